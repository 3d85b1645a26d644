#include "analysis/cover_matching.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/node_index.h"

namespace liftarm::analysis {

namespace {

//! One edge could be covered by one module of a beam.
struct Candidate {
  int module = -1;
  double offset = 0.0;  // |layer|, and more than any where the model says another one
};

constexpr double kNotSaid = 100.0;

//! Layers are whole, or quarters beside whole for thin beams: what rounding leaves of a position
//! must not decide which of two comes first.
double layerOf(const Cover& cover) {
  return 0.25 * static_cast<double>(std::lround(4.0 * std::abs(cover.layer)));
}

class Matching {
 public:
  explicit Matching(std::vector<EdgeCover>& edges) : edges_(edges) {
    numberEdges();
    for (std::size_t e = 0; e < edges.size(); ++e) {
      for (const Cover& cover : edges[e].covers) {
        addCandidate(places_[e], moduleOf(cover), layerOf(cover) + (cover.said ? 0.0 : kNotSaid));
      }
    }
    std::set<int> said;
    for (const EdgeCover& edge : edges) {
      for (const Cover& cover : edge.covers) {
        if (cover.said) {
          said.insert(cover.part);
        }
      }
    }
    elsewhere_.resize(modules_.size());
    for (const auto& [key, module] : modules_) {
      elsewhere_[static_cast<std::size_t>(module)] = said.count(std::get<0>(key)) > 0;
    }
    for (std::vector<Candidate>& list : candidates_) {
      std::stable_sort(list.begin(), list.end(), [](const Candidate& a, const Candidate& b) {
        return a.offset < b.offset;
      });
    }
  }

  void solve() {
    std::vector<int> order(candidates_.size());
    std::iota(order.begin(), order.end(), 0);
    const auto best = [&](int place) {
      const std::vector<Candidate>& list = candidates_[static_cast<std::size_t>(place)];
      return list.empty() ? 1e9 : list.front().offset;
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return best(a) < best(b); });
    owner_.assign(modules_.size(), -1);
    for (const int place : order) {
      seen_.assign(modules_.size(), false);
      augment(place);
    }
    for (const int place : order) {
      for (const Candidate& candidate : candidates_[static_cast<std::size_t>(place)]) {
        int& owner = owner_[static_cast<std::size_t>(candidate.module)];
        const bool said = candidate.offset < kNotSaid;
        owner = owner < 0 && (said || !elsewhere_[static_cast<std::size_t>(candidate.module)])
                    ? place
                    : owner;
      }
    }
  }

  //! Takes from each edge the covers whose module stands for another one.
  void apply() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      std::vector<Cover>& covers = edges_[e].covers;
      covers.erase(std::remove_if(covers.begin(),
                                  covers.end(),
                                  [&](const Cover& cover) {
                                    const int module = moduleOf(cover);
                                    return owner_[static_cast<std::size_t>(module)] != places_[e];
                                  }),
                   covers.end());
    }
  }

 private:
  //! Edges between the same nodes share a place.
  void numberEdges() {
    const NodeIndex nodes(edges_);
    std::map<std::pair<int, int>, int> known;
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      const std::pair<int, int> ends = std::minmax(nodes.from(e), nodes.to(e));
      places_.push_back(known.emplace(ends, static_cast<int>(known.size())).first->second);
    }
    candidates_.resize(known.size());
  }

  //! Counted from the beam's own end: what is far from the origin or turned gives the same.
  int moduleOf(const Cover& cover) {
    const Key key{cover.part, cover.stretch, std::lround(2.0 * cover.place)};
    return modules_.emplace(key, static_cast<int>(modules_.size())).first->second;
  }

  void addCandidate(int place, int module, double offset) {
    std::vector<Candidate>& list = candidates_[static_cast<std::size_t>(place)];
    const bool known = std::any_of(
        list.begin(), list.end(), [&](const Candidate& c) { return c.module == module; });
    if (!known) {
      list.push_back({module, offset});
    }
  }

  bool augment(int place) {
    for (const Candidate& candidate : candidates_[static_cast<std::size_t>(place)]) {
      const auto module = static_cast<std::size_t>(candidate.module);
      if (seen_[module]) {
        continue;
      }
      seen_[module] = true;
      if (owner_[module] < 0 || augment(owner_[module])) {
        owner_[module] = place;
        return true;
      }
    }
    return false;
  }

  using Key = std::tuple<int, int, long>;  // part, stretch, twice the place along it

  std::vector<EdgeCover>& edges_;
  std::vector<int> places_;
  std::vector<std::vector<Candidate>> candidates_;  // by place
  std::map<Key, int> modules_;
  std::vector<int> owner_;  // place, by module
  std::vector<bool> seen_;
  std::vector<bool> elsewhere_;  // by module: the model says which edges its beam covers
};

}  // namespace

void matchCovers(std::vector<EdgeCover>& edges) {
  Matching matching(edges);
  matching.solve();
  matching.apply();
}

}  // namespace liftarm::analysis
