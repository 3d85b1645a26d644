#include "guide/orbits.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/det_math.h"
#include "base/index.h"
#include "guide/beam_bound.h"

namespace liftarm::guide {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;

constexpr double kSamePlace = 1e-3;
constexpr std::size_t kMostImages = 512;  // of one run
constexpr std::size_t kLostShare = 4;     // one run of so many may be lost to a symmetry

bool near(Vec3 a, Vec3 b) {
  const Vec3 d = a - b;
  return lattice::dot(d, d) < kSamePlace * kSamePlace;
}

//! Whether a linear part moves nothing: of a shift.
bool isShift(const lattice::Mat3& linear) {
  return near(linear * Vec3{1, 0, 0}, {1, 0, 0}) && near(linear * Vec3{0, 1, 0}, {0, 1, 0}) &&
         near(linear * Vec3{0, 0, 1}, {0, 0, 1});
}

//! How a linear map permutes the principal axes; nothing when it does not.
std::optional<RunImage> axesOf(const lattice::Mat3& linear) {
  RunImage image;
  for (int i = 0; i < 3; ++i) {
    const Vec3 mapped = linear * lattice::unitVector(lattice::axisFromIndex(i));
    bool found = false;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(std::abs(mapped[k]) - 1.0) < kSamePlace) {
        image.axes[at(i)] = k;
        image.signs[at(i)] = mapped[k] > 0.0 ? 1 : -1;
        found = true;
      }
    }
    if (!found) {
      return std::nullopt;
    }
  }
  return image;
}

RunImage inverseOf(const RunImage& image, int run) {
  RunImage inverse{run, image.reversed, {}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const std::size_t mapped = at(image.axes[at(i)]);
    inverse.axes[mapped] = i;
    inverse.signs[mapped] = image.signs[at(i)];
    inverse.lifts[mapped] = -image.lifts[at(i)] * image.signs[at(i)];
  }
  return inverse;
}

//! First `a`, then `b`.
RunImage composed(const RunImage& a, const RunImage& b) {
  RunImage image{b.run, a.reversed != b.reversed, {}, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    image.axes[i] = b.axes[at(a.axes[i])];
    image.signs[i] = a.signs[i] * b.signs[at(a.axes[i])];
    image.lifts[i] = b.layerOf(a.lifts[i], at(a.axes[i]));
  }
  return image;
}

//! Whether the layers that two runs may have are images of each other.
bool sameLayers(const GuideRun& a, const GuideRun& b, const RunImage& image, Axis axis) {
  if (a.layers == kAllLayers && b.layers == kAllLayers) {
    return true;
  }
  bool same = true;
  for (int layer = -kMaxLayer; layer <= kMaxLayer; ++layer) {
    const int mapped = image.layerOf(layer, at(lattice::index(axis)));
    const bool allowed = std::abs(mapped) <= kMaxLayer && b.allows(mapped);
    same = same && a.allows(layer) == allowed;
  }
  return same;
}

bool sameRules(const GuideRun& a, const GuideRun& b, const RunImage& image) {
  return a.nodes.size() == b.nodes.size() && a.exact == b.exact && a.axes.size() == b.axes.size() &&
         std::all_of(a.axes.begin(), a.axes.end(), [&](Axis axis) {
           const Axis mapped = lattice::axisFromIndex(image.axes[at(lattice::index(axis))]);
           return std::find(b.axes.begin(), b.axes.end(), mapped) != b.axes.end() &&
                  sameLayers(a, b, image, axis);
         });
}

//! A junction that two runs share at which neither may leave its edge to a mechanism.
bool touchFirmly(const GuidingGraph& graph, int a, int b) {
  for (const int j : graph.runs[at(a)].junctions) {
    const Junction& junction = graph.junctions[at(j)];
    const bool shared = std::any_of(junction.incident.begin(),
                                    junction.incident.end(),
                                    [&](const Incidence& i) { return i.run == b; });
    if (shared && !mayBridge(graph.runs[at(a)], junction)) {
      return true;
    }
  }
  return false;
}

//! A cover that reads the same from both ends has a beam across the middle: none but the shortest
//! and those of two thin halves have an even number of holes. A builder lets one end stick out.
bool hasNoMiddle(const GuideRun& run) {
  return run.nodes.size() > 2 && run.nodes.size() % 2 == 0;
}

Vec3 middleOf(const GuidingGraph& graph, const GuideRun& run) {
  return 0.5 * (graph.nodes[at(run.nodes.front())] + graph.nodes[at(run.nodes.back())]);
}

}  // namespace

//! Runs that meet their image on the same layer pass it on the next one, towards the middle of the
//! drawing: so the images of both under another mirror pass each other alike.
void Orbits::crossOver(const GuidingGraph& graph, Generator* generator) {
  Vec3 centre;
  for (const Vec3& node : graph.nodes) {
    centre = centre + (1.0 / static_cast<double>(graph.nodes.size())) * node;
  }
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    RunImage& there = generator->forward[r];
    const int run = static_cast<int>(r);
    if (there.run <= run || graph.runs[r].exact || generator->forward[at(there.run)].run != run ||
        !touchFirmly(graph, run, there.run)) {
      continue;
    }
    RunImage& back = generator->forward[at(there.run)];
    const Vec3 middle = middleOf(graph, graph.runs[r]);
    const Vec3 apart = middleOf(graph, graph.runs[at(there.run)]) - middle;
    const bool swapped = apart.x + apart.y + apart.z < -kSamePlace;
    for (std::size_t i = 0; i < 3; ++i) {
      if (there.axes[i] == static_cast<int>(i) && there.signs[i] > 0) {
        const int axis = static_cast<int>(i);
        const int inwards = middle[axis] > centre[axis] + kSamePlace ? -1 : 1;
        there.lifts[i] = swapped ? -inwards : inwards;
        back.lifts[i] = -there.lifts[i];
      }
    }
    generator->backward[r] = inverseOf(back, there.run);
    generator->backward[at(there.run)] = inverseOf(there, run);
  }
}

Orbits::Generator Orbits::makeGenerator(const GuidingGraph& graph,
                                        const std::vector<const GuideSymmetry*>& parts) {
  Generator generator;
  generator.forward.resize(graph.runs.size());
  generator.backward.resize(graph.runs.size());
  for (const GuideSymmetry* part : parts) {
    const std::optional<RunImage> axes = axesOf(part->linear);
    if (!axes) {
      continue;
    }
    for (const int partner : part->partners) {
      const GuideRun& from = graph.runs[at(partner)];
      const Vec3 first = part->linear * graph.nodes[at(from.nodes.front())] + part->shift;
      const Vec3 last = part->linear * graph.nodes[at(from.nodes.back())] + part->shift;
      for (const int id : part->runs) {
        const GuideRun& to = graph.runs[at(id)];
        const bool ahead = near(first, graph.nodes[at(to.nodes.front())]) &&
                           near(last, graph.nodes[at(to.nodes.back())]);
        const bool back = near(first, graph.nodes[at(to.nodes.back())]) &&
                          near(last, graph.nodes[at(to.nodes.front())]);
        const bool noMiddle = id == partner && back && hasNoMiddle(to);
        if ((ahead || back) && !noMiddle && sameRules(from, to, *axes)) {
          RunImage image = *axes;
          image.run = id;
          image.reversed = back;
          generator.forward[at(partner)] = image;
          generator.backward[at(id)] = inverseOf(image, partner);
        }
      }
    }
  }
  crossOver(graph, &generator);
  return generator;
}

void Orbits::drop(Generator* generator, int run) {
  for (auto [there, back] : {std::pair(&generator->forward, &generator->backward),
                             std::pair(&generator->backward, &generator->forward)}) {
    const int image = (*there)[at(run)].run;
    if (image >= 0) {
      (*back)[at(image)] = {};
      (*there)[at(run)] = {};
    }
  }
}

//! All images of all runs, by following the generators.
void Orbits::close(const GuidingGraph& graph) {
  images_.assign(graph.runs.size(), {});
  empty_ = true;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    RunImage self;
    self.run = static_cast<int>(r);
    std::vector<RunImage> seen{self};
    for (std::size_t i = 0; i < seen.size() && seen.size() < kMostImages; ++i) {
      for (const Generator& generator : generators_) {
        for (const std::vector<RunImage>* maps : {&generator.forward, &generator.backward}) {
          const RunImage& map = (*maps)[at(seen[i].run)];
          const RunImage image = composed(seen[i], map);
          if (map.run >= 0 && std::find(seen.begin(), seen.end(), image) == seen.end()) {
            seen.push_back(image);
          }
        }
      }
    }
    images_[r].assign(seen.begin() + 1, seen.end());
    empty_ = empty_ && images_[r].empty();
  }
}

int Orbits::representative(int run) const {
  int least = run;
  for (const RunImage& image : images(run)) {
    least = std::min(least, image.run);
  }
  return least;
}

SelfBinding Orbits::binding(int run, Axis axis) const {
  SelfBinding binding;
  const std::size_t a = at(lattice::index(axis));
  for (const RunImage& image : images(run)) {
    // Two ways onto one other run must agree as well: together they map this run onto itself, and
    // that is among the images too.
    if (image.run != run) {
      continue;
    }
    binding.allowed = binding.allowed && image.axes[a] == static_cast<int>(a);
    binding.allowed = binding.allowed && image.lifts[a] == 0;
    if (!image.reversed) {
      binding.pinned = binding.pinned || image.signs[a] < 0;
    } else {
      binding.pinned = binding.pinned || (binding.centred && binding.sign != image.signs[a]);
      binding.centred = true;
      binding.sign = image.signs[a];
    }
  }
  return binding;
}

//! Whether no cover of a run with this hole axis can obey the symmetries.
bool Orbits::lost(const GuidingGraph& graph, int run, Axis axis) const {
  const SelfBinding self = binding(run, axis);
  const std::size_t a = at(lattice::index(axis));
  if (!self.allowed || (self.pinned && graph.runs[at(run)].edgeCount() > kLongestBeam)) {
    return true;
  }
  if (self.centred && hasNoMiddle(graph.runs[at(run)])) {
    return true;
  }
  // An image that is met on the same layer would stand in the way.
  return std::any_of(images(run).begin(), images(run).end(), [&](const RunImage& image) {
    return image.run != run && image.axes[a] == static_cast<int>(a) && image.signs[a] > 0 &&
           image.lifts[a] == 0 && touchFirmly(graph, run, image.run);
  });
}

std::vector<int> Orbits::lostRuns(const GuidingGraph& graph) const {
  std::vector<int> runs;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    const std::vector<Axis>& axes = graph.runs[r].axes;
    if (std::all_of(axes.begin(), axes.end(), [&](Axis axis) {
          return lost(graph, static_cast<int>(r), axis);
        })) {
      runs.push_back(static_cast<int>(r));
    }
  }
  return runs;
}

int Orbits::pinnedAxes(const GuidingGraph& graph) const {
  int pairs = 0;
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    for (const Axis axis : graph.runs[r].axes) {
      pairs += binding(static_cast<int>(r), axis).pinned ? 1 : 0;
    }
  }
  return pairs;
}

bool Orbits::accept(const GuidingGraph& graph, Generator generator, bool shift) {
  const Orbits before = *this;
  const int pinnedBefore = generators_.empty() ? 0 : pinnedAxes(graph);
  generators_.push_back(std::move(generator));
  close(graph);
  const bool contradicts = shift && pinnedAxes(graph) > pinnedBefore;
  for (std::vector<int> without = lostRuns(graph); !without.empty() && !contradicts;
       without = lostRuns(graph)) {
    if (without.size() * kLostShare > graph.runs.size() && !before.empty_) {
      break;
    }
    const std::size_t last = generators_.size() - 1;
    for (const int run : without) {
      drop(&generators_[last], run);
    }
    close(graph);
    if (lostRuns(graph).size() >= without.size()) {
      break;
    }
  }
  if (contradicts || !lostRuns(graph).empty()) {
    *this = before;
    return false;
  }
  return true;
}

Orbits::Orbits(const GuidingGraph& graph) {
  close(graph);
  for (std::size_t s = 0; s < graph.symmetries.size();) {
    std::vector<const GuideSymmetry*> parts{&graph.symmetries[s]};
    const bool shift = isShift(parts[0]->linear);
    // A shift is given pair by pair.
    for (++s; shift && s < graph.symmetries.size() && isShift(graph.symmetries[s].linear) &&
              near(graph.symmetries[s].shift, parts[0]->shift);
         ++s) {
      parts.push_back(&graph.symmetries[s]);
    }
    accept(graph, makeGenerator(graph, parts), shift);
  }
  for (std::size_t r = 0; r < graph.runs.size(); ++r) {
    allowed_.push_back({true, true, true});
    for (const Axis axis : graph.runs[r].axes) {
      allowed_[r][at(lattice::index(axis))] = !lost(graph, static_cast<int>(r), axis);
    }
  }
}

void Orbits::release(int run) {
  const std::vector<RunImage> members = images(run);
  images_[at(run)].clear();
  allowed_[at(run)] = {true, true, true};
  for (const RunImage& member : members) {
    images_[at(member.run)].clear();
    allowed_[at(member.run)] = {true, true, true};
  }
  empty_ = std::all_of(images_.begin(), images_.end(), [](const std::vector<RunImage>& images) {
    return images.empty();
  });
}

}  // namespace liftarm::guide
