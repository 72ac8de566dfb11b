#include "libvehicle/result/time_history.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

TimeHistory twoSamples() {
  TimeHistory history({{"carbody.z", "m"}, {"carbody.pitch", "rad"}});
  history.reserve(2);
  for (const double t : {0.0, 0.005}) {
    const std::span<double> row = history.append(t);
    row[1] = 1.0 + t;
    row[2] = -2.0 * t;
  }
  return history;
}

TEST(TimeHistory, FirstColumnIsTime) {
  const TimeHistory history = twoSamples();
  ASSERT_EQ(history.columns().size(), 3u);
  EXPECT_EQ(history.columns()[0], (Channel{"time", "s"}));
  EXPECT_EQ(history.columns()[2], (Channel{"carbody.pitch", "rad"}));
  EXPECT_EQ(history.samples(), 2u);
  EXPECT_EQ(history.column("time"), (std::vector<double>{0.0, 0.005}));
}

TEST(TimeHistory, RowsColumnsAndSingleValuesAreTheSameTable) {
  const TimeHistory history = twoSamples();
  EXPECT_EQ(history.column("carbody.z"), (std::vector<double>{1.0, 1.005}));
  EXPECT_EQ(history.column(2), (std::vector<double>{-0.0, -0.01}));
  EXPECT_EQ(history.at(1, 2), -0.01);
  EXPECT_EQ(history.row(1)[1], 1.005);
  EXPECT_EQ(history.row(1).size(), 3u);
}

TEST(TimeHistory, NewRowStartsAtZero) {
  TimeHistory history(std::vector<Channel>{{"carbody.z", "m"}});
  EXPECT_EQ(history.append(0.3)[1], 0.0);
}

TEST(TimeHistory, WrongColumnNameIsAnsweredWithTheNearestOne) {
  const TimeHistory history = twoSamples();
  EXPECT_EQ(history.indexOf("carbody.pitch"), 2u);
  try {
    (void)history.column("carbody.pich");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "TimeHistory: no column \"carbody.pich\" among 3; did you mean \"carbody.pitch\"?");
  }
  try {
    (void)history.indexOf("x");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "TimeHistory: no column \"x\" among 3");
  }
}

TEST(TimeHistory, RefusesTwoColumnsOfOneName) {
  EXPECT_THROW(TimeHistory(std::vector<Channel>(2, Channel{"carbody.z", "m"})), std::invalid_argument);
  EXPECT_THROW(TimeHistory(std::vector<Channel>{{"time", "s"}}), std::invalid_argument);
}

TEST(TimeHistory, WithoutColumnsHasNoSamplesAndTakesNone) {
  TimeHistory history;
  EXPECT_EQ(history.samples(), 0u);
  EXPECT_THROW(history.append(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
