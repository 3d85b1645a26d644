#pragma once

#include <string>
#include <utility>
#include <vector>

#include "layout/layout.h"

namespace liftarm::search {

//! \brief How many of the parts that it lays the search may use; what is not listed, as many as it
//! likes.
struct Supply {
  struct Beams {
    int holes = 0;
    int owned = 0;  //!< parts, of which a beam of 4 or 6 holes takes two
  };

  std::vector<Beams> beams;               //!< straight ones
  std::vector<std::pair<int, int>> bent;  //!< index of a bent beam (layout/bent_beam.h), and owned
  std::vector<std::pair<int, int>> frames;  //!< index of a frame (layout/frame_beam.h), and owned
  std::vector<std::pair<std::string, int>> connectors;  //!< LDraw number, owned
};

//! \brief Counts what a layout uses beyond a supply. \details Pins of joints in line count as 2780,
//! which the model has there; pins without friction at joints count as those they replace.
class SupplyCounter {
 public:
  //! \pre table outlives this.
  SupplyCounter(Supply supply, const mechanisms::MechanismTable& table);

  [[nodiscard]] bool limited() const { return limited_; }

  //! \brief Parts that a layout needs and the supply has not.
  [[nodiscard]] int missing(const layout::Layout& layout);

  //! \brief What a beam of each length costs more while a run is covered anew: `cost` for each part
  //! that would be missing, given the beams of all other runs.
  [[nodiscard]] std::vector<double> lengthCosts(const layout::Layout& layout,
                                                int run,
                                                const std::vector<int>& lengths,
                                                double cost) const;

 private:
  [[nodiscard]] std::vector<int> framesUsed(const layout::Layout& layout) const;
  [[nodiscard]] std::vector<int> beamsUsed(const layout::Layout& layout, int exceptRun) const;
  [[nodiscard]] const std::vector<int>& connectorsOf(int oriented);

  Supply supply_;
  const mechanisms::MechanismTable* table_;
  bool limited_ = false;
  int inlinePin_ = -1;                         //!< place of 2780 among the connectors ...
  int spacer_ = -1;                            //!< ... and of the spacer
  std::vector<std::vector<int>> byMechanism_;  //!< counts of the connectors, filled when asked for
};

}  // namespace liftarm::search
