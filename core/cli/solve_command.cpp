#include "cli/solve_command.h"

#include <charconv>
#include <cstdio>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/files.h"
#include "cli/report_text.h"
#include "cli/solve_seeds.h"
#include "cli/stress_text.h"
#include "design/design_session.h"
#include "design/placements.h"
#include "design/symmetries.h"
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

base::Result<std::string> writeResults(const SolveOptions& options, const std::string& modelJson) {
  const std::string stem = options.folder + "/" + baseName(options.sketchPath);
  base::Result<std::string> done = makeFolder(options.folder);
  if (!done.ok()) {
    return done;
  }
  done = writeFile(stem + ".model.json", modelJson);
  for (const char* format : {"mpd", "parts.csv"}) {
    if (!done.ok()) {
      return done;
    }
    const base::Result<std::string> text = design::exportModel(modelJson, format);
    if (!text.ok()) {
      return text;
    }
    done = writeFile(stem + "." + format, text.value());
  }
  return done;
}

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

ExitCode printReport(ordered_json report, const std::string& path, bool json) {
  if (report.value("name", "").empty()) {
    report["name"] = baseName(path);
  }
  print(json ? report.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n"
             : reportText(report));
  return report.value("buildable", false) ? ExitCode::kBuildable : ExitCode::kNotBuildable;
}

}  // namespace

ExitCode refuse(const std::string& message) {
  std::string line;
  for (const char c : "liftarm: " + message) {
    line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
  return ExitCode::kRefused;
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
  base::Result<Solution> solved = solve(sketch.value(), settings.value(), options);
  if (!solved.ok()) {
    return refuse(options.sketchPath + ": " + solved.error().message);
  }
  Solution solution = std::move(solved).value();
  if (!options.quiet) {
    const base::Result<std::string> written = writeResults(options, solution.modelJson);
    if (!written.ok()) {
      return refuse(written.error().message);
    }
  }
  return printReport(std::move(solution.report), options.sketchPath, options.json);
}

ExitCode checkCommand(const std::string& modelPath, bool json) {
  constexpr std::size_t kMaxBytes = 64U << 20U;
  const base::Result<std::string> model = readFile(modelPath, kMaxBytes);
  if (!model.ok()) {
    return refuse(model.error().message);
  }
  const base::Result<std::string> checked = design::checkModelJson(model.value());
  if (!checked.ok()) {
    return refuse(modelPath + ": " + checked.error().message);
  }
  ordered_json report = ordered_json::parse(checked.value(), nullptr, false);
  report["stress"] = stressSummary(model.value());
  return printReport(std::move(report), modelPath, json);
}

ExitCode placementsCommand(const SolveOptions& options) {
  const base::Result<ordered_json> settings = settingsOf(options);
  if (!settings.ok()) {
    return refuse(settings.error().message);
  }
  const base::Result<std::string> sketch = readFile(options.sketchPath, sketch::kMaxSketchBytes);
  if (!sketch.ok()) {
    return refuse(sketch.error().message);
  }
  const base::Result<std::string> listed =
      design::placementsJson(sketch.value(), settings.value().dump());
  if (!listed.ok()) {
    return refuse(options.sketchPath + ": " + listed.error().message);
  }
  print(listed.value() + "\n");
  return ExitCode::kBuildable;
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
  print(json ? found.value() + "\n"
             : symmetriesText(ordered_json::parse(found.value(), nullptr, false)));
  return ExitCode::kBuildable;
}

}  // namespace liftarm::cli
