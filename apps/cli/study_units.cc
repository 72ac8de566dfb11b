#include "apps/cli/study_units.h"

#include <array>
#include <string_view>
#include <utility>

namespace vehicle::cli {

ShownUnit shownUnit(const std::string& si, double largest) {
  constexpr double kThousand = 1000.0;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kThousands = {
      {{"N", "kN"}, {"N/m", "kN/m"}, {"N*s/m", "kN*s/m"}, {"kg", "t"}, {"kg*m^2", "t*m^2"}}};
  if (si == "m" && largest > 0.0 && largest < 1.0) return {"mm", kThousand};
  for (const auto& [unit, thousand] : kThousands) {
    if (si == unit && largest >= kThousand) return {std::string(thousand), 1.0 / kThousand};
  }
  return {si, 1.0};
}

}  // namespace vehicle::cli
