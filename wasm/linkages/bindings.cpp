// What JavaScript may call of the linkages (hand-written twin:
// web/src/solver/linkages/linkage-module.ts).

#include <string>

#include <emscripten/bind.h>

#include "base/status.h"
#include "linkages/linkage_json.h"
#include "linkages/linkage_table.h"

namespace {

using liftarm::base::Result;
using liftarm::linkages::LinkageTable;

//! \brief A text, or the message that says why there is none.
struct LinkageReply {
  bool ok = false;
  std::string text;
};

LinkageReply findLinkages(const LinkageTable& table, const std::string& pathJson) {
  const Result<std::string> found = liftarm::linkages::linkagesJson(table, pathJson);
  return found.ok() ? LinkageReply{true, found.value()}
                    : LinkageReply{false, found.error().message};
}

}  // namespace

EMSCRIPTEN_BINDINGS(liftarmLinkages) {
  emscripten::value_object<LinkageReply>("LinkageReply")
      .field("ok", &LinkageReply::ok)
      .field("text", &LinkageReply::text);
  emscripten::class_<LinkageTable>("LinkageTable")
      .constructor<>()
      .function("advance", &LinkageTable::advance)
      .function("fraction", &LinkageTable::fraction)
      .function("find", &findLinkages);
}
