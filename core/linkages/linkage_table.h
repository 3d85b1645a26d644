#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "linkages/four_bar.h"
#include "linkages/path_match.h"
#include "linkages/path_shape.h"

namespace liftarm::linkages {

//! \brief What a path is for.
enum class PathKind {
  kAny,
  kFoot,  //!< both pivots lie above its lowest point, so that it can be walked on
  kLine,  //!< open: the way back is free
};

struct PathQuestion {
  DrawnPath path;
  PathKind kind = PathKind::kAny;
  Turns turns = Turns::kAny;
  int most = 6;  //!< answers
};

//! \brief A linkage that draws a path, and how well.
struct LinkageAnswer {
  FourBar bar;
  Match match;
  double transmission = 0.0;  //!< degrees at its worst
};

//! \brief The coupler curves of all crank-rockers within limits, with what is needed to find those
//! like a drawn path.
//! \details A curve is kept as points at equal arc length, and as the magnitudes of its Fourier
//! coefficients (path_shape.h), in the order of the largest: by Parseval's theorem, curves whose
//! magnitudes differ much lie apart however they are placed, so those beyond the best distances
//! found are passed over. Stepped, so that a worker can tell how far it is.
class LinkageTable {
 public:
  LinkageTable() : LinkageTable(FourBarLimits{}) {}

  explicit LinkageTable(const FourBarLimits& limits);

  //! \brief Adds the curves of at most so many couplers. \return True when all are in.
  bool advance(int couplers);

  //! \brief From 0 to 1.
  [[nodiscard]] double fraction() const;

  [[nodiscard]] std::size_t curves() const { return entries_.size(); }

  //! \brief The best linkages for a path, the best first; of linkages with the same links only
  //! one. \pre advance() has returned true; the path has at least two points.
  [[nodiscard]] std::vector<LinkageAnswer> find(const PathQuestion& question) const;

 private:
  struct Entry {
    std::uint16_t coupler = 0;
    std::uint8_t crank = 0;
    std::uint8_t rocker = 0;
    std::uint8_t frame = 0;
    float perimeter = 0.0F;
    std::array<float, kCoefficients> sizes{};
    std::array<std::int16_t, static_cast<std::size_t>(2 * kShapePoints)> points{};
  };

  //! A curve that may do, where it would lie.
  struct Candidate {
    int entry = -1;
    double distance = 0.0;
    Placement placement;
  };

  void addCurves(int coupler);
  void finish();
  [[nodiscard]] FourBar barOf(const Entry& entry) const;
  [[nodiscard]] static ShapePoints pointsOf(const Entry& entry);
  [[nodiscard]] std::vector<Candidate> likeClosed(const PathQuestion& question) const;
  [[nodiscard]] std::vector<Candidate> likeOpen(const PathQuestion& question) const;
  void placeClosed(const ShapePoints& drawn, Turns turns, Candidate* candidate) const;
  [[nodiscard]] bool suits(const Candidate& candidate, const PathQuestion& question) const;

  FourBarLimits limits_;
  std::vector<Coupler> couplers_;
  std::vector<Entry> entries_;
  std::vector<std::array<int, 3>> links_;  // that fit the present coupler
  int next_ = 0;
};

}  // namespace liftarm::linkages
