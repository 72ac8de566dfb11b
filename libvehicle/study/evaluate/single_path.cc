#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/excitation/excitation.h"
#include "libvehicle/linear/steady_state.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/simulate/vehicle_warnings.h"
#include "libvehicle/study/evaluate/column_statistic.h"
#include "libvehicle/study/evaluate/flat_block.h"
#include "libvehicle/study/evaluate/path.h"
#include "libvehicle/study/evaluate/steady_range.h"
#include "libvehicle/study/evaluate/steady_statistic.h"
#include "libvehicle/study/evaluate/summary_statistic.h"

// Design by design, for what no lane of an ensemble can hold: any vehicle, any column.
namespace vehicle {

namespace {

constexpr std::size_t kMostStatistics = 64;

class SinglePath : public Path {
 public:
  explicit SinglePath(const StudyInputs& inputs)
      : inputs_(inputs), vehicle_(inputs.vehicle), scenarios_(inputs.scenarios) {
    for (std::size_t c = 0; c < inputs.bound.cases.size(); ++c) requests_.push_back(requestsOf(inputs.bound, c));
  }

  void evaluate(DesignRows& rows) override {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (rows.failed(row) || requests_.front().empty()) continue;
      apply(inputs_.bound, rows.parameters(row), vehicle_, scenarios_);
      for (std::size_t c = 0; c < requests_.size() && !rows.failed(row); ++c) {
        const StudyCase& study_case = inputs_.bound.cases[c];
        const Scenario& scenario = scenarios_[study_case.scenario];
        try {
          one(c, row, scenario, speedOf(inputs_.bound, study_case, scenario), rows);
        } catch (const std::runtime_error& error) {
          tell(c, row, error, rows);
        } catch (const std::invalid_argument& error) {
          tell(c, row, error, rows);
        }
      }
    }
  }

 protected:
  virtual void one(std::size_t study_case, std::size_t row, const Scenario& scenario, double speed,
                   DesignRows& rows) = 0;

  /// Writes what `value` returns; where the statistic cannot be given, that metric alone stays empty.
  template <class Value>
  static void write(const MetricPlace& entry, std::size_t row, DesignRows& rows, Value value) {
    try {
      rows.metric(row, entry.place) = value();
    } catch (const std::domain_error& error) {
      rows.leaveEmpty(row, entry.place, error.what());
    }
  }

  [[nodiscard]] const Vehicle& vehicle() const { return vehicle_; }
  [[nodiscard]] const StudyInputs& inputs() const { return inputs_; }
  [[nodiscard]] const std::vector<ColumnRequest>& requests(std::size_t study_case) const {
    return requests_[study_case];
  }

 private:
  void tell(std::size_t study_case, std::size_t row, const std::exception& error, DesignRows& rows) const {
    const std::string& label = inputs_.bound.cases[study_case].label;
    rows.fail(row, (label.empty() ? label : label + ": ") + designProblem(error));
  }

  const StudyInputs& inputs_;
  Vehicle vehicle_;
  std::vector<Scenario> scenarios_;
  std::vector<std::vector<ColumnRequest>> requests_;  // (cases)
};

bool needsSamples(const ColumnRequest& request) {
  return std::any_of(request.entries.begin(), request.entries.end(),
                     [](const MetricPlace& each) { return !comesFromSummary(each.metric.statistic); });
}

/// A column from the first sample on that counts.
std::vector<double> countedSamples(const TimeHistory& history, std::size_t column, double settle) {
  const double step = history.at(1, 0) - history.at(0, 0);
  std::vector<double> values = history.column(column);
  std::size_t first = 0;
  while (first < values.size() && history.at(first, 0) < settle - kSameInstant * step) ++first;
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  return values;
}

class SingleRunPath final : public SinglePath {
 public:
  using SinglePath::SinglePath;

 private:
  void one(std::size_t study_case, std::size_t row, const Scenario& scenario, double speed, DesignRows& rows) override {
    RunChoice choice;
    choice.speed = speed;
    choice.settle = inputs().study.settle;
    const bool needs_samples = std::any_of(requests(study_case).begin(), requests(study_case).end(), needsSamples);
    choice.keep = needs_samples ? Keep::kRegular : Keep::kNothing;
    const RunResult result = simulate(vehicle(), scenario, choice);
    for (const Warning& each : result.warnings) rows.warn(row, each.code);
    for (const ColumnRequest& request : requests(study_case)) {
      const std::size_t column = result.history.indexOf(request.column);
      const std::vector<double> samples =
          needs_samples ? countedSamples(result.history, column, choice.settle) : std::vector<double>();
      for (const MetricPlace& entry : request.entries) {
        write(entry, row, rows, [&] {
          return comesFromSummary(entry.metric.statistic)
                     ? fromSummary(entry.metric.statistic, result.summaries[column - 1])
                     : statistic_(entry.metric, samples, result.history.at(1, 0) - result.history.at(0, 0));
        });
      }
    }
  }

  ColumnStatistic statistic_;
};

class SteadySinglePath final : public SinglePath {
 public:
  using SinglePath::SinglePath;

 private:
  void one(std::size_t study_case, std::size_t row, const Scenario& scenario, double speed, DesignRows& rows) override {
    ProblemList problems = check(vehicle());
    problems.append(check(scenario));
    if (!problems.empty()) throw InvalidInput(std::move(problems));
    const CompiledModel model = compileChecked(vehicle(), scenario.gravity);
    const std::unique_ptr<System> form = buildForm("matrix", model);
    if (!stands(model, row, rows)) {
      return leaveEmpty(requests(study_case), row, "no steady state: the vehicle cannot stand", rows);
    }
    const Input input = inputOf(steadyScenario(scenario), model.topology, speed);
    const InputSegment& rail = input.segment(0);
    try {
      answer(*form, rail);
    } catch (const std::invalid_argument& error) {  // nothing damps what this rail excites; other speeds may do
      return leaveEmpty(requests(study_case), row, error.what(), rows);
    }
    SteadyStatistic& statistic = statistics_.of(rail.angular_frequency);
    if (range_.empty()) range_ = rangeColumns(model.outputs);
    for (const RangeColumn& each : range_) {
      if (each.kind == RangeKind::kLoad && scenario.gravity == 0.0) continue;
      takeColumn(each.column);
      if (leavesRange(each.kind, mean_[each.column], harmonic_, statistic)) rows.warn(row, rangeCode(each.kind));
    }
    for (const ColumnRequest& request : requests(study_case)) {
      const auto& columns = form->outputs();
      const auto found = std::find_if(columns.begin(), columns.end(),
                                      [&](const Channel& each) { return each.name == request.column; });
      const auto column = static_cast<std::size_t>(found - columns.begin());  // bindStudy() knows it
      takeColumn(column);
      for (const MetricPlace& entry : request.entries) {
        write(entry, row, rows, [&] { return statistic(entry.metric, mean_[column], harmonic_); });
      }
    }
  }

  static bool stands(const CompiledModel& model, std::size_t row, DesignRows& rows) {
    bool stands = true;
    for (const Warning& each : restWarnings(model)) {
      rows.warn(row, each.code);
      stands = stands && each.code != WarningCode::kCannotStand;
    }
    return stands;
  }

  void takeColumn(std::size_t column) {
    for (std::size_t f = 0; f < harmonic_.size(); ++f) harmonic_[f] = amplitudes_[f][column];
  }

  // Outputs are linear in state and rail, but for the static loads: what they are at rest on level rail.
  void answer(const System& form, const InputSegment& rail) {
    const StateSpace matrices = form.linear().value();
    std::vector<double> x(static_cast<std::size_t>(form.size()), 0.0);
    std::vector<double> u(3 * static_cast<std::size_t>(form.channels()), 0.0);
    std::vector<double> at_rest(form.outputs().size());
    form.output(x, u, at_rest);

    InputSegment level = rail;
    level.angular_frequency.clear();
    level.cosine.clear();
    level.sine.clear();
    const Eigen::VectorXd constant = steadyState(matrices, level, level.begin);
    std::copy(constant.begin(), constant.end(), x.begin());
    for (int j = 0; j < form.channels(); ++j) {
      const auto channel = static_cast<std::size_t>(j);
      u[channel] = rail.polynomial[InputSegment::kPolynomial * channel];
    }
    mean_.resize(at_rest.size());
    form.output(x, u, mean_);

    const std::size_t harmonics = rail.angular_frequency.size();
    harmonic_.resize(harmonics);
    amplitudes_.assign(harmonics, std::vector<std::complex<double>>(at_rest.size()));
    for (std::size_t f = 0; f < harmonics; ++f) {
      const Eigen::VectorXcd X = steadyAmplitude(matrices, rail, static_cast<int>(f));
      fillAmplitudes(form, rail, f, X, at_rest);
    }
  }

  // Real and imaginary parts go through the outputs one after the other.
  void fillAmplitudes(const System& form, const InputSegment& rail, std::size_t f, const Eigen::VectorXcd& state,
                      const std::vector<double>& at_rest) {
    const auto wheels = static_cast<std::size_t>(form.channels());
    const std::size_t harmonics = rail.angular_frequency.size();
    const std::complex<double> iw(0.0, rail.angular_frequency[f]);
    std::vector<double> x(static_cast<std::size_t>(form.size()));
    std::vector<double> u(3 * wheels);
    std::vector<double> part(at_rest.size());
    for (const bool imaginary : {false, true}) {
      const auto take = [imaginary](std::complex<double> z) { return imaginary ? z.imag() : z.real(); };
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = take(state[static_cast<Eigen::Index>(i)]);
      for (std::size_t j = 0; j < wheels; ++j) {
        const std::complex<double> height(rail.cosine[j * harmonics + f], -rail.sine[j * harmonics + f]);
        u[j] = take(height);
        u[wheels + j] = take(iw * height);
        u[2 * wheels + j] = take(iw * iw * height);
      }
      form.output(x, u, part);
      for (std::size_t c = 0; c < part.size(); ++c) {
        const double value = part[c] - at_rest[c];
        amplitudes_[f][c] += imaginary ? std::complex<double>(0.0, value) : std::complex<double>(value, 0.0);
      }
    }
  }

  std::vector<double> mean_;                                   // (columns)
  std::vector<std::vector<std::complex<double>>> amplitudes_;  // (harmonics x columns)
  std::vector<std::complex<double>> harmonic_;                 // (harmonics) of one column
  std::vector<RangeColumn> range_;                             // the same for every design
  SteadyStatistics statistics_{kMostStatistics};
};

}  // namespace

std::unique_ptr<Path> makeSingleRunPath(const StudyInputs& inputs) { return std::make_unique<SingleRunPath>(inputs); }

std::unique_ptr<Path> makeSteadySinglePath(const StudyInputs& inputs) {
  return std::make_unique<SteadySinglePath>(inputs);
}

}  // namespace vehicle
