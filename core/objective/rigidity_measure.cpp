#include "objective/rigidity_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "base/index.h"

namespace liftarm::objective {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;
using parts::FeatureKind;

constexpr double kMeets = 1e-2;  // modules; holes are a module apart

bool meets(Vec3 a, Vec3 b) {
  const Vec3 d = a - b;
  return std::abs(d.x) < kMeets && std::abs(d.y) < kMeets && std::abs(d.z) < kMeets;
}

std::array<int, 3> moduleOf(Vec3 p) {
  return {static_cast<int>(std::floor(p.x + 0.5)),
          static_cast<int>(std::floor(p.y + 0.5)),
          static_cast<int>(std::floor(p.z + 0.5))};
}

//! A hole or a head of some body in its place; all are along principal axes.
struct BodySlot {
  int body = -1;
  FeatureKind kind = FeatureKind::kPinHole;
  Axis axis = Axis::kX;
  Vec3 at;
};

//! Slots by place.
class SlotIndex {
 public:
  void add(const BodySlot& slot) { buckets_[moduleOf(slot.at)].push_back(slot); }

  [[nodiscard]] std::vector<BodySlot> find(Vec3 p, Axis axis) const {
    std::vector<BodySlot> found;
    const std::array<int, 3> home = moduleOf(p);
    for (int i = 0; i < 27; ++i) {
      const auto bucket =
          buckets_.find({home[0] + i % 3 - 1, home[1] + i / 3 % 3 - 1, home[2] + i / 9 - 1});
      if (bucket == buckets_.end()) {
        continue;
      }
      for (const BodySlot& slot : bucket->second) {
        if (slot.axis == axis && meets(slot.at, p)) {
          found.push_back(slot);
        }
      }
    }
    return found;
  }

 private:
  std::map<std::array<int, 3>, std::vector<BodySlot>> buckets_;
};

//! Two bodies that turn against each other about a line.
struct Hinge {
  int bodyA = -1;
  int bodyB = -1;
  int line = -1;
};

class Bodies {
 public:
  int add(bool beam) {
    parents_.push_back(static_cast<int>(parents_.size()));
    isBeam_.push_back(beam);
    return parents_.back();
  }

  int rootOf(int body) {
    while (parents_[at(body)] != body) {
      parents_[at(body)] = parents_[at(parents_[at(body)])];
      body = parents_[at(body)];
    }
    return body;
  }

  void merge(int a, int b) { parents_[at(rootOf(a))] = rootOf(b); }

  void addHinge(int a, int b, Axis axis, Vec3 through) {
    through[lattice::index(axis)] = 0.0;
    int line = 0;
    const auto count = static_cast<int>(lines_.size());
    while (line < count &&
           !(lines_[at(line)].first == axis && meets(lines_[at(line)].second, through))) {
      ++line;
    }
    if (line == count) {
      lines_.emplace_back(axis, through);
    }
    hinges_.push_back({a, b, line});
  }

  //! Makes one of all bodies that share two lines, until no more do.
  void mergeRigid() {
    bool changed = true;
    while (changed) {
      changed = false;
      std::map<std::pair<int, int>, std::set<int>> linesBetween;
      for (const Hinge& hinge : hinges_) {
        const std::pair<int, int> pair = std::minmax(rootOf(hinge.bodyA), rootOf(hinge.bodyB));
        if (pair.first != pair.second) {
          linesBetween[pair].insert(hinge.line);
        }
      }
      for (const auto& [pair, lines] : linesBetween) {
        if (lines.size() > 1 && rootOf(pair.first) != rootOf(pair.second)) {
          merge(pair.first, pair.second);
          changed = true;
        }
      }
    }
  }

  int subsetsWithBeams() {
    std::set<int> roots;
    for (std::size_t body = 0; body < parents_.size(); ++body) {
      if (isBeam_[body]) {
        roots.insert(rootOf(static_cast<int>(body)));
      }
    }
    return static_cast<int>(roots.size());
  }

 private:
  std::vector<int> parents_;
  std::vector<bool> isBeam_;
  std::vector<std::pair<Axis, Vec3>> lines_;
  std::vector<Hinge> hinges_;
};

bool isPlainPin(const parts::Part& part) {
  return part.features.size() == 1 && part.features.front().kind == FeatureKind::kPin;
}

class Measure {
 public:
  explicit Measure(const guide::GuidingGraph& graph) : graph_(graph) {}

  void addBeams(const std::vector<layout::Cover>& covers) {
    for (std::size_t r = 0; r < covers.size(); ++r) {
      const guide::GuideRun& run = graph_.runs[r];
      const layout::Cover& cover = covers[r];
      std::vector<int> bodies;
      for (const layout::Beam& beam : cover.beams) {
        bodies.push_back(bodies_.add(true));
        mergeArm(static_cast<int>(r), beam, bodies.back());
        for (int i = beam.start; i <= beam.last(); ++i) {
          holes_.add({bodies.back(),
                      FeatureKind::kPinHole,
                      beam.hasHoleAt(i) ? cover.axis : layout::axisAcross(run, cover.axis),
                      layout::holePosition(graph_, run, cover.axis, i, beam.layer)});
        }
      }
      for (std::size_t b = 1; b < bodies.size(); ++b) {
        for (const int i : layout::inlinePins(run, cover.beams[b - 1], cover.beams[b])) {
          bodies_.addHinge(bodies[b - 1],
                           bodies[b],
                           cover.axis,
                           layout::holePosition(graph_, run, cover.axis, i, 0));
        }
      }
    }
  }

  //! Beams on one axle turn against each other, as on a pin. \pre All beams are there.
  void addAxles(const std::vector<layout::Cover>& covers) {
    for (std::size_t r = 0; r < covers.size(); ++r) {
      const guide::GuideRun& run = graph_.runs[r];
      std::vector<BodySlot> onAxle;
      for (int i = covers[r].axle.start; covers[r].axle.used() && i <= covers[r].axle.last(); ++i) {
        const Vec3 place = layout::holePosition(graph_, run, covers[r].axis, i, 0);
        for (const BodySlot& hole : holes_.find(place, lattice::mainAxis(run.direction))) {
          onAxle.push_back(hole);
        }
      }
      hingeAll(onAxle);
    }
  }

  void addMechanism(const mechanisms::Mechanism& shape, Vec3 origin) {
    std::vector<int> bodies;
    for (const mechanisms::MechanismPart& member : shape.parts) {
      const parts::Part* part = parts::Catalogue::builtIn().find(member.id);
      bodies.push_back(part == nullptr || isPlainPin(*part) ? -1 : bodies_.add(false));
      forSlots(member, origin, bodies.back(), [&](const BodySlot& slot) {
        if (!parts::isMale(slot.kind)) {
          holes_.add(slot);
        }
      });
    }
    for (std::size_t m = 0; m < shape.parts.size(); ++m) {
      addHeads(shape.parts[m], origin, bodies[m]);
    }
  }

  int result() {
    bodies_.mergeRigid();
    return bodies_.subsetsWithBeams();
  }

 private:
  template <typename Visit>
  static void forSlots(const mechanisms::MechanismPart& member,
                       Vec3 origin,
                       int body,
                       Visit visit) {
    const parts::Part* part = parts::Catalogue::builtIn().find(member.id);
    if (part == nullptr) {
      return;
    }
    for (const parts::Feature& feature : part->features) {
      for (const Vec3& slot : feature.slots) {
        visit(BodySlot{body,
                       feature.kind,
                       lattice::mainAxis(member.pose.rotation * feature.axis),
                       origin + member.pose.apply(slot)});
      }
    }
  }

  //! The arms of a bent beam and the bars of a frame are one body.
  void mergeArm(int run, const layout::Beam& beam, int body) {
    if (!beam.isArm()) {
      return;
    }
    const bool frame = beam.site >= 0;
    const std::array<int, 3> key{
        beam.site, frame ? 0 : std::min(run, beam.mate), frame ? 0 : std::max(run, beam.mate)};
    bodies_.merge(body, arms_.emplace(key, body).first->second);
  }

  //! Joins all bodies whose holes one part's heads fill: to the part, or to each other when it is a
  //! pin.
  void addHeads(const mechanisms::MechanismPart& member, Vec3 origin, int body) {
    std::vector<BodySlot> onPin;
    forSlots(member, origin, body, [&](const BodySlot& head) {
      if (!parts::isMale(head.kind)) {
        return;
      }
      for (const BodySlot& hole : holes_.find(head.at, head.axis)) {
        if (hole.body == body) {
          continue;
        }
        if (body < 0) {
          onPin.push_back(hole);
        } else if (head.kind == FeatureKind::kAxle && hole.kind == FeatureKind::kAxleHole) {
          bodies_.merge(body, hole.body);
        } else {
          bodies_.addHinge(body, hole.body, head.axis, head.at);
        }
      }
    });
    hingeAll(onPin);
  }

  void hingeAll(const std::vector<BodySlot>& slots) {
    for (std::size_t i = 1; i < slots.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        bodies_.addHinge(slots[i].body, slots[j].body, slots[i].axis, slots[i].at);
      }
    }
  }

  const guide::GuidingGraph& graph_;
  Bodies bodies_;
  std::map<std::array<int, 3>, int> arms_;  // body of each frame by site, of each bent beam by runs
  SlotIndex holes_;
};

}  // namespace

int countRigidSubsets(const guide::GuidingGraph& graph,
                      const mechanisms::MechanismTable& table,
                      const std::vector<layout::Cover>& covers,
                      const std::vector<layout::JunctionState>& junctions) {
  Measure measure(graph);
  measure.addBeams(covers);
  measure.addAxles(covers);
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    const Vec3 origin = graph.nodes[at(graph.junctions[j].node)];
    for (const layout::PlacedMechanism& placed : junctions[j].connection.mechanisms) {
      measure.addMechanism(table.oriented(placed.oriented).shape,
                           origin + lattice::toVec3(placed.at));
    }
  }
  return measure.result();
}

}  // namespace liftarm::objective
