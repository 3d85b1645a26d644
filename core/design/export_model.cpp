#include "design/design_session.h"
#include "exporters/ldraw.h"
#include "exporters/parts_list.h"
#include "model/model_json.h"

namespace liftarm::design {

base::Result<std::string> exportModel(std::string_view modelJson, std::string_view format) {
  const base::Result<model::Model> model = model::readModel(modelJson);
  if (!model.ok()) {
    return model.error();
  }
  if (format == "mpd") {
    return exporters::writeLdraw(model.value(), parts::Catalogue::builtIn());
  }
  if (format == "parts.csv") {
    return exporters::writePartsCsv(model.value());
  }
  return base::Error{base::Status::kInvalidInput,
                     "format: \"" + std::string(format) + "\" is not known; use mpd or parts.csv"};
}

}  // namespace liftarm::design
