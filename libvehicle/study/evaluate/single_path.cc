#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <stdexcept>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/linear/steady_state.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/study/evaluate/column_statistic.h"
#include "libvehicle/study/evaluate/flat_block.h"
#include "libvehicle/study/evaluate/path.h"
#include "libvehicle/study/evaluate/steady_statistic.h"

// Design by design, for what no lane of an ensemble can hold: any vehicle, any column.
namespace vehicle {

namespace {

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
        } catch (const std::domain_error& error) {
          tell(c, row, error, rows);
        }
      }
    }
  }

 protected:
  virtual void one(std::size_t study_case, std::size_t row, const Scenario& scenario, double speed,
                   DesignRows& rows) = 0;

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

class SingleRunPath final : public SinglePath {
 public:
  using SinglePath::SinglePath;

 private:
  void one(std::size_t study_case, std::size_t row, const Scenario& scenario, double speed, DesignRows& rows) override {
    RunChoice choice;
    choice.speed = speed;
    const RunResult result = simulate(vehicle(), scenario, choice);
    const double step = scenario.run.output_step;
    const auto first = static_cast<std::size_t>(firstCounted(inputs().study.settle, step));
    if (first >= result.history.samples()) {
      throw std::invalid_argument("settle leaves no sample of the run; settle less or run longer");
    }
    for (const ColumnRequest& request : requests(study_case)) {
      const std::vector<double> values = result.history.column(request.column);
      for (const ColumnRequest::Entry& entry : request.entries) {
        rows.metric(row, entry.place) = statistic_(entry.metric, std::span(values).subspan(first), step);
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
    const std::unique_ptr<System> form = buildForm("matrix", vehicle(), scenario.gravity);
    const Input input = inputOf(steadyScenario(scenario), topologyOf(vehicle()), speed);
    const InputSegment& rail = input.segment(0);
    answer(*form, rail);
    SteadyStatistic& statistic = statisticOf(rail);
    const std::size_t harmonics = rail.angular_frequency.size();
    for (const ColumnRequest& request : requests(study_case)) {
      const auto& columns = form->outputs();
      const auto found = std::find_if(columns.begin(), columns.end(),
                                      [&](const Channel& each) { return each.name == request.column; });
      const auto column = static_cast<std::size_t>(found - columns.begin());  // bindStudy() knows it
      for (std::size_t f = 0; f < harmonics; ++f) harmonic_[f] = amplitudes_[f][column];
      for (const ColumnRequest::Entry& entry : request.entries) {
        rows.metric(row, entry.place) = statistic(entry.metric, mean_[column], harmonic_);
      }
    }
  }

  // Means and complex amplitudes of all columns: outputs are linear in state and rail, but for the static loads.
  void answer(const System& form, const InputSegment& rail) {
    const StateSpace matrices = form.linear().value();
    const auto n = static_cast<std::size_t>(form.size());
    const auto wheels = static_cast<std::size_t>(form.channels());
    const std::size_t harmonics = rail.angular_frequency.size();
    const std::size_t columns = form.outputs().size();
    std::vector<double> x(n, 0.0);
    std::vector<double> u(3 * wheels, 0.0);
    std::vector<double> at_rest(columns);
    std::vector<double> part(columns);
    form.output(x, u, at_rest);

    InputSegment level = rail;
    level.angular_frequency.clear();
    level.cosine.clear();
    level.sine.clear();
    const Eigen::VectorXd constant = steadyState(matrices, level, level.begin);
    std::copy(constant.begin(), constant.end(), x.begin());
    for (std::size_t j = 0; j < wheels; ++j) u[j] = rail.polynomial[InputSegment::kPolynomial * j];
    mean_.resize(columns);
    form.output(x, u, mean_);

    amplitudes_.assign(harmonics, std::vector<std::complex<double>>(columns));
    harmonic_.resize(harmonics);
    for (std::size_t f = 0; f < harmonics; ++f) {
      const Eigen::VectorXcd X = steadyAmplitude(matrices, rail, static_cast<int>(f));
      const std::complex<double> iw(0.0, rail.angular_frequency[f]);
      for (const bool imaginary : {false, true}) {
        const auto take = [imaginary](std::complex<double> z) { return imaginary ? z.imag() : z.real(); };
        for (std::size_t i = 0; i < n; ++i) x[i] = take(X[static_cast<Eigen::Index>(i)]);
        for (std::size_t j = 0; j < wheels; ++j) {
          const std::complex<double> height(rail.cosine[j * harmonics + f], -rail.sine[j * harmonics + f]);
          u[j] = take(height);
          u[wheels + j] = take(iw * height);
          u[2 * wheels + j] = take(iw * iw * height);
        }
        form.output(x, u, part);
        for (std::size_t c = 0; c < columns; ++c) {
          const double value = part[c] - at_rest[c];
          amplitudes_[f][c] += imaginary ? std::complex<double>(0.0, value) : std::complex<double>(value, 0.0);
        }
      }
    }
  }

  SteadyStatistic& statisticOf(const InputSegment& rail) {
    if (statistics_.size() > 64) statistics_.clear();  // designs may bring frequencies of their own
    const auto found = statistics_.find(rail.angular_frequency);
    if (found != statistics_.end()) return found->second;
    return statistics_.try_emplace(rail.angular_frequency, rail.angular_frequency).first->second;
  }

  std::vector<double> mean_;                                   // (columns)
  std::vector<std::vector<std::complex<double>>> amplitudes_;  // (harmonics x columns)
  std::vector<std::complex<double>> harmonic_;                 // (harmonics) of one column
  std::map<std::vector<double>, SteadyStatistic> statistics_;
};

}  // namespace

std::unique_ptr<Path> makeSingleRunPath(const StudyInputs& inputs) { return std::make_unique<SingleRunPath>(inputs); }

std::unique_ptr<Path> makeSteadySinglePath(const StudyInputs& inputs) {
  return std::make_unique<SteadySinglePath>(inputs);
}

}  // namespace vehicle
