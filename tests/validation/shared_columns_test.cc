#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/validation/validation.h"
#include "tests/support/affinity.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

Scenario onsetFor(double duration) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.run.duration = duration;
  return scenario;
}

ValidationChoice flatChoice() {
  ValidationChoice choice;
  choice.forms = {"flat"};
  return choice;
}

bool hasRun(const ValidationReport& report, const std::string& text) {
  return std::any_of(report.runs.begin(), report.runs.end(),
                     [&](const ValidationRun& run) { return run.key.text() == text; });
}

/// Every run shared among threads has been compared with its serial one and is equal to it.
void expectEqualBits(const ValidationReport& report) {
  EXPECT_TRUE(report.inside());
  std::size_t compared = 0;
  for (const PairAgreement& pair : report.pairs) {
    const RunKey& a = report.runs[pair.first].key;
    const RunKey& b = report.runs[pair.second].key;
    if (!haveEqualBits(a, b)) continue;
    ++compared;
    EXPECT_EQ(pair.expected.value_or(1.0), 0.0) << a.text() << " / " << b.text();
    for (const ColumnAgreement& column : pair.columns) {
      EXPECT_EQ(column.norms.max_difference, 0.0) << a.text() << " / " << b.text() << ": " << column.column.name;
    }
  }
  EXPECT_GE(compared, 4u);
}

TEST(SharedColumns, ThePapersVehicleIsRunByEverySchemeAndHasTheBitsOfTheSerialRun) {
  const ValidationReport report = validate(test::paperVehicle(), onsetFor(0.5), flatChoice());
  for (const char* text : {"flat rk4 stages x4 map paper", "flat rk4 halo x2", "flat rk4 pipeline x2", "flat rk4_split",
                           "flat rk4_split split x2"}) {
    EXPECT_TRUE(hasRun(report, text)) << text;
  }
  expectEqualBits(report);
}

// Speeds of the issue: 20..150 km/h, of which both ends and one between.
TEST(SharedColumns, AreInsideFrom20To150KilometresAnHour) {
  for (const double kmh : {20.0, 85.0, 150.0}) {
    ValidationChoice choice = flatChoice();
    choice.forms = {"flat", "mbs-linear"};
    choice.methods = {"rk4", "exact"};
    choice.run.speed = kmh / 3.6;
    expectEqualBits(validate(test::paperVehicle(), onsetFor(0.2), choice));
  }
}

TEST(SharedColumns, WorkOnASingleAllowedCore) {
  const test::OnlyCore one(0);
  expectEqualBits(validate(test::paperVehicle(), onsetFor(0.2), flatChoice()));
}

TEST(SharedColumns, OfAnAsymmetricVehicleLeaveBounceAndPitchTogether) {
  Vehicle vehicle = test::paperVehicle();
  test::named(vehicle.bodies, "front_bogie").mass *= 1.25;
  const ValidationReport report = validate(vehicle, onsetFor(0.5), flatChoice());
  EXPECT_FALSE(hasRun(report, "flat rk4_split"));
  EXPECT_TRUE(hasRun(report, "flat rk4 stages x4 map paper"));
  expectEqualBits(report);
  // Nobody asked for the split methods, so that they do not fit is no news.
  for (const Unsupported& unsupported : report.unsupported) EXPECT_NE(unsupported.method, "rk4_split");
  ValidationChoice asked = flatChoice();
  asked.methods = {"rk4_split", "exact"};
  const ValidationReport on_request = validate(vehicle, onsetFor(0.5), asked);
  ASSERT_FALSE(on_request.unsupported.empty());
  EXPECT_EQ(on_request.unsupported[0].method, "rk4_split");
  EXPECT_NE(on_request.unsupported[0].reason.find("mass of the front bogie"), std::string::npos)
      << on_request.unsupported[0].reason;
}

// A machine that is too busy gives less evidence, which is no pass.
TEST(SharedColumns, ThatDoNotEndInTimeAreNotJudgedAndNoPass) {
  ValidationChoice choice = flatChoice();
  choice.methods = {"rk4"};
  choice.shared = {{"rk4", "stages", 2, "auto"}};
  choice.shared_time_limit = 1e-9;
  const ValidationReport report = validate(test::paperVehicle(), onsetFor(0.5), choice);
  EXPECT_FALSE(report.inside());
  EXPECT_FALSE(report.failed());
  EXPECT_FALSE(report.stopped);
  ASSERT_TRUE(hasRun(report, "flat rk4 stages x2"));
  const ValidationRun& late = report.runs.back();
  EXPECT_EQ(late.key.text(), "flat rk4 stages x2");
  EXPECT_EQ(late.ending, RunEnding::kOutOfTime);
  EXPECT_EQ(late.reason.rfind("not done after ", 0), 0u) << late.reason;
  // Against the reference, its serial run, and no other: those at half the step are compared with the reference alone.
  EXPECT_EQ(report.count(Verdict::kNotJudged), 2u);
  EXPECT_EQ(report.count(Verdict::kOutside), 0u);
  EXPECT_GT(report.count(Verdict::kInside), 0u);
  for (const PairAgreement& pair : report.pairs) {
    const bool is_late = report.runs[pair.second].key == late.key;
    EXPECT_EQ(pair.verdict == Verdict::kNotJudged, is_late) << pair.why;
    EXPECT_EQ(pair.why == "flat rk4 stages x2: " + late.reason, is_late) << pair.why;
  }
}

TEST(SharedColumns, WithoutALimitAreWaitedFor) { EXPECT_EQ(ValidationChoice().shared_time_limit, std::nullopt); }

TEST(SharedColumns, ThatDifferInTheirMapAloneAreTwoRuns) {
  ValidationChoice choice = flatChoice();
  choice.methods = {"rk4"};
  choice.shared = {{"rk4", "stages", 2, "auto"}, {"rk4", "stages", 2, "body"}, {"rk4", "stages", 2, "body"}};
  const ValidationPlan plan = validationPlanOf(compile(test::paperVehicle(), 9.81), choice);
  std::vector<std::string> shared;
  for (const RunKey& key : plan.runs) {
    if (!key.scheme.empty()) shared.push_back(key.text());
  }
  EXPECT_EQ(shared, (std::vector<std::string>{"flat rk4 stages x2", "flat rk4 stages x2 map body"}));
  // Each is compared with the serial run, and with the other.
  const ValidationReport report = validate(test::paperVehicle(), onsetFor(0.2), choice);
  EXPECT_TRUE(report.inside());
  EXPECT_EQ(report.runs.size(), plan.runs.size());
}

TEST(RunKey, EveryMemberTellsTwoRunsApart) {
  const RunKey key{.form = "flat", .method = "rk4"};
  EXPECT_EQ(key, (RunKey{.form = "flat", .method = "rk4"}));
  const std::vector<RunKey> others = {
      {.form = "matrix", .method = "rk4"},
      {.form = "flat", .method = "dopri5"},
      {.form = "flat", .method = "rk4", .refine = 2},
      {.form = "flat", .method = "rk4", .step = 2e-3},
      {.form = "flat", .method = "rk4", .relative = 1e-9},
      {.form = "flat", .method = "rk4", .absolute = 1e-9},
      {.form = "flat", .method = "rk4", .accuracy = 1e-9},
      {.form = "flat", .method = "rk4", .scheme = "halo"},
      {.form = "flat", .method = "rk4", .threads = 2},
      {.form = "flat", .method = "rk4", .map = "body"},
  };
  for (const RunKey& other : others) EXPECT_NE(key, other) << other.text();
}

TEST(SharedColumns, AreLeftOutOnRequest) {
  ValidationChoice choice = flatChoice();
  choice.shared.clear();
  for (const ValidationRun& run : validate(test::paperVehicle(), onsetFor(0.5), choice).runs) {
    EXPECT_EQ(run.key.scheme, "") << run.key.text();
    EXPECT_EQ(run.key.threads, 1);
  }
}

// The verdict can fail: one unit in the last place of one sample of one column, against an expectation of zero.
TEST(SharedColumns, OneBitOfOneSampleIsOutside) {
  const ValidationReport report = validate(test::paperVehicle(), onsetFor(0.5), flatChoice());
  const auto pair = std::find_if(report.pairs.begin(), report.pairs.end(), [&](const PairAgreement& each) {
    return haveEqualBits(report.runs[each.first].key, report.runs[each.second].key);
  });
  ASSERT_NE(pair, report.pairs.end());
  Expectation zero;
  zero.size = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(pair->columns.size()));
  zero.rounding = zero.size;
  RunChoice choice;
  choice.form = "flat";
  choice.method = "rk4";
  const TimeHistory right = simulate(test::paperVehicle(), onsetFor(0.5), choice).history;
  TimeHistory wrong(std::vector<Channel>(right.columns().begin() + 1, right.columns().end()));
  for (std::size_t i = 0; i < right.samples(); ++i) {
    const std::span<double> row = wrong.append(right.at(i, 0));
    for (std::size_t j = 1; j < row.size(); ++j) row[j] = right.at(i, j);
    if (i == 50) row[3] = std::nextafter(row[3], 1.0);
  }
  EXPECT_EQ(compareHistories(right, right, zero).verdict, Verdict::kInside);
  EXPECT_EQ(compareHistories(right, wrong, zero).verdict, Verdict::kOutside);
}

}  // namespace
}  // namespace vehicle
