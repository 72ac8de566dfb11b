#include "libvehicle/study/evaluate/flat_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "libvehicle/excitation/excitation.h"
#include "libvehicle/flat/flat_form.h"
#include "libvehicle/simulate/initial_state.h"
#include "libvehicle/simulate/vehicle_warnings.h"

namespace vehicle {

std::string designProblem(const std::exception& error) {
  const auto* invalid = dynamic_cast<const InvalidInput*>(&error);
  return invalid != nullptr ? firstProblem(invalid->problems()) : error.what();
}

namespace {

/// What restWarnings() says of a design in a lane: wheel loads that miss the weight, springs that come down too far.
void judgeRest(const EnsembleDesign& design, double gravity, std::size_t row, DesignRows& rows) {
  const FlatParameters& v = design.vehicle;
  std::array<double, 4> primary{};  // [N] on each spring
  double weight = (v.mk + v.m1 + v.m2) * gravity;
  double load = 0.0;
  bool deep = false;
  for (std::size_t j = 0; j < 4; ++j) {
    const double wheelset = design.wheelset_mass[j] * gravity;
    weight += wheelset;
    load += design.wheel_load[j];
    primary[j] = design.wheel_load[j] - wheelset;
    deep = deep || std::abs(primary[j]) > kMostRestDeflection * v.cp[j];
  }
  deep = deep || std::abs(primary[0] + primary[1] - v.m1 * gravity) > kMostRestDeflection * v.cs1;
  deep = deep || std::abs(primary[2] + primary[3] - v.m2 * gravity) > kMostRestDeflection * v.cs2;
  if (deep) rows.warn(row, WarningCode::kRestDeflection);
  if (std::abs(load - weight) > kMostLoadError * weight) rows.warn(row, WarningCode::kGivenLoads);
}

}  // namespace

FlatBlock::FlatBlock(const StudyInputs& inputs, Evaluation evaluation)
    : inputs_(inputs),
      steady_(evaluation == Evaluation::kSteadyState),
      maker_(inputs),
      shared_(maker_.geometryIsFixed() && scenariosAreFixed(inputs.bound)),
      vehicle_(inputs.vehicle),
      scenarios_(inputs.scenarios) {
  const std::vector<StudyCase>& cases = inputs.bound.cases;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Scenario& scenario = inputs.scenarios[cases[c].scenario];
    if (shared_) shared_rails_.push_back(railOf(cases[c], scenario).inOrder(maker_.layout().wheelset));
    const auto same = [&](std::size_t other) {
      const Scenario& its = inputs.scenarios[cases[other].scenario];
      return startsAtRest(scenario) && startsAtRest(its) && scenario.gravity == its.gravity;
    };
    const auto found = shared_ ? std::find_if(group_case_.begin(), group_case_.end(), same) : group_case_.end();
    group_.push_back(static_cast<std::size_t>(found - group_case_.begin()));
    if (found == group_case_.end()) group_case_.push_back(c);
  }
  designs_.resize(group_case_.size());
  if (shared_) return;
  rails_.resize(cases.size());
  output_steps_.resize(inputs.scenarios.size());
}

void FlatBlock::prepare(DesignRows& rows) {
  alive_.clear();
  for (auto& each : designs_) each.clear();
  for (auto& each : rails_) each.clear();
  for (auto& each : output_steps_) each.clear();
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows.failed(row)) continue;
    try {
      add(row, rows);
    } catch (const std::runtime_error& error) {
      rows.fail(row, designProblem(error));
    } catch (const std::invalid_argument& error) {
      rows.fail(row, error.what());
    }
    if (!rows.failed(row)) alive_.push_back(row);
    // What a failed design has left behind is no longer anybody's.
    for (auto& each : designs_) each.resize(alive_.size());
    for (auto& each : rails_) each.erase(each.begin() + static_cast<std::ptrdiff_t>(alive_.size()), each.end());
    for (auto& each : output_steps_) each.resize(alive_.size());
  }
}

void FlatBlock::add(std::size_t row, DesignRows& rows) {
  const std::span<const double> values = rows.parameters(row);
  if (const std::optional<std::string> wrong = maker_.set(values)) return rows.fail(row, *wrong);
  const std::vector<StudyCase>& cases = inputs_.bound.cases;
  if (!shared_) {
    apply(inputs_.bound, values, vehicle_, scenarios_);
    for (std::size_t s = 0; s < scenarios_.size(); ++s) {
      if (const ProblemList wrong = check(scenarios_[s]); !wrong.empty()) return rows.fail(row, firstProblem(wrong));
      output_steps_[s].push_back(scenarios_[s].run.output_step);
    }
  }
  for (std::size_t g = 0; g < group_case_.size(); ++g) {
    const std::size_t c = group_case_[g];
    const Scenario& scenario = scenarios_[cases[c].scenario];
    EnsembleDesign design = maker_.design(scenario.gravity);
    judgeRest(design, scenario.gravity, row, rows);
    if (!shared_) rails_[c].push_back(railOf(cases[c], scenario));
    if (!startsAtRest(scenario)) {
      if (shared_) apply(inputs_.bound, values, vehicle_, scenarios_);
      design.start = startOf(scenario, shared_ ? railOf(cases[c], scenario) : rails_[c].back());
    }
    if (!shared_) rails_[c].back() = rails_[c].back().inOrder(maker_.layout().wheelset);
    designs_[g].push_back(design);
  }
}

Input FlatBlock::railOf(const StudyCase& study_case, const Scenario& scenario) const {
  const double speed = speedOf(inputs_.bound, study_case, scenario);
  return inputOf(steady_ ? steadyScenario(scenario) : scenario, maker_.topology(), speed);
}

bool FlatBlock::startsAtRest(const Scenario& scenario) const {
  return steady_ || (scenario.initial_state.from == InitialRest::kZero && scenario.initial_state.bodies.empty());
}

std::array<double, 8> FlatBlock::startOf(const Scenario& scenario, const Input& rail_in_file_order) const {
  const CompiledModel model = compileChecked(vehicle_, scenario.gravity);
  const std::unique_ptr<FlatForm> form = buildFlatForm(model);
  const std::vector<double> x0 = initialState(*form, model, scenario, rail_in_file_order);
  std::array<double, 8> start{};
  for (std::size_t i = 0; i < 8; ++i) start[i] = x0[static_cast<std::size_t>(form->stateOrder()[i])];
  return start;
}

double FlatBlock::outputStep(std::size_t study_case, std::size_t place) const {
  const std::size_t scenario = inputs_.bound.cases[study_case].scenario;
  return shared_ ? inputs_.scenarios[scenario].run.output_step : output_steps_[scenario][place];
}

FlatColumn FlatBlock::column(const std::string& name) const {
  return flatColumn(maker_.topology(), maker_.layout(), name).value();
}

}  // namespace vehicle
