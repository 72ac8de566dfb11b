#pragma once

#include <span>

namespace vehicle {

/// How far one column of a history is from the same column of a reference, equally spaced samples.
///
/// With <a, b> the trapezoidal mean of a b over time, m the reference and c the other:
///
///     max_difference = max |c - m|                       relative = max_difference / max |m|
///     nrmse          = sqrt(<c-m, c-m>) / (max m - min m)         [by max |m| where m is constant]
///     magnitude      = sqrt(<c, c> / <m, m>) - 1                  M of Sprague and Geers
///     phase          = (1/pi) acos(<m, c> / sqrt(<m, m> <c, c>))  P: 0 in phase, 1 in antiphase
///     combined       = sqrt(M^2 + P^2)                            C
///
/// P is taken from the two sides of the triangle instead of acos, which would not see angles below 1e-8 and
/// whose argument can pass 1 by rounding. A zero column: all numbers are 0 against another zero column,
/// against anything else `relative`, `nrmse` and M are infinite and P is 1/2 (nothing in common).
/// A value that is not finite makes max_difference NaN.
/// Source: M. A. Sprague, T. L. Geers, Commun. Numer. Methods Eng. 20 (2004) 467-483;
/// L. E. Schwer, Engineering with Computers 23 (2007) 295-309. Angle: W. Kahan, How Futile are Mindless
/// Assessments of Roundoff (2006), sec. 12.
struct Norms {
  double peak = 0.0;            // max |m|, in the column's unit
  double max_difference = 0.0;  // in the column's unit
  double relative = 0.0;        // [-]
  double nrmse = 0.0;           // [-]
  double magnitude = 0.0;       // [-]
  double phase = 0.0;           // [-]
  double combined = 0.0;        // [-]
};

/// @param floor  a column whose peak is not above it is nothing but rounding and counts as a zero column, except
///               in max_difference and peak
/// @throws std::invalid_argument if the columns differ in length or are empty
[[nodiscard]] Norms compareColumns(std::span<const double> reference, std::span<const double> other,
                                   double floor = 0.0);

}  // namespace vehicle
