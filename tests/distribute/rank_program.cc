// One rank of a job that evaluates a closed-form table; the leader writes it, row by row in order, as bits.
//
// usage: rank_program CASE FILE [THREADS]
//   CASE  whole      every design
//         stop       the leader stops after the first batches, then evaluates everything in a second run
//         failure    design 700 ends the work of whoever meets it; the leader writes what is thrown to it
//         sink       the leader's sink throws; everything is evaluated in a second run
//         absent     rank 1 never calls run(); the leader writes what is thrown to it
//         lost       rank 1 is gone in the middle of its work
//         stored     a study of 60 000 designs with a database FILE, gone on with if it is there; then FILE.csv
//         stored-lost  the same until rank 1 is gone
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "libvehicle/distribute/mpi_executor.h"
#include "libvehicle/study/runner.h"
#include "tests/study/evaluators.h"

namespace {

using namespace vehicle;

constexpr std::size_t kColumns = 4;

Workload wholeWorkload() {
  Workload workload;
  workload.ranges = {{0, 5000}, {6000, 6001}, {10'000, 30'000}};
  for (const DesignSpan& range : workload.ranges) {
    for (std::int64_t i = range.first; i < range.end; ++i) workload.given.push_back(std::sqrt(static_cast<double>(i)));
  }
  return workload;
}

void write(const char* file, const std::map<std::int64_t, std::vector<double>>& rows) {
  FILE* out = std::fopen(file, "wb");
  if (out == nullptr) std::exit(1);
  for (const auto& [design, row] : rows) {
    std::fwrite(&design, sizeof design, 1, out);
    std::fwrite(row.data(), sizeof(double), row.size(), out);
  }
  std::fclose(out);
}

void writeText(const char* file, const std::string& text) {
  FILE* out = std::fopen(file, "wb");
  if (out == nullptr) std::exit(1);
  std::fputs(text.c_str(), out);
  std::fclose(out);
}

/// The study's own way: what is missing is evaluated by all ranks, and the leader alone has the database.
int runStored(MpiExecutor& executor, const std::string& file, bool loses_rank_1) {
  int evaluated = 0;
  const test::FunctionEvaluator evaluator(
      2, 64, [&](std::int64_t design, std::span<const double>, std::span<double> row) {
        if (loses_rank_1) {
          // Rank 1 goes after some thousand designs. The others leave that many to it, however late a busy machine lets
          // it begin, and wait to be ended with it.
          ++evaluated;
          if (executor.rank() == 1 && evaluated == 8000) ::_exit(9);
          while (executor.rank() != 1 && evaluated > 20'000) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        row[0] = static_cast<double>(design);
        row[1] = std::sin(row[0]);
      });
  if (!executor.leads()) {
    serve(evaluator, executor);
    return 0;
  }
  StudyTarget target;
  target.database = file;
  target.resume = true;
  StudyRecord record;
  record.program = "rank_program";
  record.parameters = {{"x", "m"}};
  record.metrics = {{"y", "m"}};
  record.designs = 60'000;
  StudyDatabase database = openOrCreate(target, record);
  evaluateMissing(database, evaluator, executor);
  database.writeCsv(file + ".csv");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::string which = argv[1];
  const char* file = argv[2];
  MpiExecutor executor(argc > 3 ? std::atoi(argv[3]) : 1);
  if (which.starts_with("stored")) return runStored(executor, file, which == "stored-lost");
  const int rank = executor.rank();
  int evaluated = 0;
  const test::FunctionEvaluator evaluator(
      kColumns, 16,
      [&](std::int64_t design, std::span<const double> given, std::span<double> row) {
        if (design % 1000 == 7) throw std::domain_error("design " + std::to_string(design) + " weighs nothing");
        if (which == "failure" && design == 700) throw std::logic_error("a mistake of ours");
        // In the second batch of the portion that it is given at once: a slow machine's others cannot do without it.
        if (which == "lost" && rank == 1 && ++evaluated == 20) ::_exit(9);
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = std::sin(given[0] + static_cast<double>(i));
        if (design % 1000 == 11) row[2] = NAN;
      },
      1);
  if (which == "absent" && rank == 1) return 0;
  if (!executor.leads()) {
    executor.run(evaluator, {}, [](Batch&) {});
    return 0;
  }
  const Workload workload = wholeWorkload();
  std::map<std::int64_t, std::vector<double>> rows;
  int repeated = 0;
  const Sink sink = [&](Batch& batch) {
    for (std::int64_t design = batch.range.first; design < batch.range.end; ++design) {
      const std::span<double> row = batch.row(design, kColumns);
      repeated += rows.emplace(design, std::vector<double>(row.begin(), row.end())).second ? 0 : 1;
    }
    for (const DesignFailure& each : batch.failures) {
      rows[each.design].assign(kColumns, -static_cast<double>(each.message.size()));
    }
    for (const DesignGap& each : batch.gaps) rows[each.design].push_back(static_cast<double>(each.message.size()));
    for (const DesignWarnings& each : batch.warnings) {
      rows[each.design].push_back(static_cast<double>(each.warnings.words().size()));
    }
  };
  try {
    if (which == "stop") {
      executor.run(evaluator, workload, sink, [] { return false; });
      rows.clear();
    } else if (which == "sink") {
      try {
        executor.run(evaluator, workload, [](Batch&) { throw std::runtime_error("disk full"); });
        return 1;
      } catch (const std::runtime_error& error) {
        if (std::strcmp(error.what(), "disk full") != 0) return 1;
      }
    }
    if (executor.run(evaluator, workload, sink) != Ending::kFinished || repeated > 0) return 1;
  } catch (const std::exception& error) {
    writeText(file, error.what());
    return 0;
  }
  write(file, rows);
  return 0;
}
