#include "libvehicle/study/runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "libvehicle/study/compare/sensitivity.h"
#include "libvehicle/study/summary.h"
#include "tests/study/evaluators.h"
#include "tests/study/inputs.h"
#include "tests/support/test_folder.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

using namespace test;

Study sobolStudy(int size, std::uint64_t seed = 1) {
  Study study = studyOf({range("secondary.stiffness_z", "1 MN/m", "4 MN/m"), range("carbody.mass", "40 t", "60 t"),
                         list("speed", "20 m/s, 31 m/s")},
                        {"carbody.az.rms", "secondary_front.deflection.peak"});
  study.evaluation = Evaluation::kSteadyState;
  study.plan.emplace();
  study.plan->kind = PlanKind::kSobol;
  study.plan->size = size;
  study.plan->seed = static_cast<int>(seed);
  StudyDesign soft;
  soft.name = "soft";
  soft.sets.push_back({"primary.stiffness_z", "2 MN/m", {}});
  study.designs.push_back(soft);
  return study;
}

/// A study ready to run, and the table of what its database holds.
struct Prepared {
  explicit Prepared(const Study& study)
      : inputs(inputsOf(study, paperVehicle(), {paperScenario(History::kExtended)})),
        plan(DesignPlan::of(study, inputs.bound).orThrow()) {}
  StudyTarget target(const std::string& file, const std::string& text = "<study/>") const {
    StudyTarget made;
    made.database = folder.path(file);
    made.program = "vehicle 0.1.0";
    made.inputs = {{"study.xml", text}};
    return made;
  }
  std::string table(const std::string& file) const {
    StudyDatabase::read(folder.path(file)).writeCsv(folder.path("table.csv"));
    return textOf(folder.path("table.csv"));
  }
  TestFolder folder;
  StudyInputs inputs;
  DesignPlan plan;
};

TEST(StudyRunner, AnyNumberOfThreadsWritesTheSameTable) {
  const Prepared study(sobolStudy(3000));
  std::string reference;
  for (const int threads : {1, 2, 3}) {
    const std::string file = std::to_string(threads) + ".sqlite";
    ThreadExecutor executor(threads);
    const StudyOutcome outcome = runStudy(study.inputs, study.plan, study.target(file), executor);
    EXPECT_EQ(outcome.ending, Ending::kFinished);
    EXPECT_EQ(outcome.progress.evaluated, 2u + 2u * 3000u);  // base, soft, and 3000 points of each
    EXPECT_EQ(outcome.progress.failed, 0u);
    if (threads == 1) reference = study.table(file);
    EXPECT_TRUE(study.table(file) == reference) << threads << " threads";
  }
  EXPECT_EQ(std::count(reference.begin(), reference.end(), '\n'), 6003);
  EXPECT_TRUE(reference.starts_with("id,status,primary.stiffness_z [N/m],") ||
              reference.starts_with("id,status,secondary.stiffness_z [N/m],"))
      << reference.substr(0, 100);
}

// A plan of second order with a mode that some designs lack: the bits of indices and gaps are those of a serial run.
TEST(StudyRunner, SecondOrderAndMissingValuesHaveTheSameBitsOnAnyThreadsAndResumed) {
  Study asked = studyOf({range("secondary.stiffness_z", "0.3 MN/m", "4 MN/m"), range("carbody.mass", "40 t", "60 t")},
                        {"carbody.az.rms", "mode.carbody pitch.frequency"});
  asked.evaluation = Evaluation::kSteadyState;
  asked.plan.emplace();
  asked.plan->kind = PlanKind::kSaltelli;
  asked.plan->size = 64;
  asked.plan->second_order = SecondOrder::kYes;
  const Prepared study(asked);
  ThreadExecutor serial(1);
  ThreadExecutor three(3);
  runStudy(study.inputs, study.plan, study.target("serial"), serial);
  runStudy(study.inputs, study.plan, study.target("three"), three);
  StudyTarget parts = study.target("parts");
  parts.resume = true;
  int asks = 0;
  runStudy(study.inputs, study.plan, parts, three, [&](const StudyProgress&) { return ++asks < 2; });
  runStudy(study.inputs, study.plan, parts, three);
  EXPECT_NE(study.table("serial").find("the mode is overdamped"), std::string::npos);
  EXPECT_TRUE(study.table("three") == study.table("serial"));
  EXPECT_TRUE(study.table("parts") == study.table("serial"));
  const auto pairOf = [&](const char* file) {
    const StudySummary summary = summarise(StudyDatabase::read(study.folder.path(file)), study.inputs, study.plan);
    return summary.influences.at(0).indices.pairs.at(0).second;
  };
  for (const char* other : {"three", "parts"}) {
    EXPECT_EQ(pairOf(other).value, pairOf("serial").value);
    EXPECT_EQ(pairOf(other).low, pairOf("serial").low);
    EXPECT_EQ(pairOf(other).high, pairOf("serial").high);
  }
}

TEST(StudyRunner, AStoppedStudyGoesOnWhereItWas) {
  const Prepared study(sobolStudy(60'000));  // some tenths of a second on one thread: it is asked well before the end
  ThreadExecutor executor(1);
  ASSERT_EQ(runStudy(study.inputs, study.plan, study.target("whole"), executor).ending, Ending::kFinished);

  const StudyOutcome first =
      runStudy(study.inputs, study.plan, study.target("parts"), executor,
               [](const StudyProgress& progress) { return progress.evaluated == 0; });
  EXPECT_EQ(first.ending, Ending::kStopped);
  ASSERT_GT(first.progress.evaluated, 0u);
  ASSERT_LT(first.progress.evaluated, study.plan.size());
  EXPECT_EQ(StudyDatabase::read(study.folder.path("parts")).stored(), first.progress.evaluated);

  StudyTarget target = study.target("parts");
  EXPECT_THROW(runStudy(study.inputs, study.plan, target, executor), RunFailed);  // it is there already
  target.resume = true;
  const StudyOutcome second = runStudy(study.inputs, study.plan, target, executor);
  EXPECT_EQ(second.progress.before, first.progress.evaluated);
  EXPECT_EQ(second.progress.evaluated, study.plan.size() - first.progress.evaluated);
  EXPECT_TRUE(study.table("parts") == study.table("whole"));

  const StudyOutcome third = runStudy(study.inputs, study.plan, target, executor);
  EXPECT_EQ(third.progress.evaluated, 0u);
}

TEST(StudyRunner, AChangedStudyIsRefusedWithTheDifference) {
  const Prepared study(sobolStudy(10));
  ThreadExecutor executor(1);
  runStudy(study.inputs, study.plan, study.target("db", "<study>\n  <plan size=\"10\"/>\n</study>\n"), executor);
  StudyTarget changed = study.target("db", "<study>\n  <plan size=\"11\"/>\n</study>\n");
  changed.resume = true;
  try {
    runStudy(study.inputs, study.plan, changed, executor);
    FAIL() << "went on with another study";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("study.xml:2:"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("size=\"11\""), std::string::npos) << error.what();
  }
}

StudyRecord recordOfColumns(std::uint64_t designs) {
  StudyRecord record;
  record.program = "test";
  record.inputs = {{"study.xml", "<study/>"}};
  record.parameters = {{"x", "m"}};
  record.metrics = {{"y", "m"}};
  record.designs = designs;
  return record;
}

TEST(StudyRunner, FailedDesignsAreStoredWithTheirReason) {
  const TestFolder folder;
  StudyDatabase database = StudyDatabase::create(folder.path("db"), recordOfColumns(1000));
  const FunctionEvaluator evaluator(2, 16, [](std::int64_t design, std::span<const double>, std::span<double> row) {
    row[0] = static_cast<double>(design);
    if (design % 100 == 50) return;  // the failure itself is told below
    row[1] = 2.0 * row[0];
  });
  struct Failing : Evaluator {
    explicit Failing(const Evaluator& inner) : own(inner) {}
    std::size_t columns() const override { return own.columns(); }
    std::int64_t batchSize() const override { return own.batchSize(); }
    std::unique_ptr<Worker> worker() const override {
      struct Both : Worker {
        explicit Both(std::unique_ptr<Worker> inner) : own(std::move(inner)) {}
        void evaluate(const Task& task, Batch& batch) override {
          own->evaluate(task, batch);
          for (std::int64_t i = task.range.first; i < task.range.end; ++i) {
            if (i % 100 == 50) batch.failures.push_back({i, "too light"});
          }
        }
        std::unique_ptr<Worker> own;
      };
      return std::make_unique<Both>(own.worker());
    }
    const Evaluator& own;
  };
  ThreadExecutor executor(2);
  const StudyOutcome outcome = evaluateMissing(database, Failing(evaluator), executor);
  EXPECT_EQ(outcome.progress.evaluated, 1000u);
  EXPECT_EQ(outcome.progress.failed, 10u);
  std::uint64_t id = 0;
  database.forEach([&](const StoredDesign& each) {
    EXPECT_EQ(each.id, id);
    EXPECT_EQ(each.parameters[0], static_cast<double>(id));
    EXPECT_EQ(each.status == DesignStatus::kFailed, id % 100 == 50);
    if (each.status == DesignStatus::kFailed) {
      EXPECT_EQ(each.message, "too light");
    } else {
      EXPECT_EQ(each.metrics[0], 2.0 * static_cast<double>(id));
    }
    ++id;
    return true;
  });
  EXPECT_EQ(id, 1000u);
}

TEST(StudyRunner, WhatEndsTheWorkKeepsWhatIsFinished) {
  const TestFolder folder;
  StudyDatabase database = StudyDatabase::create(folder.path("db"), recordOfColumns(5000));
  const FunctionEvaluator evaluator(2, 10, [](std::int64_t design, std::span<const double>, std::span<double> row) {
    if (design == 3000) throw std::logic_error("a mistake of ours");
    row[0] = row[1] = static_cast<double>(design);
  });
  ThreadExecutor executor(1);
  EXPECT_THROW(evaluateMissing(database, evaluator, executor), std::logic_error);
  EXPECT_EQ(database.stored(), 3000u);
}

TEST(StudyRunner, RefusesRowsThatDoNotFitTheDatabase) {
  const TestFolder folder;
  StudyDatabase database = StudyDatabase::create(folder.path("db"), recordOfColumns(5));
  const FunctionEvaluator evaluator(3, 10, [](std::int64_t, std::span<const double>, std::span<double>) {});
  ThreadExecutor executor(1);
  EXPECT_THROW(evaluateMissing(database, evaluator, executor), std::invalid_argument);
}

/// Ishigami's function f = sin x1 + a sin^2 x2 + b x3^4 sin x1, a = 7, b = 0.1, x in [-pi, pi]^3, of a plan over three
/// parameters of the paper's vehicle: everything but the vehicle is the study's own way.
/// Source: Ishigami, Homma, ISUMA '90, 398-403; indices in closed form: S1 = 0.3139, S2 = 0.4424, S3 = 0, ST1 = 0.5576,
/// ST2 = 0.4424, ST3 = 0.2437. Sampling error of 2048 blocks: about 1/sqrt(2048) = 0.022 of a first index, a quarter of
/// that of a total one (Jansen); the indices themselves lie 0.1 apart.
TEST(StudyRunner, SobolIndicesOfTheIshigamiFunctionComeOutOfADatabase) {
  Study study = studyOf({range("carbody.mass", "1 t", "2 t"), range("primary.stiffness_z", "1 MN/m", "2 MN/m"),
                         range("secondary.stiffness_z", "1 MN/m", "2 MN/m")},
                        {"carbody.az.rms"});
  study.plan.emplace();
  study.plan->kind = PlanKind::kSaltelli;
  study.plan->size = 2048;
  const Prepared prepared(study);
  const DesignPlan& plan = prepared.plan;
  const std::vector<Factor>& factors = plan.study().factors;
  const FunctionEvaluator evaluator(
      4, 64, [&](std::int64_t design, std::span<const double>, std::span<double> row) {
        plan.valuesOf(static_cast<std::uint64_t>(design), row.first(3));
        std::array<double, 3> x{};
        for (std::size_t i = 0; i < 3; ++i) {
          const double share = (row[i] - factors[i].from) / (factors[i].to - factors[i].from);
          x[i] = std::numbers::pi * (2.0 * share - 1.0);
        }
        row[3] = std::sin(x[0]) * (1.0 + 0.1 * std::pow(x[2], 4)) + 7.0 * std::pow(std::sin(x[1]), 2);
      });
  StudyDatabase database = StudyDatabase::create(prepared.folder.path("db"), recordOf(plan, prepared.target("db")));
  ThreadExecutor executor(2);
  evaluateMissing(database, evaluator, executor);
  std::vector<double> values;
  database.forEach([&](const StoredDesign& each) {
    if (plan.identityOf(each.id).point) values.push_back(each.metrics[0]);
    return true;
  });
  const SensitivityResult result = sensitivityOf(values, 3);
  ASSERT_EQ(result.blocks, 2048u);
  const double variance = 0.5 + 49.0 / 8.0 + 0.1 * std::pow(std::numbers::pi, 4) / 5.0 +
                          0.01 * std::pow(std::numbers::pi, 8) / 18.0;
  const double v1 = 0.5 * std::pow(1.0 + 0.1 * std::pow(std::numbers::pi, 4) / 5.0, 2);
  const double v13 = 0.01 * std::pow(std::numbers::pi, 8) * (1.0 / 18.0 - 1.0 / 50.0);
  const std::array<double, 3> first = {v1 / variance, 49.0 / 8.0 / variance, 0.0};
  const std::array<double, 3> total = {(v1 + v13) / variance, 49.0 / 8.0 / variance, v13 / variance};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_WITHIN(result.indices[i].first.value, first[i], 0.04) << "factor " << i;
    EXPECT_WITHIN(result.indices[i].total.value, total[i], 0.02) << "factor " << i;
  }
}

}  // namespace
}  // namespace vehicle
