#include "exporters/ansys.h"

#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "core/helpers/models.h"

namespace liftarm::exporters {
namespace {

analysis::StressState squareState() {
  const model::Model model = testing::squareFrame();
  const analysis::Scene scene = analysis::makeScene(model, parts::Catalogue::builtIn());
  return analysis::solveStress(scene, {}).value();
}

int countOf(const std::string& script, const std::string& start) {
  std::istringstream lines(script);
  std::string line;
  int count = 0;
  while (std::getline(lines, line)) {
    count += line.rfind(start, 0) == 0 ? 1 : 0;
  }
  return count;
}

TEST(Ansys, HasABarAndASpringForEachOfTheFrame) {
  const analysis::StressState state = squareState();
  int touching = 0;
  for (const bool touches : state.touching) {
    touching += touches ? 1 : 0;
  }
  const std::string script = writeAnsys(state, "Square");
  const int springs = static_cast<int>(state.model.frame.springs.size()) + touching;
  EXPECT_EQ(countOf(script, "E,"), static_cast<int>(state.model.frame.elements.size()) + springs);
  EXPECT_EQ(countOf(script, "R,"), springs);
  // 78 constants, six a line: R and twelve times RMORE.
  EXPECT_EQ(countOf(script, "RMORE,"), 12 * springs);
}

TEST(Ansys, LoadsItWithTheWholeWeight) {
  const analysis::StressState state = squareState();
  std::istringstream lines(writeAnsys(state, "Square"));
  std::string line;
  double sum = 0.0;
  while (std::getline(lines, line)) {
    const std::size_t at = line.find(",FZ,");
    if (line.rfind("F,", 0) == 0 && at != std::string::npos) {
      sum += std::stod(line.substr(at + 4));
    }
  }
  EXPECT_NEAR(sum, -state.model.weight, 1e-6);
}

TEST(Ansys, KeepsCommandsOutOfItsTitle) {
  const std::string script = writeAnsys(squareState(), "a$FINISH\n/EXIT");
  EXPECT_EQ(countOf(script, "/EXIT"), 0);
  EXPECT_EQ(script.find('$'), std::string::npos);
}

}  // namespace
}  // namespace liftarm::exporters
