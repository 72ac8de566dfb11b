#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

#include "libvehicle/definition/judge.h"
#include "libvehicle/model/bind_metrics.h"
#include "libvehicle/model/bound_study.h"

// The names of a study looked up in its vehicle and scenarios.
namespace vehicle {

namespace {

std::string speedLabel(double speed) {
  std::array<char, 40> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), speed * 3.6, std::chars_format::general, 6);
  return std::string(text.data(), end) + " km/h";
}

/// What a scenario says of a run and its samples: a steady state has neither.
bool isOfRunsOnly(std::string_view address) {
  return address == "scenario.duration" || address == "scenario.distance" || address == "scenario.output_step" ||
         address == "scenario.fade_in";
}

class Binder {
 public:
  Binder(const Study& study, const Vehicle& vehicle, const std::vector<Scenario>& scenarios)
      : study_(study), vehicle_(vehicle), scenarios_(scenarios), of_vehicle_(parametersOf(vehicle)) {
    for (const VehicleParameter& each : of_vehicle_) addresses_.push_back(each.address);
    std::set<std::string> seen;
    for (const Scenario& each : scenarios) {
      of_scenarios_.push_back(parametersOf(each));
      for (const ScenarioParameter& own : of_scenarios_.back()) {
        if (seen.insert(own.address).second) addresses_.push_back(own.address);
      }
    }
  }

  Outcome<BoundStudy> run(const ListedColumns& listed) {
    for (const Vary& vary : study_.varies) bindVary(vary);
    for (const Channel& column : listed.columns) bindColumn(column, listed.place);
    bindDesigns();
    bindCases();
    checkSettle();
    bindMetrics(study_, vehicle_, bound_, problems_);
    problems_.sortByPlace();
    Outcome<BoundStudy> outcome;
    outcome.problems = std::move(problems_);
    if (outcome.problems.empty()) outcome.value = std::move(bound_);
    return outcome;
  }

 private:
  /// Index in bound_.parameters of an address, entered there at its first naming; nothing, and told, if it leads
  /// nowhere.
  std::optional<std::size_t> indexOf(const std::string& address, Judge& judge) {
    for (std::size_t i = 0; i < bound_.parameters.size(); ++i) {
      if (bound_.parameters[i].address == address) return i;
    }
    if (study_.evaluation == Evaluation::kSteadyState && isOfRunsOnly(address)) {
      judge.say(address + " has no effect with evaluation=\"steady_state\", which has neither start nor end",
                "remove it, or take evaluation=\"run\"");
      return std::nullopt;
    }
    StudyParameter found;
    found.address = address;
    std::optional<double> base;
    if (const VehicleParameter* own = findParameter(of_vehicle_, address)) {
      found.in_vehicle = *own;
      found.dimension = own->dimension;
      base = own->valueIn(vehicle_);
    } else if (!findInScenarios(found, base, judge)) {
      return std::nullopt;
    }
    if (!base) {
      judge.say("the files give no value for " + address, "write one there: the design \"base\" needs it");
      return std::nullopt;
    }
    found.base = *base;
    bound_.parameters.push_back(std::move(found));
    return bound_.parameters.size() - 1;
  }

  bool findInScenarios(StudyParameter& found, std::optional<double>& base, Judge& judge) {
    bool known = false;
    found.in_scenarios.resize(scenarios_.size());
    for (std::size_t s = 0; s < scenarios_.size(); ++s) {
      const ScenarioParameter* own = findParameter(of_scenarios_[s], found.address);
      if (own == nullptr) continue;
      const std::optional<double> value = own->valueIn(scenarios_[s]);
      if (known && value != base) {
        judge.say("the scenarios give different values for " + found.address,
                  "give it the same value in all of them, or make a study of each");
        return false;
      }
      known = true;
      base = value;
      found.in_scenarios[s] = *own;
      found.dimension = own->dimension;
    }
    if (!known) {
      const Problem unknown = unknownParameter(found.address, addresses_);
      judge.say(unknown.message, unknown.remedy);
    }
    return known;
  }

  void bindColumn(const Channel& column, const Place& header) {
    if (column.name == "speed" && std::any_of(study_.varies.begin(), study_.varies.end(), givesSpeeds)) {
      Judge(problems_, "<study><plan>", "", study_.plan ? study_.plan->origin : study_.origin)
          .say("lists \"speed\", and a <vary> gives speeds that every design runs at", "remove one of them");
      return;
    }
    Judge judge(problems_, "", "", Origin{header, {}});
    const std::optional<std::size_t> index = indexOf(column.name, judge);
    if (!index) return;
    const ParsedQuantity one = parseQuantity("1 " + column.unit, bound_.parameters[*index].dimension);
    if (!one.si) judge.say("column \"" + column.name + "\": the unit [" + column.unit + "] " + one.message, one.remedy);
  }

  void bindVary(const Vary& vary) {
    if (givesSpeeds(vary)) return;
    Judge judge(problems_, "<study><vary>", vary.parameter, vary.origin);
    Factor factor;
    factor.name = vary.parameter;
    factor.kind = vary.kind;
    factor.spacing = vary.spacing;
    for (const std::string& address : listedIn(vary.parameter)) {
      const std::optional<std::size_t> index = indexOf(address, judge);
      if (!index) return;
      factor.parameters.push_back(*index);
    }
    if (!readValues(vary, bound_.parameters[factor.parameters.front()].dimension, factor, judge)) return;
    const auto isNothing = [&](std::size_t index) { return bound_.parameters[index].base == 0.0; };
    if (vary.kind == Variation::kRelative &&
        std::all_of(factor.parameters.begin(), factor.parameters.end(), isNothing)) {
      judge.say(vary.parameter + " is 0 in the file, and so is every part of it", "vary it with kind=\"absolute\"");
    }
    for (const std::size_t index : factor.parameters) {
      const StudyParameter& parameter = bound_.parameters[index];
      const StudyParameter& first = bound_.parameters[factor.parameters.front()];
      if (vary.kind == Variation::kAbsolute && parameter.dimension != first.dimension) {
        judge.say(first.address + " and " + parameter.address + " are of different kinds",
                  "tie them with kind=\"relative\"");
        return;
      }
    }
    for (const double end : {factor.from, factor.to}) {
      std::vector<std::pair<std::size_t, double>> sets;
      for (const std::size_t index : factor.parameters) {
        sets.emplace_back(index, vary.kind == Variation::kRelative ? bound_.parameters[index].base * end : end);
      }
      if (!mayBe(sets, judge)) break;
    }
    bound_.factors.push_back(std::move(factor));
  }

  /// Fills from, to and levels; from and to are the extremes of a list.
  bool readValues(const Vary& vary, Dimension own, Factor& factor, Judge& judge) {
    const Dimension dimension = vary.kind == Variation::kRelative ? Dimension::kNumber : own;
    if (!vary.values.empty()) {
      for (const std::string& text : listedIn(vary.values)) {
        const std::optional<double> value = judge.quantity("values", vary.values, dimension, text);
        if (!value) return false;
        if (std::find(factor.levels.begin(), factor.levels.end(), *value) != factor.levels.end()) {
          judge.say(written("values", vary.values) + " has \"" + text + "\" twice", "write it once");
          return false;
        }
        factor.levels.push_back(*value);
      }
      const auto [least, most] = std::minmax_element(factor.levels.begin(), factor.levels.end());
      factor.from = *least;
      factor.to = *most;
      return true;
    }
    const std::optional<double> from = judge.quantity("from", vary.from, dimension);
    const std::optional<double> to = judge.quantity("to", vary.to, dimension);
    if (!from || !to) return false;
    if (!(*from < *to)) {
      judge.say(written("from", vary.from) + " is not below " + written("to", vary.to),
                "a range goes from the lower to the higher");
      return false;
    }
    if (vary.spacing == Spacing::kLogarithmic && *from <= 0.0) {
      judge.say(written("from", vary.from) + " with spacing=\"logarithmic\"", "a logarithmic range begins above 0");
      return false;
    }
    factor.from = *from;
    factor.to = *to;
    if (!vary.count) return true;
    Factor range = factor;
    for (int i = 0; i < *vary.count; ++i) {
      factor.levels.push_back(valueAt(range, static_cast<double>(i) / (*vary.count - 1)));
    }
    return true;
  }

  /// Whether vehicle and scenarios are in order with these values; tells if not.
  bool mayBe(const std::vector<std::pair<std::size_t, double>>& sets, Judge& judge) {
    std::vector<double> values;
    for (const StudyParameter& each : bound_.parameters) values.push_back(each.base);
    std::string said;
    for (const auto& [index, value] : sets) {
      const StudyParameter& parameter = bound_.parameters[index];
      values[index] = value;
      said += (said.empty() ? "" : ", ") + parameter.address + " = " +
              (std::isfinite(value) ? formatQuantity(value, parameter.dimension) : "inf");
    }
    Vehicle vehicle = vehicle_;
    std::vector<Scenario> scenarios = scenarios_;
    apply(bound_, values, vehicle, scenarios);
    ProblemList wrong = check(vehicle);
    for (const Scenario& each : scenarios) wrong.append(check(each));
    if (wrong.empty()) return true;
    judge.say(said + " is not possible: " + wrong[0].message, wrong[0].remedy);
    return false;
  }

  void bindDesigns() {
    bound_.designs.push_back({std::string(kBaseDesign), {}});
    for (const StudyDesign& design : study_.designs) {
      NamedDesign named{design.name, {}};
      const std::size_t before = problems_.size();
      for (const StudySet& set : design.sets) {
        Judge judge(problems_, "<study><design><set>", set.parameter, set.origin);
        for (const std::string& address : listedIn(set.parameter)) {
          const std::optional<std::size_t> index = indexOf(address, judge);
          if (!index) break;
          const std::optional<double> value = judge.quantity("value", set.value, bound_.parameters[*index].dimension);
          if (!value) break;
          named.sets.emplace_back(*index, *value);
        }
      }
      Judge judge(problems_, "<study><design>", design.name, design.origin);
      if (problems_.size() == before) static_cast<void>(mayBe(named.sets, judge));
      bound_.designs.push_back(std::move(named));
    }
  }

  void bindCases() {
    const Vary* given = nullptr;
    for (const Vary& vary : study_.varies) given = givesSpeeds(vary) ? &vary : given;
    Factor speeds;
    if (given != nullptr) {
      Judge judge(problems_, "<study><vary>", given->parameter, given->origin);
      if (!readValues(*given, Dimension::kSpeed, speeds, judge)) return;
      if (!(speeds.from > 0.0)) {
        judge.say("has a speed that is not above 0", "a vehicle runs at all of them");
        return;
      }
    }
    for (std::size_t s = 0; s < scenarios_.size(); ++s) {
      const double own = scenarios_[s].run.speed;
      std::vector<double> levels = given != nullptr ? speeds.levels : std::vector<double>{own};
      std::set<std::string> labels;
      for (const double level : levels) {
        const double speed = given != nullptr && given->kind == Variation::kRelative ? own * level : level;
        if (!labels.insert(speedLabel(speed)).second) {
          Judge(problems_, "<study><vary>", given->parameter, given->origin)
              .say("has the speed " + speedLabel(speed) + " twice", "speeds differ in their first six digits");
          return;
        }
        bound_.cases.push_back({s, speed, ""});
      }
    }
    std::set<std::string> names;
    for (const Scenario& each : scenarios_) {
      if (names.insert(each.name).second) continue;
      Judge(problems_, "<study>", study_.name, study_.origin)
          .say("two scenarios are both named \"" + each.name + '"', "give each a name of its own");
    }
    for (StudyCase& each : bound_.cases) {
      if (scenarios_.size() > 1) each.label = scenarios_[each.scenario].name;
      if (given != nullptr) each.label += (each.label.empty() ? "" : ", ") + speedLabel(each.speed);
    }
  }

  /// A run that is over before it has settled leaves nothing to measure.
  void checkSettle() {
    if (study_.evaluation != Evaluation::kRun) return;
    for (const StudyCase& each : bound_.cases) {
      if (!study_.origin.knows("settle")) return;
      Scenario scenario = scenarios_[each.scenario];
      scenario.run.speed = each.speed;
      const double duration = durationOf(scenario);
      if (study_.settle <= duration) continue;
      Judge settle(problems_, "<study>", study_.name, study_.origin);
      settle.say(settle.written("settle", study_.settle, Dimension::kTime) + " leaves nothing of the run over \"" +
                     scenario.name + "\", which lasts " + formatQuantity(duration, Dimension::kTime),
                 "settle less, or run longer");
      return;
    }
  }

  const Study& study_;
  const Vehicle& vehicle_;
  const std::vector<Scenario>& scenarios_;
  std::vector<VehicleParameter> of_vehicle_;
  std::vector<std::vector<ScenarioParameter>> of_scenarios_;
  std::vector<std::string> addresses_;
  ProblemList problems_;
  BoundStudy bound_;
};

}  // namespace

Outcome<BoundStudy> bindStudy(const Study& study, const Vehicle& vehicle, const std::vector<Scenario>& scenarios,
                              const ListedColumns& listed) {
  return Binder(study, vehicle, scenarios).run(listed);
}

}  // namespace vehicle
