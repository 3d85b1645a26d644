#pragma once

namespace liftarm::base {

//! \brief exp, log and trigonometry from + - * / alone, so that every platform gives the same bits
//! (libm differs between our native and WebAssembly builds, DESIGN 2).
//! \details Relative error below 1e-12 over the stated ranges; not for the last digit.

//! \param x Any real number; below -700 gives 0, above 700 gives exp(700).
double detExp(double x);

//! \param x Positive.
double detLog(double x);

//! \param angle In radians, at most 1e6 in magnitude.
double detSin(double angle);
double detCos(double angle);

//! \return The angle of (x, y) in (-pi, pi].
double detAtan2(double y, double x);

}  // namespace liftarm::base
