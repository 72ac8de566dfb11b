#include "libvehicle/validation/validation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

Scenario shortScenario(double duration) {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.run.duration = duration;
  return scenario;
}

const PairAgreement& pairOf(const ValidationReport& report, const std::string& first, const std::string& second) {
  for (const PairAgreement& pair : report.pairs) {
    if (report.runs[pair.first].key.text() == first && report.runs[pair.second].key.text() == second) return pair;
  }
  throw std::invalid_argument("no pair " + first + ", " + second);
}

std::string outsideOf(const ValidationReport& report) {
  std::string text;
  for (const PairAgreement& pair : report.pairs) {
    if (pair.verdict != Verdict::kOutside) continue;
    const ColumnAgreement& worst = pair.columns[pair.worst];
    text += report.runs[pair.first].key.text() + " / " + report.runs[pair.second].key.text() + ": " +
            worst.column.name + " " + std::to_string(worst.norms.max_difference / *worst.expected) + " of limit\n";
  }
  for (const ValidationRun& run : report.runs) text += run.reason;
  return text;
}

Expectation expectationOf(const PairAgreement& pair) {
  Expectation made;
  made.size.resize(static_cast<Eigen::Index>(pair.columns.size()));
  for (Eigen::Index i = 0; i < made.size.size(); ++i)
    made.size(i) = *pair.columns[static_cast<std::size_t>(i)].expected;
  made.rounding = Eigen::VectorXd::Zero(made.size.size());
  return made;
}

/// Two tests look at it.
const ValidationReport& paperReport() {
  static const ValidationReport report = [] {
    ValidationChoice choice;
    choice.shared.clear();  // shared_columns_test.cc has them
    return validate(test::paperVehicle(), shortScenario(2.5), choice);
  }();
  return report;
}

TEST(Validate, ThePapersVehicleIsInsideInEveryFormAndMethod) {
  const ValidationReport& report = paperReport();
  EXPECT_TRUE(report.inside()) << outsideOf(report);
  // exact, rk4, dopri5 of flat, matrix and mbs-linear, simbody_rkm of the latter; rk4, dopri5, simbody_rkm of mbs:
  // 13 runs; rk4_split of flat. 14 runs make 91 pairs, and the four rk4 at half the step of linear forms meet the
  // reference.
  EXPECT_EQ(report.pairs.size(), 95u);
  EXPECT_EQ(report.count(Verdict::kInside), 95u);
  for (const ValidationRun& run : report.runs) {
    if (run.key.refine == 1 || run.key.form == "mbs") continue;
    ASSERT_TRUE(run.order.has_value()) << run.key.text();
    // At |h lambda| <= 0.04 the next term changes the ratio 16 by 2 %: 0.03 of an order.
    EXPECT_WITHIN(*run.order, 4.0, 0.1);
  }
}

// A ledger that expects too much would catch nothing: the sizes stay within the decade or two that a bound costs.
TEST(Validate, ExpectationsOfThePapersVehicleAreNotWiderThanABoundMustBe) {
  const ValidationReport& report = paperReport();
  const auto expected = [&](const char* a, const char* b) {
    const PairAgreement& pair = pairOf(report, a, b);
    EXPECT_TRUE(pair.expected.has_value());
    return pair.expected.value_or(1.0);
  };
  EXPECT_LT(expected("flat rk4", "mbs-linear rk4"), 2e-12);
  EXPECT_LT(expected("matrix exact", "flat exact"), 2e-12);
  EXPECT_LT(expected("matrix exact", "flat rk4"), 1e-7);
  EXPECT_LT(expected("matrix exact", "flat dopri5"), 3e-8);
  EXPECT_LT(expected("matrix exact", "mbs rk4"), 3e-5);
  EXPECT_EQ(pairOf(report, "flat rk4", "mbs-linear rk4").source, Source::kRounding);
  EXPECT_EQ(pairOf(report, "matrix exact", "flat rk4").source, Source::kIntegration);
  EXPECT_EQ(pairOf(report, "matrix exact", "mbs rk4").source, Source::kGeometry);
  EXPECT_EQ(pairOf(report, "mbs rk4", "mbs dopri5").source, Source::kIntegration);
}

// The wrong vehicle is one spring 0.1 % harder in one form: its rk4 history takes the place of the right one.
TEST(Validate, AStiffnessThatDiffersByAThousandthInOneFormIsOutsideInEveryPair) {
  const Scenario scenario = shortScenario(1.5);
  ValidationChoice choice;
  choice.methods = {"exact", "rk4"};
  choice.shared.clear();
  const ValidationReport report = validate(test::paperVehicle(), scenario, choice);
  ASSERT_TRUE(report.inside()) << outsideOf(report);
  Vehicle harder = test::paperVehicle();
  test::named(harder.elements, "primary").stiffness_z *= 1.001;
  std::vector<TimeHistory> right, wrong;  // shape (runs)
  for (const ValidationRun& run : report.runs) {
    RunChoice again;
    again.form = run.key.form;
    again.method = run.key.method;
    again.refine = run.key.refine;
    right.push_back(simulate(test::paperVehicle(), scenario, again).history);
    wrong.push_back(simulate(harder, scenario, again).history);
  }
  for (const PairAgreement& pair : report.pairs) {
    const std::string text = report.runs[pair.first].key.text() + " / " + report.runs[pair.second].key.text();
    const Expectation expectation = expectationOf(pair);
    EXPECT_EQ(compareHistories(right[pair.first], right[pair.second], expectation).verdict, Verdict::kInside) << text;
    EXPECT_EQ(compareHistories(right[pair.first], wrong[pair.second], expectation).verdict, Verdict::kOutside) << text;
  }
  EXPECT_GE(report.pairs.size(), 20u);
}

// A vehicle, a track and a speed that the ledger's constants were not chosen on; every_vehicle_test.cc has the others.
TEST(Validate, AnAsymmetricVehicleWithPitchingBogiesIsInsideToo) {
  ValidationChoice choice;
  choice.run.speed = 31.0;
  const ValidationReport report = validate(test::asymmetricBogiePitchVehicle(), shortScenario(2.0), choice);
  EXPECT_TRUE(report.inside()) << outsideOf(report);
}

// Without heights the difference between true geometry and the linear forms is of third order in the motion, so
// relative to it amplitude^2, in what is expected and in what is found. The tolerance is the next order,
// (10 x 1.2 mrad)^2, times a sensitivity of some tens.
TEST(Validate, TrueGeometryIsExpectedAndFoundToGrowWithTheSquareOfTheAmplitude) {
  ValidationChoice choice;
  choice.forms = {"mbs"};
  choice.methods = {"dopri5"};
  const auto relative = [&](double factor) {
    Scenario scenario = shortScenario(4.0);
    for (Harmonic& harmonic : scenario.track->harmonics) harmonic.amplitude *= factor;
    const ValidationReport report = validate(test::paperVehicle(), scenario, choice);
    EXPECT_TRUE(report.inside()) << outsideOf(report);
    const PairAgreement& pair = pairOf(report, "matrix exact", "mbs dopri5");
    const ColumnAgreement& pitch = pair.columns[1];
    EXPECT_EQ(pitch.column.name, "carbody.pitch");
    return std::pair(pitch.norms.relative, *pitch.expected / pitch.norms.peak);
  };
  const auto [found_small, expected_small] = relative(1.0);
  const auto [found_large, expected_large] = relative(10.0);
  EXPECT_WITHIN(std::log10(found_large / found_small), 2.0, 0.05);
  EXPECT_WITHIN(std::log10(expected_large / expected_small), 2.0, 0.05);
}

TEST(Validate, PrintedVariantsDifferByDesignFromAllOthersAndAgreeWithThemselves) {
  ValidationChoice choice;
  choice.forms = {"flat", "flat-7-printed", "flat-literal"};
  choice.methods = {"exact", "rk4"};
  const ValidationReport report = validate(test::paperVehicle(), shortScenario(4.0), choice);
  EXPECT_TRUE(report.inside()) << outsideOf(report);
  EXPECT_EQ(pairOf(report, "matrix exact", "flat-7-printed exact").verdict, Verdict::kByDesign);
  EXPECT_EQ(pairOf(report, "flat-7-printed exact", "flat-literal exact").verdict, Verdict::kByDesign);
  EXPECT_EQ(pairOf(report, "flat-7-printed exact", "flat-7-printed rk4").verdict, Verdict::kInside);
  EXPECT_GT(pairOf(report, "matrix exact", "flat-7-printed exact").relative, 0.05);
}

// One sample a second and a half sees no peak: the sizes must not be read from those samples.
TEST(Validate, FewSamplesDoNotNarrowWhatIsExpected) {
  Scenario scenario = shortScenario(3.0);
  scenario.run.output_step = 1.5;
  const ValidationReport paper = validate(test::paperVehicle(), scenario);
  EXPECT_TRUE(paper.inside()) << outsideOf(paper);
  ValidationChoice matrix;
  matrix.forms = {"matrix"};
  matrix.methods = {"rk4", "dopri5"};
  const ValidationReport contact = validate(test::contactVehicle(), scenario, matrix);
  EXPECT_TRUE(contact.inside()) << outsideOf(contact);
  EXPECT_LT(pairOf(paper, "matrix exact", "flat rk4").expected.value_or(1.0), 1e-6);
}

TEST(Validate, WhatDoesNotFitIsListedWithItsReason) {
  const ValidationReport report = validate(test::bogiePitchVehicle(), shortScenario(1.0));
  const auto names = [&](const std::string& form, const std::string& method) {
    return std::any_of(report.unsupported.begin(), report.unsupported.end(), [&](const Unsupported& unsupported) {
      return unsupported.form == form && unsupported.method == method && !unsupported.reason.empty();
    });
  };
  EXPECT_TRUE(names("flat", ""));
  EXPECT_TRUE(names("mbs", "exact"));
  EXPECT_TRUE(names("matrix", "simbody_rkm"));
}

TEST(Validate, AStepThatDoesNotResolveTheContactIsShortenedAndSaysSo) {
  ValidationChoice choice;
  choice.run.step = 20e-3;
  choice.forms = {"matrix"};
  choice.methods = {"rk4"};
  const ValidationReport report = validate(test::contactVehicle(), shortScenario(1.0), choice);
  EXPECT_TRUE(report.inside()) << outsideOf(report);
  ASSERT_EQ(report.notes.size(), 1u);
  EXPECT_NE(report.notes[0].find("instead of 20 ms"), std::string::npos) << report.notes[0];
  for (const ValidationRun& run : report.runs) {
    if (run.key.refine != 2) continue;
    ASSERT_TRUE(run.order.has_value());
    // The fastest mode loses up to 1/20 of itself: its error's next terms are of that size, 0.1 of an order.
    EXPECT_WITHIN(*run.order, 4.0, 0.3);
  }
}

TEST(Validate, AFormThatNoChosenMethodRunsIsRunByItsOwnAndSaysSo) {
  ValidationChoice choice;
  choice.forms = {"flat", "mbs"};
  choice.methods = {"exact"};
  const ValidationReport report = validate(test::paperVehicle(), shortScenario(1.0), choice);
  EXPECT_TRUE(report.inside()) << outsideOf(report);
  EXPECT_NO_THROW(static_cast<void>(pairOf(report, "matrix exact", "mbs dopri5")));
  ASSERT_EQ(report.notes.size(), 1u);
}

TEST(Validate, AReportWithoutAnyPairIsNotInside) {
  EXPECT_FALSE(ValidationReport().inside());
  ValidationChoice choice;
  choice.forms = {"matrix"};
  choice.methods = {"exact"};
  EXPECT_FALSE(validate(test::paperVehicle(), shortScenario(1.0), choice).inside());
}

TEST(Validate, AnUnknownFormOrMethodIsNamedBack) {
  ValidationChoice choice;
  choice.forms = {"flta"};
  EXPECT_THROW(static_cast<void>(validate(test::paperVehicle(), shortScenario(1.0), choice)), std::invalid_argument);
  choice.forms = {};
  choice.methods = {"rk5"};
  EXPECT_THROW(static_cast<void>(validate(test::paperVehicle(), shortScenario(1.0), choice)), std::invalid_argument);
}

TEST(Validate, EndsEarlyWhenAsked) {
  int calls = 0;
  const ValidationReport report =
      validate(test::paperVehicle(), shortScenario(1.0), {}, [&](double, const std::string&) { return ++calls < 4; });
  EXPECT_TRUE(report.stopped);
  EXPECT_FALSE(report.inside());
}

TEST(Validate, HistoriesThatWouldNotFitInMemoryAreRefusedBeforeTheyAreMade) {
  Scenario scenario = shortScenario(100.0);
  scenario.run.output_step = 1e-4;
  EXPECT_THROW(static_cast<void>(validate(test::paperVehicle(), scenario)), std::invalid_argument);
}

TEST(CasesOf, CrossesVehiclesScenariosAndSpeeds) {
  Suite suite;
  suite.vehicles.resize(2);
  suite.scenarios.resize(3);
  EXPECT_EQ(casesOf(suite).size(), 6u);
  EXPECT_FALSE(casesOf(suite)[0].speed.has_value());
  suite.speeds.resize(1);
  suite.speeds[0].from = 10.0;
  suite.speeds[0].to = 40.0;
  suite.speeds[0].count = 4;
  const std::vector<ValidationCase> cases = casesOf(suite);
  ASSERT_EQ(cases.size(), 24u);
  EXPECT_EQ(*cases[1].speed, 20.0);
  EXPECT_EQ(cases[23].vehicle, 1u);
  EXPECT_EQ(cases[23].scenario, 2u);
}

TEST(ChoiceOf, TakesTheSuitesNamesUnlessSomeAreChosen) {
  Suite suite;
  suite.forms = {{"flat", {}}};
  suite.methods = {{"rk4", {}}};
  EXPECT_EQ(choiceOf(suite).forms, std::vector<std::string>{"flat"});
  ValidationChoice own;
  own.forms = {"mbs"};
  EXPECT_EQ(choiceOf(suite, own).forms, std::vector<std::string>{"mbs"});
  EXPECT_EQ(choiceOf(suite, own).methods, std::vector<std::string>{"rk4"});
}

}  // namespace
}  // namespace vehicle
