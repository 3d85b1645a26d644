#include "cli/linkage_command.h"

#include <cstdio>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/files.h"
#include "linkages/linkage_json.h"
#include "linkages/linkage_table.h"

namespace liftarm::cli {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kCouplersAtOnce = 1000;

//! The path's text with what the command line says of it. What is no object is left to its reader.
std::string withOptions(const std::string& text, const LinkageOptions& options) {
  json document = json::parse(text, nullptr, false);
  if (!document.is_object() || (options.kind.empty() && options.turns.empty())) {
    return text;
  }
  if (!options.kind.empty()) {
    document["kind"] = options.kind;
  }
  if (!options.turns.empty()) {
    document["turns"] = options.turns;
  }
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string rowText(std::size_t number, const ordered_json& answer) {
  const ordered_json& links = answer.at("links");
  std::vector<char> row(200);
  std::snprintf(row.data(),
                row.size(),
                "%zu: crank %d, coupler %.3g, rocker %d, frame %d: %.2f mm off on average, %.2f at "
                "most; transmission angle at least %.0f degrees\n",
                number,
                links.at(0).get<int>(),
                links.at(1).get<double>(),
                links.at(2).get<int>(),
                links.at(3).get<int>(),
                answer.at("error").get<double>(),
                answer.at("largest").get<double>(),
                answer.at("transmission").get<double>());
  return row.data();
}

base::Result<std::size_t> writeSketches(const LinkageOptions& options, const ordered_json& reply) {
  std::vector<FileText> files;
  for (const ordered_json& answer : reply.at("answers")) {
    files.push_back({options.folder + "/" + baseName(options.pathFile) + "-" +
                         std::to_string(files.size() + 1) + ".sketch.json",
                     answer.at("sketch").dump(2) + "\n"});
  }
  const base::Result<std::string> folder = makeFolder(options.folder);
  return folder.ok() ? writeFiles(files) : base::Result<std::size_t>(folder.error());
}

}  // namespace

ExitCode linkageCommand(const LinkageOptions& options) {
  const base::Result<std::string> text = readFile(options.pathFile, linkages::kMaxPathBytes);
  if (!text.ok()) {
    return refuse(text.error().message);
  }
  const std::string path = withOptions(text.value(), options);
  if (const auto drawing = linkages::readPath(path); !drawing.ok()) {
    return refuse(options.pathFile + ": " + drawing.error().message);
  }
  linkages::LinkageTable table;
  while (!table.advance(kCouplersAtOnce)) {
  }
  const base::Result<std::string> found = linkages::linkagesJson(table, path);
  if (!found.ok()) {
    return refuse(options.pathFile + ": " + found.error().message);
  }
  const ordered_json reply = ordered_json::parse(found.value());
  if (!options.folder.empty()) {
    if (const auto written = writeSketches(options, reply); !written.ok()) {
      return fail(written.error().message);
    }
  }
  std::string report = options.json ? found.value() + "\n" : "";
  for (std::size_t i = 0; i < reply.at("answers").size() && !options.json; ++i) {
    report += rowText(i + 1, reply.at("answers")[i]);
  }
  if (!print(report)) {
    return fail("the answer cannot be written to standard output");
  }
  return reply.at("answers").empty() ? ExitCode::kNotBuildable : ExitCode::kBuildable;
}

}  // namespace liftarm::cli
