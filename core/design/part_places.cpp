#include "design/part_places.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/index.h"
#include "design/attempt.h"
#include "design/earlier_json.h"
#include "design/model_builder.h"
#include "design/settings.h"
#include "guide/beam_bound.h"
#include "layout/bent_beam.h"
#include "layout/frame_beam.h"
#include "layout/keeps.h"
#include "model/model_json.h"
#include "sketch/keep_json.h"
#include "sketch/sketch_json.h"

namespace liftarm::design {

namespace {

using base::at;
using lattice::Axis;
using lattice::Vec3;
using layout::Beam;
using layout::RunStretch;
using nlohmann::json;

constexpr double kSameLayer = 0.3;  // modules: halves of a thin pair are a quarter off
constexpr int kPast = 1;
constexpr std::size_t kMostFits = 24;

//! A part that lies on runs: one bar for each.
struct Body {
  std::string part;
  std::vector<RunStretch> bars;
  Axis axis = Axis::kX;
  int layer = 0;
};

//! All that is asked about.
class Places {
 public:
  static base::Result<std::unique_ptr<Places>> read(std::string_view modelJson,
                                                    std::string_view layoutJson,
                                                    std::string_view settingsJson) {
    base::Result<model::Model> model = model::readModel(modelJson);
    if (!model.ok()) {
      return model.error();
    }
    base::Result<sketch::Sketch> sketch = sketch::readSketch(model.value().sketchJson);
    if (!sketch.ok()) {
      return sketch.error();
    }
    base::Result<Settings> settings = readSettings(settingsJson);
    if (!settings.ok()) {
      return settings.error();
    }
    const json layout = json::parse(layoutJson.begin(), layoutJson.end(), nullptr, false);
    base::Result<search::EarlierLayout> earlier = readEarlier(layout);
    if (!earlier.ok()) {
      return earlier.error();
    }
    Settings wanted = std::move(settings).value();
    wanted.keeps = sketch::keepsOf(model.value().sketchJson, sketch.value());
    return std::unique_ptr<Places>(new Places(
        std::move(model).value(), std::move(sketch).value(), std::move(wanted), earlier.value()));
  }

  [[nodiscard]] json places() const {
    json all = json::array();
    for (const model::PlacedPart& placed : model_.parts) {
      const Body* body = bodyOf(placed);
      all.push_back(body == nullptr ? json() : placeJson(*body));
    }
    return all;
  }

  [[nodiscard]] json fits(int part) const {
    json all = json::array();
    const Body* body =
        part >= 0 && at(part) < model_.parts.size() ? bodyOf(model_.parts[at(part)]) : nullptr;
    if (body != nullptr) {
      for (const Body& other : candidates(*body)) {
        all.push_back(placeJson(other));
      }
    }
    return all;
  }

  [[nodiscard]] json layers(int part) const {
    json all = json::array();
    const Body* body =
        part >= 0 && at(part) < model_.parts.size() ? bodyOf(model_.parts[at(part)]) : nullptr;
    for (int layer = -guide::kMaxLayer; body != nullptr && layer <= guide::kMaxLayer; ++layer) {
      Body moved = *body;
      moved.layer = layer;
      const bool allowed =
          std::all_of(moved.bars.begin(), moved.bars.end(), [&](const RunStretch& bar) {
            return runOf(bar).allows(layer) && (!runOf(bar).exact || layer == 0);
          });
      if (layer != body->layer && allowed) {
        all.push_back(placeJson(moved));
      }
    }
    return all;
  }

 private:
  Places(model::Model model,
         sketch::Sketch sketch,
         Settings settings,
         const search::EarlierLayout& earlier)
      : model_(std::move(model)),
        sketch_(std::move(sketch)),
        settings_(std::move(settings)),
        problem_(problemOf(sketch_, settings_)),
        finder_(sketch_, problem_.graph) {
    std::vector<int> lengths;
    for (int n = 2; n <= guide::kLongestBeam + 1; ++n) {  // holes: one more than modules
      lengths.push_back(n);
    }
    const std::vector<int> bends = layout::allBentBeams();
    const std::vector<int> frames = layout::allFrameBeams();
    covers_ =
        search::keepRuns(problem_.graph, earlier, {lengths, bends, frames, problem_.sites}).covers;
    findBodies();
  }

  [[nodiscard]] const guide::GuideRun& runOf(const RunStretch& bar) const {
    return problem_.graph.runs[at(bar.run)];
  }

  void findBodies() {
    for (std::size_t r = 0; r < covers_.size(); ++r) {
      if (!covers_[r]) {
        continue;
      }
      for (const Beam& beam : covers_[r]->beams) {
        Body body = bodyAt(static_cast<int>(r), beam);
        if (!body.part.empty()) {
          bodies_.push_back(std::move(body));
        }
      }
    }
  }

  //! The part that a beam is, at the lowest of its runs; without a number at the others.
  [[nodiscard]] Body bodyAt(int run, const Beam& beam) const {
    Body body{"", {{run, beam.start, beam.holes}}, covers_[at(run)]->axis, beam.layer};
    if (beam.site >= 0) {
      const layout::FrameSite& site = problem_.sites[at(beam.site)];
      return site.arms.front().run == run ? bodyOfSite(site, beam.layer) : body;
    }
    if (beam.mate < 0) {
      body.part = straightBeamPart(beam.holes).id;
      return body;
    }
    if (run > beam.mate || !covers_[at(beam.mate)]) {
      return body;
    }
    for (const Beam& other : covers_[at(beam.mate)]->beams) {
      if (layout::isOneBeam(run, beam, beam.mate, other)) {
        body.part = layout::bentBeams()[at(beam.form)].part;
        body.bars.push_back({beam.mate, other.start, other.holes});
      }
    }
    return body;
  }

  static Body bodyOfSite(const layout::FrameSite& site, int layer) {
    Body body{layout::frameBeams()[at(site.frame)].part, {}, site.axis, layer};
    for (const layout::SiteArm& arm : site.arms) {
      body.bars.push_back({arm.run, arm.beam.start, arm.beam.holes});
    }
    return body;
  }

  [[nodiscard]] const Body* bodyOf(const model::PlacedPart& placed) const {
    const parts::Part* part = parts::Catalogue::builtIn().find(placed.part);
    if (part == nullptr) {
      return nullptr;
    }
    std::vector<Vec3> holes;
    for (const parts::Feature& feature : part->features) {
      holes.push_back(placed.pose.position + placed.pose.rotation * feature.center);
    }
    for (const Body& body : bodies_) {
      if (body.part == placed.part && liesIn(body, holes)) {
        return &body;
      }
    }
    return nullptr;
  }

  //! Whether each node of a body is at one of these holes.
  [[nodiscard]] bool liesIn(const Body& body, const std::vector<Vec3>& holes) const {
    return std::all_of(body.bars.begin(), body.bars.end(), [&](const RunStretch& bar) {
      for (int i = bar.start; i < bar.start + bar.holes; ++i) {
        const Vec3 node =
            layout::holePosition(problem_.graph, runOf(bar), body.axis, i, body.layer);
        if (std::none_of(holes.begin(), holes.end(), [&](Vec3 hole) {
              return lattice::length(hole - node) < kSameLayer;
            })) {
          return false;
        }
      }
      return true;
    });
  }

  [[nodiscard]] json placeJson(const Body& body) const {
    sketch::KeptPart part;
    part.part = body.part;
    part.on = finder_.lineOf(body.bars.front());
    part.layer = body.layer;
    part.holeAxis = body.axis;
    for (std::size_t i = 1; i < body.bars.size(); ++i) {
      part.with.push_back(finder_.lineOf(body.bars[i]));
    }
    return {{"line", part.on.line}, {"part", json::parse(sketch::keptPartText(part))}};
  }

  [[nodiscard]] std::vector<Body> candidates(const Body& body) const {
    std::vector<Body> all;
    for (const RunStretch& bar : body.bars) {
      addStraight(body, bar, &all);
      addBent(body, bar, &all);
      addFrames(body, bar, &all);
    }
    const auto same = [](const Body& a, const Body& b) {
      return a.part == b.part && a.bars.size() == b.bars.size() &&
             std::all_of(a.bars.begin(), a.bars.end(), [&](const RunStretch& bar) {
               return std::any_of(b.bars.begin(), b.bars.end(), [&](const RunStretch& other) {
                 return bar.run == other.run && bar.start == other.start &&
                        bar.holes == other.holes;
               });
             });
    };
    std::vector<Body> each;
    for (Body& one : all) {
      const bool known =
          same(one, body) ||
          std::any_of(each.begin(), each.end(), [&](const Body& b) { return same(one, b); });
      if (!known && each.size() < kMostFits) {
        each.push_back(std::move(one));
      }
    }
    return each;
  }

  void addStraight(const Body& body, const RunStretch& bar, std::vector<Body>* all) const {
    const int edges = runOf(bar).edgeCount();
    const int past = runOf(bar).exact ? 0 : kPast;
    std::vector<int> lengths = settings_.annealing.lengths;
    std::stable_sort(lengths.begin(), lengths.end(), [&](int a, int b) {
      return std::abs(a - bar.holes) < std::abs(b - bar.holes);
    });
    for (const int holes : lengths) {
      for (const int start : {bar.start, bar.start + bar.holes - holes}) {
        const int last = start + holes - 1;
        if (start >= -past && last <= edges + past && start < edges && last > 0) {
          all->push_back(
              {straightBeamPart(holes).id, {{bar.run, start, holes}}, body.axis, body.layer});
        }
      }
    }
  }

  [[nodiscard]] bool mayTurn(int run, Axis axis) const {
    const std::vector<Axis>& axes = problem_.graph.runs[at(run)].axes;
    return std::find(axes.begin(), axes.end(), axis) != axes.end();
  }

  void addBent(const Body& body, const RunStretch& bar, std::vector<Body>* all) const {
    const guide::GuideRun& run = runOf(bar);
    for (std::size_t j = 0; j < run.junctions.size(); ++j) {
      const guide::Junction& junction = problem_.graph.junctions[at(run.junctions[j])];
      for (const guide::Incidence& other : junction.incident) {
        if (other.run == bar.run || junction.joint >= 0 || !mayTurn(other.run, body.axis)) {
          continue;
        }
        std::vector<layout::Bend> bends;
        for (const int form : settings_.annealing.bends) {
          layout::addBends(problem_.graph, form, bar.run, other.run, body.layer, &bends);
        }
        for (const layout::Bend& bend : bends) {
          if (bend.arm.start < bar.start + bar.holes && bend.arm.last() >= bar.start) {
            all->push_back({layout::bentBeams()[at(bend.arm.form)].part,
                            {{bar.run, bend.arm.start, bend.arm.holes},
                             {other.run, bend.mateArm.start, bend.mateArm.holes}},
                            body.axis,
                            body.layer});
          }
        }
      }
    }
  }

  void addFrames(const Body& body, const RunStretch& bar, std::vector<Body>* all) const {
    const std::vector<int>& allowed = settings_.annealing.frames;
    for (const layout::FrameSite& site : problem_.sites) {
      const bool here =
          std::any_of(site.arms.begin(), site.arms.end(), [&](const layout::SiteArm& arm) {
            return arm.run == bar.run && arm.beam.start < bar.start + bar.holes &&
                   arm.beam.last() >= bar.start;
          });
      if (here && site.axis == body.axis && (!site.exact || body.layer == 0) &&
          std::find(allowed.begin(), allowed.end(), site.frame) != allowed.end()) {
        all->push_back(bodyOfSite(site, body.layer));
      }
    }
  }

  model::Model model_;
  sketch::Sketch sketch_;
  Settings settings_;
  layout::LayoutProblem problem_;
  layout::StretchFinder finder_;
  std::vector<std::optional<layout::Cover>> covers_;  // by run
  std::vector<Body> bodies_;
};

}  // namespace

base::Result<std::string> partPlacesJson(std::string_view modelJson,
                                         std::string_view layoutJson,
                                         std::string_view settingsJson) {
  const auto places = Places::read(modelJson, layoutJson, settingsJson);
  if (!places.ok()) {
    return places.error();
  }
  return json{{"places", places.value()->places()}}.dump();
}

base::Result<std::string> fittingPartsJson(std::string_view modelJson,
                                           std::string_view layoutJson,
                                           std::string_view settingsJson,
                                           int part) {
  const auto places = Places::read(modelJson, layoutJson, settingsJson);
  if (!places.ok()) {
    return places.error();
  }
  return json{{"fits", places.value()->fits(part)}, {"layers", places.value()->layers(part)}}
      .dump();
}

}  // namespace liftarm::design
