#include "libvehicle/study/search/search_study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "libvehicle/study/compare/verdict.h"
#include "tests/study/hypervolume.h"
#include "tests/study/inputs.h"
#include "tests/support/test_folder.h"

namespace vehicle {
namespace {

using namespace test;

/// Comfort against room: the carbody's acceleration and the secondary's deflection in the steady state.
StudyInputs comfortAgainstRoom() {
  Study study = studyOf(
      {range("secondary.stiffness_z", "0.5 MN/m", "4 MN/m"), range("secondary.damping_z", "20 kN*s/m", "400 kN*s/m")},
      {"carbody.az.rms", "secondary_front.deflection.rms"});
  study.evaluation = Evaluation::kSteadyState;
  study.search.emplace();
  study.search->population = 16;
  study.search->generations = 12;
  for (const char* metric : {"carbody.az.rms", "secondary_front.deflection.rms"}) {
    Objective objective;
    objective.metric = metric;
    study.objectives.push_back(objective);
  }
  return inputsOf(study, paperVehicle(), {paperScenario(History::kExtended)});
}

DesignPlan planOf(const StudyInputs& inputs) { return DesignPlan::of(inputs.study, inputs.bound).orThrow(); }

StudyTarget targetIn(const TestFolder& folder, const char* name, bool resume = false) {
  return {folder.path(name), resume, "vehicle test", {{"study.xml", "the study\n"}}};
}

std::string tableOf(const std::filesystem::path& database) {
  const std::string csv = database.string() + ".csv";
  StudyDatabase::read(database).writeCsv(csv);
  return textOf(csv);
}

/// Values of both parameters over their ranges, n + 1 each.
std::vector<std::vector<double>> gridOf(int n) {
  std::vector<std::vector<double>> grid;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) grid.push_back({0.5e6 + i * 3.5e6 / n, 20e3 + j * 380e3 / n});
  }
  return grid;
}

TEST(SearchStudy, KeepsEveryDesignThatItEvaluates) {
  const TestFolder folder;
  const StudyInputs inputs = comfortAgainstRoom();
  const DesignPlan plan = planOf(inputs);
  const SearchNumbers numbers(plan, *inputs.study.search);
  EXPECT_EQ(numbers.size(), 1u + 13u * 16u);
  EXPECT_EQ(numbers.nameOf(numbers.firstOf(3) + 7), "generation 3 #7");

  ThreadExecutor executor(2);
  const StudyTarget target = targetIn(folder, "whole.sqlite");
  const StudyOutcome outcome = searchStudy(inputs, plan, target, executor);
  EXPECT_EQ(outcome.ending, Ending::kFinished);
  EXPECT_EQ(outcome.progress.evaluated, numbers.size());
  EXPECT_EQ(outcome.progress.failed, 0u);
  EXPECT_EQ(StudyDatabase::read(target.database).stored(), numbers.size());
}

// A fine grid over the same two parameters knows the front to its own spacing: the search's front may lie above it by
// what 208 designs leave open and below it by what the grid does, both well under 5 % of the area.
TEST(SearchStudy, ComesToTheFrontThatAFineGridShows) {
  const TestFolder folder;
  const StudyInputs inputs = comfortAgainstRoom();
  const DesignPlan plan = planOf(inputs);
  ThreadExecutor executor(1);
  const StudyTarget target = targetIn(folder, "front.sqlite");
  searchStudy(inputs, plan, target, executor);
  std::vector<double> searched;
  const Verdict verdict(inputs.bound);
  StudyDatabase::read(target.database).forEach([&](const StoredDesign& design) {
    if (design.id == 0) return true;  // the base lies where it lies
    for (const double value : verdict.toMinimise(design.metrics)) searched.push_back(value);
    return true;
  });

  std::vector<double> gridded;
  std::pair<double, double> worst{0.0, 0.0};
  for (const std::vector<double>& row : answersOf(inputs, gridOf(60)).metrics) {
    gridded.insert(gridded.end(), row.begin(), row.end());
    worst = {std::max(worst.first, row[0]), std::max(worst.second, row[1])};
  }
  const double known = hypervolume(gridded, worst);
  EXPECT_GT(hypervolume(searched, worst), 0.95 * known);
  EXPECT_LT(hypervolume(searched, worst), 1.05 * known);
}

TEST(SearchStudy, InterruptedAndResumedItGivesTheTableOfAnUninterruptedRun) {
  const TestFolder folder;
  const StudyInputs inputs = comfortAgainstRoom();
  const DesignPlan plan = planOf(inputs);
  ThreadExecutor one(1);
  const StudyTarget whole = targetIn(folder, "whole.sqlite");
  searchStudy(inputs, plan, whole, one);

  ThreadExecutor two(2);
  std::uint64_t last = 0;
  for (const std::uint64_t stop_after : {1u, 40u, 100u, 101u}) {
    const StudyTarget part = targetIn(folder, "part.sqlite", true);
    const StudyOutcome outcome = searchStudy(inputs, plan, part, two, [&](const StudyProgress& progress) {
      return progress.before + progress.evaluated < stop_after;
    });
    EXPECT_EQ(outcome.ending, Ending::kStopped);
    EXPECT_GE(StudyDatabase::read(part.database).stored(), last);
    last = StudyDatabase::read(part.database).stored();
    EXPECT_LT(last, plan.size() + 13u * 16u);
  }
  const StudyTarget part = targetIn(folder, "part.sqlite", true);
  EXPECT_EQ(searchStudy(inputs, plan, part, two).ending, Ending::kFinished);
  EXPECT_EQ(tableOf(part.database), tableOf(whole.database));
}

TEST(SearchStudy, TheLastGenerationsKeepTheLimits) {
  const TestFolder folder;
  StudyInputs inputs = comfortAgainstRoom();
  std::vector<double> deflections;
  for (const std::vector<double>& row : answersOf(inputs, gridOf(10)).metrics) deflections.push_back(row[1]);
  std::nth_element(deflections.begin(), deflections.begin() + 60, deflections.end());
  const std::string median = std::to_string(1e3 * deflections[60]) + " mm";  // about half of all designs go beyond it
  inputs.study.limits.push_back({"secondary_front.deflection.rms", median, "", {}});
  inputs = inputsOf(inputs.study, inputs.vehicle, inputs.scenarios);
  const DesignPlan plan = planOf(inputs);
  ThreadExecutor executor(1);
  const StudyTarget target = targetIn(folder, "limited.sqlite");
  searchStudy(inputs, plan, target, executor);
  const Verdict verdict(inputs.bound);
  const SearchNumbers numbers(plan, *inputs.study.search);
  int beyond_at_first = 0;
  int beyond_at_last = 0;
  StudyDatabase::read(target.database).forEach([&](const StoredDesign& design) {
    const bool beyond = !verdict.keepsLimits(design.metrics);
    if (design.id >= numbers.firstOf(0) && design.id < numbers.firstOf(1)) beyond_at_first += beyond;
    if (design.id >= numbers.firstOf(12)) beyond_at_last += beyond;
    return true;
  });
  EXPECT_GT(beyond_at_first, 2);  // else the limit means nothing here
  // Children are made by crossing and mutation, so some try the other side; most come from parents that keep it.
  EXPECT_LE(2 * beyond_at_last, beyond_at_first + 4);
}

// Carbody pitch stops oscillating on soft springs with strong dampers: a design that lacks an objective is the worst,
// so the search leaves that corner and finds no front there.
TEST(SearchStudy, ADesignThatLacksAnObjectiveIsWorseThanAllThatHaveIt) {
  const TestFolder folder;
  Study study = studyOf(
      {range("secondary.stiffness_z", "0.3 MN/m", "6 MN/m"), range("secondary.damping_z", "50 kN*s/m", "150 kN*s/m")},
      {"carbody.az.rms", "mode.carbody pitch.frequency"});
  study.evaluation = Evaluation::kSteadyState;
  study.search.emplace();
  study.search->population = 16;
  study.search->generations = 8;
  for (const char* metric : {"carbody.az.rms", "mode.carbody pitch.frequency"}) {
    Objective objective;
    objective.metric = metric;
    study.objectives.push_back(objective);
  }
  const StudyInputs inputs = inputsOf(study, paperVehicle(), {paperScenario(History::kExtended)});
  const DesignPlan plan = planOf(inputs);
  ThreadExecutor executor(2);
  EXPECT_EQ(searchStudy(inputs, plan, targetIn(folder, "search"), executor).progress.failed, 0u);
  const SearchNumbers numbers(plan, *study.search);
  int first = 0;
  int last = 0;
  StudyDatabase::read(folder.path("search")).forEach([&](const StoredDesign& design) {
    if (!std::isnan(design.metrics[1])) return true;
    first += design.id >= numbers.firstOf(0) && design.id < numbers.firstOf(1) ? 1 : 0;
    last += design.id >= numbers.firstOf(8) ? 1 : 0;
    return true;
  });
  EXPECT_GT(first, 2);  // of the random start
  EXPECT_LT(last, first);
}

TEST(SearchStudy, RefusesToGoOnFromPointsThatAreNotItsOwn) {
  const TestFolder folder;
  const StudyInputs inputs = comfortAgainstRoom();
  const DesignPlan plan = planOf(inputs);
  const StudyTarget target = targetIn(folder, "other.sqlite", true);
  {
    StudyDatabase database = StudyDatabase::create(target.database, searchRecordOf(plan, *inputs.study.search, target));
    DesignBatch batch(2, 2);
    const double parameters[] = {1e6, 50e3};
    const double metrics[] = {0.1, 0.001};
    batch.add(plan.size(), parameters, metrics);
    database.append(batch);
  }
  ThreadExecutor executor(1);
  try {
    searchStudy(inputs, plan, target, executor);
    FAIL() << "went on";
  } catch (const RunFailed& failure) {
    EXPECT_STREQ(
        failure.what(),
        "design generation 0 #0 of the database is not the one that this search comes to; it was written with another "
        "version of the search library: start anew in another file");
  }
}

}  // namespace
}  // namespace vehicle
