#pragma once

#include <array>
#include <span>

#include "libvehicle/system/input.h"

namespace vehicle {

/// One line of a one-sided spectrum: S [m^2 s] at w stands for a band of width dw/(2 pi) [Hz].
struct SpectrumLine {
  double angular_frequency = 0.0;  // [rad/s] > 0, distinct
  double density = 0.0;            // S [m^2/Hz] >= 0
  double width = 0.0;              // [Hz] >= 0
};

/// A rail whose steady state has the variance of the response to a spectrum, sum of |H|^2 S df: one harmonic of
/// amplitude sqrt(2 S df) a line, met by each wheel after its delay. Its peaks mean nothing: the phases are not random.
/// @param delay  [s] (4) by which a wheel follows the leading one
/// @throws std::invalid_argument for a line that breaks its rule
[[nodiscard]] InputSegment spectrumRail(std::span<const SpectrumLine> lines, const std::array<double, 4>& delay);

}  // namespace vehicle
