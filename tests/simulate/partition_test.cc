// Vehicles and trains on a team of threads: the bits of the serial run of the same form, for every scheme, map and
// number of threads, kinks of the onset included.
#include <string>
#include <vector>

#include "libvehicle/definition/train.h"
#include "libvehicle/excitation/excitation.h"
#include "libvehicle/flat/flat_train.h"
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

  RecordedRun serial(Scheme scheme) const {
    return record([&](const Observer& observe) {
      if (scheme == Scheme::kRows) return runExact(*system, input, schedule, rest, observe);
      const auto* flat = dynamic_cast<const FlatForm*>(system.get());
      return flat != nullptr ? runFlatRk4(*flat, input, schedule, kStep, rest, observe)
                             : runRk4(*system, input, schedule, kStep, rest, observe);
    });
  }
  RecordedRun shared(Scheme scheme, EquationMap map, int threads, std::function<void(int, long)> disturb = {}) const {
    PartitionChoice choice{.scheme = scheme, .map = map, .team = {}};
    choice.team.threads = threads;
    choice.team.disturb = std::move(disturb);
    return record([&](const Observer& observe) {
      return runPartitioned(*system, input, schedule, kStep, rest, observe, choice).statistics;
    });
  }
  RecordedRun stagesByType(EquationMap map, int threads, std::function<void(int, long)> disturb = {}) const {
    PartitionChoice choice{.scheme = Scheme::kStages, .map = map, .team = {}};
    choice.team.threads = threads;
    choice.team.disturb = std::move(disturb);
    return record([&](const Observer& observe) {
      return runFlatStages(dynamic_cast<const FlatForm&>(*system), input, schedule, kStep, rest, observe, choice)
          .statistics;
    });
  }
};

Problem flatProblem(const Vehicle& vehicle, History history, double duration = 1.0, double speed = 20.0) {
  return Problem(vehicle, buildFlatForm(compile(vehicle, kGravity)), history, duration, speed);
}

struct Way {
  Scheme scheme;
  EquationMap map;
  int threads;
};

std::vector<Way> waysOfAVehicle() {
  std::vector<Way> ways = {{Scheme::kSerial, EquationMap::kAuto, 1}};
  for (const Scheme scheme : {Scheme::kStages, Scheme::kHalo, Scheme::kRows}) {
    for (int threads = 1; threads <= 4; ++threads) ways.push_back({scheme, EquationMap::kAuto, threads});
    for (int threads = 1; threads <= 3; ++threads) ways.push_back({scheme, EquationMap::kBody, threads});
    ways.push_back({scheme, EquationMap::kPaper, 4});
  }
  for (int threads = 1; threads <= 4; ++threads) ways.push_back({Scheme::kPipeline, EquationMap::kAuto, threads});
  return ways;
}

void expectSerialBits(const Problem& problem, const std::vector<Way>& ways,
                      const std::function<void(int, long)>& disturb = {}) {
  const RecordedRun rk4 = problem.serial(Scheme::kStages);
  const RecordedRun exact = problem.serial(Scheme::kRows);
  for (const Way& way : ways) {
    SCOPED_TRACE(std::string(nameOf(way.scheme)) + " " + nameOf(way.map) + " " + std::to_string(way.threads));
    const Watchdog watchdog;
    expectSameBits(problem.shared(way.scheme, way.map, way.threads, disturb),
                   way.scheme == Scheme::kRows ? exact : rk4);
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
                     {{Scheme::kStages, EquationMap::kPaper, 4},
                      {Scheme::kStages, EquationMap::kAuto, 2},
                      {Scheme::kHalo, EquationMap::kBody, 3},
                      {Scheme::kRows, EquationMap::kAuto, 4}},
                     randomDelays(seed));
  }
}

void expectSerialBitsByType(const Problem& problem, const std::function<void(int, long)>& disturb = {}) {
  const RecordedRun serial = problem.serial(Scheme::kStages);
  const auto expectSame = [&](EquationMap map, int threads) {
    SCOPED_TRACE(std::string("by type, ") + nameOf(map) + " " + std::to_string(threads));
    const Watchdog watchdog;
    expectSameBits(problem.stagesByType(map, threads, disturb), serial);
  };
  for (int threads = 1; threads <= 4; ++threads) expectSame(EquationMap::kAuto, threads);
  for (int threads = 1; threads <= 3; ++threads) expectSame(EquationMap::kBody, threads);
  expectSame(EquationMap::kPaper, 4);
}

TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunWithTheEquationsByType) {
  expectSerialBitsByType(flatProblem(paperVehicle(), History::kOnset));
  expectSerialBitsByType(flatProblem(paperVehicle(), History::kExtended));
  expectSerialBitsByType(flatProblem(asymmetricVehicle(), History::kOnset));
}

TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunByTypeUnderRandomDelays) {
  const Problem problem = flatProblem(asymmetricVehicle(), History::kOnset, 0.5);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) expectSerialBitsByType(problem, randomDelays(seed));
}

// The speeds of the reference sweep; other speeds are other kinks and other step lengths.
TEST(PartitionedVehicle, GivesTheBitsOfTheSerialRunFrom20To150KilometresAnHour) {
  for (int kmh = 20; kmh <= 150; kmh += 10) {
    SCOPED_TRACE(kmh);
    expectSerialBits(flatProblem(paperVehicle(), History::kOnset, 0.7, kmh / 3.6),
                     {{Scheme::kStages, EquationMap::kPaper, 4},
                      {Scheme::kHalo, EquationMap::kAuto, 2},
                      {Scheme::kRows, EquationMap::kAuto, 2},
                      {Scheme::kPipeline, EquationMap::kAuto, 2}});
    const Problem problem = flatProblem(paperVehicle(), History::kOnset, 0.7, kmh / 3.6);
    expectSameBits(problem.stagesByType(EquationMap::kBody, 2), problem.serial(Scheme::kStages));
  }
}

TEST(PartitionedTrain, GivesTheBitsOfTheSerialRunForOneToSixteenThreads) {
  const Vehicle train = assembled(equalTrain(paperVehicle(), 17, 12.0));
  const Problem problem(train, buildFlatTrain(compile(train, kGravity)), History::kOnset, 0.5);
  std::vector<Way> ways = {{Scheme::kSerial, EquationMap::kAuto, 1}};
  for (int threads = 1; threads <= 16; ++threads) ways.push_back({Scheme::kHalo, EquationMap::kAuto, threads});
  for (const int threads : {2, 5, 16}) {
    ways.push_back({Scheme::kHalo, EquationMap::kBody, threads});
    ways.push_back({Scheme::kStages, EquationMap::kAuto, threads});
    ways.push_back({Scheme::kStages, EquationMap::kBody, threads});
  }
  ways.push_back({Scheme::kPipeline, EquationMap::kAuto, 2});
  expectSerialBits(problem, ways);
}

TEST(PartitionedTrain, GivesTheBitsOfTheSerialRunWhereNothingIsEqual) {
  const Vehicle train = assembled(mixedTrain());
  const Problem problem(train, buildFlatTrain(compile(train, kGravity)), History::kOnset, 0.5);
  std::vector<Way> ways;
  for (const Scheme scheme : {Scheme::kStages, Scheme::kHalo, Scheme::kRows}) {
    for (int threads = 1; threads <= 12; ++threads) ways.push_back({scheme, EquationMap::kAuto, threads});
  }
  expectSerialBits(problem, ways);
}

}  // namespace
}  // namespace vehicle::test
