#include "exporters/ldraw.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/plain_text.h"
#include "instructions/sequence.h"
#include "model/number_text.h"

namespace liftarm::exporters {

namespace {

using instructions::Add;
using instructions::Group;
using instructions::Sequence;
using instructions::Step;
using lattice::Mat3;
using lattice::Pose;
using lattice::Vec3;
using model::numberText;

constexpr double kLduPerModule = 20.0;
constexpr int kOwnColour = 16;  // LDraw: that of whoever refers to it
// Deeper subassemblies are written into the one that they go into.
constexpr int kMaxDepth = 6;

//! Z up to -Y up.
const Mat3 kToLdraw{{1, 0, 0, 0, 0, -1, 0, 1, 0}};

//! A text that is safe on one line of the file and as the name of a part of it: readers split rows
//! at white space, and take any stretch of it for one.
std::string oneLine(const std::string& text, const std::string& otherwise) {
  std::string result;
  for (const char c : base::plainText(text)) {
    if (c != ' ' || (!result.empty() && result.back() != ' ')) {
      result += c;
    }
  }
  if (!result.empty() && result.back() == ' ') {
    result.pop_back();
  }
  return result.empty() ? otherwise : result;
}

//! A name as the title of a file. One in capitals could be taken for a command, as FILE or STEP.
std::string titleOf(const std::string& name) {
  const std::string first = name.substr(0, name.find(' '));
  const bool lower =
      std::any_of(first.begin(), first.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return lower ? name : "Model " + name;
}

std::string placeLine(int color, const Pose& pose, const std::string& file) {
  const Vec3 at = kToLdraw * pose.position;
  const Mat3 turned = kToLdraw * pose.rotation * lattice::transposed(kToLdraw);
  std::string line = "1 " + std::to_string(color);
  for (int i = 0; i < 3; ++i) {
    line += " " + numberText(kLduPerModule * at[i]);
  }
  for (const double value : turned.m) {
    line += " " + numberText(value);
  }
  return line + " " + file + "\n";
}

//! Writes the whole and each subassembly as a file of the document.
class Document {
 public:
  Document(const model::Model& model, const Sequence& sequence)
      : model_(model),
        sequence_(sequence),
        name_(oneLine(model.name, "Model")),
        stepsOf_(sequence.groups.size()) {
    for (const Step& step : sequence.steps) {
      stepsOf_[static_cast<std::size_t>(step.group)].push_back(&step);
    }
  }

  std::string write() {
    std::string text = header(name_) + stepsText(0, {}, 0);
    text += missingParts() + "0 NOFILE\n";
    return text + submodels_;
  }

 private:
  static std::string header(const std::string& name) {
    return "0 FILE " + name + ".ldr\n0 " + titleOf(name) + "\n0 Name: " + name +
           ".ldr\n0 BFC CERTIFY CCW\n";
  }

  [[nodiscard]] const model::PlacedPart& part(int index) const {
    return model_.parts[static_cast<std::size_t>(index)];
  }

  [[nodiscard]] std::string partLine(int index, Vec3 origin) const {
    Pose pose = part(index).pose;
    pose.position = pose.position - origin;
    return placeLine(part(index).color, pose, part(index).part + ".dat");
  }

  //! All steps of a group about an origin. `depth`: how deep its submodels are nested.
  std::string stepsText(std::size_t g, Vec3 origin, int depth) {
    std::string text;
    for (const Step* step : stepsOf_[g]) {
      for (const Add& add : step->adds) {
        text += add.subgroup >= 0 && depth < kMaxDepth ? referenceText(add, origin, depth)
                                                       : partLines(add.parts, origin);
      }
      text += "0 STEP\n";
    }
    return text;
  }

  [[nodiscard]] std::string partLines(const std::vector<int>& parts, Vec3 origin) const {
    std::string text;
    for (const int index : parts) {
      text += partLine(index, origin);
    }
    return text;
  }

  //! A line that puts a submodel in its place; the submodel itself is written when it is new.
  std::string referenceText(const Add& add, Vec3 origin, int depth) {
    const auto g = static_cast<std::size_t>(add.subgroup);
    const Group& group = sequence_.groups[g];
    const Vec3 own = part(group.parts.front()).pose.position;
    for (std::size_t c = 0; c < group.copies.size(); ++c) {
      std::vector<int> sorted = group.copies[c];
      std::sort(sorted.begin(), sorted.end());
      if (sorted != add.parts) {
        continue;
      }
      if (group.mirrored[c] || !sameColours(group.parts, group.copies[c])) {
        return writtenOut(add, origin);
      }
      return placeLine(kOwnColour,
                       {group.poses[c].apply(own) - origin, group.poses[c].rotation},
                       submodel(g, own, depth));
    }
    return placeLine(kOwnColour, {own - origin, Mat3()}, submodel(g, own, depth));
  }

  //! A copy that cannot refer to the first: its parts in one step of a submodel of its own.
  std::string writtenOut(const Add& add, Vec3 origin) {
    const Vec3 own = part(add.parts.front()).pose.position;
    const std::string name = nextName();
    submodels_ += header(name) + partLines(add.parts, own) + "0 STEP\n0 NOFILE\n";
    return placeLine(kOwnColour, {own - origin, Mat3()}, name + ".ldr");
  }

  //! The file of a group, which is written at its first use.
  std::string submodel(std::size_t g, Vec3 origin, int depth) {
    if (names_.size() < sequence_.groups.size()) {
      names_.resize(sequence_.groups.size());
    }
    if (names_[g].empty()) {
      names_[g] = nextName();
      const std::string text = header(names_[g]) + stepsText(g, origin, depth + 1) + "0 NOFILE\n";
      submodels_ += text;
    }
    return names_[g] + ".ldr";
  }

  std::string nextName() { return name_ + " - " + std::to_string(++submodelCount_); }

  [[nodiscard]] bool sameColours(const std::vector<int>& a, const std::vector<int>& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), [&](int x, int y) {
      return part(x).color == part(y).color;
    });
  }

  //! Parts that the catalogue does not have are in no step.
  [[nodiscard]] std::string missingParts() const {
    std::vector<char> told(model_.parts.size(), 0);
    for (const int index : sequence_.groups.front().parts) {
      told[static_cast<std::size_t>(index)] = 1;
    }
    std::string text;
    for (std::size_t i = 0; i < told.size(); ++i) {
      text += told[i] == 0 ? partLine(static_cast<int>(i), {}) : "";
    }
    return text.empty() ? text : text + "0 STEP\n";
  }

  const model::Model& model_;
  const Sequence& sequence_;
  std::string name_;
  std::vector<std::vector<const Step*>> stepsOf_;
  std::vector<std::string> names_;
  std::string submodels_;
  int submodelCount_ = 0;
};

}  // namespace

std::string writeLdraw(const model::Model& model, const parts::Catalogue& catalogue) {
  Sequence sequence;
  if (model.parts.size() <= analysis::kMaxPartsTakenApart) {
    sequence = instructions::planSequence(analysis::makeScene(model, catalogue));
  } else {
    sequence.groups.emplace_back();
  }
  return Document(model, sequence).write();
}

}  // namespace liftarm::exporters
