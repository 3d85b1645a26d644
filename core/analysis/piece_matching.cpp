#include "analysis/piece_matching.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>

#include "analysis/assembly.h"

namespace liftarm::analysis {

namespace {

//! Which assemblies could stand for which piece: those with a beam on every covered edge of it.
std::vector<std::vector<int>> candidatesOfPieces(const std::vector<EdgeCover>& coverage,
                                                 const std::vector<int>& assemblies,
                                                 const std::vector<int>& pieces) {
  const auto count = static_cast<std::size_t>(groupCount(pieces));
  std::vector<std::optional<std::set<int>>> common(count);
  for (const EdgeCover& edge : coverage) {
    std::set<int> here;
    for (const Cover& cover : edge.covers) {
      here.insert(assemblies[static_cast<std::size_t>(cover.part)]);
    }
    here.erase(-1);
    if (here.empty()) {
      continue;  // item 5 tells whether it is bridged
    }
    auto& ofPiece = common[static_cast<std::size_t>(pieces[static_cast<std::size_t>(edge.line)])];
    if (!ofPiece.has_value()) {
      ofPiece = std::move(here);
      continue;
    }
    for (auto it = ofPiece->begin(); it != ofPiece->end();) {
      it = here.count(*it) > 0 ? std::next(it) : ofPiece->erase(it);
    }
  }
  std::vector<std::vector<int>> candidates(count);
  for (std::size_t p = 0; p < count; ++p) {
    if (common[p].has_value()) {
      candidates[p].assign(common[p]->begin(), common[p]->end());
    }
  }
  return candidates;
}

class PieceMatcher {
 public:
  PieceMatcher(const std::vector<std::vector<int>>& candidates, int assemblies)
      : candidates_(candidates), pieceOf_(static_cast<std::size_t>(assemblies), -1) {
    for (std::size_t p = 0; p < candidates.size(); ++p) {
      seen_.assign(pieceOf_.size(), false);
      augment(static_cast<int>(p));
    }
  }

  [[nodiscard]] std::vector<int> assemblyOfPiece() const {
    std::vector<int> result(candidates_.size(), -1);
    for (std::size_t a = 0; a < pieceOf_.size(); ++a) {
      if (pieceOf_[a] >= 0) {
        result[static_cast<std::size_t>(pieceOf_[a])] = static_cast<int>(a);
      }
    }
    return result;
  }

 private:
  bool augment(int piece) {
    for (const int assembly : candidates_[static_cast<std::size_t>(piece)]) {
      const auto a = static_cast<std::size_t>(assembly);
      if (seen_[a]) {
        continue;
      }
      seen_[a] = true;
      if (pieceOf_[a] < 0 || augment(pieceOf_[a])) {
        pieceOf_[a] = piece;
        return true;
      }
    }
    return false;
  }

  const std::vector<std::vector<int>>& candidates_;
  std::vector<int> pieceOf_;  // by assembly
  std::vector<bool> seen_;
};

}  // namespace

PieceMatching matchPieces(const std::vector<EdgeCover>& coverage,
                          const std::vector<int>& assemblies,
                          const std::vector<int>& pieces) {
  const std::vector<std::vector<int>> candidates = candidatesOfPieces(coverage, assemblies, pieces);
  PieceMatching matching;
  matching.assemblyOfPiece = PieceMatcher(candidates, groupCount(assemblies)).assemblyOfPiece();
  matching.covered.assign(candidates.size(), false);
  for (const EdgeCover& edge : coverage) {
    if (!edge.covers.empty()) {
      matching.covered[static_cast<std::size_t>(pieces[static_cast<std::size_t>(edge.line)])] =
          true;
    }
  }
  return matching;
}

void keepOwnCovers(const std::vector<int>& assemblies,
                   const std::vector<int>& pieces,
                   std::vector<EdgeCover>& coverage) {
  const std::vector<int> own = matchPieces(coverage, assemblies, pieces).assemblyOfPiece;
  for (EdgeCover& edge : coverage) {
    const int assembly = own[static_cast<std::size_t>(pieces[static_cast<std::size_t>(edge.line)])];
    if (assembly < 0) {
      continue;
    }
    edge.covers.erase(std::remove_if(edge.covers.begin(),
                                     edge.covers.end(),
                                     [&](const Cover& cover) {
                                       return assemblies[static_cast<std::size_t>(cover.part)] !=
                                              assembly;
                                     }),
                      edge.covers.end());
  }
}

}  // namespace liftarm::analysis
