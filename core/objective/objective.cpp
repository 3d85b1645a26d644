#include "objective/objective.h"

#include <algorithm>

namespace liftarm::objective {

namespace {

constexpr std::array<std::string_view, 5> kPresetNames{
    "faithful", "simple", "faithful-rigid", "simple-rigid", "balanced"};

void set(Weights* weights, std::string_view name, double weight) {
  (*weights)[*termIndex(name)] = weight;
}

bool isFaithful(Preset p) {
  return p == Preset::kFaithful || p == Preset::kFaithfulRigid;
}

}  // namespace

bool isRigid(Preset preset) {
  return preset == Preset::kFaithfulRigid || preset == Preset::kSimpleRigid ||
         preset == Preset::kBalanced;
}

Scale scaleOf(const guide::GuidingGraph& graph) {
  Scale scale;
  scale.nodes = std::max(1.0, static_cast<double>(graph.nodes.size()));
  scale.edges = std::max(1.0, static_cast<double>(graph.edges));
  double branching = 0.0;
  for (const int degree : graph.degrees) {
    branching += static_cast<double>(degree - 1) * static_cast<double>(degree - 1);
  }
  scale.branching = std::max(1.0, branching);
  return scale;
}

std::optional<std::size_t> termIndex(std::string_view name) {
  const auto found = std::find_if(
      kTerms.begin(), kTerms.end(), [&](const Term& term) { return term.name == name; });
  if (found == kTerms.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - kTerms.begin());
}

std::optional<Preset> presetFromName(std::string_view name) {
  const auto found = std::find(kPresetNames.begin(), kPresetNames.end(), name);
  if (found == kPresetNames.end()) {
    return std::nullopt;
  }
  return static_cast<Preset>(found - kPresetNames.begin());
}

std::string_view nameOf(Preset preset) {
  return kPresetNames[static_cast<std::size_t>(preset)];
}

namespace {

//! A beam costs as much as before, so that few are laid; a layer off the line a good deal more than
//! for `simple`, so that what can lie on its line does.
Weights balancedWeights() {
  Weights weights{};
  set(&weights, "beams", 10.0);
  set(&weights, "holes", 0.05);
  set(&weights, "layers", 0.3);
  set(&weights, "overhang", 4.0);
  set(&weights, "hinges", 5.0);
  set(&weights, "connections", 1.0);
  set(&weights, "violations", 25.0);
  return weights;
}

}  // namespace

Weights searchWeights(Preset preset) {
  if (preset == Preset::kBalanced) {
    return balancedWeights();
  }
  Weights weights{};
  set(&weights, "beams", isFaithful(preset) ? 4.0 : 10.0);
  set(&weights, "holes", 0.05);
  set(&weights, "layers", isFaithful(preset) ? 0.5 : 0.02);
  set(&weights, "overhang", isFaithful(preset) ? 6.0 : 2.0);
  set(&weights, "hinges", isRigid(preset) ? 8.0 : 3.0);
  set(&weights, "connections", isRigid(preset) ? 0.5 : 1.0);
  set(&weights, "violations", 25.0);
  return weights;
}

Weights paperWeights(Preset preset) {
  Weights weights{};
  set(&weights, "dev", isFaithful(preset) ? 100.0 : 0.0);
  set(&weights, "cpt", 1.0);
  set(&weights, "sym", 30.0);
  set(&weights, "tbl", isFaithful(preset) ? 0.0 : 100.0);
  set(&weights, "phr", 10.0);
  set(&weights, "col", 30.0);
  set(&weights, "gap", 100.0);
  set(&weights, "coh", 50.0);
  set(&weights, "rgd", isRigid(preset) ? 100.0 : 0.0);
  return weights;
}

double value(const Measures& measures, const Weights& weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kTerms.size(); ++i) {
    if (weights[i] != 0.0) {
      sum += weights[i] * kTerms[i].value(measures);
    }
  }
  return sum;
}

double delta(const Measures& before, const Measures& after, const Weights& weights) {
  return value(after, weights) - value(before, weights);
}

}  // namespace liftarm::objective
