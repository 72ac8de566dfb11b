#pragma once

#include <optional>
#include <string>
#include <utility>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/study.h"

// What studies are built from by hand.
namespace vehicle::test {

/// 10 s at 20 m/s over one harmonic of 25 m, which is called "wave".
/// @param amplitude  [m]
inline Scenario waves(std::string name = "waves", double amplitude = 5e-3) {
  Scenario made;
  made.name = std::move(name);
  made.run.speed = 20.0;
  made.run.duration = 10.0;
  made.track.emplace();
  Harmonic wave;
  wave.name = "wave";
  wave.wavelength = 25.0;
  wave.amplitude = amplitude;
  made.track->harmonics = {wave};
  return made;
}

inline Vary range(std::string parameter, std::string from, std::string to, std::optional<int> count = std::nullopt) {
  Vary made;
  made.parameter = std::move(parameter);
  made.from = std::move(from);
  made.to = std::move(to);
  made.count = count;
  return made;
}

inline Vary list(std::string parameter, std::string values) {
  Vary made;
  made.parameter = std::move(parameter);
  made.values = std::move(values);
  return made;
}

}  // namespace vehicle::test
