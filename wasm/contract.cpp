#include "wasm/contract.h"

#include <nlohmann/json.hpp>

#include "design/settings.h"

namespace liftarm::wasm {

using base::Status;

std::string statusName(Status status) {
  switch (status) {
    case Status::kOk:
      return "ok";
    case Status::kInvalidInput:
      return "invalidInput";
    case Status::kUnsupported:
      return "unsupported";
    case Status::kInfeasible:
      return "infeasible";
    case Status::kSingular:
      return "singular";
    case Status::kCancelled:
      return "cancelled";
  }
  return "";
}

std::string contractJson() {
  // The enum has no count: its names are read until the first value that has none.
  nlohmann::ordered_json statuses = nlohmann::ordered_json::array();
  for (int i = 0; !statusName(static_cast<Status>(i)).empty(); ++i) {
    statuses.push_back(statusName(static_cast<Status>(i)));
  }
  nlohmann::ordered_json contract;
  contract["statuses"] = statuses;
  contract["settings"] =
      nlohmann::ordered_json::parse(design::settingsJson(design::readSettings("").value()));
  return contract.dump();
}

}  // namespace liftarm::wasm
