// Vehicles and trains on a team of threads: the bits of the serial run of the same form, for every scheme, map and
// number of threads, breakpoints of the onset included.
#include <string>
#include <vector>

#include "libvehicle/definition/train.h"
#include "libvehicle/excitation/excitation.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/model/topology.h"
#include "libvehicle/partition/schemes/blocked_rk4.h"
#include "libvehicle/simulate/flat_by_type.h"
#include "tests/support/delays.h"
#include "tests/support/recorded_run.h"
#include "tests/support/trains.h"
#include "tests/support/vehicles.h"
#include "tests/support/watchdog.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;
constexpr FixedStep kStep{.step = 1e-3, .refine = 1};

struct Problem {
  std::unique_ptr<System> system;
  Input input;
  Schedule schedule;
  std::vector<double> rest;

  Problem(const Vehicle& vehicle, std::unique_ptr<System> form, History history, double duration, double speed = 20.0)
      : system(std::move(form)),
        input(inputOf(scenarioOf(history, duration), topologyOf(vehicle), speed)),
        schedule(input, 5e-3),
        rest(static_cast<std::size_t>(system->size()), 0.0) {}

  static Scenario scenarioOf(History history, double duration) {
    Scenario scenario = paperScenario(history);
    scenario.run.duration = duration;
    return scenario;
  }

  [[nodiscard]] RunProblem problem() const { return {*system, input, schedule, rest}; }
  RecordedRun serial() const {
    return record([&](const Observer& observe) {
      return dynamic_cast<const FlatForm*>(system.get()) != nullptr
                 ? makeFlatRk4(problem(), kStep)->run(schedule, rest, observe)
                 : runRk4({*system, input, schedule, rest}, kStep, observe);
    });
  }
  RecordedRun shared(const Sharing& sharing, std::function<void(int, long)> injectDelay = {}) const {
    TeamPolicy team;
    team.injectDelay = std::move(injectDelay);
    return record(
        [&](const Observer& observe) { return runPartitioned(problem(), kStep, observe, sharing, team).statistics; });
  }
};

Problem flatProblem(const Vehicle& vehicle, History history, double duration = 1.0, double speed = 20.0) {
  return Problem(vehicle, buildFlatForm(compile(vehicle, kGravity)), history, duration, speed);
}

std::vector<Sharing> waysOfAVehicle() {
  std::vector<Sharing> ways = {{1, Scheme::kSerial, EquationMap::kAuto}};
  for (const Scheme scheme : {Scheme::kStages, Scheme::kHalo}) {
    for (int threads = 1; threads <= 4; ++threads) ways.push_back({threads, scheme, EquationMap::kAuto});
    for (int threads = 1; threads <= 3; ++threads) ways.push_back({threads, scheme, EquationMap::kBody});
    ways.push_back({4, scheme, EquationMap::kPaper});
  }
  for (int threads = 1; threads <= 4; ++threads) ways.push_back({threads, Scheme::kPipeline, EquationMap::kAuto});
  return ways;
}

void expectSerialBits(const Problem& problem, const std::vector<Sharing>& ways,
                      const std::function<void(int, long)>& injectDelay = {}) {
  const RecordedRun serial = problem.serial();
  for (const Sharing& way : ways) {
    SCOPED_TRACE(std::string(nameOf(*way.scheme)) + " " + nameOf(way.map) + " " + std::to_string(way.threads));
    const Watchdog watchdog;
    expectSameBits(problem.shared(way, injectDelay), serial);
  }
}

TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunOnThePapersOnset) {
  expectSerialBits(flatProblem(paperVehicle(), History::kOnset), waysOfAVehicle());
}

TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunOnTheExtendedRail) {
  expectSerialBits(flatProblem(paperVehicle(), History::kExtended), waysOfAVehicle());
}

TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunWhereNothingIsSymmetric) {
  expectSerialBits(flatProblem(asymmetricVehicle(), History::kOnset), waysOfAVehicle());
}

TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunUnderRandomDelays) {
  const Problem problem = flatProblem(paperVehicle(), History::kOnset, 0.6);
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    expectSerialBits(problem,
                     {{4, Scheme::kStages, EquationMap::kPaper},
                      {2, Scheme::kStages, EquationMap::kBody},
                      {2, Scheme::kStages, EquationMap::kAuto},
                      {3, Scheme::kHalo, EquationMap::kBody}},
                     randomDelays(seed));
  }
}

// The speeds of the reference sweep; other speeds are other breakpoints and other step lengths.
TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunFrom20To150KilometresAnHour) {
  for (int kmh = 20; kmh <= 150; kmh += 10) {
    SCOPED_TRACE(kmh);
    expectSerialBits(flatProblem(paperVehicle(), History::kOnset, 0.7, kmh / 3.6),
                     {{4, Scheme::kStages, EquationMap::kPaper},
                      {2, Scheme::kStages, EquationMap::kBody},
                      {2, Scheme::kHalo, EquationMap::kAuto},
                      {2, Scheme::kPipeline, EquationMap::kAuto}});
  }
}

TEST(PartitionedTrain, GivesTheBitsOfTheSerialRunForOneToSixteenThreads) {
  const Vehicle train = assembled(equalTrain(paperVehicle(), 17, 12.0));
  const Problem problem(train, buildFlatTrain(compile(train, kGravity)), History::kOnset, 0.5);
  std::vector<Sharing> ways = {{1, Scheme::kSerial, EquationMap::kAuto}};
  for (int threads = 1; threads <= 16; ++threads) ways.push_back({threads, Scheme::kHalo, EquationMap::kAuto});
  for (const int threads : {2, 5, 16}) {
    ways.push_back({threads, Scheme::kHalo, EquationMap::kBody});
    ways.push_back({threads, Scheme::kStages, EquationMap::kAuto});
    ways.push_back({threads, Scheme::kStages, EquationMap::kBody});
  }
  ways.push_back({2, Scheme::kPipeline, EquationMap::kAuto});
  expectSerialBits(problem, ways);
}

TEST(PartitionedTrain, GivesTheBitsOfTheSerialRunWhereNothingIsEqual) {
  const Vehicle train = assembled(mixedTrain());
  const Problem problem(train, buildFlatTrain(compile(train, kGravity)), History::kOnset, 0.5);
  std::vector<Sharing> ways;
  for (const Scheme scheme : {Scheme::kStages, Scheme::kHalo}) {
    for (int threads = 1; threads <= 12; ++threads) ways.push_back({threads, scheme, EquationMap::kAuto});
  }
  expectSerialBits(problem, ways);
}

}  // namespace
}  // namespace vehicle::test
