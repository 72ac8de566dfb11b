#include "libvehicle/study/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "libvehicle/study/compare/pareto.h"
#include "libvehicle/study/compare/verdict.h"
#include "libvehicle/study/search/search_study.h"

namespace vehicle {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// The numbers whose dependence on the factors is told.
class Outputs {
 public:
  Outputs(const BoundStudy& bound, const Verdict& verdict, std::size_t most) : bound_(bound), verdict_(verdict) {
    for (const BoundObjective& each : bound.objectives) {
      const std::size_t cases = verdict.columnsOf(each.metric).size();
      std::string name = bound.metrics[each.metric].metric.name;
      if (cases > 1) name += (each.over == Over::kMean ? ", mean of " : ", worst of ") + std::to_string(cases);
      names_.push_back(std::move(name));
    }
    if (!names_.empty()) return;
    for (const MetricColumn& each : metricColumns(bound)) {
      if (names_.size() < most) names_.push_back(each.channel.name);
    }
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] std::vector<double> of(std::span<const double> metrics) const {
    if (metrics.empty()) return std::vector<double>(names_.size(), kNothing);
    if (!bound_.objectives.empty()) return verdict_.objectives(metrics);
    return {metrics.begin(), metrics.begin() + static_cast<std::ptrdiff_t>(names_.size())};
  }

 private:
  const BoundStudy& bound_;
  const Verdict& verdict_;
  std::vector<std::string> names_;
};

class Summary {
 public:
  Summary(const StudyDatabase& database, const StudyInputs& inputs, const DesignPlan& plan, const SummaryChoice& choice)
      : database_(database),
        inputs_(inputs),
        bound_(inputs.bound),
        plan_(plan),
        choice_(choice),
        verdict_(inputs.bound),
        outputs_(inputs.bound, verdict_, choice.outputs),
        front_(inputs.bound.objectives.size()),
        regressions_(outputs_.names().size(), Regression(inputs.bound.factors.size())) {
    summary_.designs = database.record().designs;
    summary_.best.resize(bound_.objectives.size());
    best_.resize(bound_.objectives.size());
    few_ = summary_.designs <= choice.all_up_to;
    const bool saltelli = inputs.study.plan && inputs.study.plan->kind == PlanKind::kSaltelli && !inputs.study.search;
    if (!saltelli) return;
    sensitivity_.order = inputs.study.plan->second_order;
    blocks_.assign(outputs_.names().size(), std::vector<double>(plan.points(), kNothing));
  }

  StudySummary run() {
    database_.forEach([this](const StoredDesign& design) {
      add(design);
      return true;
    });
    summary_.incomplete = missing_.designs();
    summary_.missing = missing_.mostFrequent(choice_.reasons);
    fetchChosen();
    if (!bound_.factors.empty()) tellInfluences();
    return std::move(summary_);
  }

 private:
  void add(const StoredDesign& design) {
    ++summary_.stored;
    if (design.status == DesignStatus::kFailed) {
      ++summary_.failed;
      if (summary_.failures.size() < choice_.failures) summary_.failures.push_back(judged(design));
    }
    if (few_ || design.id < bound_.designs.size()) summary_.compared.push_back(judged(design));
    learn(design);
    if (design.status == DesignStatus::kFailed) return;
    missing_.add(design.metrics, design.message);
    count(design);
    if (!verdict_.keepsLimits(design.metrics)) return;
    ++summary_.within_limits;
    const std::vector<double> values = verdict_.toMinimise(design.metrics);
    if (values.size() > 1) front_.add(design.id, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isnan(values[i])) keepIfGood(best_[i], {values[i], design.id});
    }
  }

  void count(const StoredDesign& design) {
    if (design.warnings.empty()) return;
    ++summary_.warned;
    for (const WarningCode code : design.warnings.codes()) {
      const auto at = std::lower_bound(summary_.warnings.begin(), summary_.warnings.end(), code,
                                       [](const WarnedDesigns& each, WarningCode other) { return each.code < other; });
      if (at != summary_.warnings.end() && at->code == code) {
        ++at->designs;
      } else {
        summary_.warnings.insert(at, {code, 1, designName(inputs_, plan_, design.id)});
      }
    }
  }

  using Rank = std::pair<double, std::uint64_t>;  // equal values: the one with the smaller number
  void keepIfGood(std::vector<Rank>& best, Rank rank) const {
    best.insert(std::upper_bound(best.begin(), best.end(), rank), rank);
    if (best.size() > choice_.best) best.pop_back();
  }

  void learn(const StoredDesign& design) {
    // Named designs lie off the plan; those that are crossed with it would count the factors of another vehicle.
    const bool searched = inputs_.study.search && design.id >= plan_.size();
    std::optional<std::uint64_t> point;
    if (!searched) {
      const DesignIdentity identity = plan_.identityOf(design.id);
      if (identity.named != 0 || !identity.point) return;
      point = identity.point;
    }
    const std::vector<double> y = outputs_.of(design.status == DesignStatus::kDone ? design.metrics
                                                                                   : std::span<const double>());
    std::vector<double> x;
    for (const Factor& factor : bound_.factors) x.push_back(design.parameters[factor.parameters.front()]);
    ++learned_;
    for (std::size_t i = 0; i < y.size(); ++i) {
      regressions_[i].add(x, y[i]);
      if (!blocks_.empty()) blocks_[i][*point] = y[i];
    }
  }

  void fetchChosen() {
    std::map<std::uint64_t, JudgedDesign> chosen;
    for (const std::vector<Rank>& each : best_) {
      for (const Rank& rank : each) chosen.emplace(rank.second, JudgedDesign{});
    }
    for (const ParetoFront::Member& each : front_.members()) chosen.emplace(each.design, JudgedDesign{});
    if (chosen.empty()) return;
    const std::uint64_t last = chosen.rbegin()->first;
    database_.forEach([&](const StoredDesign& design) {
      if (const auto found = chosen.find(design.id); found != chosen.end()) found->second = judged(design);
      return design.id < last;
    });
    for (std::size_t i = 0; i < best_.size(); ++i) {
      for (const Rank& rank : best_[i]) summary_.best[i].push_back(chosen.at(rank.second));
    }
    for (const ParetoFront::Member& each : front_.members()) summary_.front.push_back(chosen.at(each.design));
  }

  void tellInfluences() {
    for (std::size_t i = 0; i < outputs_.names().size(); ++i) {
      const std::uint64_t designs = regressions_[i].designs();
      if (designs < 3 && blocks_.empty()) continue;
      Influence influence;
      influence.output = outputs_.names()[i];
      influence.designs = designs;
      influence.left_out = learned_ - designs;
      influence.correlations = regressions_[i].correlations();
      influence.fit = regressions_[i].fit();
      if (!blocks_.empty()) influence.indices = sensitivityOf(blocks_[i], bound_.factors.size(), sensitivity_);
      summary_.influences.push_back(std::move(influence));
    }
  }

  JudgedDesign judged(const StoredDesign& design) const {
    JudgedDesign made;
    made.id = design.id;
    made.name = designName(inputs_, plan_, design.id);
    made.parameters.assign(design.parameters.begin(), design.parameters.end());
    made.message = design.message;
    made.warnings = design.warnings;
    if (design.status == DesignStatus::kFailed) return made;
    made.metrics.assign(design.metrics.begin(), design.metrics.end());
    made.objectives = verdict_.objectives(design.metrics);
    made.violations = verdict_.violations(design.metrics);
    for (const BoundObjective& each : bound_.objectives) {
      const bool has_worst = each.over == Over::kWorst && verdict_.columnsOf(each.metric).size() > 1;
      made.worst.push_back(has_worst ? verdict_.worstColumn(each, design.metrics) : std::nullopt);
    }
    return made;
  }

  const StudyDatabase& database_;
  const StudyInputs& inputs_;
  const BoundStudy& bound_;
  const DesignPlan& plan_;
  const SummaryChoice& choice_;
  Verdict verdict_;
  Outputs outputs_;
  ParetoFront front_;
  std::vector<std::vector<Rank>> best_;
  std::vector<Regression> regressions_;       // (outputs)
  std::vector<std::vector<double>> blocks_;   // (outputs x points) of a Saltelli plan
  SensitivityChoice sensitivity_;
  std::uint64_t learned_ = 0;  // designs that the influences ask
  MissingCount missing_;
  bool few_ = false;
  StudySummary summary_;
};

}  // namespace

bool JudgedDesign::keepsLimits() const {
  return !failed() && std::all_of(violations.begin(), violations.end(), [](double each) { return each == 0.0; });
}

std::string designName(const StudyInputs& inputs, const DesignPlan& plan, std::uint64_t design) {
  if (design < plan.size()) return plan.nameOf(design);
  return SearchNumbers(plan, *inputs.study.search).nameOf(design);
}

StudySummary summarise(const StudyDatabase& database, const StudyInputs& inputs, const DesignPlan& plan,
                       const SummaryChoice& choice) {
  return Summary(database, inputs, plan, choice).run();
}

}  // namespace vehicle
