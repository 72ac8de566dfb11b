#pragma once

#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/linear/motion_rates.h"
#include "libvehicle/model/compiled_model.h"

namespace vehicle {

inline constexpr double kMostRestDeflection = 0.5;  // [m]: the softest air springs come down by half of it
inline constexpr double kMostLoadError = 5e-3;      // of the weight: data sheets round to three digits

/// What is doubtful of a vehicle before it moves:
///     CANNOT_STAND     the stiffness about the loaded rest position, heights under static loads included, is negative in
///                      some motion (that of M^-1/2 K M^-1/2 with the lowest eigenvalue is named)
///     FREE_MODE        it is zero in some motion: there is no rest position
///     GIVEN_LOADS      wheel loads of the file miss the weight of what they carry by more than 0.5 %
///     REST_DEFLECTION  a spring comes down by more than 0.5 m
/// Each place of a file once: what holds of one of equal vehicles of a train holds of all.
/// Cost: an eigenvalue problem for each vehicle of a train.
[[nodiscard]] Warnings restWarnings(const CompiledModel& model);

/// What is doubtful of the motions of a linear form:
///     UNSTABLE_MODE    one grows by itself; left out where the vehicle cannot stand, which says more
///     ILL_CONDITIONED  the fastest is so far from the slowest that rounding reaches a millionth of a result
[[nodiscard]] Warnings motionWarnings(const MotionRates& rates, bool can_stand);

}  // namespace vehicle
