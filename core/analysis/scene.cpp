#include "analysis/scene.h"

#include <cstddef>

#include "analysis/convex.h"
#include "model/number_text.h"
#include "sketch/sketch_json.h"

namespace liftarm::analysis {

namespace {

using lattice::Vec3;

parts::Prism placed(const lattice::Pose& pose, const parts::Prism& prism) {
  return {pose.apply(prism.from),
          pose.apply(prism.to),
          pose.rotation * prism.axis,
          prism.radius,
          prism.halfThickness};
}

void addHeads(const parts::Feature& feature,
              int index,
              const lattice::Pose& pose,
              std::vector<Shape>& shapes) {
  const double half = feature.length / static_cast<double>(feature.slots.size()) / 2;
  for (std::size_t s = 0; s < feature.slots.size(); ++s) {
    const Vec3 at = feature.slots[s];
    shapes.push_back({Shape::Kind::kHead,
                      placed(pose, {at, at, feature.axis, kHeadRadius, half}),
                      index,
                      static_cast<int>(s)});
  }
}

ScenePart makePart(const model::PlacedPart& source, const parts::Catalogue& catalogue) {
  ScenePart result;
  result.part = catalogue.find(source.part);
  if (result.part == nullptr) {
    return result;
  }
  for (const parts::Prism& prism : result.part->solid) {
    result.shapes.push_back({Shape::Kind::kBody, placed(source.pose, prism), -1, -1});
  }
  for (const parts::Prism& prism : result.part->collars) {
    result.shapes.push_back({Shape::Kind::kCollar, placed(source.pose, prism), -1, -1});
  }
  for (std::size_t f = 0; f < result.part->features.size(); ++f) {
    if (parts::isMale(result.part->features[f].kind)) {
      addHeads(result.part->features[f], static_cast<int>(f), source.pose, result.shapes);
    }
  }
  for (const Shape& shape : result.shapes) {
    result.box.add(boundsOf(shape.prism));
  }
  return result;
}

}  // namespace

Scene makeScene(const model::Model& model, const parts::Catalogue& catalogue) {
  Scene scene;
  scene.model = &model;
  for (const model::PlacedPart& part : model.parts) {
    scene.parts.push_back(makePart(part, catalogue));
  }
  scene.connections = model::findConnections(model, catalogue);
  if (!model.sketchJson.empty()) {
    const base::Result<sketch::Sketch> read = sketch::readSketch(model.sketchJson);
    if (read.ok()) {
      scene.sketch = read.value();
    } else {
      scene.sketchError = read.error().message;
    }
  }
  return scene;
}

std::string nameOf(const Scene& scene, int part) {
  const auto i = static_cast<std::size_t>(part);
  const parts::Part* known = scene.parts[i].part;
  return "part " + std::to_string(part) + " (" + scene.model->parts[i].part +
         (known != nullptr ? ", " + known->name : "") + ")";
}

std::string pointText(Vec3 p) {
  return "(" + model::numberText(p.x, 3) + ", " + model::numberText(p.y, 3) + ", " +
         model::numberText(p.z, 3) + ")";
}

}  // namespace liftarm::analysis
