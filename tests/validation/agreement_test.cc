#include "libvehicle/validation/agreement.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

const std::vector<Channel> kColumns = {{"carbody.z", "m"},
                                       {"carbody.vz", "m/s"},
                                       {"carbody.az", "m/s^2"},
                                       {"primary_1.force", "N"},
                                       {"carbody.pitch", "rad"}};

/// Every column is amplitude * scale_j * sin(t); pitch is nothing but rounding.
TimeHistory history(double amplitude) {
  TimeHistory made(kColumns);
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.05 * i;
    const std::span<double> row = made.append(t);
    for (int j = 1; j <= 4; ++j) row[static_cast<std::size_t>(j)] = amplitude * std::pow(10.0, j) * std::sin(t);
    row[5] = 1e-19 * amplitude * std::sin(3.0 * t);
  }
  return made;
}

Expectation expectation(double relative) {
  Expectation made;
  made.size = Eigen::VectorXd{{10.0, 1e2, 1e3, 1e4, 1e-17}} * relative;
  made.rounding = Eigen::VectorXd::Constant(5, 1e-17);
  made.size(4) = 1e-17;
  made.why = "the test says so";
  return made;
}

// Peaks are sampled sines of 20 s: max sin = 1 - 2e-4 at worst, so 1.1e-6 stands clear of 1e-6 and 0.9e-6 below it.
TEST(CompareHistories, DifferencesBelowTheExpectationAreInsideAndAboveItOutside) {
  const PairAgreement inside = compareHistories(history(1.0), history(1.0 + 0.9e-6), expectation(1e-6));
  EXPECT_EQ(inside.verdict, Verdict::kInside);
  EXPECT_WITHIN(inside.relative, 0.9e-6, 1e-9);  // sums and differences of numbers of size 1
  const PairAgreement outside = compareHistories(history(1.0), history(1.0 + 1.1e-6), expectation(1e-6));
  EXPECT_EQ(outside.verdict, Verdict::kOutside);
}

TEST(CompareHistories, OneColumnOutsideIsEnoughAndIsNamed) {
  TimeHistory doctored(kColumns);
  const TimeHistory whole = history(1.0);
  for (std::size_t i = 0; i < whole.samples(); ++i) {
    const std::span<double> row = doctored.append(whole.at(i, 0));
    for (std::size_t j = 1; j < row.size(); ++j) row[j] = whole.at(i, j) * (j == 3 && i == 31 ? 1.01 : 1.0);
  }
  const PairAgreement pair = compareHistories(whole, doctored, expectation(1e-6));
  EXPECT_EQ(pair.verdict, Verdict::kOutside);
  EXPECT_EQ(pair.columns[pair.worst].column.name, "carbody.az");
}

TEST(CompareHistories, GroupsFollowTheUnitsAndColumnsOfRoundingDoNotCount) {
  const PairAgreement pair = compareHistories(history(1.0), history(1.5), expectation(1.0));
  ASSERT_EQ(pair.groups.size(), 4u);
  for (const GroupAgreement& group : pair.groups) {
    EXPECT_WITHIN(group.magnitude, 0.5, 1e-12);  // sums of 401 terms
    EXPECT_WITHIN(group.relative, 0.5, 1e-12);
  }
  EXPECT_EQ(pair.groups[0].group, QuantityGroup::kDisplacements);
  EXPECT_EQ(pair.groups[0].column, "carbody.z");
  EXPECT_EQ(pair.groups[3].group, QuantityGroup::kForces);
}

TEST(CompareHistories, WithoutExpectationNothingFailsAndNothingPasses) {
  const PairAgreement pair = compareHistories(history(1.0), history(7.0), std::nullopt);
  EXPECT_EQ(pair.verdict, Verdict::kByDesign);
  EXPECT_WITHIN(pair.relative, 6.0, 1e-12);
}

TEST(CompareHistories, AValueThatIsNoNumberIsOutsideWhateverIsExpected) {
  TimeHistory broken = history(1.0);
  broken.append(20.05)[1] = std::numeric_limits<double>::quiet_NaN();
  TimeHistory longer = history(1.0);
  longer.append(20.05)[1] = 0.0;
  EXPECT_EQ(compareHistories(longer, broken, expectation(1e300)).verdict, Verdict::kOutside);
}

TEST(CompareHistories, HistoriesOfDifferentShapeAreRefused) {
  TimeHistory longer = history(1.0);
  longer.append(20.05);
  EXPECT_THROW(static_cast<void>(compareHistories(history(1.0), longer, std::nullopt)), std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(compareHistories(history(1.0), TimeHistory(std::vector<Channel>{{"z", "m"}}), std::nullopt)),
      std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
