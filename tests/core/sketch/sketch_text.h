#pragma once

#include <string>

#include "sketch/sketch_json.h"

namespace liftarm::testing {

//! \brief A sketch file with these lines (JSON objects, comma-separated) and members after them.
inline std::string sketchText(const std::string& lines, const std::string& more = "") {
  return R"({"format": "technic-sketch", "version": 1, "lines": [)" + lines + "]" +
         (more.empty() ? "" : ", " + more) + "}";
}

//! \brief One line from (x, y, z) to (x, y, z), both given as "0,0,0".
inline std::string lineText(const std::string& from,
                            const std::string& to,
                            const std::string& more = "") {
  return R"({"from": [)" + from + R"(], "to": [)" + to + "]" + (more.empty() ? "" : ", " + more) +
         "}";
}

//! \brief The message with which a text is refused, or "accepted".
inline std::string refusalOf(const std::string& text) {
  const base::Result<sketch::Sketch> result = sketch::readSketch(text);
  return result.ok() ? "accepted" : result.error().message;
}

}  // namespace liftarm::testing
