#include "cli/report_text.h"

#include <array>
#include <cstddef>

#include "base/plain_text.h"
#include "cli/stress_text.h"

namespace liftarm::cli {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMaxProblems = 20;

//! The numbers that are worth a line, with the words around them.
struct Row {
  const char* key;
  const char* label;
  const char* unit;
};

constexpr std::array<Row, 13> kRows{{{"seed", "seed", ""},
                                     {"lines", "lines", ""},
                                     {"length", "length", " modules"},
                                     {"beams", "beams", ""},
                                     {"beamsLowerBound", "beams needed at least", ""},
                                     {"axles", "lines covered by axles", ""},
                                     {"bricks", "bricks", ""},
                                     {"gaps", "gaps", ""},
                                     {"collisions", "collisions", ""},
                                     {"uncovered", "uncovered", ""},
                                     {"failedConnections", "failed connections", ""},
                                     {"mass", "mass", " g"},
                                     {"iterations", "iterations", ""}}};

std::string plainTextOf(const ordered_json& value) {
  return value.is_string() ? base::plainText(value.get<std::string>()) : value.dump();
}

//! A member that is a text, which may come from a file of others.
std::string textAt(const ordered_json& object, const char* key) {
  return base::plainText(object.value(key, ""));
}

//! How the model stands and moves: numbers in a search's report, objects in a check's.
std::string motionText(const ordered_json& report) {
  std::string text;
  if (report.contains("freedoms")) {
    const ordered_json& freedoms = report.at("freedoms");
    const bool detailed = freedoms.is_object();
    text += "  freedoms: " + (detailed ? freedoms.at("free") : freedoms).dump();
    if (detailed || report.contains("freedomsHeld")) {
      text += " (" + (detailed ? freedoms.at("held") : report.at("freedomsHeld")).dump() +
              " with friction)";
    }
    text += "\n";
  }
  for (const ordered_json& joint : report.value("joints", ordered_json::array())) {
    text += "  joint " + joint.at("joint").dump();
    if (joint.contains("bodies")) {
      text += ", bodies " + joint.at("bodies")[0].dump() + " and " + joint.at("bodies")[1].dump();
    }
    text += ": " + textAt(joint, "message") + "\n";
  }
  const bool judged = report.contains("balance") && report.at("balance").is_object();
  if (judged || report.contains("balanced")) {
    const bool stands =
        judged ? report.at("balance").value("stable", false) : report.at("balanced").get<bool>();
    text += std::string("  balance: ") + (stands ? "stands" : "falls over");
    if (judged) {
      const ordered_json& balance = report.at("balance");
      text += stands ? ", up to a slope of " + balance.at("tippingAngle").dump() + " degrees"
                     : std::string();
      text += ", towards " + balance.at("direction").dump();
    }
    text += "\n";
  }
  return text;
}

std::string itemsText(const ordered_json& items) {
  std::string text;
  for (const ordered_json& item : items) {
    text += std::string(item.value("ok", false) ? "  ok    " : "  FAILS ") + textAt(item, "title") +
            " (" + textAt(item, "detail") + ")\n";
  }
  return text;
}

std::string wellBuiltText(const ordered_json& items) {
  std::string text;
  for (const ordered_json& item : items) {
    const char* mark = item.value("ok", false) ? "yes" : "NO ";
    text += std::string("    ") + mark + "  " + textAt(item, "title") + ": " +
            textAt(item, "detail") + "\n";
  }
  return text;
}

std::string problemsText(const ordered_json& problems) {
  std::string text;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    if (i == kMaxProblems) {
      return text + "  ... and " + std::to_string(problems.size() - i) + " more\n";
    }
    text += "  " + textAt(problems[i], "kind") + ": " + textAt(problems[i], "message") + "\n";
  }
  return text;
}

//! A sketch of several pieces is built, and yet most likely not what was meant: said in the first
//! line.
std::string piecesText(const ordered_json& report) {
  const int pieces = report.value("pieces", 1);
  return pieces < 2 ? std::string() : ", " + std::to_string(pieces) + " separate pieces";
}

}  // namespace

std::string reportText(const ordered_json& report) {
  std::string text = textAt(report, "name") +
                     (report.value("buildable", false) ? ": buildable" : ": NOT buildable") +
                     piecesText(report) + "\n";
  for (const ordered_json& note : report.value("notes", ordered_json::array())) {
    text += "  NOTE: " + textAt(note, "message") + "\n";
  }
  for (const ordered_json& left : report.value("leftOut", ordered_json::array())) {
    text += "  NOTE: " + base::plainText(left.get<std::string>()) + "\n";
  }
  for (const Row& row : kRows) {
    if (report.contains(row.key)) {
      text +=
          "  " + std::string(row.label) + ": " + plainTextOf(report.at(row.key)) + row.unit + "\n";
    }
  }
  text += motionText(report);
  if (report.contains("seconds")) {
    text += "  seconds: " + report.at("seconds").at("total").dump() + "\n";
  }
  if (report.contains("seeds")) {
    for (const ordered_json& tried : report.at("seeds")) {
      text += "  seed " + tried.at("seed").dump() + ": " + tried.at("beams").dump() + " beams, " +
              tried.at("bricks").dump() + " bricks" +
              (tried.value("buildable", false) ? "\n" : ", not buildable\n");
    }
  }
  if (report.contains("items")) {
    text += itemsText(report.at("items"));
  }
  if (report.contains("wellBuilt")) {
    const ordered_json& wellBuilt = report.at("wellBuilt");
    text += "  well built: " + wellBuilt.at("passed").dump() + " of " + wellBuilt.at("of").dump() +
            "\n" + wellBuiltText(wellBuilt.at("items"));
  }
  if (report.contains("stress")) {
    text += stressText(report.at("stress"));
  }
  if (report.contains("problems") && !report.at("problems").empty()) {
    text += "problems:\n" + problemsText(report.at("problems"));
  }
  return text;
}

std::string symmetriesText(const ordered_json& found) {
  std::string text;
  for (const ordered_json& symmetry : found.at("symmetries")) {
    const bool known = symmetry.value("kind", "") != "rotation";
    text += symmetry.dump() + (known ? "\n" : "  (for information)\n");
  }
  return text.empty() ? "no symmetries that the sketch does not name\n" : text;
}

}  // namespace liftarm::cli
