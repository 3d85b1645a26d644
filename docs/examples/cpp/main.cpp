// A frame of four lines, as a model: `npm run example:cpp` builds and runs this against an installation.
#include <cstdio>

#include <design/solve.h>

int main() {
  liftarm::sketch::Sketch frame;
  frame.name = "Frame";
  frame.lines = {{{0, 0, 0}, {10, 0, 0}}, {{10, 0, 0}, {10, 0, 6}},
                 {{10, 0, 6}, {0, 0, 6}}, {{0, 0, 6}, {0, 0, 0}}};
  const auto design = liftarm::design::solve(frame, {.seed = 3});
  if (!design.ok()) {
    std::fprintf(stderr, "%s\n", design.error().message.c_str());
    return 1;
  }
  const auto& found = design.value();
  std::printf("%s: %s, %zu parts, %.1f g\n", frame.name.c_str(),
              found.buildable ? "buildable" : "not buildable", found.model.parts.size(),
              found.check.counts.mass);
  return found.buildable ? 0 : 2;
}
