#include "search/cover_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include "base/index.h"
#include "search/tuning.h"

namespace liftarm::search {

namespace {

using base::at;

constexpr std::int64_t kUnit = 1 << 16;  // of the rounded prices

//! What must be covered and what covers it: indices only.
struct Programme {
  int rows = 0;
  std::vector<std::vector<int>> columns;  // rows of each, ascending
  std::vector<int> costs;
  std::vector<double> straight;  // prices to begin with, by row
};

bool isPart(const std::vector<int>& small, const std::vector<int>& large) {
  return std::includes(large.begin(), large.end(), small.begin(), small.end());
}

//! Rows that nothing covers are nobody's. The cheapest of the columns that cover the same, and none
//! that another one makes needless.
Programme reduced(int rows, const std::vector<std::pair<std::vector<int>, int>>& all) {
  std::map<std::vector<int>, int> cheapest;
  for (const auto& [column, cost] : all) {
    const auto [place, fresh] = cheapest.emplace(column, cost);
    place->second = fresh ? cost : std::min(place->second, cost);
  }
  std::vector<std::vector<const std::pair<const std::vector<int>, int>*>> byRow(at(rows));
  for (const auto& column : cheapest) {
    for (const int row : column.first) {
      byRow[at(row)].push_back(&column);
    }
  }
  Programme programme{rows, {}, {}, {}};
  for (const auto& column : cheapest) {
    const int rare = *std::min_element(column.first.begin(), column.first.end(), [&](int a, int b) {
      return byRow[at(a)].size() < byRow[at(b)].size();
    });
    const bool needless =
        std::any_of(byRow[at(rare)].begin(), byRow[at(rare)].end(), [&](const auto* other) {
          return other->first.size() > column.first.size() && other->second <= column.second &&
                 isPart(column.first, other->first);
        });
    if (!needless) {
      programme.columns.push_back(column.first);
      programme.costs.push_back(column.second);
    }
  }
  return programme;
}

//! Prices as if there were straight beams alone: a run needs as many as greedy steps along it
//! count, and each step's part goes in equal shares to the edges where it could begin.
std::vector<double> straightPrices(const CoverTable& table, int rows) {
  std::map<int, int> longest;  // by run, in edges
  for (const TableCover& cover : table.covers) {
    if (cover.part.kind == CoverKind::kStraight && !cover.edges.empty()) {
      int& most = longest[table.edges[at(cover.edges.front())].run];
      most = std::max(most, cover.part.index - 1);
    }
  }
  std::vector<double> prices(at(rows), 0.0);
  const std::vector<TableEdge>& edges = table.edges;
  for (std::size_t begin = 0; begin < edges.size();) {
    const int run = edges[begin].run;
    std::size_t end = begin;
    while (end < edges.size() && edges[end].run == run) {
      ++end;
    }
    std::vector<std::size_t> early;  // where beams begin, laid from one end ...
    std::vector<std::size_t> late;   // ... and from the other, the last one first
    const int step = std::max(1, longest[run]);
    for (std::size_t e = begin; e < end; ++e) {
      if (early.empty() || edges[e].index >= edges[early.back()].index + step) {
        early.push_back(e);
      }
    }
    for (std::size_t e = end; e-- > begin;) {
      if (late.empty() || edges[e].index <= edges[late.back()].index - step) {
        late.push_back(e);
      }
    }
    for (std::size_t k = 0; k < early.size(); ++k) {
      const std::size_t last = late[early.size() - 1 - k];
      const double share = 1.0 / static_cast<double>(last - early[k] + 1);
      for (std::size_t e = early[k]; e <= last; ++e) {
        prices[e] += share;
      }
    }
    begin = end;
  }
  return prices;
}

Programme programmeOf(const CoverTable& table) {
  // A run is a row of its own only where no edge of it asks for a cover.
  std::map<int, int> bare;
  for (const TableCover& cover : table.covers) {
    for (const int run : cover.runs) {
      bare.emplace(run, 0);
    }
  }
  for (const TableEdge& edge : table.edges) {
    bare.erase(edge.run);
  }
  auto rows = static_cast<int>(table.edges.size());
  for (auto& [run, row] : bare) {
    row = rows++;
  }
  std::vector<std::pair<std::vector<int>, int>> columns;
  for (const TableCover& cover : table.covers) {
    std::vector<int> covered = cover.edges;
    for (const int run : cover.runs) {
      if (const auto row = bare.find(run); row != bare.end()) {
        covered.push_back(row->second);
      }
    }
    if (!covered.empty()) {
      columns.emplace_back(std::move(covered), cover.parts);
    }
  }
  Programme programme = reduced(rows, columns);
  programme.straight = straightPrices(table, rows);
  return programme;
}

//! The pieces of a programme that share no column.
std::vector<Programme> piecesOf(const Programme& whole) {
  std::vector<int> root(at(whole.rows));
  std::iota(root.begin(), root.end(), 0);
  const auto rootOf = [&](int row) {
    while (root[at(row)] != row) {
      row = root[at(row)] = root[at(root[at(row)])];
    }
    return row;
  };
  for (const std::vector<int>& column : whole.columns) {
    for (const int row : column) {
      root[at(rootOf(row))] = rootOf(column.front());
    }
  }
  std::vector<int> piece(at(whole.rows), -1);  // by root
  std::vector<int> number(at(whole.rows), 0);
  std::vector<Programme> pieces;
  for (int row = 0; row < whole.rows; ++row) {
    int& mine = piece[at(rootOf(row))];
    if (mine < 0) {
      mine = static_cast<int>(pieces.size());
      pieces.emplace_back();
    }
    number[at(row)] = pieces[at(mine)].rows++;
    pieces[at(mine)].straight.push_back(whole.straight[at(row)]);
  }
  for (std::size_t c = 0; c < whole.columns.size(); ++c) {
    Programme& mine = pieces[at(piece[at(rootOf(whole.columns[c].front()))])];
    mine.costs.push_back(whole.costs[c]);
    std::vector<int>& rows = mine.columns.emplace_back();
    for (const int row : whole.columns[c]) {
      rows.push_back(number[at(row)]);
    }
  }
  return pieces;
}

//! The bound that some prices give, in units of 1 / kUnit, exactly.
std::int64_t exactBound(const Programme& programme, const std::vector<double>& prices) {
  std::vector<std::int64_t> whole;
  for (const double price : prices) {
    whole.push_back(static_cast<std::int64_t>(price * static_cast<double>(kUnit)));
  }
  std::int64_t bound = std::accumulate(whole.begin(), whole.end(), std::int64_t{0});
  for (std::size_t c = 0; c < programme.columns.size(); ++c) {
    std::int64_t left = kUnit * programme.costs[c];
    for (const int row : programme.columns[c]) {
      left -= whole[at(row)];
    }
    bound += std::min<std::int64_t>(0, left);
  }
  return bound;
}

//! Prices that no column is too dear for: each row's least share of a column.
std::vector<double> firstPrices(const Programme& programme) {
  std::vector<double> prices(at(programme.rows), 1e9);
  for (std::size_t c = 0; c < programme.columns.size(); ++c) {
    const double share =
        static_cast<double>(programme.costs[c]) / static_cast<double>(programme.columns[c].size());
    for (const int row : programme.columns[c]) {
      prices[at(row)] = std::min(prices[at(row)], share);
    }
  }
  return prices;
}

//! The best bound of some steps from these prices, as exactBound gives it.
std::int64_t boundFrom(const Programme& programme, std::vector<double> prices) {
  std::vector<double> best = prices;
  std::vector<double> slope(prices.size());
  double bestBound = 0.0;
  double stride = kTuning.bound.firstStride;
  int since = 0;
  for (int step = 0; step < kTuning.bound.steps; ++step) {
    double bound = 0.0;
    for (const double price : prices) {
      bound += price;
    }
    std::fill(slope.begin(), slope.end(), 1.0);
    for (std::size_t c = 0; c < programme.columns.size(); ++c) {
      double left = static_cast<double>(programme.costs[c]);
      for (const int row : programme.columns[c]) {
        left -= prices[at(row)];
      }
      if (left < 0.0) {
        bound += left;
        for (const int row : programme.columns[c]) {
          slope[at(row)] -= 1.0;
        }
      }
    }
    ++since;
    if (bound > bestBound) {
      bestBound = bound;
      best = prices;
      since = 0;
    } else if (since > kTuning.bound.patience) {
      stride *= 0.5;
      since = 0;
      prices = best;
      continue;
    }
    double square = 0.0;
    for (std::size_t r = 0; r < prices.size(); ++r) {
      slope[r] = prices[r] <= 0.0 && slope[r] < 0.0 ? 0.0 : slope[r];
      square += slope[r] * slope[r];
    }
    if (square == 0.0) {
      break;
    }
    const double length =
        stride * (kTuning.bound.targetShare * bestBound + kTuning.bound.targetMore - bound) /
        square;
    for (std::size_t r = 0; r < prices.size(); ++r) {
      prices[r] = std::max(0.0, prices[r] + length * slope[r]);
    }
  }
  return exactBound(programme, best);
}

//! \pre there is a column.
int boundOf(const Programme& programme) {
  const std::int64_t bound = std::max(boundFrom(programme, programme.straight),
                                      boundFrom(programme, firstPrices(programme)));
  return static_cast<int>((bound + kUnit - 1) / kUnit);
}

}  // namespace

int coverLowerBound(const CoverTable& table) {
  int total = 0;
  for (const Programme& piece : piecesOf(programmeOf(table))) {
    total += piece.columns.empty() ? 0 : boundOf(piece);
  }
  return total;
}

}  // namespace liftarm::search
