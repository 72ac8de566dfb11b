#include "libvehicle/definition/study.h"

#include <algorithm>
#include <map>
#include <set>

#include "libvehicle/definition/judge.h"
#include "libvehicle/definition/study_attributes.h"

namespace vehicle {

namespace {

PlanKind planOf(const Study& study) { return study.plan ? study.plan->kind : PlanKind::kGrid; }

/// Judges the addresses of one parameter="..." and says whether all have a form.
bool checkAddresses(const std::string& parameter, Judge& judge) {
  if (!judge.knows({"parameter"})) return false;
  if (parameter.empty()) {
    judge.say("parameter is empty", "name one, e.g. parameter=\"primary.stiffness_z\"");
    return false;
  }
  std::set<std::string> own;
  for (const std::string& address : listedIn(parameter)) {
    if (address.empty()) {
      judge.say(written("parameter", parameter) + " has an empty item", "put one comma between two parameters");
      return false;
    }
    if (own.insert(address).second) continue;
    judge.say(written("parameter", parameter) + " names " + address + " twice", "name it once");
    return false;
  }
  return true;
}

class Checks {
 public:
  explicit Checks(const Study& study) : study_(study) {}

  ProblemList run() {
    Judge judge(problems_, "<study>", study_.name, study_.origin);
    judge.properName(study_.name);
    judge.numbers(study_);
    if (study_.evaluation == Evaluation::kSteadyState && study_.settle > 0.0) {
      judge.say(judge.written("settle", study_.settle, Dimension::kTime) +
                    " has no effect with evaluation=\"steady_state\", which has no start to leave out",
                "remove settle, or take evaluation=\"run\"");
    }
    const bool strange = study_.origin.hasStrange();
    if (study_.vehicle.file.empty() && study_.vehicle.origin.knows("file")) {
      judge.say("has no <vehicle>", "name one, e.g. <vehicle file=\"coach.xml\"/>");
    }
    if (study_.scenarios.empty() && !strange) judge.say("has no <scenario>", "a study has at least one");
    if (study_.metrics.empty() && !strange) {
      judge.say("has no <metric>", "name what is compared, e.g. carbody.az.rms");
    }
    scenarios();
    for (const Vary& vary : study_.varies) checkVary(vary);
    plan(judge);
    search();
    designs();
    metrics();
    objectives();
    limits();
    problems_.sortByPlace();
    return std::move(problems_);
  }

 private:
  void scenarios() {
    std::map<std::string, Origin> seen;
    for (const FileReference& each : study_.scenarios) {
      Judge judge(problems_, "<study><scenario>", "", each.origin);
      if (!judge.knows({"file"})) continue;
      if (each.file.empty()) judge.say("file is empty", "name a file, e.g. file=\"../scenarios/track.xml\"");
      const auto [first, fresh] = seen.try_emplace(each.file, each.origin);
      if (fresh || each.file.empty()) continue;
      judge.say(written("file", each.file) + " is listed twice" + inLine(first->second), "list it once");
    }
  }

  void checkVary(const Vary& vary) {
    Judge judge(problems_, "<study><vary>", vary.parameter, vary.origin);
    if (checkAddresses(vary.parameter, judge)) {
      for (const std::string& address : listedIn(vary.parameter)) {
        const auto [first, fresh] = varied_.try_emplace(address, &vary);
        if (!fresh) {
          judge.say(address + " is varied already" + inLine(first->second->origin), "vary it once");
        }
      }
    }
    if (!judge.knows({"from", "to", "count", "values"})) return;
    const bool range = !vary.from.empty() || !vary.to.empty() || vary.count;
    if (range && !vary.values.empty()) {
      judge.say("has a range and a list of values", "give from and to, or values");
      return;
    }
    if (!vary.values.empty()) {
      for (const std::string& value : listedIn(vary.values)) {
        if (value.empty())
          judge.say(written("values", vary.values) + " has an empty item", "put one comma between two");
      }
      if (vary.spacing == Spacing::kLogarithmic && judge.knows({"spacing"})) judge.say("has spacing with a list of values", "remove spacing");
      return;
    }
    if (vary.from.empty() || vary.to.empty()) {
      judge.say("has no values", "give from and to, or values=\"1 kN/m, 2 kN/m\"");
      return;
    }
    if (const AttributeRow& row = rowOf<&Vary::count>();
        vary.count && (*vary.count < row.least || *vary.count > row.most)) {
      judge.say(judge.written("count", *vary.count), "must be " + std::to_string(row.least) + ".." +
                                                         std::to_string(row.most) + "; both ends of a range count");
    }
    const bool grid = planOf(study_) == PlanKind::kGrid && (!study_.plan || study_.plan->origin.knows("kind"));
    if (!vary.count && !study_.search && grid && !study_.origin.hasStrange()) {
      judge.say("has no count", "a grid needs the number of its steps, e.g. count=\"11\"");
    }
  }

  void plan(Judge& whole) {
    std::size_t factors = 0;
    for (const Vary& vary : study_.varies) factors += givesSpeeds(vary) ? 0 : 1;
    const bool strange = study_.origin.hasStrange();
    if (study_.designs.empty() && study_.varies.empty() && planOf(study_) != PlanKind::kList && !strange) {
      whole.say("has no <vary> and no <design>", "say what is compared: a study has at least one of them");
    }
    if (!study_.plan) return;
    const Plan& plan = *study_.plan;
    Judge judge(problems_, "<study><plan>", "", plan.origin);
    if (study_.search) judge.say("stands beside a <search>", "a search chooses its designs itself; remove one of them");
    const bool samples = plan.kind != PlanKind::kGrid && plan.kind != PlanKind::kList;
    if (plan.seed && *plan.seed < 0 && judge.knows({"seed"})) {
      judge.say(judge.written("seed", *plan.seed), "must be >= 0");
    } else if (plan.seed && !samples && judge.knows({"kind"})) {
      judge.say(judge.written("seed", *plan.seed) + " has no effect: a " +
                    (plan.kind == PlanKind::kGrid ? "grid" : "list") + " draws nothing",
                "remove seed, or take a kind that samples: latin_hypercube, sobol, saltelli");
    }
    if (!judge.knows({"kind", "size", "file"})) return;
    if (samples && !plan.size) judge.say("has no size", "say how many designs, e.g. size=\"1000\"");
    if (!samples && plan.size) {
      judge.say("has size", plan.kind == PlanKind::kGrid ? "the counts of the ranges make the size of a grid"
                                                         : "the rows of the file make the size of a list");
    }
    if (plan.size && *plan.size < 1) judge.say(judge.written("size", *plan.size), "must be >= 1");
    if (samples && factors == 0 && !strange) {
      judge.say("has nothing to sample", "add a <vary>; a speed with count or values is run by every design");
    }
    if (plan.second_order == SecondOrder::kYes && plan.kind != PlanKind::kSaltelli) {
      judge.say("has second_order with another kind than saltelli", "write kind=\"saltelli\", or remove second_order");
    }
    if (plan.kind == PlanKind::kList) {
      if (plan.file.empty()) judge.say("has no file", "name the CSV file of the designs, e.g. file=\"designs.csv\"");
      if (factors != 0)
        judge.say("stands beside a <vary>", "the columns of the file name what varies; remove the <vary>");
    } else if (!plan.file.empty()) {
      judge.say("has file with another kind than list", "write kind=\"list\", or remove file");
    }
  }

  void search() {
    if (!study_.search) return;
    const Search& search = *study_.search;
    Judge judge(problems_, "<study><search>", "", search.origin);
    const bool strange = study_.origin.hasStrange();
    if (study_.objectives.size() < 2 && !strange) {
      judge.say(study_.objectives.empty() ? "has no objective" : "has one objective",
                "a search weighs two or more; add <objective metric=\"...\" goal=\"minimise\"/>");
    }
    if (search.seed < 0 && judge.knows({"seed"})) judge.say(judge.written("seed", search.seed), "must be >= 0");
    if (search.generations < 1 && judge.knows({"generations"})) {
      judge.say(judge.written("generations", search.generations), "must be >= 1");
    }
    const std::string population = judge.written("population", search.population);
    const bool known = judge.knows({"method", "population"});
    if (known && search.method == SearchMethod::kNsga2 && (search.population < 8 || search.population % 4 != 0)) {
      judge.say(population, "nsga2 needs a multiple of 4, at least 8");
    } else if (known && search.population < 4) {
      judge.say(population, "must be at least 4");
    }
    bool ranges = false;
    for (const Vary& vary : study_.varies) {
      if (givesSpeeds(vary)) continue;
      ranges = true;
      if ((vary.values.empty() && !vary.count) || !vary.origin.knows("count")) continue;
      Judge(problems_, "<study><vary>", vary.parameter, vary.origin)
          .say("has steps beside a <search>", "a search takes any value of a range: from and to alone");
    }
    if (!ranges && !strange) judge.say("has nothing to vary", "add a <vary> with from and to");
  }

  void designs() {
    std::map<std::string, Origin> names;
    for (const StudyDesign& design : study_.designs) {
      Judge judge(problems_, "<study><design>", design.name, design.origin);
      if (design.sets.empty() && !study_.origin.hasStrange()) {
        judge.say("sets nothing", "add a <set>; the vehicle as it is is the design \"base\"");
      }
      checkSets(design);
      if (!judge.properName(design.name)) continue;
      if (design.name == kBaseDesign) {
        judge.say(written("name", design.name), "the vehicle as its file says it is called so; choose another name");
      }
      const auto [first, fresh] = names.try_emplace(design.name, design.origin);
      if (!fresh) {
        judge.say(written("name", design.name) + " is already the name of a design" + inLine(first->second),
                  "names are unique in a file");
      }
    }
  }

  void checkSets(const StudyDesign& design) {
    std::map<std::string, Origin> set;
    for (const StudySet& each : design.sets) {
      Judge judge(problems_, "<study><design><set>", each.parameter, each.origin);
      if (each.value.empty() && judge.knows({"value"})) judge.say("has no value", "give one with its unit, e.g. value=\"600 kN/m\"");
      if (!checkAddresses(each.parameter, judge)) continue;
      for (const std::string& address : listedIn(each.parameter)) {
        const auto [first, fresh] = set.try_emplace(address, each.origin);
        if (!fresh) judge.say(address + " is set already" + inLine(first->second), "set it once");
        const auto vary = varied_.find(address);
        if (vary == varied_.end()) continue;
        if (vary->second->kind == Variation::kRelative && !givesSpeeds(*vary->second)) continue;
        judge.say(address + " is varied too" + inLine(vary->second->origin) + ", which would undo the design's value",
                  "vary it with kind=\"relative\", or not at all");
      }
    }
  }

  void metrics() {
    for (const StudyMetric& each : study_.metrics) {
      Judge judge(problems_, "<study><metric>", "", each.origin);
      if (!judge.knows({"name"})) {
        nameless_metric_ = true;
        continue;
      }
      const ParsedMetric parsed = parseMetric(each.name);
      if (!parsed.metric) {
        judge.say(written("name", each.name) + ' ' + parsed.message, parsed.remedy);
        nameless_metric_ = true;
        continue;
      }
      const auto [first, fresh] = metrics_.try_emplace(parsed.metric->name, each.origin);
      if (!fresh) judge.say(written("name", each.name) + " is listed twice" + inLine(first->second), "list it once");
    }
  }

  /// Whether a metric of that name is listed; tells if not.
  bool knows(const std::string& name, Judge& judge) {
    if (metrics_.contains(name)) return true;
    // A metric that is wrong itself may be the one that is meant.
    if (nameless_metric_ || study_.metrics.empty() || study_.origin.hasStrange() || !judge.knows({"metric"}) ||
        !lost_metrics_.insert(name).second) {
      return false;
    }
    std::vector<std::string> names;
    for (const auto& [known, origin] : metrics_) names.push_back(known);
    const auto nearest = nearestName(name, names);
    judge.say(written("metric", name) + " is no <metric> of this study",
              nearest ? "did you mean \"" + *nearest + "\"?" : "add <metric name=\"" + name + "\"/>");
    return false;
  }

  void objectives() {
    std::map<std::string, Origin> seen;
    for (const Objective& each : study_.objectives) {
      Judge judge(problems_, "<study><objective>", each.metric, each.origin);
      if (!knows(each.metric, judge)) continue;
      const auto [first, fresh] = seen.try_emplace(each.metric, each.origin);
      if (!fresh)
        judge.say(written("metric", each.metric) + " has a goal already" + inLine(first->second), "give it one");
    }
  }

  void limits() {
    for (const Limit& each : study_.limits) {
      Judge judge(problems_, "<study><limit>", each.metric, each.origin);
      static_cast<void>(knows(each.metric, judge));
      if (each.below.empty() && each.above.empty() && judge.knows({"below", "above"})) judge.say("has no bound", "give below, above or both");
    }
  }

  const Study& study_;
  ProblemList problems_;
  std::map<std::string, const Vary*> varied_;
  std::map<std::string, Origin> metrics_;
  std::set<std::string> lost_metrics_;  // reported already
  bool nameless_metric_ = false;        // the name of one could not be read or is no metric
};

}  // namespace

std::vector<std::string> listedIn(std::string_view text) {
  constexpr std::string_view kSpaces = " \t\r\n";
  std::vector<std::string> items;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    std::string_view item = text.substr(0, comma);
    more = comma != std::string_view::npos;
    text.remove_prefix(more ? comma + 1 : text.size());
    const std::size_t begin = item.find_first_not_of(kSpaces);
    item = begin == std::string_view::npos ? std::string_view()
                                           : item.substr(begin, item.find_last_not_of(kSpaces) - begin + 1);
    items.emplace_back(item);
  }
  return items;
}

bool givesSpeeds(const Vary& vary) {
  return listedIn(vary.parameter) == std::vector<std::string>{"speed"} && (vary.count || !vary.values.empty());
}

ProblemList check(const Study& study) { return Checks(study).run(); }

}  // namespace vehicle
