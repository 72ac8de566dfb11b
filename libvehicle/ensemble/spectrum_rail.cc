#include "libvehicle/ensemble/spectrum_rail.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace vehicle {

InputSegment spectrumRail(std::span<const SpectrumLine> lines, const std::array<double, 4>& delay) {
  InputSegment rail;
  rail.end = 1.0;
  rail.polynomial.assign(16, 0.0);
  rail.cosine.resize(4 * lines.size());
  rail.sine.resize(4 * lines.size());
  for (std::size_t f = 0; f < lines.size(); ++f) {
    const SpectrumLine& line = lines[f];
    const double amplitude = std::sqrt(2.0 * line.density * line.width);
    if (!(line.angular_frequency > 0.0) || !(line.density >= 0.0) || !(line.width >= 0.0) ||
        !std::isfinite(line.angular_frequency) || !std::isfinite(amplitude)) {
      throw std::invalid_argument(
          "spectrumRail: line " + std::to_string(f) + ": w = " + std::to_string(line.angular_frequency) +
          " rad/s, S = " + std::to_string(line.density) + " m^2/Hz, width = " + std::to_string(line.width) +
          " Hz, must be finite, w > 0, S >= 0, width >= 0");
    }
    rail.angular_frequency.push_back(line.angular_frequency);
    for (std::size_t j = 0; j < 4; ++j) {
      // cos(w (t - delay))
      rail.cosine[j * lines.size() + f] = amplitude * std::cos(line.angular_frequency * delay[j]);
      rail.sine[j * lines.size() + f] = amplitude * std::sin(line.angular_frequency * delay[j]);
    }
  }
  return rail;
}

}  // namespace vehicle
