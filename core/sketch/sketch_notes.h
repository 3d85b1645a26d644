#pragma once

#include <string>
#include <vector>

#include "lattice/vec.h"
#include "sketch/sketch_json.h"

namespace liftarm::sketch {

//! \brief A line that a mend changes or, where `line` is -1, adds.
struct MendedLine {
  int line = -1;
  lattice::Vec3 from;
  lattice::Vec3 to;
};

//! \brief Something that a person would want to know of a legal sketch before it is built.
struct Note {
  std::string kind;     //!< "moved", "open", "near", "crossing" or "pieces"
  std::string message;  //!< one sentence with the place and, where there is one, the mend
  lattice::Vec3 at;
  std::vector<int> lines;
  std::vector<MendedLine> mend;  //!< what would put it right; empty where nothing simple would
};

//! Of one kind no more are told one by one.
inline constexpr int kMostNotes = 8;

//! \brief What reading moved, lengths that do not close, lines that nearly touch or cross where no
//! pin can be, and pieces that nothing joins, in this order.
std::vector<Note> notesOn(const Reading& reading);

}  // namespace liftarm::sketch
