#include "libvehicle/report/document/engineering_units.h"

#include <numbers>
#include <string_view>

namespace vehicle::report {
namespace {

struct Step {
  std::string_view si;
  double from;  // [si] the smallest magnitude that has this unit, unless a later line of the same si has it too
  std::string_view shown;
  double factor;
};

constexpr double kAny = 0.0;
constexpr double kDegree = 180.0 / std::numbers::pi;
constexpr double kThousand = 1e3;
constexpr double kKilo = 1e-3;
constexpr double kMega = 1e-6;
constexpr double kFromMega = 1e7;  // 9999 kN/m stands in four digits

constexpr Step kSteps[] = {
    {"m", kAny, "mm", kThousand},
    {"m", 1.0, "m", 1.0},
    {"rad", kAny, "mrad", kThousand},
    {"rad", 0.1, "deg", kDegree},
    {"rad/s", kAny, "mrad/s", kThousand},
    {"rad/s", 1.0, "rad/s", 1.0},
    {"rad/s^2", kAny, "mrad/s^2", kThousand},
    {"rad/s^2", 1.0, "rad/s^2", 1.0},
    {"m/s", kAny, "mm/s", kThousand},
    {"m/s", 1.0, "m/s", 1.0},
    {"s", kAny, "ns", 1e9},
    {"s", 1e-6, "us", 1e6},
    {"s", 1e-3, "ms", kThousand},
    {"s", 0.1, "s", 1.0},
    {"N", kThousand, "kN", kKilo},
    {"N", kFromMega, "MN", kMega},
    {"N/m", kThousand, "kN/m", kKilo},
    {"N/m", kFromMega, "MN/m", kMega},
    {"N*s/m", kThousand, "kN*s/m", kKilo},
    {"N*s/m", kFromMega, "MN*s/m", kMega},
    {"N*m", kThousand, "kN*m", kKilo},
    {"N*m", kFromMega, "MN*m", kMega},
    {"N*m/rad", kThousand, "kN*m/rad", kKilo},
    {"N*m/rad", kFromMega, "MN*m/rad", kMega},
    {"N*m*s/rad", kThousand, "kN*m*s/rad", kKilo},
    {"N*m*s/rad", kFromMega, "MN*m*s/rad", kMega},
    {"N/m^1.5", kFromMega, "GN/m^1.5", 1e-9},
    {"kg", kThousand, "t", kKilo},
    {"kg*m^2", kThousand, "t*m^2", kKilo},
};

}  // namespace

ShownUnit shownUnit(const std::string& si, double largest, Velocity velocity) {
  if (si == "m/s" && velocity == Velocity::kOfTravel && largest > 0.0) return {"km/h", 3.6};
  ShownUnit shown{si, 1.0};
  for (const Step& each : kSteps) {
    if (each.si == si && largest > 0.0 && largest >= each.from) shown = {std::string(each.shown), each.factor};
  }
  return shown;
}

}  // namespace vehicle::report
