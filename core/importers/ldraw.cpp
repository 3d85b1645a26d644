#include "importers/ldraw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "importers/ldraw_rows.h"
#include "importers/mirror_plane.h"
#include "importers/part_numbers.h"
#include "model/model_json.h"

namespace liftarm::importers {

namespace {

using lattice::Mat3;
using lattice::Vec3;

constexpr double kLduPerModule = 20.0;
constexpr std::size_t kMaxDepth = 60;
//! Rows that are followed, counted before any is: submodels multiply, with or without a part.
constexpr std::size_t kMaxVisits = 400000;
constexpr std::size_t kNamedAtMost = 24;
constexpr std::size_t kLongestName = 60;
constexpr std::size_t kLongestNumber = 40;
constexpr std::size_t kPeek = 4096;
constexpr int kFirstColor = 7;

base::Error refusal(std::string message) {
  return {base::Status::kInvalidInput, std::move(message)};
}

bool endsWith(std::string_view text, std::string_view ending) {
  return text.size() >= ending.size() && text.substr(text.size() - ending.size()) == ending;
}

//! Six decimals, and never -0.
double neat(double value) {
  const double rounded = std::floor(value * 1e6 + 0.5) / 1e6;
  return rounded == 0.0 ? 0.0 : rounded;
}

Vec3 neat(Vec3 v) {
  return {neat(v.x), neat(v.y), neat(v.z)};
}

//! LDraw (x, y, z) in LDU is (x, z, -y) in modules.
Vec3 toModules(Vec3 p) {
  return neat((1.0 / kLduPerModule) * Vec3{p.x, p.z, -p.y});
}

//! The inverse of R -> M R M^T with M: (x, y, z) -> (x, -z, y).
Mat3 toOurs(const Mat3& rotation) {
  const std::array<double, 9>& r = rotation.m;
  Mat3 turned{{r[0], r[2], -r[1], r[6], r[8], -r[7], -r[3], -r[5], r[4]}};
  for (double& value : turned.m) {
    value = neat(value);
  }
  return turned;
}

//! A part that is its own mirror image may be placed as one: it is the same as turned.
lattice::Pose proper(const parts::Part& part, const lattice::Pose& pose) {
  const std::optional<MirrorPlane> plane =
      lattice::determinant(pose.rotation) < 0.0 ? mirrorPlane(part) : std::nullopt;
  if (!plane) {
    return pose;
  }
  Vec3 shift;
  shift[plane->axis] = 2.0 * plane->at;
  lattice::Pose turned = pose;
  for (std::size_t i = 0; i < turned.rotation.m.size(); ++i) {
    const bool flips = static_cast<int>(i % 3) == plane->axis;
    turned.rotation.m[i] = neat(flips ? -pose.rotation.m[i] : pose.rotation.m[i]);
  }
  turned.position = neat(pose.position + pose.rotation * shift);
  return turned;
}

//! Which files of a document are submodels, to be followed, and which are parts. Some programs
//! write the shapes of parts into the document too: such a file is a part where its name ends with
//! `.dat` or it draws something itself, and no part that is known stands in it.
class Leaves {
 public:
  Leaves(const LdrawFiles& files, const parts::Catalogue& catalogue)
      : files_(files), catalogue_(catalogue) {}

  bool isSubmodel(const std::string& file) {
    if (files_.rows.count(file) == 0) {
      return false;
    }
    const bool part = endsWith(file, ".dat");
    if (part && knownPart(file, catalogue_) != nullptr) {
      return false;
    }
    return !(part || files_.drawn.count(file) > 0) || holdsKnown(file, 0);
  }

  [[nodiscard]] bool holds(const std::string& file) const { return files_.rows.count(file) > 0; }

 private:
  //! Whether a known part stands in a file or in what it holds. A circle holds what else is in it.
  bool holdsKnown(const std::string& file, std::size_t depth) {
    const auto rows = files_.rows.find(file);
    if (depth > kMaxDepth) {
      // It is followed, and refused.
      return true;
    }
    if (const auto told = holds_.find(file); told != holds_.end()) {
      return told->second;
    }
    holds_[file] = false;
    bool held = false;
    if (rows != files_.rows.end()) {
      for (const LdrawRow& row : rows->second) {
        const bool leaf = files_.rows.count(row.file) == 0 || endsWith(row.file, ".dat");
        held = held || (leaf && knownPart(row.file, catalogue_) != nullptr) ||
               holdsKnown(row.file, depth + 1);
      }
    }
    holds_[file] = held;
    return held;
  }

  const LdrawFiles& files_;
  const parts::Catalogue& catalogue_;
  std::map<std::string, bool> holds_;
};

//! Follows submodels down to parts.
class Placer {
 public:
  Placer(const LdrawFiles& files, const parts::Catalogue& catalogue)
      : files_(files), catalogue_(catalogue), leaves_(files, catalogue) {}

  //! How many rows are followed from a file down, each as often as it is come by; or what is wrong.
  base::Result<std::size_t> countVisits(const std::string& file) {
    if (const auto known = visits_.find(file); known != visits_.end()) {
      return known->second;
    }
    if (std::find(path_.begin(), path_.end(), file) != path_.end()) {
      return refusal(file + ": the submodel holds itself");
    }
    if (path_.size() > kMaxDepth) {
      return refusal(file + ": submodels are nested more than " + std::to_string(kMaxDepth) +
                     " deep");
    }
    path_.push_back(file);
    std::size_t count = 0;
    for (const LdrawRow& row : files_.rows.at(file)) {
      ++count;
      if (leaves_.isSubmodel(row.file)) {
        const base::Result<std::size_t> inside = countVisits(row.file);
        if (!inside.ok()) {
          return inside.error();
        }
        // More than too many are too many.
        count = std::min(count + inside.value(), kMaxVisits + 1);
      }
    }
    path_.pop_back();
    visits_[file] = count;
    return count;
  }

  void place(const std::string& file, const lattice::Pose& at, int color) {
    for (const LdrawRow& row : files_.rows.at(file)) {
      const lattice::Pose pose{at.apply(row.position), at.rotation * row.rotation};
      const int own = isInherited(row.color) ? color : row.color;
      if (leaves_.isSubmodel(row.file)) {
        place(row.file, pose, own);
      } else {
        add(row.file, pose, own);
      }
    }
  }

  //! What could not be placed, one sentence each.
  [[nodiscard]] std::vector<std::string> leftOut() const {
    std::vector<std::string> notes;
    if (!unknown_.empty()) {
      std::string named;
      for (std::size_t i = 0; i < std::min(unknown_.size(), kNamedAtMost); ++i) {
        named += (i > 0 ? ", " : "") + unknown_[i] + " (" +
                 std::to_string(unknownCounts_.at(unknown_[i])) + ")";
      }
      notes.push_back("parts that are not known here are not judged: " + named +
                      (unknown_.size() > kNamedAtMost ? ", \u2026" : ""));
    }
    if (!missing_.empty()) {
      notes.push_back("what stands in another file is left out: " + missing_);
    }
    return notes;
  }

  std::vector<model::PlacedPart> take() && { return std::move(parts_); }

  [[nodiscard]] std::size_t count() const { return parts_.size(); }

 private:
  void add(const std::string& file, const lattice::Pose& pose, int color) {
    const parts::Part* part = knownPart(file, catalogue_);
    if (part == nullptr) {
      leaveOut(file);
      return;
    }
    model::PlacedPart placed;
    placed.part = part->id;
    placed.color = color;
    placed.pose = proper(*part, {toModules(pose.position), toOurs(pose.rotation)});
    parts_.push_back(std::move(placed));
  }

  void leaveOut(const std::string& file) {
    if (!leaves_.holds(file) && (endsWith(file, ".ldr") || endsWith(file, ".mpd"))) {
      missing_ = missing_.empty() ? file.substr(0, kLongestName) : missing_;
      return;
    }
    const std::string number = plainNumber(file).substr(0, kLongestNumber);
    if (unknownCounts_[number]++ == 0) {
      unknown_.push_back(number);
    }
  }

  const LdrawFiles& files_;
  const parts::Catalogue& catalogue_;
  Leaves leaves_;
  std::vector<model::PlacedPart> parts_;
  std::vector<std::string> path_;
  std::map<std::string, std::size_t> visits_;
  std::vector<std::string> unknown_;  //!< in the order of the file
  std::map<std::string, std::size_t> unknownCounts_;
  std::string missing_;
};

//! The name of the first file as it is written, without its ending.
std::string nameOf(const LdrawFiles& files) {
  for (const std::string_view ending : {".ldr", ".mpd", ".dat"}) {
    if (endsWith(files.names.front(), ending)) {
      return files.title.substr(0, files.title.size() - ending.size());
    }
  }
  return files.title;
}

}  // namespace

bool looksLikeLdraw(std::string_view text) {
  for (const std::string_view line : linesOf(text.substr(0, kPeek))) {
    const std::string_view row = trimmed(line);
    // A sign that some programs write before a note.
    if (row.empty() || row.substr(0, 2) == "//") {
      continue;
    }
    if (row[0] == '0') {
      return row.size() == 1 || row[1] == ' ' || row[1] == '\t';
    }
    return looksLikeRow(row);
  }
  return false;
}

base::Result<Imported> readLdraw(std::string_view text, const parts::Catalogue& catalogue) {
  base::Result<LdrawFiles> read = readRows(text);
  if (!read.ok()) {
    return read.error();
  }
  const LdrawFiles files = std::move(read).value();
  constexpr const char* kNone = "the file holds no parts (lines that begin with \"1\")";
  if (files.names.empty()) {
    return refusal(kNone);
  }
  Placer placer(files, catalogue);
  const base::Result<std::size_t> visits = placer.countVisits(files.names.front());
  if (!visits.ok()) {
    return visits.error();
  }
  if (visits.value() > kMaxVisits) {
    return refusal("submodels and parts are more than " + std::to_string(kMaxVisits) +
                   ", which is the limit");
  }
  placer.place(files.names.front(), {}, kFirstColor);
  const std::vector<std::string> left = placer.leftOut();
  if (placer.count() == 0) {
    return refusal(left.empty() ? kNone : left.front());
  }
  if (placer.count() > model::kMaxParts) {
    return refusal("more than " + std::to_string(model::kMaxParts) + " parts, which is the limit");
  }
  Imported imported;
  imported.model.name = nameOf(files);
  imported.notes = files.notes;
  imported.notes.insert(imported.notes.end(), left.begin(), left.end());
  imported.model.parts = std::move(placer).take();
  return imported;
}

}  // namespace liftarm::importers
