#pragma once

#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "sketch/sketch_json.h"

namespace liftarm::bench {

//! \brief A sketch file, by its path from the project's root; nothing where it is missing or
//! refused.
inline std::optional<sketch::Sketch> readSketchFile(const std::string& path) {
  std::ifstream file(std::string(LIFTARM_SOURCE_DIR) + "/" + path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  base::Result<sketch::Sketch> sketch = sketch::readSketch(text);
  if (!sketch.ok()) {
    return std::nullopt;
  }
  return std::move(sketch).value();
}

}  // namespace liftarm::bench
