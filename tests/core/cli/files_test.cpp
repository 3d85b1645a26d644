#include "cli/files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/cli/command.h"
#include "core/helpers/models.h"
#include "model/model_json.h"

namespace liftarm::cli {
namespace {

namespace fs = std::filesystem;

using testing::Command;
using testing::Outcome;

//! What the command does to the files of others, and when the machine does not do its part.
class Files : public Command {
 protected:
  std::string square() {
    return write("Square.sketch.json",
                 testing::sketchOf({{{0, 0, 0}, {8, 0, 0}},
                                    {{8, 0, 0}, {8, 8, 0}},
                                    {{8, 8, 0}, {0, 8, 0}},
                                    {{0, 8, 0}, {0, 0, 0}}}));
  }

  //! Names in the folder, but those that run() leaves.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name != "stdout" && name != "stderr") {
        names.push_back(name);
      }
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  //! One line on standard error that names the place, exit 3.
  void expectFailed(const Outcome& outcome, const std::string& place) const {
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_NE(outcome.err.find(place), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
};

TEST_F(Files, AreWrittenWholeAndLeaveNothingBesideThem) {
  const std::string a = (folder_ / "a").string();
  const std::string b = (folder_ / "b").string();
  write("a", "old");
  ASSERT_TRUE(writeFiles({{a, "one"}, {b, "two"}}).ok());
  EXPECT_EQ(read("a"), "one");
  EXPECT_EQ(read("b"), "two");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(Files, AreAllLeftAsTheyWereWhenOneCannotBeWritten) {
  write("a", "old");
  fs::create_directories(folder_ / "b");
  const auto done =
      writeFiles({{(folder_ / "a").string(), "new"}, {(folder_ / "b").string(), "new"}});
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().message.rfind((folder_ / "b").string(), 0), 0U) << done.error().message;
  EXPECT_EQ(read("a"), "old");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(Files, StayLinksWithTheirRights) {
  write("a", "old");
  fs::permissions(folder_ / "a", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a", folder_ / "link");
  ASSERT_TRUE(writeFiles({{(folder_ / "link").string(), "new"}}).ok());
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read("a"), "new");
  EXPECT_EQ(fs::status(folder_ / "a").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Files, OnAFullDiskAreSaidToBeSoAndLeaveWhatWasThere) {
  const std::string sketch = square();
  write("Square.model.json", "old");
  fs::create_symlink("/dev/full", folder_ / "Square.mpd");
  expectFailed(run("solve '" + sketch + "' -o '" + folder_.string() + "'"), "Square.mpd");
  EXPECT_EQ(read("Square.model.json"), "old");
  EXPECT_EQ(names(),
            (std::vector<std::string>{"Square.model.json", "Square.mpd", "Square.sketch.json"}));
}

// What a disk that fills up half-way does to a file that stood there.
TEST_F(Files, LargerThanTheSystemAllowsLeaveWhatWasThere) {
  const std::string sketch = square();
  write("Square.model.json", "old");
  const std::string line = std::string("trap '' XFSZ; ulimit -f 1; exec '") + LIFTARM_COMMAND +
                           "' solve '" + sketch + "' -o '" + folder_.string() + "' >/dev/null 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system(("sh -c \"" + line + "\"").c_str())), 3);
  EXPECT_EQ(read("Square.model.json"), "old");
  EXPECT_EQ(names(), (std::vector<std::string>{"Square.model.json", "Square.sketch.json"}));
}

TEST_F(Files, AreNeverWrittenOverTheSketch) {
  square();
  fs::rename(folder_ / "Square.sketch.json", folder_ / "Square.model.json");
  const std::string before = read("Square.model.json");
  expectRefused(
      "solve '" + (folder_ / "Square.model.json").string() + "' -o '" + folder_.string() + "'",
      "is the sketch itself");
  EXPECT_EQ(read("Square.model.json"), before);
}

TEST_F(Files, AReportThatDoesNotArriveIsAFailure) {
  const std::string sketch = square();
  for (const std::string& arguments : {"solve '" + sketch + "' --no-files --json",
                                       "solve '" + sketch + "' --no-files",
                                       "symmetries '" + sketch + "' --json",
                                       std::string("--help")}) {
    const std::string line =
        std::string("'") + LIFTARM_COMMAND + "' " + arguments + " >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 3) << arguments;
  }
}

TEST_F(Files, MoreThreadsThanTheSystemGivesStillSolve) {
  const std::string sketch = square();
  const Outcome outcome =
      run("solve '" + sketch + "' --no-files --seeds 8 --threads 256 --set effort=0.1 --json");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("seeds").size(), 8U);
}

TEST_F(Files, NamesInThemDoNotSteerTheTerminal) {
  model::Model model = testing::squareFrame();
  model.name =
      "a\x1B[31m\nb\x7F\xC2\x9B"
      "c";
  const std::string path = write("m.model.json", model::writeModel(model));
  for (const char* how : {"'", "' --json"}) {
    const Outcome outcome = run("check '" + path + how);
    for (const char* control : {"\x1B", "\x7F", "\xC2\x9B"}) {
      EXPECT_EQ(outcome.out.find(control), std::string::npos) << how;
    }
  }
  EXPECT_EQ(run("check '" + path + "'").out.rfind("a [31m b  c: ", 0), 0U);
}

TEST_F(Files, UnknownPartsInThemDoNotSteerTheTerminal) {
  constexpr const char* kSteering[] = {"\x1B", "\x7F", "\xC2\x9B", "\xE2\x80\xAE"};
  model::Model model = testing::squareFrame();
  for (const char* steering : kSteering) {
    model.parts[0].part = std::string("a") + steering + "b";
    const std::string path = write("m.model.json", model::writeModel(model));
    for (const char* how : {"check '", "check --json '", "stress '", "export --as inp '"}) {
      const Outcome outcome = run(how + path + "'");
      EXPECT_EQ((outcome.out + outcome.err).find(steering), std::string::npos) << how;
      EXPECT_NE((outcome.out + outcome.err).find("(a"), std::string::npos) << how;
    }
  }
}

TEST_F(Files, SeveralPiecesAreSaidInTheFirstLineOfTheReport) {
  const std::string sketch =
      write("Two.json", testing::sketchOf({{{0, 0, 0}, {8, 0, 0}}, {{0, 3, 0}, {8, 3, 0}}}));
  const Outcome outcome = run("solve '" + sketch + "' --no-files");
  EXPECT_NE(outcome.out.substr(0, outcome.out.find('\n')).find(", 2 separate pieces"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("a line between them, 3 long, would join them"), std::string::npos);
}

}  // namespace
}  // namespace liftarm::cli
