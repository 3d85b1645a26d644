#include "cli/solve_command.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/plain_text.h"
#include "cli/files.h"
#include "cli/model_file.h"
#include "cli/report_text.h"
#include "cli/solve_seeds.h"
#include "cli/stress_text.h"
#include "design/design_session.h"
#include "design/placements.h"
#include "design/stage_one.h"
#include "design/symmetries.h"
#include "parts/catalogue_data.h"
#include "sketch/sketch_json.h"

namespace liftarm::cli {

namespace {

using nlohmann::ordered_json;

//! The settings of design_session.h, or the option at fault.
base::Result<ordered_json> settingsOf(const SolveOptions& options) {
  ordered_json settings = ordered_json::object();
  const auto put = [&](const char* key, const std::string& value) {
    if (!value.empty()) {
      settings[key] = value;
    }
  };
  put("seed", options.seed);
  put("preset", options.preset);
  put("method", options.method);
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      return base::Error{base::Status::kInvalidInput, "--set " + setting + ": expected key=value"};
    }
    settings["set"][setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  return settings;
}

//! One search, or the best of several. A seed that is no number is left to the settings' reader to
//! refuse.
base::Result<Solution> solve(const std::string& sketch,
                             const ordered_json& settings,
                             const SolveOptions& options) {
  if (options.seeds <= 1) {
    return solveOnce(sketch, settings);
  }
  std::uint64_t first = 1;
  const char* const end = options.seed.data() + options.seed.size();
  const auto [stop, error] = std::from_chars(options.seed.data(), end, first);
  if (!options.seed.empty() && (error != std::errc{} || stop != end)) {
    return solveOnce(sketch, settings);
  }
  return solveSeeds(sketch, settings, first, options.seeds, options.threads);
}

constexpr const char* kModelEnding = ".model.json";
//! What a model is written as beside itself.
constexpr const char* kFilesOfAModel[] = {"mpd", "parts.csv"};

std::string stemOf(const SolveOptions& options) {
  return options.folder + "/" + baseName(options.sketchPath);
}

//! The result that would be written over the sketch, if one would.
std::optional<std::string> resultOverInput(const SolveOptions& options) {
  std::vector<std::string> paths{stemOf(options) + kModelEnding};
  for (const char* format : kFilesOfAModel) {
    paths.push_back(stemOf(options) + "." + format);
  }
  const auto found = std::find_if(paths.begin(), paths.end(), [&](const std::string& path) {
    return isSameFile(path, options.sketchPath);
  });
  return found == paths.end() ? std::nullopt : std::optional(*found);
}

base::Result<std::size_t> writeResults(const SolveOptions& options, const std::string& modelJson) {
  std::vector<FileText> files{{stemOf(options) + kModelEnding, modelJson}};
  for (const char* format : kFilesOfAModel) {
    base::Result<std::string> text = design::exportModel(modelJson, format);
    if (!text.ok()) {
      return text.error();
    }
    files.push_back({stemOf(options) + "." + format, std::move(text).value()});
  }
  const base::Result<std::string> folder = makeFolder(options.folder);
  return folder.ok() ? writeFiles(files) : base::Result<std::size_t>(folder.error());
}

//! One line of JSON in which nothing can steer a terminal: all but ASCII is escaped.
std::string jsonLine(const ordered_json& value) {
  return value.dump(-1, ' ', true, ordered_json::error_handler_t::replace) + "\n";
}

//! Prints what was found out. \return `otherwise`, unless it could not be told.
ExitCode tell(const std::string& text, ExitCode otherwise) {
  return print(text) ? otherwise : fail("the report cannot be written to standard output");
}

ExitCode printReport(ordered_json report, const std::string& path, bool asJson) {
  if (report.value("name", "").empty()) {
    report["name"] = baseName(path);
  }
  return tell(asJson ? jsonLine(report) : reportText(report),
              report.value("buildable", false) ? ExitCode::kBuildable : ExitCode::kNotBuildable);
}

void complain(const std::string& message) {
  const std::string line = base::plainText("liftarm: " + message) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

//! Prints one JSON object about a sketch with its settings.
ExitCode describe(const SolveOptions& options,
                  base::Result<std::string> (*what)(std::string_view, std::string_view)) {
  const base::Result<ordered_json> settings = settingsOf(options);
  if (!settings.ok()) {
    return refuse(settings.error().message);
  }
  const base::Result<std::string> sketch = readFile(options.sketchPath, sketch::kMaxSketchBytes);
  if (!sketch.ok()) {
    return refuse(sketch.error().message);
  }
  const base::Result<std::string> told = what(sketch.value(), settings.value().dump());
  if (!told.ok()) {
    return refuse(options.sketchPath + ": " + told.error().message);
  }
  return tell(told.value() + "\n", ExitCode::kBuildable);
}

}  // namespace

ExitCode refuse(const std::string& message) {
  complain(message);
  return ExitCode::kRefused;
}

ExitCode fail(const std::string& message) {
  complain(message);
  return ExitCode::kFailed;
}

bool print(const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
         std::fflush(stdout) == 0;
}

ExitCode solveCommand(const SolveOptions& options) {
  const base::Result<ordered_json> settings = settingsOf(options);
  if (!settings.ok()) {
    return refuse(settings.error().message);
  }
  const base::Result<std::string> sketch = readFile(options.sketchPath, sketch::kMaxSketchBytes);
  if (!sketch.ok()) {
    return refuse(sketch.error().message);
  }
  if (const std::optional<std::string> over = resultOverInput(options); over && !options.quiet) {
    return refuse(*over + ": is the sketch itself; name another folder with -o");
  }
  base::Result<Solution> solved = solve(sketch.value(), settings.value(), options);
  if (!solved.ok()) {
    return refuse(options.sketchPath + ": " + solved.error().message);
  }
  Solution solution = std::move(solved).value();
  if (!options.quiet) {
    const base::Result<std::size_t> written = writeResults(options, solution.modelJson);
    if (!written.ok()) {
      return fail(written.error().message);
    }
  }
  return printReport(std::move(solution.report), options.sketchPath, options.json);
}

ExitCode stressCommand(const std::string& modelPath, const std::string& optionsJson) {
  const base::Result<ModelText> model = readModelFile(modelPath);
  if (!model.ok()) {
    return refuse(model.error().message);
  }
  const base::Result<std::string> told = design::analyseStressJson(model.value().json, optionsJson);
  if (!told.ok()) {
    return refuse(modelPath + ": " + told.error().message);
  }
  return tell(told.value() + "\n", ExitCode::kBuildable);
}

ExitCode checkCommand(const std::string& modelPath, bool json) {
  const base::Result<ModelText> model = readModelFile(modelPath);
  if (!model.ok()) {
    return refuse(model.error().message);
  }
  const base::Result<std::string> checked = design::checkModelJson(model.value().json);
  if (!checked.ok()) {
    return refuse(modelPath + ": " + checked.error().message);
  }
  ordered_json report = ordered_json::parse(checked.value(), nullptr, false);
  report["stress"] = stressSummary(model.value().json);
  if (!model.value().notes.empty()) {
    report["leftOut"] = model.value().notes;
  }
  return printReport(std::move(report), modelPath, json);
}

ExitCode placementsCommand(const SolveOptions& options) {
  return describe(options, design::placementsJson);
}

ExitCode stageOneCommand(const SolveOptions& options) {
  return describe(options, design::stageOneJson);
}

ExitCode partsCommand() {
  return tell(std::string(parts::catalogueJsonText()), ExitCode::kBuildable);
}

ExitCode symmetriesCommand(const std::string& sketchPath, bool json) {
  const base::Result<std::string> sketch = readFile(sketchPath, sketch::kMaxSketchBytes);
  if (!sketch.ok()) {
    return refuse(sketch.error().message);
  }
  const base::Result<std::string> found = design::findSymmetriesJson(sketch.value());
  if (!found.ok()) {
    return refuse(sketchPath + ": " + found.error().message);
  }
  return tell(json ? found.value() + "\n"
                   : symmetriesText(ordered_json::parse(found.value(), nullptr, false)),
              ExitCode::kBuildable);
}

}  // namespace liftarm::cli
