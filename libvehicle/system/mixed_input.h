#pragma once

#include <span>

#include "libvehicle/system/input.h"

namespace vehicle {

/// Linear combinations of an input's channels as an input of its own:
///
///     mixed_i(t) = sum_j weights(i,j) eta_j(t)
///
/// Sums of harmonics and cubics are harmonics and cubics, so the result has the same segments and frequencies, closed
/// forms, breakpoints and one-sided limits. Its coefficients differ from exact sums by rounding, |error| <= w 2^-53
/// sum_j |weights(i,j) coefficient_j|; a row of one weight 1 gives that channel's bits.
/// @param weights  (channels of the result x channels of `input`), row-major
/// @throws std::invalid_argument unless weights are finite and whole rows, at least one
[[nodiscard]] Input mixedInput(const Input& input, std::span<const double> weights);

}  // namespace vehicle
