#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/study/evaluate/column_statistic.h"
#include "libvehicle/study/evaluate/flat_block.h"
#include "libvehicle/study/evaluate/path.h"
#include "libvehicle/study/evaluate/summary_statistic.h"

// Runs of the flat form in time, many designs at once.
namespace vehicle {

namespace {

class EnsembleRunPath final : public Path {
 public:
  explicit EnsembleRunPath(const StudyInputs& inputs) : inputs_(inputs), block_(inputs, Evaluation::kRun) {
    for (std::size_t c = 0; c < inputs.bound.cases.size(); ++c) requests_.push_back(requestsOf(inputs.bound, c));
    for (const ColumnRequest& request : requests_.front()) {
      run_.columns.push_back(block_.column(request.column));
      stores_ = stores_ || std::any_of(request.entries.begin(), request.entries.end(),
                                       [](const auto& each) { return !comesFromSummary(each.metric.statistic); });
    }
    run_.settle = inputs.study.settle;
  }

  void evaluate(DesignRows& rows) override {
    if (run_.columns.empty()) return;
    block_.prepare(rows);
    const std::size_t designs = block_.alive().size();
    for (std::size_t c = 0; c < requests_.size() && designs > 0; ++c) {
      try {
        runSome(c, 0, designs, rows);
      } catch (const std::invalid_argument& error) {
        if (block_.railsAreShared()) throw;  // of the study, not of a design
        for (std::size_t i = 0; i < designs; ++i) runOne(c, i, rows);
      }
    }
  }

 private:
  void runOne(std::size_t study_case, std::size_t place, DesignRows& rows) {
    try {
      runSome(study_case, place, 1, rows);
    } catch (const std::invalid_argument& error) {
      rows.fail(block_.alive()[place], error.what());
    }
  }

  void runSome(std::size_t study_case, std::size_t first, std::size_t count, DesignRows& rows) {
    run_.output_step = block_.outputStep(study_case, first);
    for (std::size_t i = first; i < first + count; ++i) {
      if (block_.outputStep(study_case, i) != run_.output_step) throw std::invalid_argument("output steps differ");
    }
    const std::vector<EnsembleDesign>& all = block_.designs(block_.groupOf(study_case));
    const std::span designs = std::span(all).subspan(first, count);
    StoredBlockSink store;
    if (stores_) {
      store = [&](const StoredBlock& stored) { writeStored(study_case, first, stored, rows); };
    }
    EnsembleResult result;
    if (block_.railsAreShared()) {
      result = runEnsemble(designs, block_.rail(study_case), run_, store);
    } else {
      std::vector<const Input*> rails;
      for (std::size_t i = first; i < first + count; ++i) rails.push_back(&block_.rails(study_case)[i]);
      result = runEnsemble(designs, rails, run_, store);
    }
    for (const EnsembleFailure& each : result.failures) {
      fail(study_case, first + static_cast<std::size_t>(each.design), each.time, rows);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t row = block_.alive()[first + i];
      if (rows.failed(row)) continue;
      for (std::size_t k = 0; k < run_.columns.size(); ++k) {
        for (const MetricPlace& entry : requests_[study_case][k].entries) {
          if (!comesFromSummary(entry.metric.statistic)) continue;
          rows.metric(row, entry.place) =
              fromSummary(entry.metric.statistic, result.summaries[i * run_.columns.size() + k]);
        }
      }
    }
  }

  void writeStored(std::size_t study_case, std::size_t first, const StoredBlock& stored, DesignRows& rows) {
    for (int i = 0; i < stored.designs(); ++i) {
      const std::size_t row = block_.alive()[first + static_cast<std::size_t>(stored.firstDesign() + i)];
      if (rows.failed(row)) continue;
      for (std::size_t k = 0; k < run_.columns.size(); ++k) {
        bool copied = false;
        for (const MetricPlace& entry : requests_[study_case][k].entries) {
          if (comesFromSummary(entry.metric.statistic)) continue;
          if (!copied) stored.copyColumn(i, static_cast<int>(k), values_);
          copied = true;
          // A motion that was lost is told by the run; NaN must not reach a sort.
          if (!std::all_of(values_.begin(), values_.end(), [](double x) { return std::isfinite(x); })) break;
          try {
            rows.metric(row, entry.place) = statistic_(entry.metric, values_, run_.output_step);
          } catch (const std::domain_error& error) {
            rows.fail(row, error.what());
          }
        }
      }
    }
  }

  void fail(std::size_t study_case, std::size_t place, double time, DesignRows& rows) const {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g s", time);
    rows.fail(block_.alive()[place],
              "its motion" + inCase(inputs_.bound.cases[study_case]) + " is no longer finite at t = " + text);
  }

  const StudyInputs& inputs_;
  FlatBlock block_;
  EnsembleRun run_;
  bool stores_ = false;
  std::vector<std::vector<ColumnRequest>> requests_;  // (cases)
  ColumnStatistic statistic_;
  std::vector<double> values_;  // a stored column
};

}  // namespace

std::unique_ptr<Path> makeEnsembleRunPath(const StudyInputs& inputs) {
  return std::make_unique<EnsembleRunPath>(inputs);
}

}  // namespace vehicle
