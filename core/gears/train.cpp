#include "gears/train.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "gears/chain_reach.h"
#include "gears/gear_sizes.h"
#include "gears/train_room.h"

namespace liftarm::gears {

namespace {

constexpr int kMostChains = 5;
constexpr std::size_t kMostTries = 5000;  // arrangements for one number of shafts and chains
constexpr std::array<Place, 4> kWays{Place{1, 0}, Place{0, 1}, Place{-1, 0}, Place{0, -1}};

//! A driving gear and the one that it drives.
struct Pair {
  int a = 0;  // index among the sizes
  int b = 0;
};

//! A shaft and the largest of its gears so far.
struct Stand {
  Place at;
  double radius = 0.0;
};

//! Pairs of gears of all chains but for what lies between the ends of the last.
struct Gearing {
  std::vector<Pair> pairs;
  double ratio = 1.0;
  double error = 0.0;  // share of the ratio that is asked for
};

class TrainFinder {
 public:
  explicit TrainFinder(const TrainRequest& request)
      : request_(request), reach_(request.teeth, widthFor(request)), room_(request) {
    // Those of 8, 24 and 40 teeth mesh among each other, so do those of 16; those of 12 and 28 mesh
    // with those of 20 and 36 alone: after two steps the remainder is the one before.
    const int remainders = static_cast<int>(kTeethPerModule);
    for (int a = 0; a < sizes(); ++a) {
      for (int b = 0; b < sizes(); ++b) {
        if (meshOnLattice(teeth(a), teeth(b))) {
          pairs_.push_back({a, b});
        }
        if (teeth(a) % remainders == teeth(b) % remainders) {
          evenPairs_.push_back({a, b});
        }
      }
    }
  }

  std::optional<Train> find() {
    for (int hops = 1; hops < kMostShafts; ++hops) {
      for (int chains = 1; chains <= std::min(hops, kMostChains); ++chains) {
        if (auto train = findWith(hops, chains)) {
          return train;
        }
      }
    }
    return std::nullopt;
  }

 private:
  static int widthFor(const TrainRequest& request) {
    const Place way = request.to - request.from;
    const int longest = meshDistance(request.teeth.back(), request.teeth.back()) + 1;
    return std::max(std::abs(way.u), std::abs(way.v)) + kMostChains * longest;
  }

  [[nodiscard]] int sizes() const { return static_cast<int>(request_.teeth.size()); }

  [[nodiscard]] int teeth(int size) const { return request_.teeth[static_cast<std::size_t>(size)]; }

  std::optional<Train> findWith(int hops, int chains) {
    tries_ = 0;
    const int last = hops - (chains - 1);
    for (const Gearing& gearing : gearings(chains, last % 2 == 0)) {
      std::vector<Stand> stands{{request_.from, radiusOf(gearing.pairs.front().a)}};
      if (auto train = walk(gearing, last, stands)) {
        return train;
      }
      if (tries_ > kMostTries) {
        break;
      }
    }
    return std::nullopt;
  }

  //! All rows of pairs whose ratio is near enough, the nearest first. \param even Whether the last
  //! chain has an even number of steps: which gears it leads to depends on nothing else.
  const std::vector<Gearing>& gearings(int chains, bool even) {
    std::vector<Gearing>& rows =
        gearings_[2U * static_cast<std::size_t>(chains) + static_cast<std::size_t>(even)];
    if (rows.empty()) {
      Gearing row;
      addGearings(chains, even, row, rows);
      std::stable_sort(rows.begin(), rows.end(), [](const Gearing& p, const Gearing& q) {
        return p.error < q.error - 1e-12;
      });
    }
    return rows;
  }

  void addGearings(int chains, bool even, Gearing& row, std::vector<Gearing>& rows) const {
    const double most = ratioOf({0, sizes() - 1});
    for (const Pair& pair : chains == 1 && even ? evenPairs_ : pairs_) {
      const double before = row.ratio;
      row.pairs.push_back(pair);
      row.ratio *= ratioOf(pair);
      const double left = row.ratio / request_.ratio;
      row.error = std::abs(left - 1.0);
      if (chains == 1 && row.error <= request_.tolerance) {
        rows.push_back(row);
      } else if (chains > 1 && left * (1.0 - request_.tolerance) <= powerOf(most, chains - 1) &&
                 left * (1.0 + request_.tolerance) >= 1.0 / powerOf(most, chains - 1)) {
        addGearings(chains - 1, even, row, rows);
      }
      row.pairs.pop_back();
      row.ratio = before;
    }
  }

  static double powerOf(double base, int exponent) {
    return exponent == 0 ? 1.0 : base * powerOf(base, exponent - 1);
  }

  [[nodiscard]] double ratioOf(Pair pair) const {
    return static_cast<double>(teeth(pair.b)) / static_cast<double>(teeth(pair.a));
  }

  //! Places the shafts of the first chains, then those of the last.
  std::optional<Train> walk(const Gearing& gearing, int lastHops, std::vector<Stand>& stands) {
    const std::size_t chain = stands.size() - 1;
    const Place left = request_.to - stands.back().at;
    const Pair pair = gearing.pairs[chain];
    Stand& here = stands.back();
    here.radius = std::max(here.radius, radiusOf(pair.a));
    if (!isClear(here, stands)) {
      return std::nullopt;
    }
    if (chain + 1 == gearing.pairs.size()) {
      ++tries_;
      std::optional<Train> found;
      reach_.eachChain({pair.a, pair.b, lastHops, left}, [&](const ChainReach::Chain& path) {
        found = tryPlanes(gearing, stands, path);
        return found.has_value() || ++tries_ > kMostTries;
      });
      return found;
    }
    const int distance = meshDistance(teeth(pair.a), teeth(pair.b));
    for (const Place way : waysTowards(left)) {
      const Stand next{stands[chain].at + Place{distance * way.u, distance * way.v},
                       radiusOf(pair.b)};
      if (!mayStand(next.at) || !isClear(next, stands)) {
        continue;
      }
      stands.push_back(next);
      auto found = walk(gearing, lastHops, stands);
      stands.resize(chain + 1);
      if (found.has_value() || tries_ > kMostTries) {
        return found;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] double radiusOf(int size) const { return tipRadius(teeth(size)); }

  //! Whether no gear of one shaft reaches the axle of another.
  [[nodiscard]] bool isClear(const Stand& stand, const std::vector<Stand>& others) const {
    const auto apart = [](const Stand& p, const Stand& q) {
      return p.at == q.at || keepApart({p.at, std::nullopt, std::max(p.radius, q.radius)},
                                       {q.at, std::nullopt, kAxleRadius});
    };
    return apart(stand, {request_.to, 0.0}) &&
           std::all_of(others.begin(), others.end(), [&](const Stand& other) {
             return &other == &stand || (!(other.at == stand.at) && apart(stand, other));
           });
  }

  //! Those that come nearer to it first.
  static std::array<Place, 4> waysTowards(Place left) {
    std::array<Place, 4> ways = kWays;
    std::stable_sort(ways.begin(), ways.end(), [left](Place p, Place q) {
      return p.u * left.u + p.v * left.v > q.u * left.u + q.v * left.v;
    });
    return ways;
  }

  [[nodiscard]] bool mayStand(Place place) const {
    return !(place == request_.to) && (request_.bears == nullptr || request_.bears(place));
  }

  [[nodiscard]] std::optional<Train> tryPlanes(const Gearing& gearing,
                                               const std::vector<Stand>& stands,
                                               const ChainReach::Chain& last) const {
    Train train;
    for (const Stand& stand : stands) {
      train.shafts.push_back(stand.at);
    }
    for (const Place& step : last.steps) {
      const Place next = train.shafts.back() + step;
      const bool twice =
          std::find(train.shafts.begin(), train.shafts.end(), next) != train.shafts.end();
      if (twice || (!(next == request_.to) && !mayStand(next))) {
        return std::nullopt;
      }
      train.shafts.push_back(next);
    }
    train.ratio = gearing.ratio;
    std::vector<int> planes(gearing.pairs.size(), 0);
    do {
      if (!sharesAPlane(planes)) {
        train.gears = gearsOf(gearing, last, planes);
        if (room_.holds(train)) {
          return train;
        }
      }
    } while (nextPlanes(planes));
    return std::nullopt;
  }

  //! Two gears of one shaft in one slot.
  static bool sharesAPlane(const std::vector<int>& planes) {
    return std::adjacent_find(planes.begin(), planes.end()) != planes.end();
  }

  //! The next row of planes, lowest planes first.
  bool nextPlanes(std::vector<int>& planes) const {
    for (std::size_t i = planes.size(); i-- > 0;) {
      if (++planes[i] < request_.planes) {
        return true;
      }
      planes[i] = 0;
    }
    return false;
  }

  [[nodiscard]] std::vector<TrainGear> gearsOf(const Gearing& gearing,
                                               const ChainReach::Chain& last,
                                               const std::vector<int>& planes) const {
    std::vector<TrainGear> gears;
    for (std::size_t chain = 0; chain + 1 < gearing.pairs.size(); ++chain) {
      const int shaft = static_cast<int>(chain);
      gears.push_back({shaft, planes[chain], teeth(gearing.pairs[chain].a)});
      gears.push_back({shaft + 1, planes[chain], teeth(gearing.pairs[chain].b)});
    }
    const int first = static_cast<int>(gearing.pairs.size()) - 1;
    for (std::size_t i = 0; i < last.sizes.size(); ++i) {
      gears.push_back({first + static_cast<int>(i), planes.back(), teeth(last.sizes[i])});
    }
    return gears;
  }

  const TrainRequest& request_;
  ChainReach reach_;
  TrainRoom room_;
  std::vector<Pair> pairs_;      // that an odd number of steps can lead from and to
  std::vector<Pair> evenPairs_;  // and an even one
  std::array<std::vector<Gearing>, 2 * (kMostChains + 1)> gearings_;
  std::size_t tries_ = 0;
};

}  // namespace

std::optional<Train> findTrain(const TrainRequest& request) {
  return TrainFinder(request).find();
}

}  // namespace liftarm::gears
