#pragma once

#include <memory>

#include "search/cooling.h"

namespace liftarm::rivals {

//! \brief The cooling schedules that \cite xu_2019_computational (5.3) "tried" beside the
//! exponential one. Readings: all begin at T_max and have as many moves as the exponential schedule
//! of the same cooling rate, so that they cost alike.

//! \brief Down to T_min by equal steps.
std::unique_ptr<search::Cooling> makeLinear(const search::CoolingPlan& plan);

//! \brief T_max ln 2 / ln(k + 2) before move k: the schedule that is proved to find the optimum,
//! and is still hot when the moves are used up.
std::unique_ptr<search::Cooling> makeLogarithmic(const search::CoolingPlan& plan);

//! \brief Constant thermodynamic speed, the optimum of \cite nourani_1998_comparison: the
//! temperature falls by a step in proportion to T over the standard deviation of the energy,
//! measured over each hundredth of the moves.
std::unique_ptr<search::Cooling> makeOptimum(const search::CoolingPlan& plan);

//! \brief After \cite devicente_2003_placement: the temperature is the change of the objective over
//! the change of entropy since the beginning; T_max while either is not below 0.
std::unique_ptr<search::Cooling> makeThermodynamic(const search::CoolingPlan& plan);

}  // namespace liftarm::rivals
