#include "libvehicle/ensemble/ensemble.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "tests/ensemble/designs.h"
#include "tests/ensemble/scalar_run.h"
#include "tests/support/refusal.h"

namespace vehicle::test {
namespace {

// Round-off of some thousand steps: fused multiply-adds and another order inside the sums differ from the scalar run by
// 1e-14 to 1e-13 of a column's peak. The method's own error at 1 ms is 1e-8: both sides
// have it alike, so another method or another grid would be seen six decades up.
constexpr double kRounding = 1e-12;

std::string isaName(const ::testing::TestParamInfo<Isa>& info) { return std::string(nameOf(info.param)); }

class Lanes : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(EveryIsaOfThisMachine, Lanes, ::testing::ValuesIn(supportedIsas()), isaName);

// Every column of every design against the scalar run: all samples (from the stored block) and the metrics.
void expectScalarRuns(const std::vector<EnsembleDesign>& designs, const std::vector<const Input*>& rails,
                      const EnsembleRun& run, bool shared) {
  std::vector<std::vector<std::vector<double>>> stored(designs.size());
  const auto store = [&](const StoredBlock& block) {
    for (int i = 0; i < block.designs(); ++i) {
      auto& history = stored[static_cast<std::size_t>(block.firstDesign() + i)];
      for (int sample = 0; sample < block.samples(i); ++sample) {
        history.emplace_back();
        for (int k = 0; k < block.columns(); ++k) history.back().push_back(block.at(i, k, sample));
      }
    }
  };
  const EnsembleResult result =
      shared ? runEnsemble(designs, *rails[0], run, store) : runEnsemble(designs, rails, run, store);
  ASSERT_TRUE(result.failures.empty());
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const ScalarRun scalar = scalarRun(designs[i], *rails[i], run);
    const auto& history = scalar.history;
    ASSERT_EQ(stored[i].size(), history.size());
    for (std::size_t k = 0; k < run.columns.size(); ++k) {
      const auto column = static_cast<std::size_t>(run.columns[k]);
      const double allowed = kRounding * peakOf(history, column);
      double worst = 0.0;
      for (std::size_t n = 0; n < history.size(); ++n) {
        worst = std::max(worst, std::abs(stored[i][n][k] - history[n][column]));
      }
      EXPECT_WITHIN(worst, 0.0, allowed) << "design " << i << " column " << column;
      const ColumnSummary& truth = scalar.summaries[column];
      const ColumnSummary& ours = result.summaries[i * run.columns.size() + k];
      EXPECT_WITHIN(ours.mean, truth.mean, allowed) << "design " << i << " column " << column;
      EXPECT_WITHIN(ours.rms, truth.rms, allowed) << "design " << i << " column " << column;
      EXPECT_WITHIN(ours.lowest, truth.lowest, allowed) << "design " << i << " column " << column;
      EXPECT_WITHIN(ours.highest, truth.highest, allowed) << "design " << i << " column " << column;
    }
  }
}

EnsembleRun everything(Isa isa, double settle = 0.0) {
  EnsembleRun run;
  run.settle = settle;
  run.columns = allColumns();
  run.isa = isa;
  return run;
}

TEST_P(Lanes, GiveTheScalarRunOverASharedRail) {
  const Input rail = railOf({});
  expectScalarRuns(asymmetricDesigns(11), std::vector<const Input*>(11, &rail), everything(GetParam(), 0.3), true);
}

// Breakpoints off the samples and the steps: 3/20 s is sample 30 but for rounding, 7.45/20 s = 0.3725 s is not.
TEST_P(Lanes, EndStepsOnTheBreakpointsOfASharedOnset) {
  const Input rail = railOf({.onset = true, .bump = 0.02});
  expectScalarRuns(asymmetricDesigns(9), std::vector<const Input*>(9, &rail), everything(GetParam()), true);
}

TEST_P(Lanes, GiveTheScalarRunOverARailEach) {
  std::vector<Input> inputs;
  for (int i = 0; i < 11; ++i) inputs.push_back(railOf({.speed = 15.0 + 3.1 * i, .wavelength = {25.0, 11.0 + i}}));
  std::vector<const Input*> rails;
  for (const Input& input : inputs) rails.push_back(&input);
  expectScalarRuns(asymmetricDesigns(11), rails, everything(GetParam(), 0.3), false);
}

// Every lane meets its own breakpoints at its own time, with polynomials, other numbers of harmonics and other lengths.
TEST_P(Lanes, EndStepsOnTheBreakpointsOfEachOnset) {
  std::vector<Input> inputs;
  for (int i = 0; i < 11; ++i) {
    RailShape shape{.speed = 15.0 + 3.1 * i, .end = 1.2 + 0.1 * i, .onset = i % 3 != 2};
    if (i % 2 == 0) shape.bump = 0.02;
    if (i % 4 == 1) {
      shape.wavelength = {31.0};
      shape.amplitude = {4e-3};
    }
    inputs.push_back(railOf(shape));
  }
  std::vector<const Input*> rails;
  for (const Input& input : inputs) rails.push_back(&input);
  expectScalarRuns(asymmetricDesigns(11), rails, everything(GetParam()), false);
}

// The oscillators are seeded anew on the way: a long run shows whether that joins.
TEST_P(Lanes, FollowALongRun) {
  const Input rail = railOf({.end = 20.0});
  EnsembleRun run = everything(GetParam());
  run.columns = {FlatColumn::kCarbodyZ, FlatColumn::kWheel4Load};
  const auto designs = asymmetricDesigns(2);
  expectScalarRuns(designs, {&rail, &rail}, run, true);
  expectScalarRuns(designs, {&rail, &rail}, run, false);
}

TEST_P(Lanes, TakeOtherStepsAndRefinements) {
  const Input rail = railOf({.end = 1.003, .onset = true});
  EnsembleRun run = everything(GetParam());
  run.output_step = 4e-3;
  run.step = {.step = 1.5e-3, .refine = 2};
  const auto designs = asymmetricDesigns(3);
  expectScalarRuns(designs, {&rail, &rail, &rail}, run, true);
  expectScalarRuns(designs, {&rail, &rail, &rail}, run, false);
}

// Points between output samples, as a fast design or a fast wave asks for them.
TEST_P(Lanes, MeasureBetweenOutputSamples) {
  const Input rail = railOf({.onset = true, .bump = 0.02});
  EnsembleRun run = everything(GetParam(), 0.25);
  run.fastest = 200.0;  // 3.2 points
  const auto designs = asymmetricDesigns(5);
  expectScalarRuns(designs, std::vector<const Input*>(5, &rail), run, true);
  expectScalarRuns(designs, std::vector<const Input*>(5, &rail), run, false);
  run.steps = 6;
  run.step = {.step = 5e-3 / 6};
  expectScalarRuns(designs, std::vector<const Input*>(5, &rail), run, true);
  expectScalarRuns(designs, std::vector<const Input*>(5, &rail), run, false);
}

TEST_P(Lanes, EndWhereTheRunEndsAndNotOnASample) {
  const Input rail = railOf({.end = 0.5033, .onset = true});
  const auto designs = asymmetricDesigns(3);
  expectScalarRuns(designs, {&rail, &rail, &rail}, everything(GetParam()), true);
  expectScalarRuns(designs, {&rail, &rail, &rail}, everything(GetParam()), false);
}

TEST(Ensemble, RailsOfOtherPointsAreRunApart) {
  const Input slow = railOf({});
  const Input fast = railOf({.wavelength = {25.0, 0.5}});
  const std::vector<const Input*> rails = {&slow, &fast};
  const std::vector<EnsembleDesign> designs = symmetricDesigns(2);
  EXPECT_EQ(ensembleCut(slow, {}), 1);
  EXPECT_GT(ensembleCut(fast, {}), 1);
  EXPECT_NE(refusalOf([&] { (void)runEnsemble(designs, rails, {}); }).find("run them apart"), std::string::npos);
}

// What left the model's range: the lowest of all wheel loads and the largest motion, of the samples that count.
TEST_P(Lanes, KnowHowFarADesignWent) {
  const Input rail = railOf({});
  EnsembleRun run = everything(GetParam(), 0.3);
  const std::vector<EnsembleDesign> designs = asymmetricDesigns(5);
  const EnsembleResult result = runEnsemble(designs, rail, run);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    double lowest = HUGE_VAL, share = 0.0;
    for (const std::vector<double>& row : scalarRun(designs[i], rail, run).history) {
      const auto at = [&](FlatColumn column, int further = 0) {
        return row[static_cast<std::size_t>(static_cast<int>(column) + further)];
      };
      share = std::max(share, std::abs(at(FlatColumn::kCarbodyPitch)) / kMostFlatPitch);
      share = std::max(share, std::abs(at(FlatColumn::kSecondaryFrontDeflection)) / kMostFlatTravel);
      share = std::max(share, std::abs(at(FlatColumn::kSecondaryRearDeflection)) / kMostFlatTravel);
      for (int j = 0; j < 4; ++j) {
        share = std::max(share, std::abs(at(FlatColumn::kPrimary1Deflection, 2 * j)) / kMostFlatTravel);
        lowest = std::min(lowest, at(FlatColumn::kWheel1Load, 2 * j));
      }
    }
    EXPECT_WITHIN(result.extents[i].lowest_load, lowest, kRounding * std::abs(lowest));
    EXPECT_WITHIN(result.extents[i].largest_share, share, kRounding * share);
  }
}

// A measured rail: a cubic a sample of 7 ms, so that nearly every interval has a breakpoint of its own place.
TEST_P(Lanes, FollowAStoredRail) {
  std::vector<Input> inputs;
  for (int i = 0; i < 5; ++i) {
    std::vector<double> height, rate;
    for (int n = 0; n <= 60; ++n) {
      for (int j = 0; j < 4; ++j) {
        const double angle = (20.0 + i) * (7e-3 * n - 0.05 * j);
        height.push_back(3e-3 * std::sin(angle));
        rate.push_back(3e-3 * (20.0 + i) * std::cos(angle));
      }
    }
    inputs.push_back(storedInput(4, 0.0, 7e-3, height, rate));
  }
  std::vector<const Input*> rails;
  for (const Input& input : inputs) rails.push_back(&input);
  expectScalarRuns(asymmetricDesigns(5), rails, everything(GetParam()), false);
  expectScalarRuns(asymmetricDesigns(5), std::vector<const Input*>(5, rails[0]), everything(GetParam()), true);
}

// ---- company

bool sameBits(const ColumnSummary& a, const ColumnSummary& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

struct Company {
  std::vector<EnsembleDesign> designs;
  std::vector<Input> inputs;
  std::vector<const Input*> rails;  // empty: shared
};

Company mixedCompany(int count) {
  Company company;
  company.designs = asymmetricDesigns(count);
  for (int i = 0; i < count; ++i) {
    company.inputs.push_back(railOf({.speed = 12.0 + 1.7 * i, .end = 0.8 + 0.05 * (i % 5), .onset = i % 2 == 0,
                                     .bump = i % 3 == 0 ? 0.01 : 0.0}));
  }
  for (const Input& input : company.inputs) company.rails.push_back(&input);
  return company;
}

// A lane's arithmetic never looks at its neighbours: equality is exact.
TEST_P(Lanes, GiveADesignTheSameBitsInAnyCompany) {
  constexpr int kCount = 37;
  Company company = mixedCompany(kCount);
  EnsembleRun run = everything(GetParam(), 0.1);
  const Input shared = railOf({.end = 0.7, .onset = true});
  const EnsembleResult together = runEnsemble(company.designs, company.rails, run);
  const EnsembleResult together_shared = runEnsemble(company.designs, shared, run);
  std::vector<std::size_t> order(kCount);
  for (std::size_t i = 0; i < kCount; ++i) order[i] = (i * 16 + 5) % kCount;
  std::vector<EnsembleDesign> shuffled;
  std::vector<const Input*> shuffled_rails;
  for (const std::size_t i : order) {
    shuffled.push_back(company.designs[i]);
    shuffled_rails.push_back(company.rails[i]);
  }
  const EnsembleResult apart = runEnsemble(shuffled, shuffled_rails, run);
  const EnsembleResult apart_shared = runEnsemble(shuffled, shared, run);
  const std::size_t K = run.columns.size();
  for (std::size_t place = 0; place < kCount; ++place) {
    const std::size_t i = order[place];
    const EnsembleResult alone = runEnsemble({&company.designs[i], 1}, {&company.rails[i], 1}, run);
    const EnsembleResult alone_shared = runEnsemble({&company.designs[i], 1}, shared, run);
    for (std::size_t k = 0; k < K; ++k) {
      ASSERT_TRUE(sameBits(together.summaries[i * K + k], apart.summaries[place * K + k])) << i << " column " << k;
      ASSERT_TRUE(sameBits(together.summaries[i * K + k], alone.summaries[k])) << i << " column " << k;
      ASSERT_TRUE(sameBits(together_shared.summaries[i * K + k], apart_shared.summaries[place * K + k])) << i;
      ASSERT_TRUE(sameBits(together_shared.summaries[i * K + k], alone_shared.summaries[k])) << i << " column " << k;
    }
  }
}

// More designs than are laid out at once, and a store that fills its memory: the cut leaves no trace.
TEST_P(Lanes, GiveADesignTheSameBitsInABatchOfThousands) {
  const std::vector<EnsembleDesign> designs = symmetricDesigns(2500);
  const Input rail = railOf({.end = 0.1});
  EnsembleRun run;
  run.columns = {FlatColumn::kCarbodyAz};
  run.isa = GetParam();
  const EnsembleResult all = runEnsemble(designs, rail, run);
  const EnsembleResult last = runEnsemble({&designs[2499], 1}, rail, run);
  EXPECT_TRUE(sameBits(all.summaries[2499], last.summaries[0]));
  EXPECT_EQ(all.steps, 2500 * 100);
}

TEST_P(Lanes, FillTheirTailsWhateverTheCount) {
  const std::vector<EnsembleDesign> designs = asymmetricDesigns(17);
  const Input rail = railOf({.end = 0.2, .onset = true});
  const EnsembleRun run = everything(GetParam());
  const EnsembleResult all = runEnsemble(designs, rail, run);
  for (std::size_t count = 0; count <= 17; ++count) {
    const std::vector<const Input*> rails(count, &rail);
    const EnsembleResult some = runEnsemble({designs.data(), count}, rail, run);
    const EnsembleResult each = runEnsemble({designs.data(), count}, rails, run);
    ASSERT_EQ(some.summaries.size(), count * run.columns.size());
    ASSERT_EQ(each.summaries.size(), count * run.columns.size());
    for (std::size_t i = 0; i < some.summaries.size(); ++i) ASSERT_TRUE(sameBits(some.summaries[i], all.summaries[i]));
  }
}

// ---- failures

// Stiffness far beyond what the step can follow: that lane grows to infinity, the others do not notice.
TEST_P(Lanes, ThatBlowUpAreToldWithTheirTimeAndHarmNobody) {
  std::vector<EnsembleDesign> designs = asymmetricDesigns(13);
  const Input rail = railOf({});
  const std::vector<const Input*> rails(13, &rail);
  const EnsembleRun run = everything(GetParam());
  const EnsembleResult healthy = runEnsemble(designs, rail, run);
  const EnsembleResult healthy_each = runEnsemble(designs, rails, run);
  designs[5].vehicle.cp.fill(4e11);
  designs[10].start[3] = NAN;
  const std::size_t K = run.columns.size();
  for (const bool shared : {true, false}) {
    const EnsembleResult result = shared ? runEnsemble(designs, rail, run) : runEnsemble(designs, rails, run);
    const EnsembleResult& before = shared ? healthy : healthy_each;
    ASSERT_EQ(result.failures.size(), 2u);
    EXPECT_EQ(result.failures[0].design, 5);
    EXPECT_EQ(result.failures[1].design, 10);
    EXPECT_EQ(result.failures[1].time, 0.0);
    // The scalar run says when.
    double failed_after = 0.0;
    try {
      Rk4<FlatRhs, 8> stepper{FlatRhs(designs[5].vehicle)};
      FixedSteps(stepper, rail, run.step)
          .run(Schedule(rail, run.output_step), designs[5].start, [&](int, int, double t, std::span<const double>) {
            failed_after = t;
            return true;
          });
      ADD_FAILURE() << "the scalar run did not fail";
    } catch (const std::runtime_error&) {
    }
    // Rounding decides at which step infinity is reached, within a sample or two of growth by many decades.
    EXPECT_NEAR(result.failures[0].time, failed_after + run.output_step, 2.0 * run.output_step);
    for (std::size_t i = 0; i < designs.size(); ++i) {
      for (std::size_t k = 0; k < K; ++k) {
        const ColumnSummary& summary = result.summaries[i * K + k];
        if (i == 5 || i == 10) {
          ASSERT_TRUE(std::isnan(summary.mean) && std::isnan(summary.rms) && std::isnan(summary.peak()));
        } else {
          ASSERT_TRUE(sameBits(summary, before.summaries[i * K + k])) << i << " column " << k;
        }
      }
    }
  }
}

TEST(Ensemble, TheFirstSampleThatCountsIsTheFirstNotBeforeSettle) {
  EXPECT_EQ(firstCounted(0.0, 0.005), 0);
  EXPECT_EQ(firstCounted(2.0, 0.005), 400);  // 2 / 0.005 rounds to 400
  EXPECT_EQ(firstCounted(0.3, 0.1), 3);      // 0.3 / 0.1 = 2.9999999999999996
  EXPECT_EQ(firstCounted(0.301, 0.1), 4);
}

// ---- refusals

TEST(Ensemble, NamesWhatDoesNotFit) {
  const std::vector<EnsembleDesign> designs = symmetricDesigns(2);
  const Input rail = railOf({});
  const std::vector<const Input*> one = {&rail};
  const std::vector<const Input*> null = {&rail, nullptr};
  EnsembleRun run;
  run.settle = -1.0;
  EXPECT_EQ(refusalOf([&] { (void)runEnsemble(designs, rail, run); }),
            "ensemble: settle = -1 s, must be finite and >= 0");
  run.settle = 2.5;
  EXPECT_EQ(refusalOf([&] { (void)runEnsemble(designs, rail, run); }),
            "ensemble: settle = 2.5 s leaves nothing of a run of 2 s; settle less or run longer");
  run.settle = 0.0;
  EXPECT_EQ(refusalOf([&] { (void)runEnsemble(designs, one, run); }),
            "ensemble: 1 rails for 2 designs, must be one a design and none null");
  EXPECT_EQ(refusalOf([&] { (void)runEnsemble(designs, null, run); }),
            "ensemble: 2 rails for 2 designs, must be one a design and none null");
  run.columns = {static_cast<FlatColumn>(999)};
  EXPECT_EQ(refusalOf([&] { (void)runEnsemble(designs, rail, run); }), "ensemble: column number 999, must be 0..55");
  run.columns = {};
  InputSegment segment = rail.segment(0);
  segment.cosine.resize(4);
  segment.sine.resize(4);
  segment.polynomial.resize(8);
  const Input two(2, {segment});
  EXPECT_EQ(refusalOf([&] { (void)runEnsemble(designs, two, run); }),
            "ensemble: the rail has 2 channels, must have 4, one a wheelset");
  run.output_step = 0.0;
  EXPECT_EQ(refusalOf([&] { (void)runEnsemble(designs, rail, run); }),
            "Schedule: output_step = 0 s, must be finite and > 0");
  run.output_step = 5e-3;
  run.step.step = -1.0;
  EXPECT_NE(refusalOf([&] { (void)runEnsemble(designs, rail, run); }), "accepted");
}

}  // namespace
}  // namespace vehicle::test
