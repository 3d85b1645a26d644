// Files of other programs: checked, built, written and read again by the command.

#include <string>

#include "core/cli/command.h"
#include "core/helpers/models.h"
#include "model/model_json.h"

namespace liftarm::cli {
namespace {

using testing::Command;
using testing::Outcome;

class Export : public Command {
 protected:
  //! The square frame of the helpers as a model file.
  std::string frame() {
    return write("Frame.model.json", model::writeModel(testing::squareFrame()));
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
};

TEST_F(Export, WritesTheFormatThatTheNameEndsWith) {
  const std::string model = frame();
  ASSERT_EQ(run("export '" + model + "' -o '" + path("a.mpd") + "'").exitCode, 0);
  EXPECT_EQ(read("a.mpd").find("0 FILE "), 0U);
  ASSERT_EQ(run("export '" + model + "' -o '" + path("b.parts.csv") + "'").exitCode, 0);
  const Outcome printed = run("export '" + model + "' --as parts.csv");
  EXPECT_EQ(printed.exitCode, 0);
  EXPECT_EQ(printed.out, read("b.parts.csv"));
}

TEST_F(Export, RefusesFormatsThatItDoesNotHaveAndTheModelItself) {
  const std::string model = frame();
  const Outcome unknown = run("export '" + model + "' --as step");
  EXPECT_EQ(unknown.exitCode, 1);
  EXPECT_NE(unknown.err.find("format: \"step\" is not known; use mpd"), std::string::npos);
  EXPECT_EQ(run("export '" + model + "' --as mpd -o '" + model + "'").exitCode, 1);
  EXPECT_EQ(read("Frame.model.json"), model::writeModel(testing::squareFrame()));
}

TEST_F(Export, WhatIsWrittenForLdrawIsJudgedAlike) {
  const std::string model = frame();
  run("export '" + model + "' -o '" + path("a.mpd") + "'");
  const Outcome before = run("check '" + model + "'");
  const Outcome after = run("check '" + path("a.mpd") + "'");
  EXPECT_EQ(after.exitCode, before.exitCode) << after.out << after.err;
  ASSERT_EQ(run("import '" + path("a.mpd") + "'  -o '" + path("b.model.json") + "'").exitCode, 0);
  EXPECT_EQ(run("check '" + path("b.model.json") + "'").exitCode, before.exitCode);
}

TEST_F(Export, CheckSaysWhatOfAFileItLeavesOut) {
  const std::string file = write("a.ldr",
                                 "0 A beam and a brick\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 32523.dat\n"
                                 "1 4 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat\n");
  const Outcome checked = run("check '" + file + "'");
  EXPECT_NE(checked.out.find("NOTE: parts that are not known here are not judged: 3001 (1)"),
            std::string::npos)
      << checked.out;
}

TEST_F(Export, InstructionsNameTheParts) {
  const std::string model = frame();
  const Outcome steps = run("instructions '" + model + "'");
  EXPECT_EQ(steps.exitCode, 0) << steps.err;
  const std::string count = std::to_string(testing::squareFrame().parts.size());
  EXPECT_NE(steps.out.find(": " + count + " parts, "), std::string::npos) << steps.out;
  EXPECT_NE(steps.out.find("\n  1: "), std::string::npos) << steps.out;
  EXPECT_NE(run("instructions '" + model + "' --json").out.find("\"assemblable\""),
            std::string::npos);
}

TEST_F(Export, ImportRefusesWhatIsNoModel) {
  const Outcome words = run("import '" + write("a.txt", "Dear all") + "'");
  EXPECT_EQ(words.exitCode, 1);
  const Outcome archive = run("import '" + write("a.io", "PK\x03\x04") + "'");
  EXPECT_EQ(archive.exitCode, 1);
  EXPECT_NE(archive.err.find("export the model as LDraw"), std::string::npos) << archive.err;
}

}  // namespace
}  // namespace liftarm::cli
