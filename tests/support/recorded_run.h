#pragma once

#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/partition/run.h"

namespace vehicle::test {

/// All that an observer was told in a run, and how the run ended.
struct RecordedRun {
  std::vector<int> samples;
  std::vector<int> segments;
  std::vector<double> values;  // t, then the state, sample by sample
  Statistics statistics;
  std::string failure;  // what a run that cannot go on said
};

/// @param run   run(observer) -> Statistics
/// @param last  the observer ends the run at this sample; -1: never
inline RecordedRun record(const std::function<Statistics(const Observer&)>& run, int last = -1) {
  RecordedRun seen;
  const Observer observe = [&](int sample, int segment, double t, std::span<const double> x) {
    seen.samples.push_back(sample);
    seen.segments.push_back(segment);
    seen.values.push_back(t);
    seen.values.insert(seen.values.end(), x.begin(), x.end());
    return sample != last;
  };
  try {
    seen.statistics = run(observe);
  } catch (const std::runtime_error& failure) {
    seen.failure = failure.what();
  }
  return seen;
}

/// Every bit that the observer saw, and every number of the statistics.
inline void expectSameBits(const RecordedRun& actual, const RecordedRun& expected) {
  EXPECT_EQ(actual.samples, expected.samples);
  EXPECT_EQ(actual.segments, expected.segments);
  ASSERT_EQ(actual.values.size(), expected.values.size());
  EXPECT_EQ(std::memcmp(actual.values.data(), expected.values.data(), actual.values.size() * sizeof(double)), 0);
  EXPECT_EQ(actual.failure, expected.failure);
  EXPECT_EQ(actual.statistics.steps, expected.statistics.steps);
  EXPECT_EQ(actual.statistics.evaluations, expected.statistics.evaluations);
  EXPECT_EQ(actual.statistics.rejected, expected.statistics.rejected);
  EXPECT_EQ(actual.statistics.stopped, expected.statistics.stopped);
}

}  // namespace vehicle::test
