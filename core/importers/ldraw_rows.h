#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "lattice/vec.h"

namespace liftarm::importers {

//! \brief A row of type 1, in LDraw's own coordinates: position in LDU, matrix row by row.
struct LdrawRow {
  int color = 16;
  lattice::Vec3 position;
  lattice::Mat3 rotation;
  std::string file;  //!< in lower case, white space in it made single
};

//! \brief The files of a document in their order.
struct LdrawFiles {
  std::string title;  //!< name of the first as it is written, white space in it made single
  std::vector<std::string> names;
  std::map<std::string, std::vector<LdrawRow>> rows;
  std::set<std::string> drawn;     //!< those with lines or surfaces of their own
  std::vector<std::string> notes;  //!< names that stand there more than once
};

//! \brief Lines with any end: CR LF, LF, CR.
std::vector<std::string_view> linesOf(std::string_view text);

//! \brief Without white space at its ends.
std::string_view trimmed(std::string_view text);

//! \brief Reads all rows of type 1. \return The files, or one sentence that names the line.
base::Result<LdrawFiles> readRows(std::string_view text);

//! \brief Whether a line has as many fields as a row of type 1, and what may be numbers in them.
bool looksLikeRow(std::string_view line);

//! \brief Whether a colour is that of what holds the part.
bool isInherited(int color);

}  // namespace liftarm::importers
