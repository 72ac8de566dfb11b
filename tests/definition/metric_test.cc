#include "libvehicle/definition/metric.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vehicle {
namespace {

Metric metric(const std::string& text) {
  const ParsedMetric parsed = parseMetric(text);
  EXPECT_TRUE(parsed.metric.has_value()) << text << ' ' << parsed.message;
  return parsed.metric.value_or(Metric{});
}

std::string refusal(const std::string& text) {
  const ParsedMetric parsed = parseMetric(text);
  EXPECT_FALSE(parsed.metric.has_value()) << text;
  return parsed.message + "; " + parsed.remedy;
}

TEST(ParseMetric, TheLastWordIsTheStatisticOfAColumn) {
  const std::vector<std::pair<std::string, Statistic>> words = {{"rms", Statistic::kRms},
                                                                {"mean", Statistic::kMean},
                                                                {"peak", Statistic::kPeak},
                                                                {"min", Statistic::kMin},
                                                                {"max", Statistic::kMax}};
  for (const auto& [word, statistic] : words) {
    const Metric read = metric(" front.carbody.az." + word + ' ');
    EXPECT_EQ(read.name, "front.carbody.az." + word);
    EXPECT_EQ(read.kind, MetricKind::kColumn);
    EXPECT_EQ(read.subject, "front.carbody.az");
    EXPECT_EQ(read.statistic, statistic);
    EXPECT_EQ(unitOf(read, "m/s^2"), "m/s^2");
  }
}

TEST(ParseMetric, PercentilesAreOfXOrOfItsMagnitude) {
  const Metric signed_one = metric("carbody.az.p99.85");
  EXPECT_EQ(signed_one.subject, "carbody.az");
  EXPECT_EQ(signed_one.statistic, Statistic::kPercentile);
  EXPECT_EQ(signed_one.percent, 99.85);
  EXPECT_EQ(metric("carbody.az.abs_p95").statistic, Statistic::kAbsolutePercentile);
  EXPECT_EQ(metric("carbody.az.abs_p95").percent, 95.0);
  // A part may be called p5: its column has a statistic of its own behind it.
  EXPECT_EQ(metric("p5.az.rms").subject, "p5.az");
  EXPECT_EQ(refusal("carbody.az.p100"),
            "asks for a percentile outside 0 to 100; write e.g. .p99.85; the ends are .min and .max");
  EXPECT_EQ(refusal("carbody.az.p0").substr(0, 18), "asks for a percent");
}

TEST(ParseMetric, ABandHasTwoFrequenciesAndOneUnitServesBoth) {
  for (const char* text :
       {"carbody.az.band(0.5..20 Hz)", "carbody.az.band( 0.5 Hz .. 20 Hz )", "carbody.az.band(500 mHz..20Hz)"}) {
    const Metric read = metric(text);
    EXPECT_EQ(read.subject, "carbody.az");
    EXPECT_EQ(read.statistic, Statistic::kBand);
    EXPECT_EQ(read.low, 0.5);
    EXPECT_EQ(read.high, 20.0);
  }
  constexpr const char* kExample = "; a band has two frequencies, e.g. carbody.az.band(4..8 Hz)";
  EXPECT_EQ(refusal("carbody.az.band(4 Hz)"), std::string("has a band without \"..\"") + kExample);
  EXPECT_EQ(refusal("carbody.az.band(4..8)"), std::string("has a band up to \"8\", which has no unit") + kExample);
  EXPECT_EQ(refusal("carbody.az.band(four..8 Hz)"),
            std::string("has a band from \"four\", which is not a number") + kExample);
  EXPECT_EQ(refusal("carbody.az.band(8..4 Hz)"),
            "has a band from 8 Hz to 4 Hz; a band goes from the lower to the higher, from 0 Hz on");
}

TEST(ParseMetric, ModesAndRestAreAskedByName) {
  const Metric mode = metric("mode.carbody + front_bogie bounce in phase.frequency");
  EXPECT_EQ(mode.kind, MetricKind::kMode);
  EXPECT_EQ(mode.subject, "carbody + front_bogie bounce in phase");
  EXPECT_EQ(unitOf(mode, ""), "Hz");
  for (const char* each : {"frequency", "damped_frequency", "undamped_frequency", "damping"}) {
    const Metric of_mode = metric(std::string("mode.carbody pitch.").append(each));
    EXPECT_EQ(of_mode.subject, "carbody pitch");
    EXPECT_EQ(of_mode.quantity, each);
    EXPECT_EQ(unitOf(of_mode, ""), std::string(each) == "damping" ? "" : "Hz");
  }
  const Metric rest = metric("static.secondary_front.deflection");
  EXPECT_EQ(rest.kind, MetricKind::kStatic);
  EXPECT_EQ(rest.subject, "secondary_front");
  EXPECT_EQ(unitOf(rest, ""), "m");
  EXPECT_EQ(unitOf(metric("static.wheelset_1.load"), ""), "N");
  // Parts called so keep their columns.
  EXPECT_EQ(metric("static.az.rms").kind, MetricKind::kColumn);
  EXPECT_EQ(metric("mode.z.peak").subject, "mode.z");
}

TEST(ParseMetric, WhatIsNoMetricIsToldWithTheNearestWord) {
  EXPECT_EQ(refusal("carbody.az.rmss"), "ends in \"rmss\", which is no statistic; did you mean \"rms\"?");
  EXPECT_EQ(refusal("mode.carbody pitch.freqency"),
            "ends in \"freqency\", which is no statistic; did you mean \"frequency\"?");
  EXPECT_EQ(refusal("static.wheelset_1.loads"), "ends in \"loads\", which is no statistic; did you mean \"load\"?");
  for (const char* text : {"", "rms", ".rms", "carbody.az", "carbody.az.median", "mode..frequency", "static.load", ".",
                           "()", ".band()", ".p5", "x.band(..Hz)", "x.band(", "x.band()"}) {
    EXPECT_NE(refusal(text), "; ") << text;
  }
}

}  // namespace
}  // namespace vehicle
