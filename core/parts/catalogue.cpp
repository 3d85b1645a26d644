#include "parts/catalogue.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "parts/catalogue_data.h"
#include "parts/catalogue_json.h"

namespace liftarm::parts {

Catalogue::Catalogue(std::vector<Part> parts) : parts_(std::move(parts)) {
  std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.id < b.id; });
}

const Catalogue& Catalogue::builtIn() {
  static const Catalogue catalogue = [] {
    base::Result<std::vector<Part>> parts = readCatalogue(catalogueJsonText());
    LIFTARM_CHECK(parts.ok(), "the embedded catalogue cannot be read");
    return Catalogue(std::move(parts).value());
  }();
  return catalogue;
}

const Part* Catalogue::find(std::string_view id) const {
  const auto at = std::lower_bound(
      parts_.begin(), parts_.end(), id, [](const Part& part, std::string_view key) {
        return part.id < key;
      });
  return at != parts_.end() && at->id == id ? &*at : nullptr;
}

}  // namespace liftarm::parts
