#include "cli/train_command.h"

#include <cstddef>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/files.h"
#include "gears/gear_frame.h"
#include "gears/gear_sizes.h"
#include "gears/train.h"
#include "model/number_text.h"
#include "parts/catalogue.h"

namespace liftarm::cli {

namespace {

using nlohmann::ordered_json;

ordered_json trainJson(const gears::Train& train, const std::vector<gears::GearSize>& sizes) {
  ordered_json shafts = ordered_json::array();
  for (std::size_t s = 0; s < train.shafts.size(); ++s) {
    ordered_json wheels = ordered_json::array();
    for (const gears::TrainGear& gear : train.gears) {
      for (const gears::GearSize& size : sizes) {
        if (gear.shaft == static_cast<int>(s) && size.teeth == gear.teeth) {
          wheels.push_back({{"teeth", gear.teeth}, {"part", size.part}, {"plane", gear.plane}});
        }
      }
    }
    shafts.push_back({{"at", {train.shafts[s].u, train.shafts[s].v}}, {"gears", wheels}});
  }
  return {{"ratio", train.ratio}, {"reverses", train.reverses()}, {"shafts", shafts}};
}

std::string trainText(const ordered_json& train) {
  std::string text = "ratio " + model::numberText(train.at("ratio").get<double>(), 3) +
                     ", the last shaft turns " +
                     (train.at("reverses").get<bool>() ? "the other way" : "the same way") + "\n";
  for (const ordered_json& shaft : train.at("shafts")) {
    text += "shaft at " + std::to_string(shaft.at("at").at(0).get<int>()) + ", " +
            std::to_string(shaft.at("at").at(1).get<int>()) + ":";
    for (const ordered_json& gear : shaft.at("gears")) {
      text += " " + std::to_string(gear.at("teeth").get<int>()) + " teeth in plane " +
              std::to_string(gear.at("plane").get<int>() + 1) + " (" +
              gear.at("part").get<std::string>() + ")";
    }
    text += "\n";
  }
  return text;
}

}  // namespace

ExitCode trainCommand(const TrainOptions& options) {
  gears::TrainRequest request;
  request.to = {options.way[0], options.way[1]};
  request.ratio = options.ratio;
  request.tolerance = options.tolerance / 100.0;
  const std::vector<gears::GearSize> sizes =
      gears::gearSizesOf(parts::Catalogue::builtIn().parts());
  for (const gears::GearSize& size : sizes) {
    request.teeth.push_back(size.teeth);
  }
  if (request.to == request.from) {
    return refuse("the shafts are one; give the way from the first to the last in modules");
  }
  const std::optional<gears::Train> train = gears::findTrain(request);
  if (!train.has_value()) {
    return print("no gears couple them within the tolerance\n")
               ? ExitCode::kNotBuildable
               : fail("the answer cannot be written to standard output");
  }
  if (!options.folder.empty()) {
    const base::Result<std::string> folder = makeFolder(options.folder);
    const std::string path = options.folder + "/Gear-train.sketch.json";
    const auto written = folder.ok() ? writeFiles({{path, gears::gearFrame(*train, request)}})
                                     : base::Result<std::size_t>(folder.error());
    if (!written.ok()) {
      return fail(written.error().message);
    }
  }
  const ordered_json answer = trainJson(*train, sizes);
  return print(options.json ? answer.dump() + "\n" : trainText(answer))
             ? ExitCode::kBuildable
             : fail("the answer cannot be written to standard output");
}

}  // namespace liftarm::cli
