#include "libvehicle/study/search/search_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/study/compare/verdict.h"
#include "libvehicle/study/search/search.h"

namespace vehicle {

namespace {

using Clock = std::chrono::steady_clock;

/// A design as the search needs it again.
struct Known {
  std::vector<double> parameters;
  std::vector<double> objectives;  // to minimise; empty: it has no results
  double violation = 0.0;          // relative, over all limits; infinite where a value is missing
};

class StudySearch {
 public:
  StudySearch(const StudyInputs& inputs, const DesignPlan& plan, StudyDatabase& database, Executor& executor,
              const StudyWatch& watch)
      : bound_(inputs.bound),
        plan_(plan),
        settings_(*inputs.study.search),
        numbers_(plan, settings_),
        evaluator_(inputs),
        verdict_(inputs.bound),
        database_(database),
        executor_(executor),
        watch_(watch) {
    outcome_.progress.designs = numbers_.size();
    outcome_.progress.before = database.stored();
    database.forEach([this](const StoredDesign& design) {
      known_.emplace(design.id, know(design.parameters, design.metrics));
      return true;
    });
  }

  StudyOutcome run() {
    const std::size_t parameters = bound_.parameters.size();
    std::vector<double> values(numbers_.told() * parameters);
    for (std::uint64_t design = 0; design < numbers_.told(); ++design) {
      plan_.valuesOf(design, std::span(values).subspan(design * parameters, parameters));
    }
    if (evaluate(0, values)) {
      const std::size_t variables = bound_.factors.size();
      const SearchBounds cube{std::vector<double>(variables, 0.0), std::vector<double>(variables, 1.0)};
      search(settings_, cube, bound_.objectives.size(),
             [this](int generation, std::span<const double> points, SearchAnswers answers) {
               return answer(generation, points, answers);
             });
    }
    const Ending ending = outcome_.ending;  // an interrupt that comes now is too late
    report();
    outcome_.ending = ending;
    return outcome_;
  }

 private:
  bool answer(int generation, std::span<const double> points, SearchAnswers answers) {
    const std::size_t variables = bound_.factors.size();
    const std::size_t parameters = bound_.parameters.size();
    const std::size_t count = answers.violations.size();
    std::vector<double> values(count * parameters);
    for (std::size_t i = 0; i < count; ++i) {
      plan_.valuesAt(0, points.subspan(i * variables, variables),
                     std::span(values).subspan(i * parameters, parameters));
    }
    if (!evaluate(numbers_.firstOf(generation), values)) return false;
    for (std::size_t i = 0; i < count; ++i) {
      const Known& design = known_.at(numbers_.firstOf(generation) + i);
      answers.violations[i] = design.violation;
      std::copy(design.objectives.begin(), design.objectives.end(),
                answers.objectives.begin() + static_cast<std::ptrdiff_t>(i * bound_.objectives.size()));
    }
    return true;
  }

  /// Makes designs first .. known: those that are not stored are evaluated, and stored together.
  /// @param values  (designs x parameters)
  bool evaluate(std::uint64_t first, const std::vector<double>& values) {
    const std::size_t parameters = bound_.parameters.size();
    Workload workload;
    for (std::size_t i = 0; i * parameters < values.size(); ++i) {
      const auto given = std::span(values).subspan(i * parameters, parameters);
      const std::uint64_t id = first + i;
      if (const auto stored = known_.find(id); stored != known_.end()) {
        requireSame(id, given, stored->second.parameters);
        continue;
      }
      const auto number = static_cast<std::int64_t>(id);
      if (!workload.ranges.empty() && workload.ranges.back().end == number) {
        ++workload.ranges.back().end;
      } else {
        workload.ranges.push_back({number, number + 1});
      }
      workload.given.insert(workload.given.end(), given.begin(), given.end());
    }
    if (workload.ranges.empty()) return report();
    DesignBatch finished(parameters, evaluator_.columns() - parameters);
    const auto store = [&] {
      if (finished.size() > 0) database_.append(finished);
      finished.clear();
    };
    try {
      outcome_.ending = executor_.run(
          evaluator_, workload, [&](Batch& batch) { take(batch, finished); }, [this] { return report(); });
    } catch (...) {
      store();
      throw;
    }
    store();
    return outcome_.ending == Ending::kFinished && report();
  }

  void take(Batch& batch, DesignBatch& finished) {
    const std::size_t parameters = bound_.parameters.size();
    batch.forEach(evaluator_.columns(), [&](const EvaluatedDesign& each) {
      add(each, finished);
      std::span<const double> metrics;
      if (!each.failed) metrics = each.row.subspan(parameters);
      known_.emplace(static_cast<std::uint64_t>(each.design), know(each.row.first(parameters), metrics));
      outcome_.progress.failed += each.failed ? 1 : 0;
      ++outcome_.progress.evaluated;
    });
  }

  /// @param metrics  empty for a design that failed
  Known know(std::span<const double> parameters, std::span<const double> metrics) const {
    Known known{{parameters.begin(), parameters.end()}, {}, std::numeric_limits<double>::infinity()};
    if (metrics.empty()) return known;
    known.objectives = verdict_.toMinimise(metrics);
    // A design that lacks an objective is worse than all that have it, as one that failed.
    if (!std::all_of(known.objectives.begin(), known.objectives.end(), [](double x) { return std::isfinite(x); })) {
      return known;
    }
    known.violation = 0.0;
    const std::vector<double> overstepped = verdict_.violations(metrics);
    for (std::size_t i = 0; i < overstepped.size(); ++i) {
      const BoundLimit& limit = bound_.limits[i];
      const double size = std::max(std::abs(limit.below.value_or(0.0)), std::abs(limit.above.value_or(0.0)));
      known.violation += size > 0.0 ? overstepped[i] / size : overstepped[i];
    }
    return known;
  }

  void requireSame(std::uint64_t id, std::span<const double> now, const std::vector<double>& stored) const {
    if (std::equal(now.begin(), now.end(), stored.begin(), stored.end())) return;
    throw RunFailed("design " + (id < plan_.size() ? plan_.nameOf(id) : numbers_.nameOf(id)) +
                    " of the database is not the one that this search comes to; it was "
                    "written with another version of the search library: start anew in another file");
  }

  bool report() {
    outcome_.progress.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    const bool go_on = !watch_ || watch_(outcome_.progress);
    if (!go_on) outcome_.ending = Ending::kStopped;
    return go_on;
  }

  const BoundStudy& bound_;
  const DesignPlan& plan_;
  const Search& settings_;
  SearchNumbers numbers_;
  StudyEvaluator evaluator_;
  Verdict verdict_;
  StudyDatabase& database_;
  Executor& executor_;
  const StudyWatch& watch_;
  std::map<std::uint64_t, Known> known_;
  Clock::time_point begin_ = Clock::now();
  StudyOutcome outcome_;
};

}  // namespace

std::string SearchNumbers::nameOf(std::uint64_t design) const {
  const std::uint64_t point = design - told_;
  return "generation " + std::to_string(point / population_) + " #" + std::to_string(point % population_);
}

StudyRecord searchRecordOf(const DesignPlan& plan, const Search& settings, const StudyTarget& target) {
  StudyRecord record = recordOf(plan, target);
  record.designs = SearchNumbers(plan, settings).size();
  return record;
}

StudyOutcome searchStudy(const StudyInputs& inputs, const DesignPlan& plan, const StudyTarget& target,
                         Executor& executor, const StudyWatch& watch) {
  if (!executor.leads()) {
    serve(StudyEvaluator(inputs), executor);
    return {};
  }
  const StudyRecord record = searchRecordOf(plan, *inputs.study.search, target);
  StudyDatabase database = openOrCreate(target, record);
  return StudySearch(inputs, plan, database, executor, watch).run();
}

}  // namespace vehicle
