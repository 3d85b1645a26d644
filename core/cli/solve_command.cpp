#include "cli/solve_command.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/files.h"
#include "cli/report_text.h"
#include "cli/stress_text.h"
#include "design/design_session.h"
#include "sketch/sketch_json.h"

namespace liftarm::cli {

namespace {

using nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kSlice = 20000;  // iterations in one call

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double milliseconds(double seconds) {
  return std::round(seconds * 1000.0) / 1000.0;
}

//! The settings of design_session.h, or the option at fault.
base::Result<std::string> settingsText(const SolveOptions& options) {
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
  return settings.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

//! The report with the times of DESIGN 4.
ordered_json reportOf(const design::DesignSession& session, double stageOne, double stageTwo) {
  ordered_json report = ordered_json::parse(session.reportJson(), nullptr, false);
  report["seconds"] = {{"stageOne", milliseconds(stageOne)},
                       {"stageTwo", milliseconds(stageTwo)},
                       {"total", milliseconds(stageOne + stageTwo)}};
  return report;
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
  const base::Result<std::string> settings = settingsText(options);
  if (!settings.ok()) {
    return refuse(settings.error().message);
  }
  const base::Result<std::string> sketch = readFile(options.sketchPath, sketch::kMaxSketchBytes);
  if (!sketch.ok()) {
    return refuse(sketch.error().message);
  }
  const Clock::time_point start = Clock::now();
  base::Result<std::unique_ptr<design::DesignSession>> created =
      design::DesignSession::create(sketch.value(), settings.value());
  if (!created.ok()) {
    return refuse(options.sketchPath + ": " + created.error().message);
  }
  const std::unique_ptr<design::DesignSession> session = std::move(created).value();
  // The session prepares its search in its first step.
  bool done = session->advance(1);
  const double stageOne = secondsSince(start);
  const Clock::time_point search = Clock::now();
  while (!done) {
    done = session->advance(kSlice);
  }
  const double stageTwo = secondsSince(search);
  if (!options.quiet) {
    const base::Result<std::string> written = writeResults(options, session->modelJson());
    if (!written.ok()) {
      return refuse(written.error().message);
    }
  }
  return printReport(reportOf(*session, stageOne, stageTwo), options.sketchPath, options.json);
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

}  // namespace liftarm::cli
