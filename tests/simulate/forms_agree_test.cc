// Form against form: the same physics written three times must give the same numbers.

#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/matrix/matrix_form.h"
#include "libvehicle/mbs/mbs_form.h"
#include "libvehicle/simulate/flat_by_type.h"
#include "tests/simulate/histories.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle::test {
namespace {

// Largest difference of the rates of two forms at random states of the size of a run, as a share of the largest
// rate of that kind at that state.
double rateDifference(const System& one, const System& other) {
  std::mt19937_64 generator(20170101);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto n = static_cast<std::size_t>(one.size());
  const auto w = static_cast<std::size_t>(one.channels());
  std::vector<double> x(n), u(2 * w), dx(n), dy(n);
  double worst = 0.0;
  for (int state = 0; state < 1000; ++state) {
    for (std::size_t i = 0; i < n; ++i) x[i] = (i < n / 2 ? 5e-3 : 0.1) * unit(generator);
    for (std::size_t i = 0; i < 2 * w; ++i) u[i] = (i < w ? 5e-3 : 0.1) * unit(generator);
    one.derivative(x, u, dx);
    other.derivative(x, u, dy);
    double largest = 0.0;
    double difference = 0.0;
    for (std::size_t i = n / 2; i < n; ++i) {
      largest = std::max(largest, std::abs(dx[i]));
      difference = std::max(difference, std::abs(dx[i] - dy[i]));
    }
    worst = std::max(worst, difference / largest);
  }
  return worst;
}

// Some twenty products and sums of equal size: 1e-15 each way. A wrong coefficient shows as 1e-3 and more.
constexpr double kSameEquations = 1e-14;

TEST(MbsLinear, HasTheFlatFormsRightHandSideAtRandomStates) {
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle(), heightsVehicle()}) {
    EXPECT_WITHIN(
        rateDifference(*buildFlatForm(compile(vehicle, 9.81)), *buildMbsForm(compile(vehicle, 9.81), MbsLaw::kLinear)),
        0.0, kSameEquations)
        << vehicle.name;
  }
}

TEST(MbsLinear, HasTheMatrixFormsRightHandSideForEveryTopology) {
  for (const Vehicle& vehicle :
       {paperVehicle(), asymmetricVehicle(), bogiePitchVehicle(), asymmetricBogiePitchVehicle(), contactVehicle(),
        hertzVehicle(), heightsVehicle(), bogiePitchHeightsVehicle(), assembled(mixedTrain()),
        assembled(equalTrain(contactVehicle(), 2, 26.0))}) {
    EXPECT_WITHIN(rateDifference(*buildMatrixForm(compile(vehicle, 9.81)),
                                 *buildMbsForm(compile(vehicle, 9.81), MbsLaw::kLinear)),
                  0.0, kSameEquations)
        << vehicle.name;
  }
}

TEST(MbsLinear, HasTheFlatFormsRightHandSideForTrains) {
  for (const Train& train :
       {mixedTrain(), equalTrain(paperVehicle(), 4, 16.0), equalTrain(heightsVehicle(), 2, 16.0)}) {
    const Vehicle vehicle = assembled(train);
    EXPECT_WITHIN(
        rateDifference(*buildFlatTrain(compile(vehicle, 9.81)), *buildMbsForm(compile(vehicle, 9.81), MbsLaw::kLinear)),
        0.0, kSameEquations)
        << train.name;
  }
}

TEST(FlatForm, EqualsTheMatrixFormForAsymmetricVehicles) {
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle(), heightsVehicle()}) {
    EXPECT_WITHIN(rateDifference(*buildFlatForm(compile(vehicle, 9.81)), *buildMatrixForm(compile(vehicle, 9.81))), 0.0,
                  kSameEquations)
        << vehicle.name;
  }
}

// The same stepper on both sides: what is left is the rounding of 10 000 steps of a damped system, which
// forgets; the system's memory is about 1 s, a thousand steps.
TEST(MbsLinear, WithTheSameRk4EqualsTheFlatFormOverTenSeconds) {
  for (const History history : {History::kOnset, History::kExtended}) {
    const Scenario scenario = paperScenario(history);
    EXPECT_WITHIN(historyError(run(paperVehicle(), scenario, "mbs-linear", "rk4").history,
                               run(paperVehicle(), scenario, "flat", "rk4").history), 0.0, 1e-13);
  }
}

// Simbody's accuracy is a norm over unit-scale states: 1e-12 there is 1e-10 of a millimetre-sized motion.
TEST(SimbodyIntegrator, AtTightAccuracyIsWithinABillionthOfExact) {
  RunChoice choice;
  choice.accuracy = 1e-12;
  for (const History history : {History::kOnset, History::kExtended}) {
    const Scenario scenario = paperScenario(history);
    EXPECT_WITHIN(historyError(run(paperVehicle(), scenario, "mbs-linear", "simbody_rkm", choice).history,
                               run(paperVehicle(), scenario, "flat", "exact").history), 0.0, 1e-9);
  }
}

// All states at all samples of a run, in one row.
std::vector<double> statesOf(const std::function<Statistics(const Observer&)>& run) {
  std::vector<double> states;
  run([&](int, int, double, std::span<const double> x) {
    states.insert(states.end(), x.begin(), x.end());
    return true;
  });
  return states;
}

// The stepper gets the equations by type or by a virtual call, parts in the equations' or in the file's order:
// the same sums in the same order all the same. (The r.m.s. norm of dopri5 adds states in the order they stand in,
// so an order of the file other than the equations' may change a step size in the last bit.)
TEST(FlatByType, GivesTheBitsOfTheVirtualRun) {
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle()}) {
    const Scenario scenario = paperScenario(History::kOnset);
    const std::unique_ptr<FlatForm> form = buildFlatForm(compile(vehicle, 9.81));
    const Input input = inputOf(scenario, topologyOf(vehicle), 20.0);
    const Schedule schedule(input, 5e-3);
    const std::vector<double> x0(8, 0.0);
    EXPECT_EQ(statesOf([&](const Observer& o) {
                return makeFlatRk4({*form, input, schedule, x0}, {})->run(schedule, x0, o);
              }),
              statesOf([&](const Observer& o) {
                return runRk4({*form, input, schedule, x0}, {}, o);
              }))
        << vehicle.name;
  }
  const std::unique_ptr<FlatForm> form = buildFlatForm(compile(paperVehicle(), 9.81));
  const Input input = inputOf(paperScenario(History::kOnset), topologyOf(paperVehicle()), 20.0);
  const Schedule schedule(input, 5e-3);
  const std::vector<double> x0(8, 0.0);
  EXPECT_EQ(statesOf([&](const Observer& o) {
              return makeFlatDopri5({*form, input, schedule, x0}, {})->run(schedule, x0, o);
            }),
            statesOf([&](const Observer& o) {
              return runDopri5({*form, input, schedule, x0}, {}, o);
            }));
}

Scenario scaled(Scenario scenario, double factor) {
  for (Harmonic& each : scenario.track->harmonics) each.amplitude *= factor;
  return scenario;
}

// True rotation against linear kinematics, both integrated to 1e-11: what is left is geometry, third order in the
// motion, so its share of the motion grows with the square of the amplitude.
double geometricDifference(double factor) {
  RunChoice choice;
  choice.step = 1e-3;
  Scenario scenario = scaled(paperScenario(History::kExtended), factor);
  scenario.run.duration = 4.0;
  return historyError(run(paperVehicle(), scenario, "mbs", "rk4", choice).history,
                      run(paperVehicle(), scenario, "mbs-linear", "rk4", choice).history);
}

TEST(Mbs, IsWithinAMillionthOfTheLinearFormsAtThePapersAmplitude) {
  EXPECT_WITHIN(geometricDifference(1.0), 0.0, 1e-6);
}

TEST(Mbs, DiffersFromTheLinearFormsByAmplitudeSquared) {
  const double slope = std::log10(geometricDifference(100.0) / geometricDifference(1.0)) / 2.0;
  EXPECT_GT(slope, 1.95);
  EXPECT_LT(slope, 2.05);
}

// Central differences of the true multibody accelerations about rest: error ~ scale^2 of geometry (1e-10) and
// 1e-16/scale of rounding (1e-11), against entries of order 1e2.
TEST(Mbs, DifferencedAboutRestGivesTheMatrixFormsAWithAttachmentsBelowTheCentreOfGravity) {
  for (const Vehicle& vehicle :
       {heightsVehicle(), bogiePitchHeightsVehicle(), withHeights(asymmetricBogiePitchVehicle(), 0.5), paperVehicle(),
        withHeights(contactVehicle(), 0.3)}) {
    const std::unique_ptr<MbsForm> mbs = buildMbsForm(compile(vehicle, 9.81), MbsLaw::kTrue);
    const std::vector<double> x0(static_cast<std::size_t>(mbs->size()), 0.0);
    const std::vector<double> u0(2 * static_cast<std::size_t>(mbs->channels()), 0.0);
    const StateSpace differenced = differencedStateSpace(*mbs, x0, u0, 1e-5);
    const StateSpace assembled = *buildMatrixForm(compile(vehicle, 9.81))->linear();
    for (Eigen::Index row = 0; row < assembled.A.rows(); ++row) {
      const double scale = assembled.A.row(row).cwiseAbs().maxCoeff();
      EXPECT_WITHIN((differenced.A - assembled.A).row(row).cwiseAbs().maxCoeff() / scale, 0.0, 1e-6)
          << vehicle.name << " row " << row;
    }
  }
}

// Without the static-load term the same comparison must fail, or it would prove nothing.
TEST(Mbs, DifferencedAboutRestSeesTheStaticLoadTerm) {
  const StateSpace with = *buildMatrixForm(compile(heightsVehicle(), 9.81))->linear();
  const StateSpace without = *buildMatrixForm(compile(paperVehicle(), 9.81))->linear();
  // k_g / Jk = - mk g h / Jk = - 57e3 * 9.81 * 0.5 / 70e3
  EXPECT_WITHIN(with.A(5, 1) - without.A(5, 1), 57e3 * 9.81 * 0.5 / 70e3, 1e-11);
}

}  // namespace
}  // namespace vehicle::test
