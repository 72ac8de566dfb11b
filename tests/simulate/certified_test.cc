// The exact method against the certified 40-digit solution of the paper's vehicle (tests/paper/data).

#include <gtest/gtest.h>

#include "tests/simulate/histories.h"
#include "tests/support/source_tree.h"
#include "tests/support/table.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

// Our column, the certified one, and what must be added to ours (wheel loads carry Q0).
struct Pairing {
  const char* ours;
  const char* certified;
};

constexpr Pairing kPairings[] = {
    {"carbody.z", "zk"},          {"carbody.pitch", "phik"},       {"front_bogie.z", "z1"},
    {"rear_bogie.z", "z2"},       {"carbody.vz", "dzk"},           {"carbody.pitch_rate", "dphik"},
    {"front_bogie.vz", "dz1"},    {"rear_bogie.vz", "dz2"},        {"carbody.az", "ddzk"},
    {"carbody.pitch_acc", "ddphik"}, {"front_bogie.az", "ddz1"},   {"rear_bogie.az", "ddz2"},
    {"secondary_front.force", "Fs1"}, {"secondary_rear.force", "Fs2"}, {"primary_1.force", "Fp1"},
    {"primary_2.force", "Fp2"},   {"primary_3.force", "Fp3"},      {"primary_4.force", "Fp4"},
    {"wheelset_1.rail_z", "eta1"}, {"wheelset_2.rail_z", "eta2"},  {"wheelset_3.rail_z", "eta3"},
    {"wheelset_4.rail_z", "eta4"},
};

void expectCertified(const std::string& form, const std::string& method, History history, const std::string& file,
                     double tolerance) {
  const auto certified = readTable(sourcePath("tests/paper/data/") + file);
  const RunResult result = run(paperVehicle(), paperScenario(history), form, method);
  ASSERT_EQ(result.history.samples(), certified.at("t").size());
  for (const Pairing& pairing : kPairings) {
    const double error = columnError(result.history.column(pairing.ours), certified.at(pairing.certified));
    EXPECT_WITHIN(error, 0.0, tolerance) << pairing.ours << " of " << form << " with " << method;
  }
}

// Rounding only: 2000 propagations of 8 states at 1e-16 each, forces as differences of displacements ten times
// their size. The next error, a wrong unit of anything, is at 1e-3.
constexpr double kExact = 1e-12;

TEST(Exact, EqualsTheCertifiedSolutionOnOnset) {
  for (const char* form : {"flat", "matrix", "mbs-linear"}) {
    expectCertified(form, "exact", History::kOnset, "ref_consistent_J70t_onset.csv", kExact);
  }
}

TEST(Exact, EqualsTheCertifiedSolutionOnExtended) {
  for (const char* form : {"flat", "matrix", "mbs-linear"}) {
    expectCertified(form, "exact", History::kExtended, "ref_consistent_J70t_extended.csv", kExact);
  }
}

// Fourth order at |lambda| h = 0.04: about 1e-8 in displacements; forces and accelerations a little more. A step
// across a breakpoint would show as 1e-3.
TEST(Rk4, AtOneMillisecondIsBelowOneTenMillionthOfPeakOnOnset) {
  expectCertified("flat", "rk4", History::kOnset, "ref_consistent_J70t_onset.csv", 1e-7);
}

// rtol 1e-10 a step, some hundred steps deep memory: two decades above.
TEST(Dopri5, AtTightToleranceIsBelowOneHundredMillionthOfPeak) {
  expectCertified("flat", "dopri5", History::kOnset, "ref_consistent_J70t_onset.csv", 1e-8);
  expectCertified("flat", "dopri5", History::kExtended, "ref_consistent_J70t_extended.csv", 1e-8);
}

// After the transients have gone (exp(-0.88 * 60) = 1e-23) a run from rest is the steady state: its peak and
// r.m.s. over whole periods are the certified sweep's.
TEST(Exact, FromThePeriodicStateReachesTheCertifiedPeaksOfTheSpeedSweep) {
  const auto sweep = readTable(sourcePath("tests/paper/data/sweep_peak_consistent_J70t.csv"));
  for (std::size_t row = 0; row < sweep.at("V_mps").size(); ++row) {
    const double speed = sweep.at("V_mps")[row];
    Scenario scenario = paperScenario(History::kExtended);
    scenario.initial_state.from = InitialRest::kPeriodic;
    // One period of the rail in 2^12 samples: the r.m.s. of a sum of two harmonics is then exact.
    scenario.run.duration = 25.0 / speed;
    scenario.run.output_step = 25.0 / speed / 4096.0;
    RunChoice choice;
    choice.speed = speed;
    const TimeHistory history = run(paperVehicle(), scenario, "flat", "exact", choice).history;
    for (const Pairing& pairing : kPairings) {
      const auto rms = sweep.find(std::string(pairing.certified) + "_rms");
      if (rms == sweep.end()) continue;
      const std::vector<double> values = history.column(pairing.ours);
      double square = 0.0;
      for (std::size_t i = 0; i + 1 < values.size(); ++i) square += values[i] * values[i];
      const double found = std::sqrt(square / static_cast<double>(values.size() - 1));
      EXPECT_WITHIN(found / rms->second[row], 1.0, 1e-9) << pairing.ours << " at " << speed << " m/s";
      // Between samples a peak hides by (3 w dt)^2/8 of itself: 2.6e-6 with 4096 samples a period.
      const double peak = sweep.at(std::string(pairing.certified) + "_peak")[row];
      EXPECT_WITHIN(peakOf(values) / peak, 1.0, 3e-6) << pairing.ours << " at " << speed << " m/s";
    }
  }
}

}  // namespace
}  // namespace vehicle::test
