// The rail under very many wheelsets: what fits is made, what would fill the memory is refused first.
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/excitation/excitation.h"
#include "tests/excitation/topologies.h"
#include "tests/support/tracks.h"

namespace vehicle {
namespace {

using test::wheelsets;

TEST(LongTrain, RunsOverAnExtendedRailInOnePiece) {
  const Input input = inputOf(test::paperScenario(History::kExtended), wheelsets(16384), 20.0);
  EXPECT_EQ(input.channels(), 16384);
  EXPECT_EQ(input.segments(), 1);
}

TEST(LongTrain, MeetsAnOnsetWheelByWheel) {
  Scenario scenario = test::paperScenario(History::kOnset);
  const Input input = inputOf(scenario, wheelsets(24), 20.0);
  EXPECT_EQ(input.segments(), 24);  // the first wheel meets it at t = 0, the last after 7.5 s
}

// 3000 wheelsets in 1000 s at 20 m/s: all of them meet the onset, 3000 pieces x 3000 wheelsets x 24 numbers of 8 bytes.
TEST(LongTrain, IsRefusedWhereItsBreakpointsWouldFillTheMemory) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.run.duration = 1000.0;
  scenario.track->origin.file = "track.xml";
  scenario.track->origin.line = 3;
  const auto refusal = [&] {
    try {
      (void)inputOf(scenario, wheelsets(3000), 20.0);
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal(),
            "track.xml:3: error: <scenario><track>: 3000 wheelsets pass the discontinuities of the rail at different "
            "times: 3000 segments of input would take 1.61 GiB; must be at most 1 GiB; take history=\"extended\", or a "
            "shorter train or run\n");
  scenario.track->history = History::kExtended;
  scenario.track->dips = {test::dip(DipShape::kHalfSine, 5e-3, 3.0, 40.0)};
  EXPECT_EQ(refusal(),
            "track.xml:3: error: <scenario><track>: 3000 wheelsets pass the discontinuities of the rail at different "
            "times: 6001 segments of input would take 4.02 GiB; must be at most 1 GiB; take a shorter train or run, or "
            "fewer dips, bumps and ramps\n");
}

}  // namespace
}  // namespace vehicle
