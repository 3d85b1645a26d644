#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "model/model.h"

namespace liftarm::importers {

//! \brief What a document of another program holds.
struct Imported {
  model::Model model;
  std::vector<std::string> notes;  //!< what was left out or taken otherwise, one sentence each
};

//! \brief Whether a text looks like an LDraw file: its first rows are comments or parts of one.
bool looksLikeLdraw(std::string_view text);

//! \brief Reads an LDraw document (.ldr, .mpd): the parts that the catalogue knows, under any of
//! their numbers (part_numbers.h).
//! \details Submodels are followed, each as often as it is referred to; colours are inherited; of
//! two files with one name the first counts. A part that is its own mirror image may be placed as
//! one. The page reads the same by web/src/share/read-mpd.ts; tests/contract/ldraw.test.ts compares
//! them. \param text UTF-8 (text_encoding.h).
//! \return The model without a sketch, or kInvalidInput with one sentence that names the place.
base::Result<Imported> readLdraw(std::string_view text, const parts::Catalogue& catalogue);

}  // namespace liftarm::importers
