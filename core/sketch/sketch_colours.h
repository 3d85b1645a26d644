#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/status.h"
#include "sketch/json_fields.h"
#include "sketch/keep.h"
#include "sketch/shaft.h"
#include "sketch/sketch.h"

namespace liftarm::sketch {

//! \brief The colour of one part of the model: the one with this number whose origin is here.
struct PaintedPart {
  std::string part;  //!< LDraw number
  lattice::Vec3 at;  //!< modules
  int colour = 0;
};

//! \brief What a sketch of version 2 says of colours, all LDraw codes. Empty: nothing.
//! \details A part's colour goes before that of its line, a line's colour goes before that of a
//! kind, that before `standard`, that before the scheme. The search knows nothing of it.
struct SketchColours {
  std::optional<std::string> scheme;  //!< one of kColourSchemes
  std::optional<int> standard;        //!< "default": beams
  std::map<std::string, int> kinds;   //!< by one of kColourKinds
  std::map<int, int> lines;           //!< by line
  std::vector<PaintedPart> parts;

  [[nodiscard]] bool empty() const {
    return !scheme.has_value() && !standard.has_value() && kinds.empty() && lines.empty() &&
           parts.empty();
  }
};

//! How beams are coloured where nothing else is said: by their length (the default), by the
//! component that they are in, or as the catalogue has them.
inline constexpr std::string_view kColourSchemes[] = {"length", "component", "usual"};

//! Kinds of parts with a colour of their own; "bent" are beams that are not straight.
inline constexpr std::string_view kColourKinds[] = {
    "beam", "bent", "pin", "axle", "connector", "bush", "gear"};

inline constexpr std::size_t kMaxPaintedParts = 20000;
inline constexpr int kMaxColour = 511;  //!< LDraw's codes end there; direct colours are none

//! \brief Reads the member `colours` of a document.
//! \return False when `fields` has noted what is wrong.
bool readColours(const nlohmann::json& document,
                 FieldReader& fields,
                 int lineCount,
                 SketchColours& colours);

//! \brief The colours of a sketch's text. \pre readSketch accepts it.
SketchColours coloursOf(std::string_view text);

//! \brief writeSketch() with colours, what is to stay and what turns; of version 1 where none of
//! them needs more.
std::string writeSketch(const Sketch& sketch,
                        const SketchColours& colours,
                        const Keeps& keeps = {},
                        const Shafts& shafts = {});

}  // namespace liftarm::sketch
