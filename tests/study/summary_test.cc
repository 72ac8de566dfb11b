#include "libvehicle/study/summary.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/study/runner.h"
#include "libvehicle/study/search/search_study.h"
#include "libvehicle/study/study_warnings.h"
#include "tests/study/studies.h"
#include "tests/support/test_folder.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using Values = std::vector<double>;
using Ids = std::vector<std::uint64_t>;

/// Metrics of a design from its number and parameters; nothing: it failed.
using Metrics = std::function<std::optional<Values>(std::uint64_t design, const Values& parameters)>;

/// A study in a database, filled with numbers that the test chooses.
struct Filled {
  test::TestFolder folder;
  StudyInputs inputs;
  DesignPlan plan;
  std::map<std::uint64_t, Values> metrics;  // of the designs that did not fail
  StudySummary summary;

  Filled(const Study& study, const Metrics& metrics_of, const SummaryChoice& choice = {})
      : inputs{study, test::paperVehicle(), {test::waves()},
               bindStudy(study, test::paperVehicle(), {test::waves()}).orThrow()},
        plan(DesignPlan::of(study, inputs.bound).orThrow()) {
    const StudyTarget target{folder.path("study.sqlite"), false, "vehicle 0", {{"study.xml", ""}}};
    const StudyRecord record = recordOf(plan, target);
    StudyDatabase database = StudyDatabase::create(target.database, record);
    DesignBatch batch(record.parameters.size(), record.metrics.size());
    for (std::uint64_t design = 0; design < plan.size(); ++design) {
      const Values parameters = test::valuesOf(plan, design);
      if (const std::optional<Values> row = metrics_of(design, parameters)) {
        const bool lacks = std::any_of(row->begin(), row->end(), [](double each) { return std::isnan(each); });
        batch.add(design, parameters, *row, lacks ? "carbody.az.rms @ 60 km/h: lost" : "");
        metrics[design] = *row;
      } else {
        batch.addFailed(design, parameters, "failed of " + plan.nameOf(design));
      }
    }
    database.append(batch);
    summary = summarise(database, inputs, plan, choice);
  }
};

Ids idsOf(const std::vector<JudgedDesign>& designs) {
  Ids ids;
  for (const JudgedDesign& each : designs) ids.push_back(each.id);
  return ids;
}

// Stiffness (4) x damping (3), crossed with base and "soft", at two speeds: 26 designs of 5 numbers,
// az @ 60, az @ 120, deflection @ 60, deflection @ 120, static deflection.
Study crossed() {
  Study study = test::studyOf({test::range("secondary.stiffness_z", "1 MN/m", "4 MN/m", 4),
                               test::range("secondary.damping_z", "50 kN*s/m", "150 kN*s/m", 3),
                               test::range("speed", "60 km/h", "120 km/h", 2)});
  study.metrics = {{"carbody.az.rms", {}},
                   {"secondary_front.deflection.min", {}},
                   {"static.secondary_front.deflection", {}}};
  study.objectives = {{"carbody.az.rms", Goal::kMinimise, Over::kWorst, {}},
                      {"secondary_front.deflection.min", Goal::kMaximise, Over::kMean, {}}};
  study.limits = {{"static.secondary_front.deflection", "100 mm", "", {}}};
  StudyDesign soft;
  soft.name = "soft";
  soft.sets = {{"primary.stiffness_z", "2 MN/m", {}}};
  study.designs = {soft};
  return study;
}

/// Numbers without order, so that no two lists agree by chance; every ninth design fails.
std::optional<Values> scattered(std::uint64_t design, const Values&) {
  if (design % 9 == 4) return std::nullopt;
  const auto some = [design](int column) {
    const double x = std::sin(12.9898 * static_cast<double>(design + 1) + 78.233 * column) * 43758.5453;
    return x - std::floor(x);
  };
  return Values{0.1 + some(0), 0.1 + some(1), -0.01 - 0.02 * some(2), -0.01 - 0.02 * some(3), 0.05 + 0.08 * some(4)};
}

struct Scored {
  double az = 0.0;          // worst of two speeds, to be small
  double deflection = 0.0;  // mean of two speeds, to be large
  std::uint64_t id = 0;
};

/// Objectives of the designs within the limit, by hand.
std::vector<Scored> scoredBy(const std::map<std::uint64_t, Values>& metrics) {
  std::vector<Scored> all;
  for (const auto& [id, row] : metrics) {
    if (row[4] <= 0.1) all.push_back({std::max(row[0], row[1]), (row[2] + row[3]) / 2.0, id});
  }
  return all;
}

TEST(StudySummary, CountsWhatIsStoredFailedAndWithinTheLimits) {
  const Filled filled(crossed(), scattered);
  EXPECT_EQ(filled.summary.designs, 26u);
  EXPECT_EQ(filled.summary.stored, 26u);
  EXPECT_EQ(filled.summary.failed, 3u);  // 4, 13, 22
  EXPECT_EQ(idsOf(filled.summary.failures), (Ids{4, 13, 22}));
  EXPECT_EQ(filled.summary.failures[0].message, "failed of #2");
  EXPECT_EQ(filled.summary.failures[2].name, "soft #8");
  EXPECT_TRUE(filled.summary.failures[0].failed());
  EXPECT_FALSE(filled.summary.failures[0].keepsLimits());
  const std::size_t within = scoredBy(filled.metrics).size();
  EXPECT_GT(within, 5u);
  EXPECT_LT(within, 20u);
  EXPECT_EQ(filled.summary.within_limits, within);
}

TEST(StudySummary, TheBestOfEachObjectiveKeepTheLimitsAndStandInItsOrder) {
  const Filled filled(crossed(), scattered);
  std::vector<Scored> scored = scoredBy(filled.metrics);
  ASSERT_EQ(filled.summary.best.size(), 2u);
  std::sort(scored.begin(), scored.end(), [](const Scored& a, const Scored& b) { return a.az < b.az; });
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(filled.summary.best[0].at(i).id, scored[i].id);
    EXPECT_EQ(filled.summary.best[0].at(i).objectives, (Values{scored[i].az, scored[i].deflection}));
    EXPECT_EQ(filled.summary.best[0].at(i).violations, Values{0.0});
  }
  std::sort(scored.begin(), scored.end(), [](const Scored& a, const Scored& b) { return a.deflection > b.deflection; });
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(filled.summary.best[1].at(i).id, scored[i].id);
  EXPECT_EQ(filled.summary.best[1].size(), 5u);
}

TEST(StudySummary, TheFrontIsWhatNothingWithinTheLimitsDominates) {
  const Filled filled(crossed(), scattered);
  std::vector<Scored> scored = scoredBy(filled.metrics);
  std::sort(scored.begin(), scored.end(), [](const Scored& a, const Scored& b) { return a.az < b.az; });
  Ids front;
  for (const Scored& one : scored) {
    const bool dominated = std::any_of(scored.begin(), scored.end(), [&](const Scored& other) {
      return other.az < one.az && other.deflection > one.deflection;
    });
    if (!dominated) front.push_back(one.id);
  }
  EXPECT_GE(front.size(), 2u);
  EXPECT_EQ(idsOf(filled.summary.front), front);
}

// Every third design lacks the acceleration at 60 km/h, every fourth the static deflection that has a limit.
TEST(StudySummary, DesignsThatLackAValueAreCountedAndNeverBestOfIt) {
  const Filled filled(crossed(), [](std::uint64_t design, const Values& parameters) {
    std::optional<Values> row = scattered(design, parameters);
    if (row && design % 3 == 0) (*row)[0] = std::nan("");
    if (row && design % 4 == 1) (*row)[4] = std::nan("");
    return row;
  });
  std::uint64_t lacking = 0;
  std::vector<Scored> within;
  for (const auto& [id, row] : filled.metrics) {
    lacking += std::isnan(row[0]) || std::isnan(row[4]) ? 1 : 0;
    if (row[4] <= 0.1) within.push_back({std::max(row[0], row[1]), (row[2] + row[3]) / 2.0, id});
  }
  EXPECT_EQ(filled.summary.incomplete, lacking);
  EXPECT_EQ(filled.summary.within_limits, within.size());
  ASSERT_EQ(filled.summary.missing.size(), 1u);
  EXPECT_EQ(filled.summary.missing[0].metrics, "carbody.az.rms @ 60 km/h");
  EXPECT_EQ(filled.summary.missing[0].reason, "lost");
  EXPECT_EQ(filled.summary.missing[0].designs, lacking);
  for (const JudgedDesign& each : filled.summary.best[0]) EXPECT_NE(each.id % 3, 0u);
  for (const JudgedDesign& each : filled.summary.front) EXPECT_NE(each.id % 3, 0u);
  // The other objective has a value in all of them.
  std::sort(within.begin(), within.end(), [](const Scored& a, const Scored& b) { return a.deflection > b.deflection; });
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(filled.summary.best[1].at(i).id, within[i].id);
  // Points crossed with base are the ids 2 .. 13; 4 and 13 failed.
  EXPECT_EQ(filled.summary.influences[0].designs, 6u);
  EXPECT_EQ(filled.summary.influences[0].left_out, 6u);  // 3, 6, 9, 12 besides
  EXPECT_EQ(filled.summary.influences[1].left_out, 2u);
}

TEST(StudySummary, SaysInWhichCaseTheWorstValueStands) {
  const Filled filled(crossed(), scattered);
  for (const JudgedDesign& each : filled.summary.compared) {
    if (each.failed()) continue;
    ASSERT_EQ(each.worst.size(), 2u);
    EXPECT_EQ(each.worst[0], each.metrics[0] >= each.metrics[1] ? 0u : 1u);
    EXPECT_EQ(each.worst[1], std::nullopt);  // a mean has no worst case
  }
}

TEST(StudySummary, EqualDesignsStandInTheOrderOfTheirNumbersAndThereAreNoMoreThanAskedFor) {
  SummaryChoice choice;
  choice.best = 3;
  const Filled filled(crossed(), [](std::uint64_t, const Values&) { return Values{1.0, 1.0, 0.0, 0.0, 0.0}; }, choice);
  EXPECT_EQ(idsOf(filled.summary.best[0]), (Ids{0, 1, 2}));
  EXPECT_EQ(idsOf(filled.summary.best[1]), (Ids{0, 1, 2}));
}

TEST(StudySummary, FewDesignsAreAllComparedOfManyOnlyTheNamedOnes) {
  const Filled all(crossed(), scattered);
  EXPECT_EQ(all.summary.compared.size(), 26u);
  EXPECT_EQ(all.summary.compared[1].name, "soft");
  EXPECT_EQ(all.summary.compared[2].name, "#0");
  EXPECT_EQ(all.summary.compared[2].parameters, test::valuesOf(all.plan, 2));
  SummaryChoice choice;
  choice.all_up_to = 25;
  choice.failures = 2;
  const Filled named(crossed(), scattered, choice);
  EXPECT_EQ(idsOf(named.summary.compared), (Ids{0, 1}));
  EXPECT_EQ(idsOf(named.summary.failures), (Ids{4, 13}));
  EXPECT_EQ(named.summary.failed, 3u);
}

TEST(StudySummary, AStudyThatFailsInEveryDesignHasNothingToCompare) {
  const Filled filled(crossed(), [](std::uint64_t, const Values&) { return std::nullopt; });
  EXPECT_EQ(filled.summary.failed, 26u);
  EXPECT_EQ(filled.summary.failures.size(), 5u);
  EXPECT_EQ(filled.summary.within_limits, 0u);
  EXPECT_TRUE(filled.summary.best[0].empty());
  EXPECT_TRUE(filled.summary.front.empty());
  EXPECT_TRUE(filled.summary.influences.empty());
}

// The rows of "soft" lie on another plane: only the points that are crossed with base count.
TEST(StudySummary, InfluencesAreThoseOfTheBaseAlone) {
  Study study = crossed();
  study.objectives.clear();
  const Filled filled(study, [](std::uint64_t design, const Values& p) {
    const double line = 3.0 * p[0] / 1e6 - p[1] / 1e4;
    const double other = design % 2 == 0 ? 50.0 : -50.0;
    const bool of_base = design >= 2 && design < 14;
    return Values{of_base ? line : other, line, 1.0, 2.0, 0.0};
  });
  // Stiffness 1..4 MN/m: variance 1.25 (1e6)^2 over its 4 levels; damping 5, 10, 15 1e4: variance 50/3.
  const double of_stiffness = 3.0 * std::sqrt(1.25);
  const double of_damping = -std::sqrt(50.0 / 3.0);
  const double all = std::hypot(of_stiffness, of_damping);
  ASSERT_EQ(filled.summary.influences.size(), 5u);
  for (std::size_t output : {0u, 1u}) {
    const Influence& influence = filled.summary.influences[output];
    ASSERT_TRUE(influence.fit.has_value());
    // Rounding of moments of numbers of one size, about 1e-16 each.
    EXPECT_WITHIN(influence.correlations[0], of_stiffness / all, 1e-14);
    EXPECT_WITHIN(influence.correlations[1], of_damping / all, 1e-14);
    EXPECT_WITHIN(influence.fit->coefficients[0], of_stiffness / all, 1e-14);
    EXPECT_WITHIN(influence.fit->coefficients[1], of_damping / all, 1e-14);
    EXPECT_WITHIN(influence.fit->explained, 1.0, 1e-14);
    EXPECT_TRUE(influence.indices.indices.empty());
  }
  EXPECT_EQ(filled.summary.influences[0].output, "carbody.az.rms @ 60 km/h");
  EXPECT_EQ(filled.summary.influences[2].correlations, (Values{0.0, 0.0}));
}

TEST(StudySummary, InfluencesOnAnObjectiveAreThoseOnItsWorstSpeed) {
  const Filled filled(crossed(), [](std::uint64_t, const Values& p) {
    return Values{p[0] / 1e6, p[0] / 2e6, -p[1], -3.0 * p[1], 0.0};
  });
  ASSERT_EQ(filled.summary.influences.size(), 2u);
  EXPECT_EQ(filled.summary.influences[0].output, "carbody.az.rms, worst of 2");
  EXPECT_EQ(filled.summary.influences[1].output, "secondary_front.deflection.min, mean of 2");
  // Either follows one factor alone, to rounding.
  EXPECT_WITHIN(filled.summary.influences[0].correlations[0], 1.0, 1e-14);
  EXPECT_WITHIN(filled.summary.influences[1].correlations[1], -1.0, 1e-14);
}

// y = 2 x_1 + x_2 of uniform factors: shares of the variance 4 / 5 and 1 / 5, first-order and total alike.
TEST(StudySummary, SaltelliIndicesOfASumAreItsSharesAndABlockWithAFailureIsLeftOut) {
  const std::vector<Vary> varies = {test::range("carbody.mass", "1 t", "2 t"),
                                    test::range("front_bogie.mass", "1 t", "2 t")};
  const Study study = test::studyOf(varies, PlanKind::kSaltelli, 1024);
  const Filled filled(study, [](std::uint64_t design, const Values& p) -> std::optional<Values> {
    if (design == 7) return std::nullopt;
    return Values{2.0 * p[0] + p[1]};
  });
  ASSERT_EQ(filled.summary.influences.size(), 1u);
  const SensitivityResult& result = filled.summary.influences[0].indices;
  EXPECT_EQ(result.blocks, 1023u);
  EXPECT_EQ(result.left_out, 1u);
  ASSERT_EQ(result.indices.size(), 2u);
  // 1/1024 of the sequence is its error about, the block that is missing adds as much.
  EXPECT_WITHIN(result.indices[0].first.value, 0.8, 5e-3);
  EXPECT_WITHIN(result.indices[1].first.value, 0.2, 5e-3);
  EXPECT_WITHIN(result.indices[0].total.value, 0.8, 5e-3);
  EXPECT_WITHIN(result.indices[1].total.value, 0.2, 5e-3);
}

TEST(StudySummary, ASaltelliPlanOfSecondOrderHasPairs) {
  Study study = test::studyOf({test::range("carbody.mass", "1 t", "2 t"), test::range("front_bogie.mass", "1 t", "2 t"),
                               test::range("rear_bogie.mass", "1 t", "2 t")},
                              PlanKind::kSaltelli, 256);
  study.plan->second_order = SecondOrder::kYes;
  // Of two uniform factors x, y about their means u, v the product has the variance of v x, u y and of x y alone.
  const Filled filled(study, [](std::uint64_t, const Values& p) { return Values{p[0] * p[1] * 1e-6}; });
  const SensitivityResult& result = filled.summary.influences.at(0).indices;
  const double mean = 1.5, variance = 1.0 / 12.0;
  const double whole = 2.0 * mean * mean * variance + variance * variance;
  ASSERT_EQ(result.pairs.size(), 3u);
  EXPECT_WITHIN(result.pairs[0].second.value, variance * variance / whole, 4e-3);  // 1/256 of the sequence is its error
  EXPECT_WITHIN(result.pairs[1].second.value, 0.0, 4e-3);
  EXPECT_WITHIN(result.pairs[2].second.value, 0.0, 4e-3);
  EXPECT_TRUE(warningsAfter(filled.inputs, filled.summary).empty());
  EXPECT_TRUE(warningsBefore(filled.inputs).empty());
}

TEST(StudyWarnings, ASizeThatIsNoPowerOfTwoIsDoubtful) {
  Study study = test::studyOf({test::range("carbody.mass", "1 t", "2 t")}, PlanKind::kSaltelli, 1000);
  study.plan->origin.file = "study.xml";
  study.plan->origin.line = 4;
  const Filled filled(study, [](std::uint64_t, const Values& p) { return Values{p[0]}; });
  const Warnings warnings = warningsBefore(filled.inputs);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].text(),
            "study.xml:4: warning: <study><plan>: size=\"1000\" is no power of two: the points of the plan are not "
            "balanced, its indices converge more slowly; take 512 or 1024 [SAMPLE_SIZE]");
  Study sobol = study;
  sobol.plan->kind = PlanKind::kSobol;
  EXPECT_TRUE(
      warningsBefore(Filled(sobol, [](std::uint64_t, const Values& p) { return Values{p[0]}; }).inputs).empty());
}

TEST(StudyWarnings, AnOutputWithoutIndicesIsNamedWithTheReason) {
  Study study = test::studyOf({test::range("carbody.mass", "1 t", "2 t")}, PlanKind::kSaltelli, 8);
  study.metrics = {{"carbody.az.rms", {}}, {"carbody.z.rms", {}}, {"carbody.z.peak", {}}};
  const Filled filled(study, [](std::uint64_t design, const Values& p) {
    return Values{p[0], 0.25, design % 3 == 1 ? std::nan("") : p[0]};  // one of each block
  });
  const Warnings warnings = warningsAfter(filled.inputs, filled.summary);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].text(),
            "warning: carbody.z.rms: no sensitivity index can be given: it is 0.25 in every design; "
            "vary what it depends on, or leave it out [NO_INDEX]");
  EXPECT_EQ(
      warnings[1].text(),
      "warning: carbody.z.peak: no sensitivity index can be given: designs without a value break 8 of 8 blocks of "
      "the plan, two must be whole; vary less, so that every design has a value [NO_INDEX]");
}

TEST(StudySummary, DesignsOfASearchAreCalledByTheirGeneration) {
  Study study = test::studyOf({test::range("carbody.mass", "50 t", "60 t")});
  study.plan.reset();
  study.search.emplace();
  study.search->population = 4;
  study.search->generations = 1;
  study.objectives = {{"carbody.az.rms", Goal::kMinimise, Over::kWorst, {}}};
  const test::TestFolder folder;
  const BoundStudy bound = bindStudy(study, test::paperVehicle(), {test::waves()}).orThrow();
  const StudyInputs inputs{study, test::paperVehicle(), {test::waves()}, bound};
  const DesignPlan plan = DesignPlan::of(study, bound).orThrow();
  const StudyTarget target{folder.path("study.sqlite"), false, "vehicle 0", {{"study.xml", ""}}};
  StudyDatabase database = StudyDatabase::create(target.database, searchRecordOf(plan, *study.search, target));
  DesignBatch batch(1, 1);
  for (std::uint64_t design = 0; design < 9; ++design) {
    batch.add(design, Values{50e3 + 1e3 * static_cast<double>(design)}, Values{9.0 - static_cast<double>(design)});
  }
  database.append(batch);
  const StudySummary summary = summarise(database, inputs, plan);
  EXPECT_EQ(summary.designs, 9u);  // base, then two generations of four
  ASSERT_EQ(summary.best[0].size(), 5u);
  EXPECT_EQ(summary.best[0][0].name, "generation 1 #3");
  EXPECT_EQ(summary.best[0][4].name, "generation 0 #3");
  EXPECT_WITHIN(summary.influences.at(0).correlations.at(0), -1.0, 1e-14);  // rounding
}

}  // namespace
}  // namespace vehicle
