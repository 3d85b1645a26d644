#include "cli/export_command.h"

#include <array>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/plain_text.h"
#include "cli/files.h"
#include "cli/model_file.h"
#include "design/design_session.h"
#include "model/model_json.h"
#include "parts/catalogue.h"

namespace liftarm::cli {

namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, 7> kFormats{
    "mpd", "parts.csv", "wanted.xml", "spreadsheet.csv", "assembly.json", "inp", "apdl"};

bool endsWith(std::string_view text, std::string_view ending) {
  return text.size() > ending.size() && text.substr(text.size() - ending.size()) == ending;
}

//! What was asked for, or what the output's name says.
std::string formatOf(const ExportOptions& options) {
  for (const std::string_view format : kFormats) {
    if (options.format.empty() && endsWith(options.output, "." + std::string(format))) {
      return std::string(format);
    }
  }
  return options.format;
}

ExitCode told(const std::string& text, ExitCode code) {
  return print(text) ? code : fail("the answer cannot be written to standard output");
}

//! To the file that was named, else to standard output.
ExitCode deliver(const std::string& text, const ExportOptions& options, ExitCode code) {
  if (options.output.empty()) {
    return told(text, code);
  }
  if (isSameFile(options.output, options.modelPath)) {
    return refuse(options.output + ": is the model itself; name another file with -o");
  }
  const base::Result<std::size_t> written = writeFiles({{options.output, text}});
  return written.ok() ? code : fail(written.error().message);
}

std::string notesText(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) {
    text += "NOTE: " + base::plainText(note) + "\n";
  }
  return text;
}

//! Parts by their kinds, in the order in which they first come: `2 x Beam 7 (32524)`.
std::string kindsText(const std::vector<int>& parts, const ordered_json& placed) {
  std::vector<std::string> order;
  std::map<std::string, int> counts;
  for (const int part : parts) {
    const std::string id = placed.at(static_cast<std::size_t>(part)).value("part", "");
    if (counts[id]++ == 0) {
      order.push_back(id);
    }
  }
  std::string text;
  for (const std::string& id : order) {
    const parts::Part* part = parts::Catalogue::builtIn().find(id);
    text += (text.empty() ? "" : ", ") + std::to_string(counts[id]) + " x " +
            (part != nullptr ? part->name + " (" + id + ")" : id);
  }
  return text;
}

std::string groupName(int group, const ordered_json& plan) {
  const std::size_t copies = plan.at("groups").at(static_cast<std::size_t>(group))["copies"].size();
  return "sub-build " + std::to_string(group) +
         (copies > 0 ? ", " + std::to_string(copies + 1) + " times" : "");
}

//! One step: what comes to what.
std::string stepText(const ordered_json& step,
                     const ordered_json& plan,
                     const ordered_json& parts) {
  std::vector<int> loose;
  std::string text;
  for (const ordered_json& added : step.at("adds")) {
    if (added.contains("subgroup") && added.at("subgroup").is_number()) {
      text += (text.empty() ? "" : ", ") + groupName(added.at("subgroup").get<int>(), plan);
    } else {
      const auto more = added.at("parts").get<std::vector<int>>();
      loose.insert(loose.end(), more.begin(), more.end());
    }
  }
  const std::string kinds = kindsText(loose, parts);
  return text + (text.empty() || kinds.empty() ? "" : ", ") + kinds;
}

std::string planText(const ordered_json& plan, const ordered_json& model) {
  const ordered_json& parts = model.at("parts");
  std::string text = base::plainText(model.value("name", "")) + ": " +
                     std::to_string(parts.size()) + " parts, " +
                     std::to_string(plan.at("steps").size()) + " steps\n";
  int group = -1;
  int number = 0;
  for (const ordered_json& step : plan.at("steps")) {
    if (const int own = step.value("group", 0); own != group) {
      group = own;
      text += group == 0 ? "the whole\n" : groupName(group, plan) + "\n";
    }
    text += "  " + std::to_string(++number) + ": " + stepText(step, plan, parts) + "\n";
  }
  for (const ordered_json& stuck : plan.value("stuck", ordered_json::array())) {
    text += "stuck: " + stuck.value("message", "") + "\n";
  }
  return text;
}

}  // namespace

ExitCode exportCommand(const ExportOptions& options) {
  const base::Result<ModelText> model = readModelFile(options.modelPath);
  if (!model.ok()) {
    return refuse(model.error().message);
  }
  const base::Result<std::string> text = design::exportModel(model.value().json, formatOf(options));
  if (!text.ok()) {
    return refuse(options.modelPath + ": " + text.error().message);
  }
  return deliver(text.value(), options, ExitCode::kBuildable);
}

ExitCode instructionsCommand(const ExportOptions& options) {
  const base::Result<ModelText> model = readModelFile(options.modelPath);
  if (!model.ok()) {
    return refuse(model.error().message);
  }
  const base::Result<std::string> text = design::planAssemblyJson(model.value().json);
  if (!text.ok()) {
    return refuse(options.modelPath + ": " + text.error().message);
  }
  const ordered_json plan = ordered_json::parse(text.value(), nullptr, false);
  const ExitCode code =
      plan.value("assemblable", false) ? ExitCode::kBuildable : ExitCode::kNotBuildable;
  if (options.json) {
    return deliver(text.value() + "\n", options, code);
  }
  const ordered_json parts = ordered_json::parse(model.value().json, nullptr, false);
  return deliver(notesText(model.value().notes) + planText(plan, parts), options, code);
}

ExitCode importCommand(const ExportOptions& options) {
  const base::Result<ModelText> model = readModelFile(options.modelPath);
  if (!model.ok()) {
    return refuse(model.error().message);
  }
  if (const auto read = model::readModel(model.value().json); !read.ok()) {
    return refuse(options.modelPath + ": " + read.error().message);
  }
  ExportOptions named = options;
  if (named.output.empty()) {
    named.output = baseName(options.modelPath) + ".model.json";
  }
  const ExitCode code = deliver(model.value().json, named, ExitCode::kBuildable);
  return code == ExitCode::kBuildable ? told(notesText(model.value().notes), code) : code;
}

}  // namespace liftarm::cli
