#pragma once

#include <string>

namespace vehicle::cli {

/// A unit for eyes, and what a number in SI is multiplied with to stand in it.
struct ShownUnit {
  std::string name;
  double factor = 1.0;
};

/// Millimetres for lengths below a metre; kN, kN/m, kN*s/m, t, t*m^2 from a thousand of the SI unit on; else SI.
/// @param si       an SI unit as channels have it: "m", "N/m", ...
/// @param largest  [si] the largest magnitude that is to be shown, >= 0
[[nodiscard]] ShownUnit shownUnit(const std::string& si, double largest);

}  // namespace vehicle::cli
