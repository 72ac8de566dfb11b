#include "apps/cli/study_units.h"

#include <gtest/gtest.h>

namespace vehicle::cli {
namespace {

TEST(ShownUnit, IsTheRailwaysWhereTheNumbersAreOfItsSize) {
  struct Case {
    const char* si;
    double largest;
    const char* shown;
    double factor;
  };
  const Case cases[] = {{"m", 0.012, "mm", 1e3},      {"m", 1.0, "m", 1.0},          {"m", 0.0, "m", 1.0},
                        {"N", 1e5, "kN", 1e-3},       {"N", 999.0, "N", 1.0},        {"N/m", 1e6, "kN/m", 1e-3},
                        {"N*s/m", 2e4, "kN*s/m", 1e-3}, {"kg", 57e3, "t", 1e-3},     {"kg*m^2", 70e3, "t*m^2", 1e-3},
                        {"m/s^2", 1e4, "m/s^2", 1.0}, {"rad", 0.01, "rad", 1.0},     {"", 5e3, "", 1.0}};
  for (const Case& each : cases) {
    const ShownUnit shown = shownUnit(each.si, each.largest);
    EXPECT_EQ(shown.name, each.shown) << each.si << " " << each.largest;
    EXPECT_EQ(shown.factor, each.factor) << each.si << " " << each.largest;
  }
}

}  // namespace
}  // namespace vehicle::cli
