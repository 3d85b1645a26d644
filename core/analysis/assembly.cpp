#include "analysis/assembly.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include "analysis/node_index.h"
#include "analysis/piece_matching.h"
#include "analysis/union_find.h"

namespace liftarm::analysis {

namespace {

//! Renumbers groups as 0, 1, 2, ... in order of their first member; -1 stays.
void renumber(std::vector<int>& groups) {
  std::map<int, int> numbers;
  for (int& group : groups) {
    if (group >= 0) {
      group = numbers.emplace(group, static_cast<int>(numbers.size())).first->second;
    }
  }
}

void tellStrayAssembly(const Scene& scene,
                       const std::vector<int>& assemblies,
                       int stray,
                       ItemResult& result) {
  Problem problem;
  problem.kind = "separate";
  for (std::size_t i = 0; i < assemblies.size(); ++i) {
    if (assemblies[i] == stray) {
      problem.parts.push_back(static_cast<int>(i));
    }
  }
  const auto first = static_cast<std::size_t>(problem.parts.front());
  problem.at = scene.model->parts[first].pose.position;
  problem.message = std::to_string(problem.parts.size()) + " parts beside " +
                    nameOf(scene, problem.parts.front()) + " at " + pointText(*problem.at) +
                    " are not connected to the rest";
  result.problems.push_back(std::move(problem));
}

}  // namespace

int groupCount(const std::vector<int>& groups) {
  return groups.empty() ? 0 : *std::max_element(groups.begin(), groups.end()) + 1;
}

std::vector<int> findAssemblies(const Scene& scene) {
  UnionFind groups(scene.parts.size());
  std::vector<int> assemblies(scene.parts.size(), -1);
  std::vector<bool> touched(scene.parts.size(), false);
  for (const model::Connection& c : scene.connections) {
    touched[static_cast<std::size_t>(c.male)] = true;
    touched[static_cast<std::size_t>(c.female)] = true;
    if (c.fit != model::Fit::kSlide) {
      groups.join(c.male, c.female);
      assemblies[static_cast<std::size_t>(c.male)] = 0;
      assemblies[static_cast<std::size_t>(c.female)] = 0;
    }
  }
  for (std::size_t i = 0; i < assemblies.size(); ++i) {
    const parts::Part* part = scene.parts[i].part;
    const bool beam = part != nullptr && part->partClass == parts::PartClass::kBeam;
    if (assemblies[i] == 0 || (beam && !touched[i])) {
      assemblies[i] = groups.find(static_cast<int>(i));
    }
  }
  renumber(assemblies);
  return assemblies;
}

std::vector<int> piecesOfSketch(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  if (!scene.sketch.has_value()) {
    return {};
  }
  UnionFind groups(scene.sketch->lines.size());
  const NodeIndex nodes(coverage);
  for (int node = 0; node < static_cast<int>(nodes.points().size()); ++node) {
    const std::vector<int>& edges = nodes.edgesAt(node);
    for (const int e : edges) {
      groups.join(coverage[static_cast<std::size_t>(edges.front())].line,
                  coverage[static_cast<std::size_t>(e)].line);
    }
  }
  std::vector<int> pieces(scene.sketch->lines.size());
  for (std::size_t l = 0; l < pieces.size(); ++l) {
    pieces[l] = groups.find(static_cast<int>(l));
  }
  renumber(pieces);
  return pieces;
}

ItemResult checkAssembly(const Scene& scene, const std::vector<EdgeCover>& coverage) {
  ItemResult result;
  const std::vector<int> assemblies = findAssemblies(scene);
  const std::vector<int> pieces = piecesOfSketch(scene, coverage);
  const PieceMatching matching = matchPieces(coverage, assemblies, pieces);
  const std::vector<int>& taken = matching.assemblyOfPiece;
  for (int assembly = 0; assembly < groupCount(assemblies); ++assembly) {
    // Without a sketch the assembly of the first part is the model; any other is a stray.
    const bool known = std::find(taken.begin(), taken.end(), assembly) != taken.end();
    if (pieces.empty() ? assembly > 0 : !known) {
      tellStrayAssembly(scene, assemblies, assembly, result);
    }
  }
  if (result.problems.empty()) {
    for (std::size_t piece = 0; piece < matching.assemblyOfPiece.size(); ++piece) {
      if (matching.assemblyOfPiece[piece] < 0 && matching.covered[piece]) {
        result.problems.push_back(
            {"separate",
             "connected part " + std::to_string(piece) + " of the sketch is no assembly of its own",
             std::nullopt,
             {}});
      }
    }
  }
  result.detail = "pieces drawn: " + std::to_string(matching.assemblyOfPiece.size()) +
                  ", pieces built: " + std::to_string(groupCount(assemblies));
  return result;
}

}  // namespace liftarm::analysis
