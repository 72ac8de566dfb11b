#pragma once

#include <string>

namespace vehicle::report {

/// A unit for people, and what a number in SI is multiplied with to stand in it.
struct ShownUnit {
  std::string name;
  double factor = 1.0;
};

/// What a number in m/s is: of the vehicle along the track it stands in km/h, of a part in mm/s or m/s.
enum class Velocity {
  kOfMotion,
  kOfTravel
};

/// The one place that decides in which unit people read a number; csv and json hold SI.
///
///     m  below 1 mm            rad below 0.1 mrad, else deg      N, N/m, N*s/m, N*m ... from 1e3 kN ..., from 1e7 MN ...
///     kg, kg*m^2 from 1e3 t    s   below 0.1 ms, us, ns           m/s below 1 mm/s; of travel always km/h
///
/// All other units, and all of numbers that are zero, stay as they are.
/// @param si       an SI unit as channels have it: "m", "N/m", ...
/// @param largest  [si] the largest magnitude that is to be shown, >= 0
[[nodiscard]] ShownUnit shownUnit(const std::string& si, double largest, Velocity velocity = Velocity::kOfMotion);

}  // namespace vehicle::report
