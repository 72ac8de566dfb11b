#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdio>
#include <map>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/ensemble/pace.h"
#include "libvehicle/simulate/run_plan.h"
#include "libvehicle/study/evaluate/column_statistic.h"
#include "libvehicle/study/evaluate/flat_block.h"
#include "libvehicle/study/evaluate/path.h"
#include "libvehicle/study/evaluate/summary_statistic.h"

// Runs of the flat form in time, many designs at once.
namespace vehicle {

namespace {

/// Shortest steps that lanes make: the default step halved so often, a quarter of a microsecond.
constexpr int kMostHalvings = 12;

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
    for (std::size_t c = 0; c < requests_.size(); ++c) runCase(c, rows);
  }

 private:
  /// How closely a design has to be followed: powers of two, so that designs share runs. A pure function of the design.
  struct Pace {
    int halvings = 0;   // of the default step
    int doublings = 0;  // of the motion that output samples alone resolve
    int cut = 0;        // points of an output step, where designs have rails of their own
    double output_step = 0.0;
    auto operator<=>(const Pace&) const = default;
  };
  using Places = std::vector<std::size_t>;  // of designs in the block

  static int powerAbove(double ratio) { return ratio > 1.0 ? static_cast<int>(std::ceil(std::log2(ratio) - 1e-9)) : 0; }

  [[nodiscard]] static double slowest(double output_step) {
    return 2.0 * std::numbers::pi / (kPointsPerTurn * output_step);
  }

  void setRun(const Pace& pace) {
    run_.output_step = pace.output_step;
    run_.step = {std::ldexp(kDefaultStep, -pace.halvings), 1};
    run_.fastest = std::ldexp(slowest(pace.output_step), pace.doublings);
  }

  [[nodiscard]] const Input& railOf(std::size_t study_case, std::size_t place) const {
    return block_.railsAreShared() ? block_.rail(study_case) : block_.rails(study_case)[place];
  }

  [[nodiscard]] Pace paceOf(std::size_t study_case, std::size_t place) {
    const Input& rail = railOf(study_case, place);
    const EnsembleDesign& design = block_.designs(block_.groupOf(study_case))[place];
    const DesignPace own = vehicle::paceOf(design.vehicle, rail.end() - rail.begin());
    Pace pace;
    pace.output_step = block_.outputStep(study_case, place);
    pace.halvings = powerAbove(kDefaultStep / own.step);
    pace.doublings = powerAbove(own.fastest / slowest(pace.output_step));
    setRun(pace);
    if (!block_.railsAreShared()) pace.cut = ensembleCut(rail, run_);
    return pace;
  }

  /// What is wrong with a rail that all share is wrong with the study; with one of its own, with that design.
  template <class Call>
  void ofDesign(std::size_t place, DesignRows& rows, Call call) {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      if (block_.railsAreShared()) throw;
      rows.fail(block_.alive()[place], error.what());
    }
  }

  void runCase(std::size_t study_case, DesignRows& rows) {
    std::map<Pace, Places> groups;
    for (std::size_t place = 0; place < block_.alive().size(); ++place) {
      ofDesign(place, rows, [&] {
        const Pace pace = paceOf(study_case, place);
        if (pace.halvings <= kMostHalvings) {
          groups[pace].push_back(place);
        } else {
          rows.fail(block_.alive()[place],
                    fmt::format("its fastest motion asks for rk4 steps of {:.1g} s, the shortest are {:.1g} s; look "
                                "for a stiffness or "
                                "damping that is far too large",
                                std::ldexp(kDefaultStep, -pace.halvings), std::ldexp(kDefaultStep, -kMostHalvings)));
        }
      });
    }
    for (const auto& [pace, places] : groups) {
      setRun(pace);
      try {
        runSome(study_case, places, rows);
      } catch (const std::invalid_argument&) {
        if (block_.railsAreShared()) throw;
        for (const std::size_t place : places) ofDesign(place, rows, [&] { runSome(study_case, {place}, rows); });
      }
    }
  }

  void runSome(std::size_t study_case, const Places& places, DesignRows& rows) {
    const std::vector<EnsembleDesign>& all = block_.designs(block_.groupOf(study_case));
    std::vector<EnsembleDesign> some;
    if (places.size() < all.size()) {
      for (const std::size_t place : places) some.push_back(all[place]);
    }
    const std::span<const EnsembleDesign> designs = some.empty() ? std::span(all) : std::span(some);
    StoredBlockSink store;
    if (stores_) {
      store = [&](const StoredBlock& stored) { writeStored(study_case, places, stored, rows); };
    }
    EnsembleResult result;
    if (block_.railsAreShared()) {
      result = runEnsemble(designs, block_.rail(study_case), run_, store);
    } else {
      std::vector<const Input*> rails;
      for (const std::size_t place : places) rails.push_back(&block_.rails(study_case)[place]);
      result = runEnsemble(designs, rails, run_, store);
    }
    const double gravity = inputs_.scenarios[inputs_.bound.cases[study_case].scenario].gravity;
    for (const EnsembleFailure& each : result.failures) {
      fail(study_case, places[static_cast<std::size_t>(each.design)], each.time, rows);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::size_t row = block_.alive()[places[i]];
      if (rows.failed(row)) continue;
      const DesignExtent& extent = result.extents[i];
      if (gravity > 0.0 && extent.lowest_load < 0.0) rows.warn(row, WarningCode::kWheelLoad);
      if (extent.largest_share > 1.0) rows.warn(row, WarningCode::kLargeMotion);
      for (std::size_t k = 0; k < run_.columns.size(); ++k) {
        for (const MetricPlace& entry : requests_[study_case][k].entries) {
          if (!comesFromSummary(entry.metric.statistic)) continue;
          rows.metric(row, entry.place) =
              fromSummary(entry.metric.statistic, result.summaries[i * run_.columns.size() + k]);
        }
      }
    }
  }

  void writeStored(std::size_t study_case, const Places& places, const StoredBlock& stored, DesignRows& rows) {
    const double step = run_.output_step / ensembleCut(railOf(study_case, places.front()), run_);
    for (int i = 0; i < stored.designs(); ++i) {
      const std::size_t row = block_.alive()[places[static_cast<std::size_t>(stored.firstDesign() + i)]];
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
            rows.metric(row, entry.place) = statistic_(entry.metric, values_, step);
          } catch (const std::domain_error& error) {
            rows.leaveEmpty(row, entry.place, error.what());
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
