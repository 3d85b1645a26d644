#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/status.h"

namespace liftarm::design {

//! \brief The only door to the program: text in, text out. Used by the command and by wasm/.
//! \details A session is stepped: nobody can call into a busy WebAssembly module, so advance() does
//! a bounded amount of work and returns. No clock, no threads, no files.
class DesignSession {
 public:
  //! \param sketchJson   A sketch (DESIGN 3).
  //! \param settingsJson {"seed": 1, "preset": "simple", "method": "default", "set": {"key":
  //! value}, "earlier": layout}; everything optional.
  //! \return The session, or the one message that says what is wrong with either text.
  static base::Result<std::unique_ptr<DesignSession>> create(std::string_view sketchJson,
                                                             std::string_view settingsJson);

  virtual ~DesignSession() = default;

  //! \brief Does at most `iterations` steps of the search. \return True when the search has ended.
  virtual bool advance(std::uint32_t iterations) = 0;

  //! \brief Where the search stands, as JSON: {"done", "phase", "iterations", "fraction" (0..1),
  //! "objective", "temperature", "beams", "gaps", "collisions", "failedConnections",
  //! "improvements", "terms" (what each term of the objective adds for the best layout)}.
  //! `improvements` counts how often the best layout changed: when it grew,
  //! modelJson() is new.
  [[nodiscard]] virtual std::string progressJson() const = 0;

  //! \brief The best model so far as model JSON (model/model_json.h).
  [[nodiscard]] virtual std::string modelJson() const = 0;

  //! \brief The best layout so far, for the setting "earlier" of a search on a changed sketch.
  [[nodiscard]] virtual std::string layoutJson() const = 0;

  //! \brief The report of DESIGN 4 on the best model so far, without its times, as JSON.
  [[nodiscard]] virtual std::string reportJson() const = 0;
};

//! \brief Every check on a model file (DESIGN 5): {"buildable": bool, "items": [{"id", "title",
//! "ok", "detail"}], "problems": [{"kind", "message", "at": [x,y,z], "parts": [..]}], "wellBuilt":
//! {"passed", "of", "items": [{"id", "title", "ok", "applies", "detail", "figures", "places"}]},
//! ...}; `wellBuilt` is DESIGN 5b.
base::Result<std::string> checkModelJson(std::string_view modelJson);

//! \brief How a model is put together (DESIGN 5.6 reversed), as JSON: {"assemblable": bool,
//! "groups": [{"id", "parts": all part indices in it, "copies": [[indices of each further copy, in
//! the same order]], "mirrored": [bool per copy]}], "steps": [{"group", "adds": [{"parts",
//! "travel", "subgroup": group or null, "via"?, "forced"?}], "stable": bool}], "stuck": [{"parts",
//! "by", "message"}]}. Group 0 is the whole. `travel` (modules) is the last straight move, which
//! ends in the place; the moves of `via` come before it, so a part starts at its place - travel -
//! all of via. `forced`: something is in the way, as `stuck` tells.
base::Result<std::string> planAssemblyJson(std::string_view modelJson);

//! \brief Stress of a model under its weight and the loads of the options.
//! \param optionsJson {"friction": "held" | "free" | "locked", "heldStiffness": N mm / rad,
//! "loads":
//! [{"at": [x,y,z] in modules, "force": [x,y,z] in N}]}; everything optional.
//! \return {"ok": true, "message": "", "maxStress": MPa, "safety", "maxDisplacement": mm, "weight":
//! N, "imbalance", "parts": [{"stress", "safety", "utilisation"} per part], "samples": [per part:
//! [[x,y,z in modules, stress, dx,dy,dz in mm] ...]], "pins": [{"part", "shear", "safety",
//! "torque": N mm}], "reactions": [{"at", "force"}]}; or {"ok": false, "message", "moving":
//! [parts]} where something moves without resistance.
base::Result<std::string> analyseStressJson(std::string_view modelJson,
                                            std::string_view optionsJson);

//! \brief How a model stands and moves at the first order.
//! \return {"freedoms": {"free", "held": internal freedoms with pins of friction free and holding,
//! "expected": annotated joints, "beyondJoints", "heldBeyondJoints": freedoms in which no joint
//! turns, "spinning": motions of pins and the like alone}, "groups": [rigid group of each part],
//! "motions":
//! [{"joint": index or null, "parts": [..], "velocities": [[vx,vy,vz, wx,wy,wz] about the world's
//! origin, per listed part]}], "joints": [{"index", "joint": of the sketch, "turns", "from", "to":
//! degrees, "stoppedBy": {"from": [two parts] or [], "to"}, "message", "bodies": [two of `between`]
//! where the joint has more than two: then each two of them have a row}], "trains": [{"index",
//! "turns", "message", "shafts": [{"parts", "drawn": of the sketch or null, "at", "axis": [x,y,z],
//! "speed": turns about its axis for one of the first shaft}]}], "balance": {"stable",
//! "centre": [x,y,z], "polygon":
//! [[x,y]], "ground": z, "margin": modules, "tippingAngle": degrees, "direction": [x,y]} or null,
//! "braces": [{"lines": [two], "from", "to": [x,y,z], "message"}]}.
base::Result<std::string> analyseMotionJson(std::string_view modelJson);

//! \brief Turns an annotated joint through its range. \param joint An index of "joints" above.
//! \return {"index", "turns", "message", "parts": [those that move], "angles": [degrees, rising, 0
//! among them], "poses": [per angle: [per listed part: x,y,z in modules, quaternion x,y,z,w]]}.
base::Result<std::string> jointMotionJson(std::string_view modelJson, int joint);

//! \brief The same for one of the "motions" of analyseMotionJson.
base::Result<std::string> freeMotionJson(std::string_view modelJson, int motion);

//! \brief A model in another format. \param format "mpd", "parts.csv" (Rebrickable), "wanted.xml"
//! (BrickLink), "spreadsheet.csv", or "assembly.json" (planAssemblyJson).
//! Also "inp" (CalculiX) and "apdl" (ANSYS): the frame of stress_deck.h.
base::Result<std::string> exportModel(std::string_view modelJson, std::string_view format);

}  // namespace liftarm::design
