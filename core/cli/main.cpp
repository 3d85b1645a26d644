// The command `liftarm` (DESIGN 4).

#include <algorithm>
#include <functional>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/export_command.h"
#include "cli/linkage_command.h"
#include "cli/solve_command.h"
#include "cli/train_command.h"

namespace {

using liftarm::cli::ExitCode;

constexpr int kMostSeeds = 10000;
constexpr int kMostThreads = 256;
constexpr const char* kAboutModel = "Model file (NAME.model.json), or LDraw (.ldr, .mpd)";
constexpr const char* kAbout =
    "Liftarm turns a 3D line sketch into a Technic model that can be built.\n"
    "Exit codes: 0 buildable, 1 input refused (one line on standard error), 2 not buildable,\n"
    "3 the machine could not do it, as when the disk is full (one line on standard error).\n"
    "LEGO is a trademark of the LEGO Group, which does not sponsor or endorse this.";

//! Options of a verb that say what the search may do.
void addSettings(CLI::App* verb, liftarm::cli::SolveOptions& options) {
  verb->add_option("--preset",
                   options.preset,
                   "balanced (usual), faithful, simple, faithful-rigid or simple-rigid")
      ->type_name("NAME");
  verb->add_option(
          "--method",
          options.method,
          "How to search: default, paper (the published method, for comparison), or what it was "
          "compared with: random, greedy, beam-search, ant-colony, population")
      ->type_name("NAME");
  verb->add_option("--set",
                   options.settings,
                   "One setting, such as effort=2 or weights.beams=3; a wrong key lists all")
      ->type_name("key=value")
      ->allow_extra_args(false);
}

void addSolve(CLI::App& app, liftarm::cli::SolveOptions& options) {
  CLI::App* solve = app.add_subcommand(
      "solve",
      "Solve a sketch: write DIR/NAME.model.json, NAME.mpd, NAME.parts.csv and print a report");
  solve->add_option("SKETCH", options.sketchPath, "Sketch file (JSON)")->required();
  solve->add_option("-o,--output", options.folder, "Folder for the results")
      ->type_name("DIR")
      ->capture_default_str();
  solve->add_flag("--no-files", options.quiet, "Print the report only");
  solve->add_option("--seed", options.seed, "Seed of the search, a whole number")->type_name("N");
  solve->add_option("--seeds", options.seeds, "How many seeds to try, from --seed on; best is kept")
      ->type_name("N")
      ->check(CLI::Range(1, kMostSeeds));
  solve->add_option("--threads", options.threads, "Searches at the same time; changes no result")
      ->type_name("M")
      ->check(CLI::Range(1, kMostThreads));
  addSettings(solve, options);
  solve->add_flag("--json", options.json, "Print the report as one JSON object");
}

//! A verb and what it does.
struct Verb {
  CLI::App* app;
  std::function<ExitCode()> act;
};

//! What the verbs besides `solve` are given.
struct OtherOptions {
  std::string modelPath;
  std::string sketchPath;
  std::string stressOptions;
  bool json = false;
};

//! A verb that tells of a sketch what a search with these settings would make of it.
CLI::App* addTelling(CLI::App& app,
                     const std::string& name,
                     const std::string& about,
                     liftarm::cli::SolveOptions& options) {
  CLI::App* verb = app.add_subcommand(name, about);
  verb->add_option("SKETCH", options.sketchPath, "Sketch file (JSON)")->required();
  addSettings(verb, options);
  return verb;
}

std::vector<Verb> addVerbs(CLI::App& app,
                           liftarm::cli::SolveOptions& options,
                           OtherOptions& other) {
  CLI::App* check =
      app.add_subcommand("check", "Repeat every check on a model file (docs/design.md, 5)");
  check->add_option("MODEL", other.modelPath, kAboutModel)->required();
  check->add_flag("--json", other.json, "Print the answer as one JSON object");
  CLI::App* stress = app.add_subcommand(
      "stress", "Print the stress of a model under its weight and loads: one JSON object");
  stress->add_option("MODEL", other.modelPath, kAboutModel)->required();
  stress
      ->add_option("--options",
                   other.stressOptions,
                   "JSON, such as {\"loads\": [{\"at\": [4, 0, 8], \"force\": [0, 0, -5]}]}: "
                   "modules and newtons")
      ->type_name("JSON");
  CLI::App* symmetries = app.add_subcommand(
      "symmetries", "Print the symmetries that a sketch has but does not name, in its own format");
  symmetries->add_option("SKETCH", other.sketchPath, "Sketch file (JSON)")->required();
  symmetries->add_flag("--json", other.json, "Print the answer as one JSON object");
  CLI::App* placements = addTelling(
      app,
      "placements",
      "Print every part in every place that may be used for a sketch, for proofs: one JSON object",
      options);
  CLI::App* stageOne = addTelling(
      app,
      "stage-one",
      "Print how many adjacent holes differ in direction before and after stage one: JSON",
      options);
  stageOne->add_option("--seed", options.seed, "Seed, a whole number")->type_name("N");
  CLI::App* parts = app.add_subcommand(
      "parts", "Print the facts about all parts, for programs that judge models: JSON");
  return {
      {check, [&] { return liftarm::cli::checkCommand(other.modelPath, other.json); }},
      {symmetries, [&] { return liftarm::cli::symmetriesCommand(other.sketchPath, other.json); }},
      {stress, [&] { return liftarm::cli::stressCommand(other.modelPath, other.stressOptions); }},
      {placements, [&] { return liftarm::cli::placementsCommand(options); }},
      {stageOne, [&] { return liftarm::cli::stageOneCommand(options); }},
      {parts, liftarm::cli::partsCommand}};
}

CLI::App* addLinkage(CLI::App& app, liftarm::cli::LinkageOptions& options) {
  CLI::App* linkage = app.add_subcommand(
      "linkage", "Find four-bars that draw a path: sketches to be solved, the best first");
  linkage->add_option("PATH", options.pathFile, "Path file (JSON)")->required();
  linkage->add_option("--kind", options.kind, "any (usual), foot or line; else the file's")
      ->type_name("KIND");
  linkage->add_option("--turns", options.turns, "any (usual), or quarter: pivots in a row")
      ->type_name("TURNS");
  linkage->add_option("-o,--output", options.folder, "Folder for the sketches; none: no files")
      ->type_name("DIR");
  linkage->add_flag("--json", options.json, "Print the answer as one JSON object");
  return linkage;
}

//! Verbs that make one file of another.
std::vector<Verb> addFiles(CLI::App& app, liftarm::cli::ExportOptions& options) {
  const auto add = [&](const char* name, const char* about) {
    CLI::App* verb = app.add_subcommand(name, about);
    verb->add_option("MODEL", options.modelPath, kAboutModel)->required();
    verb->add_option("-o,--output", options.output, "File to write")->type_name("FILE");
    return verb;
  };
  CLI::App* exported = add("export", "Write a model in another format; without -o, print it");
  exported
      ->add_option("--as",
                   options.format,
                   "mpd (LDraw), parts.csv (Rebrickable), wanted.xml (BrickLink), "
                   "spreadsheet.csv, assembly.json, inp (CalculiX), apdl (ANSYS); else what FILE "
                   "ends with")
      ->type_name("FORMAT");
  CLI::App* steps =
      add("instructions", "Print how a model is put together, step by step, with its parts");
  steps->add_flag("--json", options.json, "Print the plan as one JSON object");
  CLI::App* imported =
      add("import", "Write the model file of an LDraw document; without -o, NAME.model.json here");
  return {{exported, [&] { return liftarm::cli::exportCommand(options); }},
          {steps, [&] { return liftarm::cli::instructionsCommand(options); }},
          {imported, [&] { return liftarm::cli::importCommand(options); }}};
}

constexpr double kMostRatio = 1000.0;
constexpr int kMostWay = 30;

CLI::App* addTrain(CLI::App& app, liftarm::cli::TrainOptions& options) {
  CLI::App* train = app.add_subcommand(
      "train", "Find the gears that couple two parallel shafts, with the fewest parts");
  train->add_option("WAY", options.way, "From the first shaft to the last across them, modules")
      ->expected(2)
      ->required()
      ->check(CLI::Range(-kMostWay, kMostWay))
      ->type_name("U V");
  train->add_option("--ratio", options.ratio, "Turns of the first shaft for one turn of the last")
      ->check(CLI::Range(1.0 / kMostRatio, kMostRatio));
  train->add_option("--tolerance", options.tolerance, "Per cent that the ratio may be off (3)")
      ->check(CLI::Range(0.0, 50.0));
  train
      ->add_option("-o,--output", options.folder, "Folder for a sketch with a frame; none: no file")
      ->type_name("DIR");
  train->add_flag("--json", options.json, "Print the answer as one JSON object");
  return train;
}

int run(int argc, char** argv) {
  CLI::App app(kAbout, "liftarm");
  // Help of the whole command shows the options of its verbs too.
  app.set_help_flag();
  app.set_help_all_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  liftarm::cli::SolveOptions options;
  OtherOptions other;
  addSolve(app, options);
  std::vector<Verb> verbs = addVerbs(app, options, other);
  liftarm::cli::ExportOptions exportOptions;
  const std::vector<Verb> files = addFiles(app, exportOptions);
  verbs.insert(verbs.end(), files.begin(), files.end());

  liftarm::cli::LinkageOptions linkageOptions;
  CLI::App* linkage = addLinkage(app, linkageOptions);
  liftarm::cli::TrainOptions trainOptions;
  const CLI::App* train = addTrain(app, trainOptions);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    std::ostringstream help;
    const int code = app.exit(asked, help);  // --help
    return liftarm::cli::print(help.str())
               ? code
               : static_cast<int>(liftarm::cli::fail("the help cannot be written"));
  } catch (const CLI::ParseError& error) {
    return static_cast<int>(
        liftarm::cli::refuse(std::string(error.what()) + "; liftarm --help tells all"));
  }
  const auto asked =
      std::find_if(verbs.begin(), verbs.end(), [](const Verb& verb) { return verb.app->parsed(); });
  if (linkage->parsed()) {
    return static_cast<int>(liftarm::cli::linkageCommand(linkageOptions));
  }
  if (train->parsed()) {
    return static_cast<int>(liftarm::cli::trainCommand(trainOptions));
  }
  return static_cast<int>(asked != verbs.end() ? asked->act()
                                               : liftarm::cli::solveCommand(options));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    return static_cast<int>(liftarm::cli::fail("not enough memory for this"));
  }
}
