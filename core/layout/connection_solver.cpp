#include "layout/connection_solver.h"

#include "layout/connection_search.h"

namespace liftarm::layout {

namespace {

constexpr std::size_t kKnownLimit = 400000;

}  // namespace

ConnectionSolver::ConnectionSolver(const mechanisms::MechanismTable& table, ConnectionCosts costs)
    : table_(&table), search_(std::make_unique<ConnectionSearch>(table, costs)) {}

ConnectionSolver::~ConnectionSolver() = default;

std::uint64_t ConnectionSolver::work() const {
  return search_->work();
}

std::vector<FurtherJoin> ConnectionSolver::joins(const LocalProblem& problem, std::size_t most) {
  return search_->joins(problem, most);
}

const Connection& ConnectionSolver::solve(const LocalProblem& problem) {
  const std::uint64_t key = problem.hash();
  const auto found = known_.find(key);
  if (found != known_.end()) {
    ++hits_;
    return found->second;
  }
  ++misses_;
  if (known_.size() > kKnownLimit) {
    known_.clear();
  }
  return known_.emplace(key, search_->run(problem)).first->second;
}

}  // namespace liftarm::layout
