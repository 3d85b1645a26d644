#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lattice/vec.h"
#include "parts/catalogue.h"

namespace liftarm::layout {

//! \brief A straight axle of the catalogue that can lie along a line.
struct AxlePart {
  std::string part;      //!< LDraw number
  int length = 0;        //!< in slots of one module
  bool stopped = false;  //!< it has a stop at one end
  lattice::Vec3 end;     //!< towards its stop, if it has one; unit vector along it, part frame
};

//! \brief An axle in place of the beams of a run: it lies on the line itself, goes through the
//! beams of the runs that this one meets, and bushes keep them from sliding.
struct Axle {
  int part = -1;             //!< index in axleParts(); -1: there is none
  int start = 0;             //!< node index of its first slot
  bool turned = false;       //!< its stop is at the first slot, not at the last
  std::uint32_t bushes = 0;  //!< bit i: a bush is on slot i
  std::uint32_t seats = 0;   //!< bit i: a beam was in slot i when it was laid

  [[nodiscard]] bool used() const { return part >= 0; }

  [[nodiscard]] int length() const;

  [[nodiscard]] int last() const { return start + length() - 1; }

  [[nodiscard]] bool hasBush(int index) const { return has(bushes, index); }

  //! \brief Bushes in use.
  [[nodiscard]] int bushCount() const;

  //! \brief Slots in which there was a beam when it was laid.
  [[nodiscard]] int headCount() const;

  //! \brief What it and its bushes cost, in the units of Connection::cost.
  [[nodiscard]] double cost() const;

  friend bool operator==(const Axle& a, const Axle& b) {
    return a.part == b.part && a.start == b.start && a.turned == b.turned && a.bushes == b.bushes &&
           a.seats == b.seats;
  }

 private:
  [[nodiscard]] bool has(std::uint32_t slots, int index) const {
    return index >= start && index <= last() &&
           (slots >> static_cast<unsigned>(index - start) & 1U) != 0U;
  }
};

//! An axle may reach this far past the ends of its line, bushes included.
inline constexpr int kAxleReach = 3;

//! The part that keeps beams from sliding.
inline constexpr const char* kBush = "3713";

//! \brief What an axle on a run has to do with. Bit i is node index i - kAxleReach.
struct AxleSite {
  int edges = 0;                //!< of the run
  std::uint64_t seats = 0;      //!< a beam has a hole there, on the line and along it
  std::uint64_t forbidden = 0;  //!< nothing may be there
};

//! \brief The cheapest axle with bushes that covers a run and holds every beam on it.
//! \param parts Indices in axleParts() that may be used.
//! \return Where none holds them all, one without bushes that covers the line; where none is long
//! enough for that, an Axle that is not used().
Axle layAxle(const AxleSite& site, const std::vector<int>& parts);

//! \brief Of the beams on an axle those that cannot slide along it: side by side between bushes or
//! a stop. \param seats As in AxleSite. \return The same, those only that are held.
std::uint64_t heldOn(const Axle& axle, std::uint64_t seats);

//! \brief Place of a node index in the bits of AxleSite. \pre -kAxleReach <= index.
constexpr unsigned axleBit(int index) {
  return static_cast<unsigned>(index + kAxleReach);
}

//! \brief Whether the bit of a node index is set; none is beyond the reach.
constexpr bool hasAxleBit(std::uint64_t bits, int index) {
  return index >= -kAxleReach && (bits >> axleBit(index) & 1U) != 0U;
}

//! \brief The axles among some parts: nothing but one cross from end to end, and a stop at most;
//! three slots or more.
std::vector<AxlePart> axlePartsOf(const std::vector<parts::Part>& parts);

//! \brief Those of the built-in catalogue, by length, those without a stop first.
const std::vector<AxlePart>& axleParts();

//! \brief Index in axleParts(), or -1.
int axlePartIndex(const std::string& part);

//! \brief All indices of axleParts(), ascending.
std::vector<int> allAxleParts();

}  // namespace liftarm::layout
