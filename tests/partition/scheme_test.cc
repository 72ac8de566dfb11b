#include "libvehicle/partition/scheme.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

TEST(Scheme, NamesLeadBackToTheirScheme) {
  for (const std::string& name : schemeNames()) EXPECT_EQ(nameOf(schemeOf(name)), name);
  EXPECT_EQ(schemeOf("split"), Scheme::kSplit);
  for (const std::string& name : equationMapNames()) EXPECT_EQ(nameOf(equationMapOf(name)), name);
  EXPECT_EQ(equationMapOf("auto"), EquationMap::kAuto);
}

TEST(Scheme, AnUnknownNameIsRefusedWithThoseThatExist) {
  try {
    (void)schemeOf("ring");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "unknown scheme \"ring\"; must be serial | stages | halo | pipeline | split");
  }
}

}  // namespace
}  // namespace vehicle
