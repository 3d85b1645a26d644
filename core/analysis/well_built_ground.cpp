#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "analysis/assembly.h"
#include "analysis/support.h"
#include "analysis/well_built_items.h"
#include "parts/gear_teeth.h"
#include "sketch/shaft_json.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr double kInPlane = 1e-3;    // modules
constexpr double kWellInside = 0.5;  // modules: a beam's half width decides below it
// Modules: a beam on its side is rounded, and so half a millimetre less high than one that lies
// flat or a connector. Nobody builds one foot higher for that.
constexpr double kEven = 0.06;

bool touches(double z, double plane) {
  return std::abs(z - plane) < kInPlane;
}

//! Whether a drawing has wheels at the ends of its shafts: what is drawn to roll stands on them.
bool hasDrawnWheels(const std::string& sketchJson) {
  const std::vector<sketch::Shaft> shafts = sketch::shaftsOf(sketchJson).shafts;
  return std::any_of(shafts.begin(), shafts.end(), [](const sketch::Shaft& shaft) {
    return shaft.atFrom == sketch::ShaftEnd::kWheel || shaft.atTo == sketch::ShaftEnd::kWheel;
  });
}

//! What lies in the lowest plane of some lines, and whether their own centre is above it. What lies
//! flat has no feet: beams that pass each other lie on each other there.
struct Base {
  double plane = 1e9;
  bool flat = false;   // a line lies in it
  bool rises = false;  // something is drawn above it
  bool stands = false;
  std::vector<GroundPoint> corners;
};

bool isWellInside(const std::vector<GroundPoint>& corners, GroundPoint p) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const GroundPoint a = corners[i];
    const GroundPoint b = corners[(i + 1) % corners.size()];
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double inside = (x * (p.y - a.y) - y * (p.x - a.x)) / std::sqrt(x * x + y * y);
    if (inside < kWellInside) {
      return false;
    }
  }
  return corners.size() >= 3;
}

Base baseOf(const std::vector<const sketch::Line*>& lines) {
  Base base;
  GroundPoint moment;
  double length = 0.0;
  for (const sketch::Line* line : lines) {
    base.plane = std::min({base.plane, line->from.z, line->to.z});
    moment.x += line->length * (line->from.x + line->to.x) / 2;
    moment.y += line->length * (line->from.y + line->to.y) / 2;
    length += line->length;
  }
  std::vector<GroundPoint> points;
  for (const sketch::Line* line : lines) {
    int ends = 0;
    for (const Vec3 end : {line->from, line->to}) {
      if (touches(end.z, base.plane)) {
        points.push_back({end.x, end.y});
        ++ends;
      } else {
        base.rises = true;
      }
    }
    base.flat = base.flat || ends == 2;
  }
  base.corners = convexHull(points);
  base.stands = isWellInside(base.corners, {moment.x / length, moment.y / length});
  return base;
}

//! The base of each connected part of the sketch.
std::vector<Base> basesOf(const WellBuiltQuery& query) {
  const std::vector<int> pieces = piecesOfSketch(query.scene, query.coverage);
  std::vector<std::vector<const sketch::Line*>> lines;
  for (std::size_t l = 0; l < pieces.size(); ++l) {
    const auto piece = static_cast<std::size_t>(pieces[l]);
    lines.resize(std::max(lines.size(), piece + 1));
    lines[piece].push_back(&query.scene.sketch->lines[l]);
  }
  std::vector<Base> bases;
  bases.reserve(lines.size());
  for (const std::vector<const sketch::Line*>& ofPiece : lines) {
    bases.push_back(baseOf(ofPiece));
  }
  return bases;
}

//! A corner of the base, with the parts that stand for it.
struct Foot {
  Vec3 at;
  std::vector<int> parts;
  double level = 1e9;  // of their lowest point
};

class GroundJudge {
 public:
  explicit GroundJudge(const WellBuiltQuery& query) : query_(query), bases_(basesOf(query)) {}

  WellBuiltItem judge() {
    item_.id = "stands";
    item_.title = "Stands on its base";
    for (const Base& base : bases_) {
      plane_ = std::min(plane_, base.plane);
    }
    const bool stands =
        !bases_.empty() &&
        std::all_of(bases_.begin(), bases_.end(), [](const Base& b) { return b.stands; });
    const bool flat = std::any_of(bases_.begin(), bases_.end(), [&](const Base& base) {
      return base.flat && touches(base.plane, plane_);
    });
    item_.applies = stands || flat;
    if (!item_.applies) {
      item_.detail = "the drawing has no base to stand on";
      return std::move(item_);
    }
    findFeet();
    const int below = countBelow();
    const int lifted = countLifted();
    const bool falls =
        stands && query_.motion.balance.has_value() && !query_.motion.balance->stable;
    item_.ok = below == 0 && lifted == 0 && !falls;
    item_.detail = std::to_string(below) + " parts below the base, " + std::to_string(lifted) +
                   " of " + std::to_string(feet_.size()) + " feet in the air";
    item_.detail += falls ? "; it falls over where the drawing stands" : "";
    item_.figures = {{"flatBase", flat ? 1 : 0},
                     {"couldStand", stands ? 1 : 0},
                     {"belowBase", below},
                     {"liftedFeet", lifted},
                     {"feet", static_cast<double>(feet_.size())},
                     {"fallsOver", falls ? 1 : 0}};
    if (falls) {
      item_.places.push_back({"fallsOver",
                              "its centre of mass is not above what it stands on",
                              query_.motion.balance->centre,
                              {}});
    }
    return std::move(item_);
  }

 private:
  //! Parts that cover an edge at a corner of the base; the nearest of all where none does.
  void findFeet() {
    for (const Base& base : bases_) {
      for (const GroundPoint corner : base.corners) {
        if (touches(base.plane, plane_) && base.rises) {
          feet_.push_back({{corner.x, corner.y, plane_}, {}, 1e9});
        }
      }
    }
    for (Foot& foot : feet_) {
      std::set<int> parts;
      for (const EdgeCover& edge : query_.coverage) {
        if (lattice::length(edge.from - foot.at) < kInPlane ||
            lattice::length(edge.to - foot.at) < kInPlane) {
          for (const Cover& cover : edge.covers) {
            parts.insert(cover.part);
          }
        }
      }
      foot.parts.assign(parts.begin(), parts.end());
      if (foot.parts.empty()) {
        addNearest(foot);
      }
      if (!foot.parts.empty()) {
        foot.level = lowestPoint(query_.scene, foot.parts);
        floor_ = std::min(floor_, foot.level);
      }
    }
    addFloorOfBeams();
  }

  //! The part that reaches nearest to a foot that no beam covers: a mechanism bridges it.
  void addNearest(Foot& foot) const {
    double nearest = 1e9;
    for (std::size_t i = 0; i < query_.scene.parts.size(); ++i) {
      for (const Shape& shape : query_.scene.parts[i].shapes) {
        const double distance = std::min(lattice::length(shape.prism.from - foot.at),
                                         lattice::length(shape.prism.to - foot.at));
        if (distance < nearest) {
          nearest = distance;
          foot.parts = {static_cast<int>(i)};
        }
      }
    }
  }

  //! Beams that lie along the base's lines may be lower than those at its corners.
  void addFloorOfBeams() {
    std::set<int> parts;
    for (const EdgeCover& edge : query_.coverage) {
      if (touches(edge.from.z, plane_) && touches(edge.to.z, plane_)) {
        for (const Cover& cover : edge.covers) {
          parts.insert(cover.part);
        }
      }
    }
    if (!parts.empty()) {
      floor_ = std::min(floor_, lowestPoint(query_.scene, {parts.begin(), parts.end()}));
    }
  }

  int countBelow() {
    const bool rolls = hasDrawnWheels(query_.scene.model->sketchJson);
    int below = 0;
    for (std::size_t i = 0; i < query_.scene.parts.size(); ++i) {
      const int part = static_cast<int>(i);
      if (query_.scene.parts[i].box.min.z > floor_ || query_.scene.parts[i].shapes.empty() ||
          lowestPoint(query_.scene, {part}) > floor_ - kEven ||
          (rolls && query_.scene.model->parts[i].part == parts::kWheel)) {
        continue;
      }
      ++below;
      item_.places.push_back({"belowBase",
                              nameOf(query_.scene, part) + " lies below the base",
                              query_.scene.model->parts[i].pose.position,
                              {part}});
    }
    return below;
  }

  int countLifted() {
    int lifted = 0;
    for (const Foot& foot : feet_) {
      if (foot.level > floor_ + kEven) {
        ++lifted;
        item_.places.push_back({"liftedFoot",
                                "the foot at " + pointText(foot.at) + " is in the air",
                                foot.at,
                                foot.parts});
      }
    }
    return lifted;
  }

  const WellBuiltQuery& query_;
  std::vector<Base> bases_;
  double plane_ = 1e9;  // the lowest that is drawn
  double floor_ = 1e9;  // the lowest that stands for it
  std::vector<Foot> feet_;
  WellBuiltItem item_;
};

}  // namespace

WellBuiltItem judgeStanding(const WellBuiltQuery& query) {
  return GroundJudge(query).judge();
}

}  // namespace liftarm::analysis
