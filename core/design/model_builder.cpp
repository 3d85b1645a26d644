#include "design/model_builder.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/index.h"
#include "design/crossed_part.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "layout/stack.h"

namespace liftarm::design {

namespace {

using base::at;
using lattice::Axis;
using lattice::Cell;
using lattice::Mat3;
using lattice::Vec3;
using layout::Beam;
using layout::Cover;

const parts::Part& catalogued(std::string_view id) {
  const parts::Part* part = parts::Catalogue::builtIn().find(id);
  LIFTARM_CHECK(part != nullptr, "a part in use is in the catalogue");
  return *part;
}

Vec3 middleOfHoles(const parts::Part& part) {
  Vec3 sum;
  for (const parts::Feature& feature : part.features) {
    sum = sum + feature.center;
  }
  return (1.0 / static_cast<double>(part.features.size())) * sum;
}

//! The pin without friction that replaces one at a joint.
std::string withoutFriction(const std::string& id) {
  if (id == "2780") {
    return "3673";
  }
  return id == "6558" ? "32556" : id;
}

class Builder {
 public:
  Builder(const layout::LayoutProblem& problem,
          const mechanisms::MechanismTable& table,
          const search::LayoutSnapshot& layout)
      : graph_(problem.graph),
        sites_(problem.sites),
        table_(table),
        layout_(layout),
        components_(layout::findComponents(problem.graph, layout.covers)) {}

  std::vector<model::PlacedPart> build() {
    for (std::size_t r = 0; r < layout_.covers.size(); ++r) {
      addRun(static_cast<int>(r));
    }
    for (std::size_t j = 0; j < layout_.junctions.size(); ++j) {
      addJunction(static_cast<int>(j));
    }
    return std::move(parts_);
  }

 private:
  void addBeam(int runId, const Beam& beam) {
    const guide::GuideRun& run = graph_.runs[at(runId)];
    const Axis axis = layout_.covers[at(runId)].axis;
    const parts::Part& part = straightBeamPart(beam.holes);
    const Vec3 y = run.direction;
    const Vec3 z = lattice::unitVector(axis);
    const Mat3 rotation = lattice::fromColumns(lattice::cross(y, z), y, z);
    const double middle = 0.5 * static_cast<double>(beam.start + beam.last());
    const Vec3 centre = layout::holePosition(graph_, run, axis, middle, beam.layer);
    const bool thin = part.thickness < 0.75;
    for (int half = thin ? -1 : 0; half <= (thin ? 1 : 0); half += 2) {
      const Vec3 shift = 0.25 * static_cast<double>(half) * z;
      const Vec3 position = centre + shift - rotation * middleOfHoles(part);
      parts_.push_back({part.id,
                        part.color,
                        {position, rotation},
                        components_.ofRun[at(runId)],
                        beam.layer,
                        run.piece});
      if (!thin) {
        break;
      }
    }
  }

  //! A bent beam from its two arms, the one on run `runId` and its mate.
  void addBent(int runId, const Beam& arm) {
    const std::vector<Beam>& others = layout_.covers[at(arm.mate)].beams;
    const auto mate = std::find_if(others.begin(), others.end(), [&](const Beam& beam) {
      return layout::isOneBeam(runId, arm, arm.mate, beam);
    });
    LIFTARM_CHECK(mate != others.end(), "a bent beam has both its arms");
    const layout::BentBeam& bent = layout::bentBeams()[at(arm.form)];
    const guide::GuideRun& run = graph_.runs[at(runId)];
    const int corner = layout::cornerIndex(graph_, runId, arm.mate);
    const Vec3 centre =
        layout::holePosition(graph_, run, layout_.covers[at(runId)].axis, corner, arm.layer);
    std::vector<layout::Bend> bends;
    layout::addBends(graph_, arm.form, runId, arm.mate, arm.layer, &bends);
    const auto bend = std::find_if(bends.begin(), bends.end(), [&](const layout::Bend& b) {
      return b.arm == arm && b.mateArm == *mate;
    });
    LIFTARM_CHECK(bend != bends.end(), "the arms are those of the bent beam");
    parts_.push_back({bent.part,
                      catalogued(bent.part).color,
                      layout::poseOf(bent, centre, bend->first, bend->second),
                      components_.ofRun[at(runId)],
                      arm.layer,
                      run.piece});
  }

  //! A frame, from the bar on its lowest run.
  void addFrame(int runId, const Beam& bar) {
    const layout::FrameSite& site = sites_[at(bar.site)];
    if (site.arms.front().run != runId) {
      return;
    }
    const std::string& part = layout::frameBeams()[at(site.frame)].part;
    const Vec3 shift = static_cast<double>(bar.layer) * lattice::unitVector(site.axis);
    parts_.push_back({part,
                      catalogued(part).color,
                      {site.pose.position + shift, site.pose.rotation},
                      components_.ofRun[at(runId)],
                      bar.layer,
                      graph_.runs[at(runId)].piece});
  }

  void addMechanism(const mechanisms::Mechanism& mechanism, Vec3 origin, int piece, bool turning) {
    for (const mechanisms::MechanismPart& member : mechanism.parts) {
      const std::string id = turning ? withoutFriction(member.id) : member.id;
      parts_.push_back({id,
                        catalogued(id).color,
                        {origin + member.pose.position, member.pose.rotation},
                        -1,
                        0,
                        piece});
    }
  }

  void addRun(int runId) {
    const guide::GuideRun& run = graph_.runs[at(runId)];
    const Cover& cover = layout_.covers[at(runId)];
    for (const Beam& beam : cover.beams) {
      if (beam.site >= 0) {
        addFrame(runId, beam);
      } else if (beam.mate < 0) {
        addBeam(runId, beam);
      } else if (runId < beam.mate) {
        addBent(runId, beam);
      }
    }
    if (cover.axle.used()) {
      addAxle(run, cover);
    }
    for (std::size_t b = 1; b < cover.beams.size(); ++b) {
      const Beam& before = cover.beams[b - 1];
      const Beam& beam = cover.beams[b];
      for (const int node : layout::inlinePins(run, before, beam)) {
        const int low = std::min(before.layer, beam.layer);
        addPin(cover.axis, layout::holePosition(graph_, run, cover.axis, node, low), run.piece);
      }
    }
  }

  //! An axle and its bushes, all crosses turned alike.
  void addAxle(const guide::GuideRun& run, const Cover& cover) {
    const layout::Axle& axle = cover.axle;
    const layout::AxlePart& known = layout::axleParts()[at(axle.part)];
    const Vec3 wing = lattice::unitVector(cover.axis);
    const double middle = 0.5 * static_cast<double>(axle.start + axle.last());
    addCrossed(known.part,
               known.end,
               axle.turned ? -run.direction : run.direction,
               wing,
               layout::holePosition(graph_, run, cover.axis, middle, 0),
               run.piece);
    for (int i = axle.start; i <= axle.last(); ++i) {
      if (axle.hasBush(i)) {
        addCrossed(layout::kBush,
                   catalogued(layout::kBush).features.front().axis,
                   run.direction,
                   wing,
                   layout::holePosition(graph_, run, cover.axis, i, 0),
                   run.piece);
      }
    }
  }

  //! A part of one axle or axle hole, with the direction `end` of its own turned to `direction`.
  //! \pre The wing is perpendicular to the direction.
  void addCrossed(
      const std::string& id, Vec3 end, Vec3 direction, Vec3 wing, Vec3 centre, int piece) {
    const parts::Part& part = catalogued(id);
    const lattice::Pose pose = crossedPose(part.features.front(), end, {centre, direction, wing});
    parts_.push_back({id, part.color, pose, -1, 0, piece});
  }

  //! A pin through two holes: the one at `lower`, and the next along the axis.
  void addPin(Axis axis, Vec3 lower, int piece) {
    Cell step;
    step[lattice::index(axis)] = 1;
    for (const mechanisms::TableEntry& entry : table_.between(step, axis, axis)) {
      const mechanisms::OrientedMechanism& m = table_.oriented(entry.mechanism);
      if (m.heads == 2 && m.shape.cells.size() == 2) {
        const Cell head = m.shape.cells[at(entry.headA)].at;
        addMechanism(m.shape, lower - lattice::toVec3(head), piece, false);
        return;
      }
    }
  }

  void addJunction(int junctionId) {
    const guide::Junction& junction = graph_.junctions[at(junctionId)];
    const Vec3 origin = graph_.nodes[at(junction.node)];
    const int piece = graph_.runs[at(junction.incident.front().run)].piece;
    for (const layout::PlacedMechanism& placed :
         layout_.junctions[at(junctionId)].connection.mechanisms) {
      const mechanisms::Mechanism& shape = table_.oriented(placed.oriented).shape;
      addMechanism(shape,
                   origin + lattice::toVec3(placed.at),
                   piece,
                   junction.joint >= 0 && turnsAtJoint(junction, shape, placed.at));
    }
    for (const layout::Spacer& spacer : layout_.junctions[at(junctionId)].spacers) {
      addSpacer(origin, spacer, piece);
    }
  }

  void addSpacer(Vec3 origin, const layout::Spacer& spacer, int piece) {
    const parts::Part& part = catalogued(layout::kSpacerPart);
    const Vec3 z = lattice::unitVector(spacer.axis);
    const Vec3 x =
        lattice::unitVector(lattice::axisFromIndex((lattice::index(spacer.axis) + 1) % 3));
    const Mat3 rotation = lattice::fromColumns(x, lattice::cross(z, x), z);
    const Vec3 centre = origin + static_cast<double>(spacer.layer) * z;
    parts_.push_back(
        {part.id, part.color, {centre - rotation * middleOfHoles(part), rotation}, -1, 0, piece});
  }

  //! A single pin on the joint's axis through the joint itself.
  [[nodiscard]] bool turnsAtJoint(const guide::Junction& junction,
                                  const mechanisms::Mechanism& shape,
                                  Cell place) const {
    const guide::GuideJoint& joint = graph_.joints[at(junction.joint)];
    const int k = lattice::index(joint.axis);
    return shape.parts.size() == 1 &&
           std::all_of(
               shape.cells.begin(), shape.cells.end(), [&](const mechanisms::MechanismCell& cell) {
                 const Cell p = cell.at + place;
                 return cell.head && cell.axis == joint.axis && p[(k + 1) % 3] == 0 &&
                        p[(k + 2) % 3] == 0;
               });
  }

  const guide::GuidingGraph& graph_;
  const std::vector<layout::FrameSite>& sites_;
  const mechanisms::MechanismTable& table_;
  const search::LayoutSnapshot& layout_;
  layout::Components components_;
  std::vector<model::PlacedPart> parts_;
};

}  // namespace

const parts::Part& straightBeamPart(int holes) {
  const parts::Part* best = nullptr;
  for (const parts::Part& part : parts::Catalogue::builtIn().parts()) {
    const bool roundHoles =
        std::all_of(part.features.begin(), part.features.end(), [](const parts::Feature& feature) {
          return feature.kind == parts::FeatureKind::kPinHole;
        });
    if (part.holes == holes && roundHoles &&
        (best == nullptr || part.thickness > best->thickness)) {
      best = &part;
    }
  }
  LIFTARM_CHECK(best != nullptr, "the catalogue has every length that the search uses");
  return *best;
}

model::Model buildModel(const layout::LayoutProblem& problem,
                        const mechanisms::MechanismTable& table,
                        const search::LayoutSnapshot& layout,
                        const std::string& name,
                        const std::string& sketchJson) {
  model::Model result;
  result.name = name;
  result.sketchJson = sketchJson;
  result.parts = Builder(problem, table, layout).build();
  return result;
}

}  // namespace liftarm::design
