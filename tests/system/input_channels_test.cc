#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/system/input.h"

namespace vehicle {
namespace {

// A rail of that many sinusoids with random mixtures under every wheel, with and without a polynomial.
InputSegment randomPiece(int channels, int frequencies, double begin, double end, bool polynomial, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-5e-3, 5e-3);
  InputSegment piece;
  piece.begin = begin;
  piece.end = end;
  for (int f = 0; f < frequencies; ++f) piece.angular_frequency.push_back(1.3 + 2.7 * f);
  for (int j = 0; j < channels * frequencies; ++j) {
    piece.cosine.push_back(value(random));
    piece.sine.push_back(value(random));
  }
  for (int j = 0; j < channels * InputSegment::kPolynomial; ++j) {
    piece.polynomial.push_back(polynomial ? value(random) : 0.0);
  }
  return piece;
}

// Every channel is a sum of its own in a sweep, so who computes it with which others changes nothing: exact.
TEST(InputChannels, EveryRangeOfChannelsGivesTheBitsOfTheSweep) {
  constexpr int kCount = 2 * Input::kBlock + 1;  // the last block has one sample
  PhasorTable clock;                             // used again by every case: what is left in it must not matter
  for (const int channels : {1, 4, 7, 12}) {
    for (const int frequencies : {0, 1, 2, 3, 4, 5}) {
      for (const bool polynomial : {false, true}) {
        const Input input(channels, {randomPiece(channels, frequencies, 0.3, 1.0, false, 7),
                                     randomPiece(channels, frequencies, 1.0, 9.0, polynomial, 3)});
        const auto width = static_cast<std::size_t>(2 * channels);
        std::vector<double> swept(kCount * width);
        input.sweep(1, 1.1, 1.7e-3, 3 * Input::kBlock, kCount, swept);
        input.prepare(1, 1.1, 1.7e-3, 3 * Input::kBlock, kCount, clock);
        for (int from = 0; from < channels; from += 3) {
          const int to = std::min(from + 5, channels);
          const auto count = static_cast<std::size_t>(to - from);
          std::vector<double> part(2 * count);
          for (int sample = 0; sample < kCount; ++sample) {
            input.readRow(clock, sample, from, to, part.data());
            const double* row = swept.data() + static_cast<std::size_t>(sample) * width;
            for (std::size_t k = 0; k < count; ++k) {
              ASSERT_EQ(part[k], row[static_cast<std::size_t>(from) + k]) << channels << " channels, sample " << sample;
              ASSERT_EQ(part[count + k], row[static_cast<std::size_t>(channels + from) + k]) << "sample " << sample;
            }
          }
        }
      }
    }
  }
}

TEST(InputChannels, ARangeWithoutChannelsWritesNothing) {
  const Input input(3, {randomPiece(3, 2, 0.0, 1.0, true, 1)});
  PhasorTable clock;
  input.prepare(0, 0.0, 1e-3, 0, 1, clock);
  double untouched = 17.0;
  input.readRow(clock, 0, 2, 2, &untouched);
  EXPECT_EQ(untouched, 17.0);
  input.prepare(0, 0.0, 1e-3, 0, 0, clock);
  EXPECT_EQ(clock.count, 0);
}

TEST(InputChannels, TheClockStartsWhereASweepMay) {
  const Input input(1, {randomPiece(1, 1, 0.0, 1.0, false, 1)});
  PhasorTable clock;
  EXPECT_THROW(input.prepare(0, 0.0, 1e-3, 5, 1, clock), std::invalid_argument);
  EXPECT_THROW(input.prepare(0, 0.0, 1e-3, -Input::kBlock, 1, clock), std::invalid_argument);
  EXPECT_THROW(input.prepare(0, 0.0, 1e-3, 0, -1, clock), std::invalid_argument);
}

TEST(InputChannels, InAnotherOrderTheyCarryTheirValuesAlong) {
  const std::vector<int> order = {2, 0, 4, 1, 3};
  const Input input(5, {randomPiece(5, 3, 0.0, 1.0, true, 5), randomPiece(5, 1, 1.0, 2.5, false, 6)});
  const Input reordered = input.inOrder(order);
  ASSERT_EQ(reordered.segments(), 2);
  std::vector<double> before(15), after(15);
  for (const int segment : {0, 1}) {
    EXPECT_EQ(reordered.segment(segment).begin, input.segment(segment).begin);
    EXPECT_EQ(reordered.segment(segment).end, input.segment(segment).end);
    for (int i = 0; i < 20; ++i) {
      const double t = segment + 0.05 * i;
      input.evaluate(segment, t, before);
      reordered.evaluate(segment, t, after);
      for (std::size_t kind = 0; kind < 15; kind += 5) {  // heights, rates, accelerations
        for (std::size_t j = 0; j < 5; ++j) {
          ASSERT_EQ(after[kind + j], before[kind + static_cast<std::size_t>(order[j])]) << "t = " << t;
        }
      }
    }
  }
}

TEST(InputChannels, AnOrderNamesEveryChannelOnce) {
  const Input input(3, {randomPiece(3, 1, 0.0, 1.0, false, 1)});
  for (const std::vector<int>& wrong : std::vector<std::vector<int>>{{}, {0, 1}, {0, 1, 1}, {0, 1, 3}, {-1, 0, 1}}) {
    EXPECT_THROW((void)input.inOrder(wrong), std::invalid_argument);
  }
  try {
    (void)input.inOrder(std::vector<int>{0, 1});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Input: an order of 2 channels, must name each of 3 once");
  }
}

}  // namespace
}  // namespace vehicle
