#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "analysis/constraints.h"
#include "analysis/union_find.h"
#include "analysis/well_built_items.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;

bool isFrame(const ScenePart& part) {
  return part.part != nullptr && part.part->partClass == parts::PartClass::kBeam &&
         part.part->features.size() > 1;
}

//! Groups of parts that axles in axle holes make one, and the links between them.
class Hangings {
 public:
  explicit Hangings(const Scene& scene)
      : linkage_(linkageOf(scene, Friction::kFree)), groups_(scene.parts.size()) {
    for (const Link& link : linkage_.links) {
      if (!link.turns && !link.shifts) {
        groups_.join(link.a, link.b);
      }
    }
    frame_.resize(scene.parts.size(), false);
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
      frame_[at(groups_.find(static_cast<int>(i)))] =
          frame_[at(groups_.find(static_cast<int>(i)))] || isFrame(scene.parts[i]);
    }
    links_.resize(scene.parts.size());
    for (const Link& link : linkage_.links) {
      const int a = groups_.find(link.a);
      const int b = groups_.find(link.b);
      if (a != b) {
        links_[at(a)].push_back({b, &link});
        links_[at(b)].push_back({a, &link});
      }
    }
    dropLooseEnds();
  }

  //! The one line on which a beam hangs; null where it hangs on several or on none.
  [[nodiscard]] const Link* onlyLine(int beam) {
    const std::vector<Hanging>& hangings = links_[at(groups_.find(beam))];
    const bool one =
        !hangings.empty() && std::all_of(hangings.begin(), hangings.end(), [&](const Hanging& h) {
          return onOneLine(*h.link, *hangings.front().link);
        });
    return one ? hangings.front().link : nullptr;
  }

 private:
  struct Hanging {
    int other = -1;
    const Link* link = nullptr;
  };

  //! What hangs on one thing only and is no beam holds nothing: pins with a naked head, bushes.
  void dropLooseEnds() {
    std::vector<int> open;
    for (std::size_t g = 0; g < links_.size(); ++g) {
      open.push_back(static_cast<int>(g));
    }
    while (!open.empty()) {
      const int group = open.back();
      open.pop_back();
      std::set<int> others;
      for (const Hanging& hanging : links_[at(group)]) {
        others.insert(hanging.other);
      }
      if (frame_[at(group)] || others.size() != 1) {
        continue;
      }
      const int other = *others.begin();
      links_[at(group)].clear();
      std::vector<Hanging>& rest = links_[at(other)];
      rest.erase(std::remove_if(
                     rest.begin(), rest.end(), [&](const Hanging& h) { return h.other == group; }),
                 rest.end());
      open.push_back(other);
    }
  }

  Linkage linkage_;
  UnionFind groups_;
  std::vector<bool> frame_;
  std::vector<std::vector<Hanging>> links_;
};

bool isJoint(const Scene& scene, const Link& link) {
  if (!scene.sketch.has_value()) {
    return false;
  }
  constexpr double kOneLine = 0.06;  // as files round and lines snap
  return std::any_of(
      scene.sketch->joints.begin(), scene.sketch->joints.end(), [&](const sketch::Joint& joint) {
        return lattice::length(lattice::cross(joint.axis, link.axis)) < kOneLine &&
               lattice::length(lattice::cross(joint.at - link.at, link.axis)) < kOneLine;
      });
}

//! What moves in each freedom that no joint accounts for.
void tellMotions(const WellBuiltQuery& query, WellBuiltItem& item) {
  constexpr int kMostMotions = 20;  // each names all that moves
  int told = 0;
  for (const FreeMotion& motion : query.motion.free.motions) {
    Problem place{"freedom", "", std::nullopt, {}};
    for (std::size_t i = 0; motion.joint < 0 && i < motion.twists.size(); ++i) {
      const Twist& twist = motion.twists[i];
      if (!(twist.linear == lattice::Vec3{}) || !(twist.angular == lattice::Vec3{})) {
        place.parts.push_back(static_cast<int>(i));
      }
    }
    if (!place.parts.empty() && told++ < kMostMotions) {
      place.message = nameOf(query.scene, place.parts.front()) + " and what hangs on it, " +
                      std::to_string(place.parts.size()) +
                      " parts in all, move where no joint lets them";
      place.at = query.scene.model->parts[at(place.parts.front())].pose.position;
      item.places.push_back(std::move(place));
    }
  }
}

}  // namespace

WellBuiltItem judgeStiffness(const WellBuiltQuery& query) {
  WellBuiltItem item;
  item.id = "stiff";
  item.title = "Nothing moves but the joints";
  Hangings hangings(query.scene);
  int beams = 0;
  int turning = 0;
  for (std::size_t i = 0; i < query.scene.parts.size(); ++i) {
    if (!isFrame(query.scene.parts[i])) {
      continue;
    }
    ++beams;
    const int beam = static_cast<int>(i);
    const Link* line = hangings.onlyLine(beam);
    if (line != nullptr && !isJoint(query.scene, *line)) {
      ++turning;
      item.places.push_back(
          {"oneAxis",
           nameOf(query.scene, beam) + " turns about one line at " + pointText(line->at),
           line->at,
           {beam}});
    }
  }
  const int loose = query.motion.free.beyondJoints;
  tellMotions(query, item);
  for (const Brace& brace : query.motion.braces) {
    item.places.push_back({"brace", brace.message, 0.5 * (brace.from + brace.to), {}});
  }
  item.ok = loose == 0 && turning == 0;
  item.detail = std::to_string(loose) + " freedoms beyond the joints, " + std::to_string(turning) +
                " of " + std::to_string(beams) + " beams turn about one line";
  item.figures = {{"freedomsBeyondJoints", loose}, {"beamsOnOneAxis", turning}, {"beams", beams}};
  return item;
}

}  // namespace liftarm::analysis
