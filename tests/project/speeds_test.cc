#include "libvehicle/project/speeds.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

std::string refusalOf(const std::string& text) {
  try {
    static_cast<void>(parseSpeeds(text));
  } catch (const std::invalid_argument& wrong) {
    return wrong.what();
  }
  return {};
}

TEST(Speeds, OfAListAndARangeStandInTheOrderGiven) {
  const std::vector<double> speeds = parseSpeeds("20 m/s, 90:9:108 km/h");
  ASSERT_EQ(speeds.size(), 4u);
  EXPECT_EQ(speeds[0], 20.0);
  EXPECT_EQ(speeds[1], 25.0);
  EXPECT_EQ(speeds[2], 27.5);
  EXPECT_EQ(speeds[3], 30.0);
}

TEST(Speeds, ThatAreWrongAreRefusedWithTextRuleAndRemedyAndNoOption) {
  for (const char* wrong :
       {"", "3", "80,,90", "80:0:160 km/h", "90:1:80 km/h", "80:1:90", "-3 m/s", "72 km/h, 20 m/s"}) {
    const std::string refusal = refusalOf(wrong);
    EXPECT_EQ(refusal.rfind('"', 0), 0u) << wrong << ": " << refusal;
    EXPECT_NE(refusal.find("; "), std::string::npos) << wrong << ": " << refusal;
    EXPECT_EQ(refusal.find("--speed"), std::string::npos) << wrong << ": " << refusal;
  }
}

TEST(Speeds, NameTheFilesOfTheirRuns) {
  EXPECT_EQ(fileAtSpeed("out/run.h5", 25.0), "out/run-90kmh.h5");
  EXPECT_EQ(filesAtSpeed({"a.csv", "b.h5"}, 20.0), (std::vector<std::string>{"a-72kmh.csv", "b-72kmh.h5"}));
  EXPECT_EQ(speedText(25.0), "90 km/h");
}

}  // namespace
}  // namespace vehicle
