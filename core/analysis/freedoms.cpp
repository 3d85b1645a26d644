#include "analysis/freedoms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "analysis/motion_basis.h"
#include "analysis/rank.h"
#include "analysis/union_find.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;
using lattice::Vec3;

constexpr double kStill = 1e-4;  // radians and modules per unit of motion

Link lineOf(const JointLine& joint) {
  Link link;
  link.at = joint.at;
  link.axis = joint.axis;
  return link;
}

//! Links on a joint's line come late, those of the first joint last.
std::vector<int> latenessOf(const Linkage& linkage, const std::vector<JointLine>& joints) {
  std::vector<int> lateness(linkage.links.size(), 0);
  for (std::size_t l = 0; l < linkage.links.size(); ++l) {
    for (std::size_t j = joints.size(); j-- > 0;) {
      if (onOneLine(linkage.links[l], lineOf(joints[j]))) {
        lateness[l] = static_cast<int>(joints.size() - j);
      }
    }
  }
  return lateness;
}

bool isSame(const Twist& p, const Twist& q) {
  return lattice::length(p.linear - q.linear) < kStill &&
         lattice::length(p.angular - q.angular) < kStill;
}

//! Numbers the bodies by what they do in some motions: equal numbers never move against each other.
std::vector<int> groupsOf(const std::vector<int>& assemblies,
                          const std::vector<std::vector<Twist>>& motions) {
  std::vector<int> groups(assemblies.size(), -1);
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < assemblies.size(); ++i) {
    const auto same = [&](std::size_t first) {
      return assemblies[first] == assemblies[i] &&
             std::all_of(motions.begin(), motions.end(), [&](const std::vector<Twist>& twists) {
               return isSame(twists[first], twists[i]);
             });
    };
    const auto known = std::find_if(firsts.begin(), firsts.end(), same);
    groups[i] = static_cast<int>(known - firsts.begin());
    if (known == firsts.end()) {
      firsts.push_back(i);
    }
  }
  return groups;
}

std::vector<std::vector<Twist>> allTwists(const MotionBasis& basis) {
  std::vector<std::vector<Twist>> twists;
  for (std::size_t m = 0; m < basis.size(); ++m) {
    twists.push_back(basis.twists(m));
  }
  return twists;
}

//! Only the links between bodies of one group.
Linkage within(const Linkage& linkage, const std::vector<int>& groups) {
  Linkage result;
  result.bodies = linkage.bodies;
  std::copy_if(linkage.links.begin(),
               linkage.links.end(),
               std::back_inserter(result.links),
               [&](const Link& link) { return groups[at(link.a)] == groups[at(link.b)]; });
  return result;
}

std::vector<int> noneLate(const Linkage& linkage) {
  return std::vector<int>(linkage.links.size(), 0);
}

//! Joins what blocks without a motion hold, until there is no more.
void mergeLocked(MergedLinkage& merged) {
  for (;;) {
    const int before = merged.linkage.bodies;
    const MotionBasis basis(merged.linkage, noneLate(merged.linkage));
    // What moves alike is not one body for that: at a dead point it may part. What links hold it
    // together must be rigid by themselves.
    const Linkage alike = within(merged.linkage, groupsOf(basis.assemblies(), allTwists(basis)));
    merged = mergeFurther(merged, MotionBasis(alike, noneLate(alike)).locked());
    if (merged.linkage.bodies == before) {
      return;
    }
  }
}

//! Which bodies of a merged linkage are frame bodies: in an assembly without any, all are.
std::vector<bool> framesOf(const FreedomsQuery& query, const MergedLinkage& merged) {
  UnionFind assemblies(at(merged.linkage.bodies));
  for (const Link& link : merged.linkage.links) {
    assemblies.join(link.a, link.b);
  }
  std::vector<bool> frame(at(merged.linkage.bodies), false);
  std::set<int> framed;
  for (std::size_t i = 0; i < merged.bodyOf.size(); ++i) {
    if (query.frame[i]) {
      frame[at(merged.bodyOf[i])] = true;
      framed.insert(assemblies.find(merged.bodyOf[i]));
    }
  }
  for (int body = 0; body < merged.linkage.bodies; ++body) {
    frame[at(body)] = frame[at(body)] || framed.count(assemblies.find(body)) == 0;
  }
  return frame;
}

//! For a body whose links all run on one line the link that holds it best; nothing for others.
const Link* onlyLine(const std::vector<const Link*>& links) {
  const Link* best = links.front();
  for (const Link* link : links) {
    if (!onOneLine(*link, *links.front())) {
      return nullptr;
    }
    best = best->shifts && !link->shifts ? link : best;
  }
  return best;
}

//! Every body by itself.
MergedLinkage unmerged(const Linkage& linkage) {
  MergedLinkage result;
  result.linkage = linkage;
  for (int body = 0; body < linkage.bodies; ++body) {
    result.bodyOf.push_back(body);
  }
  return result;
}

//! Pins and the like that only spin in their place: each becomes one with what holds it.
//! \return How many motions that took away.
int absorbSpinning(const FreedomsQuery& query, MergedLinkage& merged) {
  int spinning = 0;
  for (;;) {
    const std::vector<bool> frame = framesOf(query, merged);
    std::vector<std::vector<const Link*>> linksOf(at(merged.linkage.bodies));
    for (const Link& link : merged.linkage.links) {
      linksOf[at(link.a)].push_back(&link);
      linksOf[at(link.b)].push_back(&link);
    }
    std::vector<std::pair<int, int>> joined;
    std::vector<bool> touched(at(merged.linkage.bodies), false);
    for (std::size_t body = 0; body < linksOf.size(); ++body) {
      const Link* link = frame[body] || linksOf[body].empty() ? nullptr : onlyLine(linksOf[body]);
      // Of two neighbours that only spin one at a time: the next round sees what is left.
      if (link != nullptr && !touched[at(link->a)] && !touched[at(link->b)]) {
        touched[body] = true;
        const std::size_t other = at(link->a) == body ? at(link->b) : at(link->a);
        touched[other] = !frame[other];
        joined.emplace_back(link->a, link->b);
        spinning += link->shifts ? 2 : 1;
      }
    }
    if (joined.empty()) {
      return spinning;
    }
    merged = mergeFurther(merged, joined);
  }
}

//! The motions of a merged linkage, seen against what rests, with what they are for.
class MotionSorter {
 public:
  MotionSorter(const FreedomsQuery& query, const MergedLinkage& merged)
      : query_(query),
        merged_(merged),
        basis_(merged.linkage, latenessOf(merged.linkage, query.joints)),
        frame_(framesOf(query, merged)),
        weight_(at(merged.linkage.bodies), 0.0) {
    for (std::size_t i = 0; i < merged.bodyOf.size(); ++i) {
      weight_[at(merged.bodyOf[i])] += query.weight[i];
    }
    for (std::size_t m = 0; m < basis_.size(); ++m) {
      const MotionBasis::Driver driver = basis_.driver(m);
      motions_.push_back({-1, driver.link, driver.shifts, basis_.twists(m)});
    }
  }

  //! Only what `beyondJoints` of sorted() says.
  int countBeyondJoints() {
    for (FreeMotion& motion : motions_) {
      standOnFrame(motion.twists);
    }
    dropSpinning();
    Freedoms freedoms;
    freedoms.internal = static_cast<int>(motions_.size());
    countJoints(freedoms);
    return freedoms.beyondJoints;
  }

  Freedoms sorted() {
    for (FreeMotion& motion : motions_) {
      settle(motion.twists);
    }
    nameJoints();
    Freedoms freedoms;
    freedoms.merged = merged_;
    freedoms.spinning = dropSpinning();
    freedoms.internal = static_cast<int>(motions_.size());
    countJoints(freedoms);
    std::vector<std::vector<Twist>> twists;
    for (const FreeMotion& motion : motions_) {
      twists.push_back(motion.twists);
    }
    const std::vector<int> groups = groupsOf(basis_.assemblies(), twists);
    for (const int body : merged_.bodyOf) {
      freedoms.groupOf.push_back(groups[at(body)]);
    }
    for (const FreeMotion& motion : motions_) {
      FreeMotion ofAll{motion.joint, motion.link, motion.shifts, {}};
      for (const int body : merged_.bodyOf) {
        ofAll.twists.push_back(motion.twists[at(body)]);
      }
      freedoms.motions.push_back(std::move(ofAll));
    }
    return freedoms;
  }

 private:
  //! Brings the heaviest bodies of each assembly that move alike to rest.
  void settle(std::vector<Twist>& twists) const {
    const std::vector<int> groups = groupsOf(basis_.assemblies(), {twists});
    std::map<int, double> weights;
    for (std::size_t body = 0; body < twists.size(); ++body) {
      weights[groups[body]] += frame_[body] ? 1.0 + weight_[body] : 0.0;
    }
    std::map<int, std::pair<double, Twist>> rest;  // assembly -> weight, twist
    for (std::size_t body = 0; body < twists.size(); ++body) {
      auto& [heaviest, twist] = rest[basis_.assemblies()[body]];
      if (weights[groups[body]] > heaviest) {
        heaviest = weights[groups[body]];
        twist = twists[body];
      }
    }
    for (std::size_t body = 0; body < twists.size(); ++body) {
      twists[body] = twists[body] - rest[basis_.assemblies()[body]].second;
      if (isSame(twists[body], {})) {
        twists[body] = {};
      }
    }
  }

  //! Brings the first frame body of each assembly to rest.
  void standOnFrame(std::vector<Twist>& twists) const {
    std::map<int, Twist> rest;  // by assembly
    for (std::size_t body = 0; body < twists.size(); ++body) {
      if (frame_[body]) {
        rest.emplace(basis_.assemblies()[body], twists[body]);
      }
    }
    for (std::size_t body = 0; body < twists.size(); ++body) {
      twists[body] = twists[body] - rest[basis_.assemblies()[body]];
    }
  }

  [[nodiscard]] JointMove move(std::size_t joint, const FreeMotion& motion) const {
    JointLine line = query_.joints[joint];
    if (!line.hasBothSides()) {
      return {};
    }
    line.a = merged_.bodyOf[at(*line.a)];
    line.b = merged_.bodyOf[at(*line.b)];
    return jointMove(line, motion.twists);
  }

  //! Gives each joint the motion that turns it most, if one is left, and puts those first.
  void nameJoints() {
    for (std::size_t j = 0; j < query_.joints.size(); ++j) {
      FreeMotion* best = nullptr;
      double most = kStill;
      for (FreeMotion& motion : motions_) {
        const double speed = std::abs(move(j, motion).rate);
        if (motion.joint < 0 && speed > most * (1.0 + kStill)) {
          best = &motion;
          most = speed;
        }
      }
      if (best != nullptr) {
        best->joint = static_cast<int>(j);
      }
    }
    std::stable_sort(
        motions_.begin(), motions_.end(), [](const FreeMotion& p, const FreeMotion& q) {
          return static_cast<unsigned>(p.joint) < static_cast<unsigned>(q.joint);
        });
  }

  //! Keeps motions that are independent as motions of frame bodies. \return How many were not.
  int dropSpinning() {
    std::vector<std::size_t> frames;
    double unit = 1.0;
    for (std::size_t body = 0; body < frame_.size(); ++body) {
      if (frame_[body]) {
        frames.push_back(body);
      }
    }
    const std::vector<Link>& links = merged_.linkage.links;
    const Vec3 middle = links.empty() ? Vec3{} : links.front().at;
    for (const Link& link : links) {
      unit = std::max(unit, lattice::length(link.at - middle));
    }
    ColumnMatrix matrix(6 * frames.size(), motions_.size());
    std::vector<int> lateness;
    for (std::size_t m = 0; m < motions_.size(); ++m) {
      for (std::size_t f = 0; f < frames.size(); ++f) {
        const std::array<double, 6> entry = scaled(motions_[m].twists[frames[f]], middle, unit);
        std::copy(entry.begin(), entry.end(), matrix.column(m) + 6 * f);
      }
      lateness.push_back(static_cast<int>(m) + 1);
    }
    const NullBasis basis = findNullBasis(matrix, lateness);
    for (std::size_t i = basis.free.size(); i-- > 0;) {
      motions_.erase(motions_.begin() + static_cast<std::ptrdiff_t>(basis.free[i]));
    }
    return static_cast<int>(basis.free.size());
  }

  void countJoints(Freedoms& freedoms) const {
    ColumnMatrix rates(query_.joints.size(), motions_.size());
    for (std::size_t j = 0; j < query_.joints.size(); ++j) {
      bool turns = false;
      bool onAxis = true;
      for (std::size_t m = 0; m < motions_.size(); ++m) {
        const JointMove found = move(j, motions_[m]);
        rates.column(m)[j] = found.rate;
        turns = turns || std::abs(found.rate) > kStill;
        onAxis = onAxis && found.onAxis;
      }
      freedoms.jointTurns.push_back(turns && onAxis);
    }
    const NullBasis basis = findNullBasis(rates, std::vector<int>(motions_.size(), 0));
    freedoms.beyondJoints = freedoms.internal - static_cast<int>(basis.rank);
  }

  const FreedomsQuery& query_;
  const MergedLinkage& merged_;
  MotionBasis basis_;
  std::vector<bool> frame_;
  std::vector<double> weight_;
  std::vector<FreeMotion> motions_;
};

}  // namespace

JointMove jointMove(const JointLine& joint, const std::vector<Twist>& twists) {
  const Twist relative = twists[at(joint.b.value())] - twists[at(joint.a.value())];
  JointMove move;
  move.rate = lattice::dot(joint.axis, relative.angular);
  // Seen from the joint: from far away the least slant of an axis looks like a shift.
  move.onAxis =
      isSame({relative.velocityAt(joint.at), relative.angular}, {{}, move.rate * joint.axis});
  return move;
}

MergedLinkage mergeAll(const Linkage& linkage) {
  MergedLinkage merged = mergeRigid(linkage);
  mergeLocked(merged);
  return merged;
}

int countFreedomsBeyondJoints(const FreedomsQuery& query) {
  // Pins go first: without them there is half as much to merge.
  MergedLinkage merged = unmerged(query.linkage);
  absorbSpinning(query, merged);
  return MotionSorter(query, merged).countBeyondJoints();
}

Freedoms findFreedoms(const FreedomsQuery& query) {
  MergedLinkage merged = mergeRigid(query.linkage);
  const int absorbed = absorbSpinning(query, merged);
  mergeLocked(merged);
  Freedoms freedoms = MotionSorter(query, merged).sorted();
  freedoms.spinning += absorbed;
  return freedoms;
}

}  // namespace liftarm::analysis
