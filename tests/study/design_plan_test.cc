#include "libvehicle/study/plan/design_plan.h"

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/study/studies.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using test::planOf;
using test::range;
using test::studyOf;
using test::valuesOf;
using Values = std::vector<double>;

TEST(DesignPlan, AGridCrossesItsRangesWithTheLastRunningFastestAndBaseInFront) {
  const DesignPlan plan =
      planOf(studyOf({range("carbody.mass", "50 t", "60 t", 2), range("primary.stiffness_z", "2 MN/m", "4 MN/m", 3)}));
  ASSERT_EQ(plan.size(), 7u);
  EXPECT_EQ(plan.points(), 6u);
  EXPECT_EQ(valuesOf(plan, 0), (Values{57e3, 3040e3}));
  EXPECT_EQ(valuesOf(plan, 1), (Values{50e3, 2e6}));
  EXPECT_EQ(valuesOf(plan, 2), (Values{50e3, 3e6}));
  EXPECT_EQ(valuesOf(plan, 3), (Values{50e3, 4e6}));
  EXPECT_EQ(valuesOf(plan, 4), (Values{60e3, 2e6}));
  EXPECT_EQ(valuesOf(plan, 6), (Values{60e3, 4e6}));
  EXPECT_EQ(plan.nameOf(0), "base");
  EXPECT_EQ(plan.nameOf(6), "#5");
  EXPECT_THROW(valuesOf(plan, 7), std::invalid_argument);
}

Study withTwoNamed() {
  Study study = studyOf({range("secondary.stiffness_z", "80 %", "120 %", 3)});
  study.varies[0].kind = Variation::kRelative;
  study.designs = {{"soft", "", {{"secondary.stiffness_z", "600 kN/m", {}}}, {}},
                   {"light", "", {{"front_bogie.mass, rear_bogie.mass", "7 t", {}}}, {}}};
  return study;
}

TEST(DesignPlan, NamedDesignsStandAloneFirstAndAreThenCrossedWithThePlan) {
  const DesignPlan plan = planOf(withTwoNamed());
  ASSERT_EQ(plan.size(), 3u + 3u * 3u);
  EXPECT_EQ(valuesOf(plan, 0), (Values{2660e3, 9e3, 9e3}));
  EXPECT_EQ(valuesOf(plan, 1), (Values{600e3, 9e3, 9e3}));
  EXPECT_EQ(valuesOf(plan, 2), (Values{2660e3, 7e3, 7e3}));
  // 0.8 of the design's own value; the middle of the range, 1, is met to a rounding of 1e-16.
  EXPECT_EQ(valuesOf(plan, 3), (Values{2660e3 * 0.8, 9e3, 9e3}));
  EXPECT_EQ(valuesOf(plan, 6), (Values{600e3 * 0.8, 9e3, 9e3}));
  EXPECT_WITHIN(valuesOf(plan, 7)[0], 600e3, 1e-9);
  EXPECT_EQ(valuesOf(plan, 11), (Values{2660e3 * 1.2, 7e3, 7e3}));
  EXPECT_EQ(plan.nameOf(2), "light");
  EXPECT_EQ(plan.nameOf(7), "soft #1");
  EXPECT_EQ(plan.identityOf(11).named, 2u);
  EXPECT_EQ(plan.identityOf(11).point, 2u);
}

TEST(DesignPlan, WithoutAnythingVariedTheNamedDesignsAreAll) {
  Study study = withTwoNamed();
  study.varies.clear();
  study.plan.reset();
  EXPECT_EQ(planOf(study).size(), 3u);
}

TEST(DesignPlan, ASpeedWithStepsMakesCasesAndNoDesigns) {
  Study study = studyOf({range("carbody.mass", "50 t", "60 t", 2), range("speed", "60 km/h", "120 km/h", 3)});
  const DesignPlan plan = planOf(study);
  EXPECT_EQ(plan.size(), 3u);
  ASSERT_EQ(plan.study().cases.size(), 3u);
  EXPECT_EQ(plan.study().cases[1].label, "90 km/h");
  EXPECT_EQ(metricColumns(plan.study())[2].channel, (Channel{"carbody.az.rms @ 120 km/h", "m/s^2"}));
}

// The values of a plan are the places of the sequence on the ranges, whoever asks and in whichever order.
TEST(DesignPlan, SamplingPlansPutTheSequenceOnTheRanges) {
  Study study = studyOf({range("carbody.mass", "50 t", "60 t"), range("primary.damping_z", "10 kN*s/m", "1000 kN*s/m")},
                        PlanKind::kSobol, 64);
  study.varies[1].spacing = Spacing::kLogarithmic;
  const DesignPlan plan = planOf(study);
  ASSERT_EQ(plan.size(), 65u);
  const SobolSequence sequence(2, 1);
  Values unit(2);
  for (const std::uint64_t point : {63u, 0u, 17u}) {
    sequence.point(point, unit);
    const Values values = valuesOf(plan, point + 1);
    // A rounding or two of numbers of that size.
    EXPECT_WITHIN(values[0], 50e3 + 10e3 * unit[0], 1e-10);
    EXPECT_WITHIN(values[1] / (10e3 * std::pow(100.0, unit[1])), 1.0, 1e-14);
  }
  study.plan->kind = PlanKind::kLatinHypercube;
  const DesignPlan hypercube = planOf(study);
  std::set<int> strata;
  for (std::uint64_t i = 1; i < 65; ++i)
    strata.insert(static_cast<int>((valuesOf(hypercube, i)[0] - 50e3) / 10e3 * 64.0));
  EXPECT_EQ(strata.size(), 64u);
}

TEST(DesignPlan, ASampledListTakesEachOfItsValuesEquallyOften) {
  Study study = studyOf({range("carbody.mass", "50 t", "60 t", 4)}, PlanKind::kSobol, 64);
  study.varies[0].spacing = Spacing::kLinear;
  const DesignPlan plan = planOf(study);
  std::map<double, int> met;
  for (std::uint64_t i = 1; i < 65; ++i) ++met[valuesOf(plan, i)[0]];
  ASSERT_EQ(met.size(), 4u);
  for (const auto& [value, count] : met) EXPECT_EQ(count, 16) << value;
}

TEST(DesignPlan, ASaltelliBlockIsAThenBThenAWithOneCoordinateOfB) {
  const DesignPlan plan =
      planOf(studyOf({range("carbody.mass", "50 t", "60 t"), range("primary.damping_z", "10 kN*s/m", "90 kN*s/m"),
                      range("speed", "10 m/s", "50 m/s")},
                     PlanKind::kSaltelli, 8));
  ASSERT_EQ(plan.points(), 8u * 5u);
  for (std::uint64_t block = 0; block < 8; ++block) {
    const std::uint64_t first = 1 + block * 5;
    const Values a = valuesOf(plan, first);
    const Values b = valuesOf(plan, first + 1);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NE(a[i], b[i]);
      Values expected = a;
      expected[i] = b[i];
      EXPECT_EQ(valuesOf(plan, first + 2 + i), expected);
    }
  }
}

TEST(DesignPlan, ASaltelliBlockOfSecondOrderHasBWithOneCoordinateOfABesides) {
  Study study = studyOf({range("carbody.mass", "50 t", "60 t"), range("primary.damping_z", "10 kN*s/m", "90 kN*s/m"),
                         range("speed", "10 m/s", "50 m/s")},
                        PlanKind::kSaltelli, 8);
  const DesignPlan first_order = planOf(study);
  study.plan->second_order = SecondOrder::kYes;
  const DesignPlan plan = planOf(study);
  ASSERT_EQ(plan.points(), 8u * 8u);
  for (std::uint64_t block = 0; block < 8; ++block) {
    const std::uint64_t first = 1 + block * 8;
    const Values a = valuesOf(plan, first);
    const Values b = valuesOf(plan, first + 1);
    for (std::uint64_t member = 0; member < 5; ++member) {
      EXPECT_EQ(valuesOf(plan, first + member), valuesOf(first_order, 1 + block * 5 + member));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      Values expected = b;
      expected[i] = a[i];
      EXPECT_EQ(valuesOf(plan, first + 5 + i), expected);
    }
  }
}

TEST(DesignPlan, TooManyDesignsAreRefusedWithoutCountingThem) {
  Study study = studyOf({range("carbody.mass", "50 t", "60 t", 100'000),
                         range("primary.damping_z", "1 kN*s/m", "2 kN*s/m", 100'000),
                         range("secondary.damping_z", "1 kN*s/m", "2 kN*s/m", 100'000)});
  study.plan->origin.file = "study.xml";
  study.plan->origin.line = 9;
  const Outcome<DesignPlan> plan =
      DesignPlan::of(study, bindStudy(study, test::paperVehicle(), {test::waves()}).orThrow());
  EXPECT_EQ(plan.problems.text(),
            "study.xml:9: error: <study><plan>: makes more than 1000000000 designs, base and named ones counted; take "
            "fewer steps, or let latin_hypercube or sobol choose among them\n");
  Study sampled = studyOf({range("carbody.mass", "50 t", "60 t")}, PlanKind::kSobol);
  sampled.plan->size = 1'000'000'000;
  const BoundStudy bound = bindStudy(sampled, test::paperVehicle(), {test::waves()}).orThrow();
  EXPECT_EQ(DesignPlan::of(sampled, bound).problems.text(),
            "error: <study><plan>: makes more than 1000000000 designs, base and named ones counted; take a smaller "
            "size\n");
}

TEST(DesignPlan, ASearchAsksForPlacesInTheUnitCube) {
  Study study = withTwoNamed();
  study.varies[0].count.reset();
  study.plan.reset();
  study.search.emplace();
  study.metrics = {{"carbody.az.rms", {}}, {"carbody.z.peak", {}}};
  study.objectives = {{"carbody.az.rms", Goal::kMinimise, Over::kWorst, {}},
                      {"carbody.z.peak", Goal::kMinimise, Over::kWorst, {}}};
  const DesignPlan plan = planOf(study);
  EXPECT_EQ(plan.size(), 3u);
  Values values(3);
  plan.valuesAt(1, Values{1.0}, values);
  EXPECT_EQ(values, (Values{600e3 * 1.2, 9e3, 9e3}));
}

}  // namespace
}  // namespace vehicle
