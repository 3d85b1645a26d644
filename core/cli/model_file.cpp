#include "cli/model_file.h"

#include <cstddef>
#include <utility>

#include "cli/files.h"
#include "importers/ldraw.h"
#include "importers/text_encoding.h"
#include "model/model_json.h"

namespace liftarm::cli {

namespace {

constexpr std::size_t kPeek = 4096;

}  // namespace

base::Result<ModelText> readModelFile(const std::string& path) {
  base::Result<std::string> read = readFile(path, model::kMaxModelBytes);
  if (!read.ok()) {
    return read.error();
  }
  if (read.value().compare(0, 2, "PK") == 0) {
    return base::Error{base::Status::kInvalidInput,
                       path +
                           ": is an archive; of a Studio file (.io), export the model as LDraw "
                           "(.ldr) and open that"};
  }
  // A model file may be large: it is not copied to be looked at.
  if (!importers::looksLikeLdraw(importers::decodedText(read.value().substr(0, kPeek)))) {
    return ModelText{std::move(read).value(), {}};
  }
  const std::string text = importers::decodedText(read.value());
  const base::Result<importers::Imported> imported =
      importers::readLdraw(text, parts::Catalogue::builtIn());
  if (!imported.ok()) {
    return base::Error{base::Status::kInvalidInput, path + ": " + imported.error().message};
  }
  return ModelText{model::writeModel(imported.value().model), imported.value().notes};
}

}  // namespace liftarm::cli
