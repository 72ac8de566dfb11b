#pragma once

#include <Eigen/Core>

#include "libvehicle/system/input.h"
#include "libvehicle/system/system.h"

namespace vehicle {

/// Complex amplitude of every state in the steady state under one harmonic of a segment:
///
///     x(t) = Re[ X e^(i w s) ],   X = (i w - A)^-1 B (Y, i w Y),   Y = cosine - i sine,   s = t - segment.begin
///
/// @param frequency  index f of the segment's frequencies
/// @return X (n)
/// @throws std::invalid_argument if w is the frequency of an undamped mode (no steady state: the answer grows), and
///         for an index that does not exist
[[nodiscard]] Eigen::VectorXcd steadyAmplitude(const StateSpace& system, const InputSegment& segment, int frequency);

/// State at time t of the one motion that repeats itself under the constant and the harmonics of a segment, as if
/// the segment had lasted for ever.
/// @param t  [s]
/// @return x (n)
/// @throws std::invalid_argument if the segment has linear or higher polynomial terms (nothing repeats itself), if a
///         harmonic meets an undamped mode, or if a constant height meets a motion without stiffness
[[nodiscard]] Eigen::VectorXd steadyState(const StateSpace& system, const InputSegment& segment, double t);

}  // namespace vehicle
