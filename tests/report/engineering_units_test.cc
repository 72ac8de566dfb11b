#include "libvehicle/report/document/engineering_units.h"

#include <numbers>

#include <gtest/gtest.h>

namespace vehicle::report {
namespace {

constexpr double kDegree = 180.0 / std::numbers::pi;

TEST(ShownUnit, IsTheRailwaysWhereTheNumbersAreOfItsSize) {
  struct Case {
    const char* si;
    double largest;
    const char* shown;
    double factor;
  };
  const Case cases[] = {
      {"m", 0.012, "mm", 1e3},
      {"m", 1.0, "m", 1.0},
      {"m", 0.0, "m", 1.0},
      {"N", 1e5, "kN", 1e-3},
      {"N", 999.0, "N", 1.0},
      {"N", 2e7, "MN", 1e-6},
      {"N/m", 2.66e6, "kN/m", 1e-3},
      {"N/m", 1.2e9, "MN/m", 1e-6},
      {"N*s/m", 2e4, "kN*s/m", 1e-3},
      {"N*m", 5e3, "kN*m", 1e-3},
      {"N*m/rad", 9.4e5, "kN*m/rad", 1e-3},
      {"N*m*s/rad", 5e3, "kN*m*s/rad", 1e-3},
      {"N/m^1.5", 9.3e10, "GN/m^1.5", 1e-9},
      {"kg", 57e3, "t", 1e-3},
      {"kg", 900.0, "kg", 1.0},
      {"kg*m^2", 70e3, "t*m^2", 1e-3},
      {"rad", 0.0012, "mrad", 1e3},
      {"rad", 0.2, "deg", kDegree},
      {"rad/s", 0.01, "mrad/s", 1e3},
      {"rad/s^2", 0.5, "mrad/s^2", 1e3},
      {"rad/s^2", 2.0, "rad/s^2", 1.0},
      {"m/s", 0.05, "mm/s", 1e3},
      {"m/s", 1.5, "m/s", 1.0},
      {"m/s^2", 1e-3, "m/s^2", 1.0},
      {"s", 10.0, "s", 1.0},
      {"s", 0.0012, "ms", 1e3},
      {"s", 64e-9, "ns", 1e9},
      {"Hz", 1e4, "Hz", 1.0},
      {"", 5e3, "", 1.0},
  };
  for (const Case& each : cases) {
    const ShownUnit shown = shownUnit(each.si, each.largest);
    EXPECT_EQ(shown.name, each.shown) << each.si << " " << each.largest;
    EXPECT_EQ(shown.factor, each.factor) << each.si << " " << each.largest;
  }
}

TEST(ShownUnit, OfTravelIsKilometresAnHour) {
  EXPECT_EQ(shownUnit("m/s", 20.0, Velocity::kOfTravel).name, "km/h");
  EXPECT_EQ(shownUnit("m/s", 20.0, Velocity::kOfTravel).factor, 3.6);
  EXPECT_EQ(shownUnit("m/s", 0.5, Velocity::kOfTravel).name, "km/h");
  EXPECT_EQ(shownUnit("m/s", 0.0, Velocity::kOfTravel).name, "m/s");  // nothing is shown: SI for other programs
}

}  // namespace
}  // namespace vehicle::report
