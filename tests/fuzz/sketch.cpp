//! libFuzzer target: any bytes either give a sketch that arranges, writes and reads back, or a
//! refusal with a message. Each find becomes a row of tests/core/sketch.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/check.h"
#include "sketch/arrangement.h"
#include "sketch/sketch_json.h"

namespace {

using namespace liftarm;  // NOLINT(google-build-using-namespace): a program of one page

void checkArrangement(const sketch::Sketch& sketch) {
  const sketch::Arrangement arrangement = sketch::arrange(sketch);
  std::size_t units = 0;
  for (const sketch::Run& run : arrangement.runs) {
    LIFTARM_CHECK(run.nodes.size() == run.edges.size() + 1, "a run has one node more than edges");
    for (const sketch::ArrangedEdge& edge : run.edges) {
      units += edge.lines.size();
    }
  }
  std::size_t length = 0;
  for (const sketch::Line& line : sketch.lines) {
    length += static_cast<std::size_t>(line.length);
  }
  LIFTARM_CHECK(units == length, "each unit of each line lies in one edge");
  for (const sketch::ArrangedJoint& joint : arrangement.joints) {
    LIFTARM_CHECK(joint.node >= 0, "a joint lies at a node");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const base::Result<sketch::Sketch> result = sketch::readSketch(text);
  if (!result.ok()) {
    LIFTARM_CHECK(!result.error().message.empty(), "a refusal says why");
    return 0;
  }
  checkArrangement(result.value());
  if (result.value().residual <= 1e-9) {
    const base::Result<sketch::Sketch> again =
        sketch::readSketch(sketch::writeSketch(result.value()));
    LIFTARM_CHECK(again.ok(), "what we write can be read");
    LIFTARM_CHECK(again.value().lines.size() == result.value().lines.size(), "no line is lost");
  }
  return 0;
}
