#include "analysis/stress.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/frame_solver.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

constexpr int kMaxRounds = 80;
constexpr int kRoundsTogether = 25;      // then one contact changes at a time
constexpr double kPullTolerance = 1e-8;  // of the load
constexpr double kMoves = 0.1;           // of the greatest motion
constexpr std::size_t kNamedParts = 5;

Vec3 translation(const Six& six) {
  return {six[0], six[1], six[2]};
}

Vec3 rotation(const Six& six) {
  return {six[3], six[4], six[5]};
}

//! Parts that move, those that move most first.
std::vector<int> movingParts(const FrameModel& model, const std::vector<Six>& motion) {
  std::vector<std::pair<double, int>> found;
  for (std::size_t part = 0; part < model.nodesOfPart.size(); ++part) {
    double most = 0.0;
    for (const int node : model.nodesOfPart[part]) {
      const Six& six = motion[static_cast<std::size_t>(node)];
      const Vec3 turn{six[3], six[4], six[5]};
      // A part that only turns moves by its rim.
      most = std::max(
          {most, lattice::length(translation(six)), lattice::length(turn) * kBeamWidth / 2.0});
    }
    if (most > kMoves) {
      found.emplace_back(-most, static_cast<int>(part));
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<int> parts;
  for (const auto& [most, part] : found) {
    parts.push_back(part);
  }
  return parts;
}

std::string namesOf(const Scene& scene, const std::vector<int>& parts) {
  std::string text;
  for (std::size_t i = 0; i < std::min(parts.size(), kNamedParts); ++i) {
    text += (i == 0 ? "" : ", ") + nameOf(scene, parts[i]);
  }
  if (parts.size() > kNamedParts) {
    text += " and " + std::to_string(parts.size() - kNamedParts) + " more";
  }
  return text;
}

std::string adviceFor(FitHold friction) {
  switch (friction) {
    case FitHold::kFree:
      return "brace it, or reckon with pins that friction holds";
    case FitHold::kHeld:
      return "brace it, or reckon with all fits locked, pins without friction too";
    case FitHold::kLocked:
      return "something is not connected";
  }
  return "";
}

//! Gives the state of a frame that moves.
//! Whether a motion moves the whole frame as one: it does not fold, it rolls or tips over.
bool movesAsOne(const Frame& frame, const std::vector<Six>& motion) {
  constexpr double kShare = 1e-4;  // of the greatest displacement
  if (motion.empty()) {
    return false;
  }
  const Vec3 turn = rotation(motion.front());
  double greatest = 0.0;
  double apart = 0.0;
  for (std::size_t node = 0; node < motion.size(); ++node) {
    const Vec3 arm = frame.nodes[node] - frame.nodes.front();
    const Vec3 expected = translation(motion.front()) + lattice::cross(turn, arm);
    const double unit = std::max(1.0, lattice::length(arm));
    greatest = std::max({greatest,
                         lattice::length(translation(motion[node])),
                         unit * lattice::length(rotation(motion[node]))});
    apart = std::max({apart,
                      lattice::length(translation(motion[node]) - expected),
                      unit * lattice::length(rotation(motion[node]) - turn)});
  }
  return apart < kShare * greatest;
}

void tellMotion(const Scene& scene, const char* how, FitHold friction, StressState& state) {
  state.stands = false;
  state.moving = movingParts(state.model, state.displacements);
  state.message =
      std::string(how) + ": " + namesOf(scene, state.moving) + "; " + adviceFor(friction);
}

//! Finds which contacts carry.
class ContactSolver {
 public:
  explicit ContactSolver(const Frame& frame)
      : frame_(frame), solver_(frame), loads_(nodalLoads(frame)) {
    active_.assign(frame.contacts.size(), true);
    for (const Six& load : loads_) {
      size_ += lattice::length(translation(load));
    }
  }

  enum class End { kStands, kFolds, kTips, kUndecided };

  End run() {
    if (!solver_.prepare(active_)) {
      displacements_ = solver_.motion();
      return End::kFolds;
    }
    displacements_ = solver_.solve(loads_);
    for (int round = 0; round < kMaxRounds; ++round) {
      if (!update(round < kRoundsTogether)) {
        return End::kStands;
      }
      while (!solver_.prepare(active_)) {
        displacements_ = solver_.motion();
        if (!catchFall()) {
          return End::kTips;
        }
      }
      displacements_ = solver_.solve(loads_);
    }
    return End::kUndecided;
  }

  [[nodiscard]] const std::vector<bool>& active() const { return active_; }

  [[nodiscard]] const std::vector<Six>& displacements() const { return displacements_; }

 private:
  //! \return What the contact would push up with, N; below 0 it would pull.
  [[nodiscard]] double push(std::size_t contact) const {
    return springForces(frame_, frame_.contacts[contact], displacements_)[2];
  }

  //! Lets go of what pulls and takes what sinks in. \return Whether anything changed.
  bool update(bool together) {
    double worst = kPullTolerance * size_;
    std::size_t which = active_.size();
    bool changed = false;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const double force = push(i);
      const double wrong = active_[i] ? -force : force;
      if (wrong <= kPullTolerance * size_) {
        continue;
      }
      changed = true;
      if (together) {
        active_[i] = !active_[i];
      } else if (wrong > worst) {
        worst = wrong;
        which = i;
      }
    }
    if (which < active_.size()) {
      active_[which] = !active_[which];
    }
    return changed;
  }

  //! The frame falls the way its loads push: puts in the contacts that would stop it.
  //! \return False where there are none.
  bool catchFall() {
    double work = 0.0;
    for (std::size_t node = 0; node < loads_.size(); ++node) {
      for (std::size_t k = 0; k < 6; ++k) {
        work += loads_[node][k] * displacements_[node][k];
      }
    }
    for (Six& six : displacements_) {
      for (double& value : six) {
        value = work < 0.0 ? -value : value;
      }
    }
    constexpr double kSinks = 1e-3;  // of the greatest motion, mm of 1 mm
    bool caught = false;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (!active_[i] && push(i) > kSinks * kGroundStiffness) {
        active_[i] = true;
        caught = true;
      }
    }
    return caught;
  }

  const Frame& frame_;
  FrameSolver solver_;
  std::vector<Six> loads_;
  double size_ = 0.0;  // of all loads, N
  std::vector<bool> active_;
  std::vector<Six> displacements_;
};

double safetyOf(double yield, double stress) {
  return stress * kMaxSafety > yield ? yield / stress : kMaxSafety;
}

void addBars(const StressState& state, StressReport& report, std::map<int, PinStress>& pins) {
  const Frame& frame = state.model.frame;
  for (const FrameElement& element : frame.elements) {
    const Section& section = frame.sections[static_cast<std::size_t>(element.section)];
    const Vec3 a = frame.nodes[static_cast<std::size_t>(element.a)];
    const Vec3 b = frame.nodes[static_cast<std::size_t>(element.b)];
    PartStress& part = report.parts[static_cast<std::size_t>(element.part)];
    for (const double share : {0.0, 0.5, 1.0}) {
      const SectionForces forces = forcesAt(frame, element, state.displacements, share);
      const int end = share < 0.5 ? element.a : element.b;
      StressSample sample;
      sample.at = (1.0 / kMillimetresPerModule) * (a + share * (b - a));
      sample.stress = vonMises(section, forces);
      sample.displacement = share == 0.5
                                ? middleDisplacement(frame, element, state.displacements)
                                : translation(state.displacements[static_cast<std::size_t>(end)]);
      part.stress = std::max(part.stress, sample.stress);
      part.samples.push_back(sample);
      if (element.head) {
        PinStress& pin = pins[element.part];
        pin.shear = std::max(
            pin.shear, lattice::length(Vec3{0.0, forces.shearY, forces.shearZ}) / section.netShear);
      }
    }
  }
}

//! Torques that friction holds, by the part with the head.
void addHeldTorques(const Scene& scene, const StressState& state, std::map<int, PinStress>& pins) {
  const FrameModel& model = state.model;
  for (std::size_t s = 0; s < model.frame.springs.size(); ++s) {
    const int connection = model.connectionOfSpring[s];
    if (connection < 0) {
      continue;
    }
    const model::Connection& fit = scene.connections[static_cast<std::size_t>(connection)];
    if (fit.fit == model::Fit::kRigid) {
      continue;
    }
    const Six forces = springForces(model.frame, model.frame.springs[s], state.displacements);
    PinStress& pin = pins[fit.male];
    pin.torque = std::max(pin.torque, std::abs(forces[3]));
  }
}

//! Forces of the ground, one for each point that carries.
std::vector<Reaction> reactionsOf(const StressState& state) {
  const Frame& frame = state.model.frame;
  std::map<std::tuple<double, double, double>, Reaction> found;
  const auto add = [&](const FrameSpring& spring) {
    const Six local = springForces(frame, spring, state.displacements);
    const Vec3 force = spring.axes * Vec3{local[0], local[1], local[2]};
    const Vec3 at = (1.0 / kMillimetresPerModule) * spring.at;
    Reaction& reaction = found[{at.x, at.y, at.z}];
    reaction.at = at;
    reaction.force = reaction.force + force;
  };
  for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
    if (state.touching[i]) {
      add(frame.contacts[i]);
    }
  }
  for (std::size_t s = 0; s < frame.springs.size(); ++s) {
    if (state.model.connectionOfSpring[s] < 0) {
      add(frame.springs[s]);
    }
  }
  std::vector<Reaction> reactions;
  for (const auto& [at, reaction] : found) {
    reactions.push_back(reaction);
  }
  return reactions;
}

double imbalanceOf(const Frame& frame, const std::vector<Reaction>& reactions) {
  Vec3 sum;
  double greatest = 0.0;
  const auto add = [&](Vec3 force) {
    sum = sum + force;
    greatest = std::max(greatest, lattice::length(force));
  };
  for (const Six& load : nodalLoads(frame)) {
    add(translation(load));
  }
  for (const Reaction& reaction : reactions) {
    add(reaction.force);
  }
  return greatest > 0.0 ? lattice::length(sum) / greatest : 0.0;
}

}  // namespace

base::Result<StressState> solveStress(const Scene& scene, const StressOptions& options) {
  if (scene.parts.empty()) {
    return base::Error{base::Status::kInfeasible, "the model has no parts: nothing carries"};
  }
  base::Result<FrameModel> model = makeFrameModel(scene, options);
  if (!model.ok()) {
    return model.error();
  }
  StressState state;
  state.model = std::move(model).value();
  ContactSolver solver(state.model.frame);
  const ContactSolver::End end = solver.run();
  state.stands = end == ContactSolver::End::kStands;
  state.touching = solver.active();
  state.displacements = solver.displacements();
  const bool folds =
      end == ContactSolver::End::kFolds && !movesAsOne(state.model.frame, state.displacements);
  if (folds) {
    tellMotion(scene, "These parts can move without resistance", options.friction, state);
  } else if (end == ContactSolver::End::kTips || end == ContactSolver::End::kFolds) {
    tellMotion(scene, "The model tips over or slides away", options.friction, state);
  } else if (end == ContactSolver::End::kUndecided) {
    return base::Error{base::Status::kInfeasible,
                       "which feet carry the model could not be found: it rocks"};
  }
  return state;
}

StressReport reportStress(const Scene& scene, const StressState& state) {
  StressReport report;
  report.parts.resize(scene.parts.size());
  report.weight = state.model.weight;
  report.up = state.model.up;
  report.tilt = state.model.tilt;
  std::map<int, PinStress> pins;
  addBars(state, report, pins);
  addHeldTorques(scene, state, pins);
  const Frame& frame = state.model.frame;
  for (std::size_t part = 0; part < report.parts.size(); ++part) {
    PartStress& stress = report.parts[part];
    if (stress.samples.empty()) {
      const auto node = static_cast<std::size_t>(state.model.nodesOfPart[part].front());
      stress.samples.push_back({(1.0 / kMillimetresPerModule) * frame.nodes[node],
                                0.0,
                                translation(state.displacements[node])});
    }
    stress.safety = safetyOf(frame.material.yieldStress, stress.stress);
    stress.utilisation = stress.stress / frame.material.yieldStress;
    report.maxStress = std::max(report.maxStress, stress.stress);
    for (const StressSample& sample : stress.samples) {
      report.maxDisplacement =
          std::max(report.maxDisplacement, lattice::length(sample.displacement));
    }
  }
  report.safety = safetyOf(frame.material.yieldStress, report.maxStress);
  for (auto& [part, pin] : pins) {
    pin.part = part;
    pin.safety = safetyOf(frame.material.shearYield(), pin.shear);
    report.safety = std::min(report.safety, pin.safety);
    report.pins.push_back(pin);
  }
  report.reactions = reactionsOf(state);
  report.imbalance = imbalanceOf(frame, report.reactions);
  return report;
}

}  // namespace liftarm::analysis
