#include "cli/solve_seeds.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "cli/best_of.h"
#include "design/design_session.h"

namespace liftarm::cli {

namespace {

using nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kSlice = 20000;  // iterations in one call

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

//! Seconds of processor time of this thread: what a search takes on a machine that is not busy.
double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double milliseconds(double seconds) {
  return std::round(seconds * 1000.0) / 1000.0;
}

std::string textOf(const ordered_json& settings) {
  return settings.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

//! Runs the same work in up to so many threads, this one among them, until all have ended.
void inThreads(int count, const std::function<void()>& work) {
  std::atomic<bool> noMemory{false};
  const auto guarded = [&] {
    try {
      work();
    } catch (const std::bad_alloc&) {
      noMemory = true;
    }
  };
  std::vector<std::thread> helpers;
  try {
    for (int i = 1; i < count; ++i) {
      helpers.emplace_back(guarded);
    }
  } catch (const std::system_error&) {
    // The system gives no more threads; those that there are do the work.
  }
  guarded();
  for (std::thread& helper : helpers) {
    helper.join();
  }
  if (noMemory) {
    throw std::bad_alloc();
  }
}

}  // namespace

base::Result<Solution> solveOnce(const std::string& sketchJson, const ordered_json& settings) {
  const Clock::time_point start = Clock::now();
  const double processorStart = processorSeconds();
  base::Result<std::unique_ptr<design::DesignSession>> created =
      design::DesignSession::create(sketchJson, textOf(settings));
  if (!created.ok()) {
    return created.error();
  }
  const std::unique_ptr<design::DesignSession> session = std::move(created).value();
  // The session prepares its search in its first step.
  bool done = session->advance(1);
  const double stageOne = secondsSince(start);
  const Clock::time_point search = Clock::now();
  while (!done) {
    done = session->advance(kSlice);
  }
  const double stageTwo = secondsSince(search);
  const double processor = processorSeconds() - processorStart;
  Solution solution{ordered_json::parse(session->reportJson(), nullptr, false),
                    session->modelJson()};
  solution.report["seconds"] = {{"stageOne", milliseconds(stageOne)},
                                {"stageTwo", milliseconds(stageTwo)},
                                {"total", milliseconds(stageOne + stageTwo)},
                                {"processor", milliseconds(processor)}};
  return solution;
}

base::Result<Solution> solveSeeds(const std::string& sketchJson,
                                  const ordered_json& settings,
                                  std::uint64_t first,
                                  int seeds,
                                  int threads) {
  const Clock::time_point start = Clock::now();
  std::vector<std::optional<base::Result<Solution>>> results(static_cast<std::size_t>(seeds));
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < results.size(); i = next++) {
      ordered_json mine = settings;
      mine["seed"] = first + i;
      results[i] = solveOnce(sketchJson, mine);
    }
  };
  inThreads(std::min(seeds, threads), work);
  ordered_json all = ordered_json::array();
  std::size_t best = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i]->ok()) {
      return results[i]->error();  // of the sketch or the settings: the same for every seed
    }
    const ordered_json& report = results[i]->value().report;
    all.push_back({{"seed", report.value("seed", std::uint64_t{0})},
                   {"buildable", report.value("buildable", false)},
                   {"beams", report.value("beams", 0)},
                   {"bricks", report.value("bricks", 0)}});
    if (isBetter(standingOf(report), standingOf(results[best]->value().report))) {
      best = i;
    }
  }
  Solution solution = std::move(*results[best]).value();
  solution.report["seeds"] = all;
  solution.report["seconds"]["total"] = milliseconds(secondsSince(start));
  return solution;
}

}  // namespace liftarm::cli
