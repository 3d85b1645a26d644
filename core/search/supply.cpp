#include "search/supply.h"

#include <algorithm>

#include "base/index.h"
#include "layout/stack.h"

namespace liftarm::search {

namespace {

using base::at;

constexpr const char* kInlinePin = "2780";

int beyond(int used, int owned) {
  return std::max(0, used - owned);
}

}  // namespace

SupplyCounter::SupplyCounter(Supply supply, const mechanisms::MechanismTable& table)
    : supply_(std::move(supply)), table_(&table) {
  limited_ = !supply_.beams.empty() || !supply_.bent.empty() || !supply_.frames.empty() ||
             !supply_.connectors.empty();
  for (std::size_t c = 0; c < supply_.connectors.size(); ++c) {
    if (supply_.connectors[c].first == kInlinePin) {
      inlinePin_ = static_cast<int>(c);
    }
    if (supply_.connectors[c].first == layout::kSpacerPart) {
      spacer_ = static_cast<int>(c);
    }
  }
}

//! Frames in use of each limited kind.
std::vector<int> SupplyCounter::framesUsed(const layout::Layout& layout) const {
  std::vector<int> used(supply_.frames.size(), 0);
  const auto runs = static_cast<int>(layout.problem().graph.runs.size());
  for (int run = 0; run < runs && !used.empty(); ++run) {
    for (const layout::Beam& beam : layout.run(run).cover.beams) {
      if (beam.site < 0) {
        continue;
      }
      const layout::FrameSite& site = layout.problem().sites[at(beam.site)];
      for (std::size_t f = 0; f < used.size() && site.arms.front().run == run; ++f) {
        used[f] += supply_.frames[f].first == site.frame ? 1 : 0;
      }
    }
  }
  return used;
}

//! Parts in use by each limited length, and of each limited bent beam after these.
std::vector<int> SupplyCounter::beamsUsed(const layout::Layout& layout, int exceptRun) const {
  std::vector<int> used(supply_.beams.size() + supply_.bent.size(), 0);
  const auto runs = static_cast<int>(layout.problem().graph.runs.size());
  for (int run = 0; run < runs; ++run) {
    if (run == exceptRun) {
      continue;
    }
    for (const layout::Beam& beam : layout.run(run).cover.beams) {
      if (beam.mate >= 0) {
        for (std::size_t b = 0; b < supply_.bent.size() && run < beam.mate; ++b) {
          used[supply_.beams.size() + b] += supply_.bent[b].first == beam.form ? 1 : 0;
        }
        continue;
      }
      for (std::size_t b = 0; b < supply_.beams.size() && beam.site < 0; ++b) {
        used[b] += supply_.beams[b].holes == beam.holes ? layout::partsOfBeam(beam.holes) : 0;
      }
    }
  }
  return used;
}

const std::vector<int>& SupplyCounter::connectorsOf(int oriented) {
  byMechanism_.resize(std::max(byMechanism_.size(), at(oriented) + 1));
  std::vector<int>& counts = byMechanism_[at(oriented)];
  if (counts.empty()) {
    for (const auto& limit : supply_.connectors) {
      const auto& parts = table_->oriented(oriented).shape.parts;
      counts.push_back(static_cast<int>(std::count_if(
          parts.begin(), parts.end(), [&](const auto& part) { return part.id == limit.first; })));
    }
  }
  return counts;
}

int SupplyCounter::missing(const layout::Layout& layout) {
  if (!limited_) {
    return 0;
  }
  const std::vector<int> beams = beamsUsed(layout, -1);
  int missing = 0;
  for (std::size_t b = 0; b < supply_.bent.size(); ++b) {
    missing += beyond(beams[supply_.beams.size() + b], supply_.bent[b].second);
  }
  for (std::size_t b = 0; b < supply_.beams.size(); ++b) {
    missing += beyond(beams[b], supply_.beams[b].owned);
  }
  const std::vector<int> frames = framesUsed(layout);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    missing += beyond(frames[f], supply_.frames[f].second);
  }
  if (supply_.connectors.empty()) {
    return missing;
  }
  std::vector<int> used(supply_.connectors.size(), 0);
  int atJunctions = 0;  // and on axles: not in line
  for (std::size_t j = 0; j < layout.problem().graph.junctions.size(); ++j) {
    for (const layout::PlacedMechanism& placed :
         layout.junction(static_cast<int>(j)).connection.mechanisms) {
      const std::vector<int>& counts = connectorsOf(placed.oriented);
      for (std::size_t c = 0; c < counts.size(); ++c) {
        used[c] += counts[c];
      }
      atJunctions += static_cast<int>(table_->oriented(placed.oriented).shape.parts.size());
    }
    const auto spacers = static_cast<int>(layout.junction(static_cast<int>(j)).spacers.size());
    atJunctions += spacers;
    if (spacer_ >= 0) {
      used[at(spacer_)] += spacers;
    }
  }
  for (int run = 0; run < static_cast<int>(layout.problem().graph.runs.size()); ++run) {
    const layout::Axle& axle = layout.run(run).cover.axle;
    if (!axle.used()) {
      continue;
    }
    for (std::size_t c = 0; c < used.size(); ++c) {
      const std::string& id = supply_.connectors[c].first;
      used[c] += id == layout::axleParts()[at(axle.part)].part ? 1 : 0;
      used[c] += id == layout::kBush ? axle.bushCount() : 0;
    }
    atJunctions += 1 + axle.bushCount();
  }
  if (inlinePin_ >= 0) {
    used[at(inlinePin_)] += layout.tallies().connectors - atJunctions;
  }
  for (std::size_t c = 0; c < used.size(); ++c) {
    missing += beyond(used[c], supply_.connectors[c].second);
  }
  return missing;
}

std::vector<double> SupplyCounter::lengthCosts(const layout::Layout& layout,
                                               int run,
                                               const std::vector<int>& lengths,
                                               double cost) const {
  const std::vector<int> used = beamsUsed(layout, run);
  std::vector<double> costs(lengths.size(), 0.0);
  for (std::size_t b = 0; b < supply_.beams.size(); ++b) {
    for (std::size_t n = 0; n < lengths.size(); ++n) {
      if (lengths[n] == supply_.beams[b].holes) {
        const int parts = layout::partsOfBeam(lengths[n]);
        const int owned = supply_.beams[b].owned;
        costs[n] =
            cost * static_cast<double>(beyond(used[b] + parts, owned) - beyond(used[b], owned));
      }
    }
  }
  return costs;
}

}  // namespace liftarm::search
