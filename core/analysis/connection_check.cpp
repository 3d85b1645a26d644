#include "analysis/connection_check.h"

#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace liftarm::analysis {

namespace {

using model::Connection;
using model::Fit;

std::string badFitText(Fit fit) {
  switch (fit) {
    case Fit::kWrongKind:
      return "a round pin does not go into an axle hole";
    case Fit::kTwisted:
      return "the cross of the axle is turned against the hole";
    case Fit::kMisplaced:
      return "the head lies between the slots of the hole";
    case Fit::kTurn:
    case Fit::kSlide:
    case Fit::kRigid:
      break;
  }
  return "";
}

void findBadFits(const Scene& scene, ItemResult& result) {
  std::set<std::pair<int, int>> told;
  for (const Connection& c : scene.connections) {
    if (!isGood(c.fit) && told.insert({c.male, c.female}).second) {
      result.problems.push_back({"badFit",
                                 nameOf(scene, c.male) + " in " + nameOf(scene, c.female) + " at " +
                                     pointText(c.at) + ": " + badFitText(c.fit),
                                 c.at,
                                 {c.male, c.female}});
    }
  }
}

void findSharedHoles(const Scene& scene, ItemResult& result) {
  using HoleSlot = std::tuple<int, int, int>;
  std::map<HoleSlot, std::vector<const Connection*>> holes;
  for (const Connection& c : scene.connections) {
    holes[{c.female, c.femaleFeature, c.femaleSlot}].push_back(&c);
  }
  for (const auto& [hole, heads] : holes) {
    // The two halves of a thin hole's head are one slot; a head can meet one slot only once.
    if (heads.size() < 2) {
      continue;
    }
    Problem problem{"sharedHole",
                    std::to_string(heads.size()) + " heads are in one hole of " +
                        nameOf(scene, std::get<0>(hole)) + " at " + pointText(heads[0]->at),
                    heads[0]->at,
                    {std::get<0>(hole)}};
    for (const Connection* c : heads) {
      problem.parts.push_back(c->male);
    }
    result.problems.push_back(std::move(problem));
  }
}

void findLooseParts(const Scene& scene, ItemResult& result) {
  std::vector<int> touching(scene.parts.size(), 0);
  std::vector<int> holding(scene.parts.size(), 0);
  for (const Connection& c : scene.connections) {
    for (const int part : {c.male, c.female}) {
      ++touching[static_cast<std::size_t>(part)];
      holding[static_cast<std::size_t>(part)] += c.fit == Fit::kSlide ? 0 : 1;
    }
  }
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (scene.parts[i].part == nullptr || holding[i] > 0 || scene.parts.size() < 2) {
      continue;
    }
    const int index = static_cast<int>(i);
    const bool loose = touching[i] > 0;
    if (!loose && scene.parts[i].part->partClass == parts::PartClass::kBeam) {
      continue;  // an assembly of its own: item 4 tells whether the sketch has a line for it
    }
    result.problems.push_back(
        {loose ? "loose" : "unconnected",
         nameOf(scene, index) +
             (loose ? " is held by nothing but axles in round holes: it can slide off"
                    : " is connected to nothing"),
         scene.model->parts[i].pose.position,
         {index}});
  }
}

}  // namespace

ItemResult checkConnections(const Scene& scene) {
  ItemResult result;
  findBadFits(scene, result);
  findSharedHoles(scene, result);
  findLooseParts(scene, result);
  result.detail = std::to_string(scene.connections.size()) + " heads in holes";
  return result;
}

}  // namespace liftarm::analysis
