#include "objective/mobility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/index.h"

namespace liftarm::objective {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;
using parts::FeatureKind;

constexpr double kSamePlace = 1e-3;
// Beams on one joint's pin are no farther from it than this along its axis.
constexpr double kPinReach = 3.5;

//! A head or a hole of a mechanism's part, in the mechanism's frame.
struct Slot {
  int part = -1;
  FeatureKind kind = FeatureKind::kPin;
  Axis axis = Axis::kX;
  Vec3 at;
};

std::vector<Slot> slotsOf(const mechanisms::Mechanism& shape) {
  std::vector<Slot> slots;
  for (std::size_t p = 0; p < shape.parts.size(); ++p) {
    const parts::Part* part = parts::Catalogue::builtIn().find(shape.parts[p].id);
    if (part == nullptr) {
      continue;
    }
    for (const parts::Feature& feature : part->features) {
      for (const Vec3& slot : feature.slots) {
        slots.push_back({static_cast<int>(p),
                         feature.kind,
                         lattice::mainAxis(shape.parts[p].pose.rotation * feature.axis),
                         shape.parts[p].pose.apply(slot)});
      }
    }
  }
  return slots;
}

bool meet(const Slot& a, const Slot& b) {
  return a.part != b.part && a.axis == b.axis && lattice::length(a.at - b.at) < kSamePlace;
}

}  // namespace

Mobility::Mobility(const layout::LayoutProblem& problem, const mechanisms::MechanismTable& table)
    : problem_(&problem), table_(&table), reduced_(table.size()), isReduced_(table.size(), 0) {}

Mobility::Reduced Mobility::reduce(const mechanisms::Mechanism& shape) const {
  const std::vector<Slot> slots = slotsOf(shape);
  std::vector<int> body(shape.parts.size());
  std::iota(body.begin(), body.end(), 0);
  const auto forFilled = [&](const auto& visit) {
    for (const Slot& male : slots) {
      for (const Slot& female : slots) {
        if (parts::isMale(male.kind) && !parts::isMale(female.kind) && meet(male, female)) {
          visit(male, female);
        }
      }
    }
  };
  forFilled([&](const Slot& male, const Slot& female) {
    if (male.kind == FeatureKind::kAxle && female.kind == FeatureKind::kAxleHole) {
      const int from = std::max(body[at(male.part)], body[at(female.part)]);
      const int to = std::min(body[at(male.part)], body[at(female.part)]);
      std::replace(body.begin(), body.end(), from, to);
    }
  });
  Reduced reduced;
  reduced.bodies = static_cast<int>(shape.parts.size());
  forFilled([&](const Slot& male, const Slot& female) {
    const int a = body[at(male.part)];
    const int b = body[at(female.part)];
    if (a != b) {
      reduced.hinges.push_back({a, b, male.axis, male.at});
    }
  });
  for (const Slot& male : slots) {
    const bool free = std::none_of(slots.begin(), slots.end(), [&](const Slot& female) {
      return !parts::isMale(female.kind) && meet(male, female);
    });
    if (parts::isMale(male.kind) && free) {
      reduced.heads.push_back({body[at(male.part)], male.axis, male.at});
    }
  }
  return reduced;
}

const Mobility::Reduced& Mobility::reduced(int oriented) {
  if (isReduced_[at(oriented)] == 0) {
    isReduced_[at(oriented)] = 1;
    reduced_[at(oriented)] = reduce(table_->oriented(oriented).shape);
  }
  return reduced_[at(oriented)];
}

void Mobility::addHinge(Axis axis, Vec3 place, int a, int b) {
  const double along = place[lattice::index(axis)];
  place[lattice::index(axis)] = 0.0;
  int line = lines_.find(axis, place);
  if (line < 0) {
    line = static_cast<int>(linePlaces_.size());
    lines_.add(axis, place, line);
    linePlaces_.emplace_back(axis, place);
  }
  graph_.addHinge(line, a, b);
  for (const int half : {twinOf(a), twinOf(b)}) {
    if (half >= 0) {
      graph_.addHinge(line, a, half);
    }
  }
  lineBodies_.push_back({line, a, along});
  lineBodies_.push_back({line, b, along});
}

//! The other half of a beam that is two thin ones, or -1: pins hold both alike.
int Mobility::twinOf(int body) const {
  const auto twin = std::find_if(
      twins_.begin(), twins_.end(), [&](const auto& pair) { return pair.first == body; });
  return twin == twins_.end() ? -1 : twin->second;
}

//! The arms of a bent beam and the bars of a frame are one body.
void Mobility::addArm(int run, const layout::Beam& beam, int body) {
  std::array<int, 4> arm{beam.site, 0, 0, body};
  if (beam.site < 0) {
    arm = {-1, std::min(run, beam.mate), std::max(run, beam.mate), body};
  }
  const auto known = std::find_if(arms_.begin(), arms_.end(), [&](const std::array<int, 4>& a) {
    return std::equal(a.begin(), a.begin() + 3, arm.begin());
  });
  if (known == arms_.end()) {
    arms_.push_back(arm);
  } else {
    graph_.merge(body, (*known)[3]);
  }
}

void Mobility::addBeams(const std::vector<layout::Cover>& covers) {
  const guide::GuidingGraph& graph = problem_->graph;
  bodiesOf_.assign(covers.size(), {});
  for (std::size_t r = 0; r < covers.size(); ++r) {
    const guide::GuideRun& run = graph.runs[r];
    const layout::Cover& cover = covers[r];
    std::vector<int>& bodies = bodiesOf_[r];
    for (const layout::Beam& beam : cover.beams) {
      bodies.push_back(graph_.addBody(true));
      if (layout::partsOfBeam(beam.holes) > 1 && !beam.isArm()) {
        twins_.emplace_back(bodies.back(), graph_.addBody(true));
      }
      if (beam.isArm()) {
        addArm(static_cast<int>(r), beam, bodies.back());
      }
      for (int i = beam.start; i <= beam.last(); ++i) {
        holes_.add(beam.hasHoleAt(i) ? cover.axis : layout::axisAcross(run, cover.axis),
                   layout::holePosition(graph, run, cover.axis, i, beam.layer),
                   bodies.back());
      }
    }
    for (std::size_t b = 1; b < bodies.size(); ++b) {
      for (const int i : layout::inlinePins(run, cover.beams[b - 1], cover.beams[b])) {
        addHinge(cover.axis,
                 layout::holePosition(graph, run, cover.axis, i, 0),
                 bodies[b - 1],
                 bodies[b]);
      }
    }
  }
}

//! Beams on one axle turn against each other, as on a pin. \pre All beams are there.
void Mobility::addAxle(int r, const layout::Cover& cover) {
  const guide::GuideRun& run = problem_->graph.runs[at(r)];
  const Axis axis = lattice::mainAxis(run.direction);
  const int axle = graph_.addBody(false);
  for (int i = cover.axle.start; i <= cover.axle.last(); ++i) {
    const Vec3 place = layout::holePosition(problem_->graph, run, cover.axis, i, 0);
    if (const int beam = holes_.find(axis, place); beam >= 0) {
      addHinge(axis, place, axle, beam);
    }
  }
}

void Mobility::addMechanism(const layout::PlacedMechanism& placed, Vec3 origin) {
  const Reduced& shape = reduced(placed.oriented);
  int first = -1;
  for (int b = 0; b < shape.bodies; ++b) {
    const int body = graph_.addBody(false);
    first = b == 0 ? body : first;
  }
  for (const LocalHinge& hinge : shape.hinges) {
    addHinge(hinge.axis, origin + hinge.at, first + hinge.a, first + hinge.b);
  }
  for (const Head& head : shape.heads) {
    if (const int beam = holes_.find(head.axis, origin + head.at); beam >= 0) {
      addHinge(head.axis, origin + head.at, first + head.body, beam);
    }
  }
}

//! What turns about an annotated joint is no freedom beyond it.
void Mobility::lockJoints() {
  for (const guide::GuideJoint& joint : problem_->graph.joints) {
    Vec3 place = problem_->graph.nodes[at(joint.node)];
    const double along = place[lattice::index(joint.axis)];
    place[lattice::index(joint.axis)] = 0.0;
    const int line = lines_.find(joint.axis, place);
    int first = -1;
    for (const Seat& seat : lineBodies_) {
      if (line >= 0 && seat.line == line && std::abs(seat.along - along) < kPinReach) {
        first = first < 0 ? seat.body : first;
        graph_.merge(first, seat.body);
      }
    }
  }
}

int Mobility::count(const std::vector<layout::Cover>& covers,
                    const std::vector<layout::JunctionState>& junctions) {
  graph_.clear();
  holes_.clear();
  lines_.clear();
  linePlaces_.clear();
  lineBodies_.clear();
  arms_.clear();
  twins_.clear();
  addBeams(covers);
  for (std::size_t r = 0; r < covers.size(); ++r) {
    if (covers[r].axle.used()) {
      addAxle(static_cast<int>(r), covers[r]);
    }
  }
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    const Vec3 node = problem_->graph.nodes[at(problem_->graph.junctions[j].node)];
    for (const layout::PlacedMechanism& placed : junctions[j].connection.mechanisms) {
      addMechanism(placed, node + lattice::toVec3(placed.at));
    }
  }
  lockJoints();
  graph_.setLines(linePlaces_);
  return graph_.mobility();
}

std::vector<std::vector<int>> Mobility::bodies() const {
  std::vector<std::vector<int>> roots = bodiesOf_;
  for (std::vector<int>& bodies : roots) {
    for (int& body : bodies) {
      body = graph_.rootOf(body);
    }
  }
  return roots;
}

std::vector<int> Mobility::looseRuns() const {
  std::vector<int> loose;
  std::vector<int> holesOf(at(graph_.bodies()), 0);
  int largest = -1;
  for (const std::vector<int>& bodies : bodiesOf_) {
    for (const int body : bodies) {
      const int root = graph_.rootOf(body);
      ++holesOf[at(root)];
      largest = largest < 0 || holesOf[at(root)] > holesOf[at(largest)] ? root : largest;
    }
  }
  for (std::size_t r = 0; r < bodiesOf_.size(); ++r) {
    if (std::any_of(bodiesOf_[r].begin(), bodiesOf_[r].end(), [&](int body) {
          return graph_.rootOf(body) != largest;
        })) {
      loose.push_back(static_cast<int>(r));
    }
  }
  return loose;
}

}  // namespace liftarm::objective
