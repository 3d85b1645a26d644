#include "design/design_session.h"
#include "design/stress_deck.h"
#include "exporters/ldraw.h"
#include "exporters/parts_list.h"
#include "exporters/spreadsheet.h"
#include "exporters/wanted_list.h"
#include "model/model_json.h"

namespace liftarm::design {

base::Result<std::string> exportModel(std::string_view modelJson, std::string_view format) {
  if (format == "assembly.json") {
    return planAssemblyJson(modelJson);
  }
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
  if (format == "wanted.xml") {
    return exporters::writeWantedList(model.value());
  }
  if (format == "spreadsheet.csv") {
    return exporters::writeSpreadsheet(model.value(), parts::Catalogue::builtIn());
  }
  if (format == "inp" || format == "apdl") {
    return writeStressDeck(model.value(), std::string(format));
  }
  return base::Error{base::Status::kInvalidInput,
                     "format: \"" + std::string(format) +
                         "\" is not known; use mpd, parts.csv, wanted.xml, spreadsheet.csv, "
                         "assembly.json, inp or apdl"};
}

}  // namespace liftarm::design
