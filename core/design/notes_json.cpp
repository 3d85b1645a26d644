#include "design/notes_json.h"

#include "design/json_values.h"

namespace liftarm::design {

namespace {

using nlohmann::json;

json mendJson(const std::vector<sketch::MendedLine>& mend) {
  json lines = json::array();
  for (const sketch::MendedLine& mended : mend) {
    json line{{"from", pointJson(mended.from)}, {"to", pointJson(mended.to)}};
    if (mended.line >= 0) {
      line["line"] = mended.line;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

json notesJson(const std::vector<sketch::Note>& notes) {
  json all = json::array();
  for (const sketch::Note& note : notes) {
    all.push_back({{"kind", note.kind},
                   {"message", note.message},
                   {"at", pointJson(note.at)},
                   {"lines", note.lines},
                   {"mend", mendJson(note.mend)}});
  }
  return all;
}

}  // namespace liftarm::design
