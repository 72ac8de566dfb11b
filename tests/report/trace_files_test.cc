#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "libvehicle/report/trace/chrome_trace.h"
#include "libvehicle/report/trace/timeline.h"

namespace vehicle::report {
namespace {

using Kind = Span::Kind;
using Json = nlohmann::json;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Two threads, two steps: 0 of 10 us, 16 of 4 us.
Trace sample() {
  return {.threads = 2,
          .every = 16,
          .spans = {{0, 0, Kind::kCompute, 1e-6, 3e-6, -1},
                    {0, 0, Kind::kWait, 3e-6, 9e-6, 1},
                    {0, 0, Kind::kCompute, 9e-6, 11e-6, -1},
                    {0, 16, Kind::kCompute, 20e-6, 24e-6, -1},
                    {1, 0, Kind::kCompute, 1e-6, 8.5e-6, -1}}};
}

TEST(ChromeTrace, HoldsEverySpanInMicrosecondsOnTheTrackOfItsThread) {
  const Json read = Json::parse(chromeTraceOf(sample(), "coach \"<1>\""));
  ASSERT_EQ(read["traceEvents"].size(), 3u + 5u);  // the names of program and threads, the spans
  EXPECT_EQ(read["traceEvents"][0]["args"]["name"], "coach \"<1>\"");
  EXPECT_EQ(read["traceEvents"][2]["args"]["name"], "thread 2");
  const Json& wait = read["traceEvents"][4];
  EXPECT_EQ(wait["name"], "wait for thread 2");
  EXPECT_EQ(wait["ph"], "X");
  EXPECT_EQ(wait["tid"], 1);
  // One product of doubles each.
  EXPECT_NEAR(wait["ts"].get<double>(), 3.0, 1e-12);
  EXPECT_NEAR(wait["dur"].get<double>(), 6.0, 1e-12);
}

TEST(ChromeTrace, OfNothingIsStillJson) { EXPECT_EQ(Json::parse(chromeTraceOf({}, ""))["traceEvents"].size(), 1u); }

TEST(Timeline, ShowsTheLongestStepWithItsLanesWaitsAndAxis) {
  const std::string svg = timelineOf(sample(), "coach: rk4 by stages & more");
  EXPECT_EQ(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\"", 0), 0u);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  for (const char* part : {"coach: rk4 by stages &amp; more", "the longest traced step: step 0, 10 us",
                           "thread 1</text>", "thread 2</text>", "for 2</text>", "time since the step began [us]",
                           "computing</text>", "thread 1, step 0: waits for thread 2, 6.000 us"}) {
    EXPECT_TRUE(has(svg, part)) << part;
  }
}

TEST(Timeline, OfATraceWithoutStepsSaysSo) { EXPECT_TRUE(has(timelineOf({}, "coach"), "no step was traced")); }

}  // namespace
}  // namespace vehicle::report
