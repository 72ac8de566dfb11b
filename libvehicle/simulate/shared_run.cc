#include "libvehicle/simulate/shared_run.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/partition/map/equation_graph.h"
#include "libvehicle/partition/map/equation_map.h"
#include "libvehicle/partition/run.h"
#include "libvehicle/simulate/flat_by_type.h"
#include "libvehicle/simulate/flat_split_run.h"
#include "libvehicle/threads/placement.h"

namespace vehicle {

namespace {

/// Equations of a share by name, in its order; of four neighbours or more the first and the last.
std::string namesOf(const EquationSet& set, const std::vector<int>& share) {
  constexpr int kSpelled = 4;
  const auto name = [&](int e) -> const std::string& { return set.equations()[static_cast<std::size_t>(e)].name; };
  std::string names;
  for (const EquationRun& run : runsOf(share)) {
    if (run.size() > kSpelled) {
      names += fmt::format("{}{} to {}", names.empty() ? "" : ", ", name(run.first), name(run.last - 1));
      continue;
    }
    for (int e = run.first; e < run.last; ++e) names += (names.empty() ? "" : ", ") + name(e);
  }
  return names;
}

std::vector<ThreadWork> workOf(const System& system, const Sharing& sharing,
                               const std::vector<std::vector<int>>& shares) {
  const Scheme scheme = *sharing.scheme;
  const int threads = sharing.threads;
  const int all = system.size() / 2;
  if (scheme == Scheme::kSplit) {
    if (threads == 1) return {{all, "bounce and pitch"}};
    return {{all / 2, "bounce: carbody and both bogies in phase"},
            {all / 2, "pitch: carbody and both bogies in antiphase"}};
  }
  const EquationSet* set = system.equations();
  std::vector<ThreadWork> work;
  if (scheme == Scheme::kPipeline) {
    std::vector<int> every(static_cast<std::size_t>(all));
    std::iota(every.begin(), every.end(), 0);
    work.push_back({all, set != nullptr ? namesOf(*set, every) : "all equations"});
    for (int thread = 1; thread < threads; ++thread) work.push_back({0, "the rail ahead"});
    return work;
  }
  for (const std::vector<int>& share : shares) work.push_back({static_cast<int>(share.size()), namesOf(*set, share)});
  if (sharing.map == EquationMap::kPaper && scheme == Scheme::kStages) {
    work[static_cast<std::size_t>(kRailThread)].what += ", the rail (6)";
  }
  return work;
}

/// One run as all ways see it.
class SharedRuns {
 public:
  SharedRuns(const Method& method, const RunProblem& problem, const MethodSettings& settings,
             const ThreadRequest& request)
      : method_(method), problem_(problem), settings_(settings), request_(request) {}

  /// The run on that input and schedule, by sharing.scheme.
  [[nodiscard]] SharedRun run(const RunProblem& problem, const Sharing& sharing, const TeamPolicy& team,
                              const Observer& observe) const {
    const Scheme scheme = *sharing.scheme;
    const int threads = sharing.threads;
    const auto made = [&](auto run) {
      SharedRun shared{run.statistics, scheme, threads, std::move(run.team), {}, {}};
      if (shared.team.members.empty()) return shared;
      std::vector<std::vector<int>> shares;
      if constexpr (requires { run.shares; }) shares = std::move(run.shares);
      shared.work = workOf(problem.system, sharing, shares);
      return shared;
    };
    switch (scheme) {
      case Scheme::kSerial:
        return {.statistics = method_.make(problem, settings_)->run(problem.schedule, problem.x0, observe)};
      case Scheme::kPipeline:
        return made(runFlatPipeline(problem, settings_.step, observe, threads, team).run);
      case Scheme::kSplit:
        return made(runFlatRk4Split(problem, settings_.step, observe, threads, team));
      case Scheme::kStages:
      case Scheme::kHalo:
        break;
    }
    return made(runPartitioned(problem, settings_.step, observe, sharing, team));
  }

  [[nodiscard]] SharedRun run(const Sharing& sharing, const Observer& observe) const {
    return run(problem_, sharing, request_.team, observe);
  }

  /// Schemes that share the work of this method on this system, the likeliest first.
  [[nodiscard]] std::vector<Scheme> schemes(int threads) const {
    std::vector<Scheme> fit;
    for (const Scheme scheme : method_.schemes) {
      if (scheme == Scheme::kSerial || !fits(scheme, threads)) continue;
      if (request_.sharing.map != EquationMap::kAuto && !sharesEquations(scheme))
        continue;  // who names a map wants it used
      fit.push_back(scheme);
    }
    // Threads with many equations each are worth an exchange a step; with few, only the rail can be shared.
    const EquationSet* set = problem_.system.equations();
    const bool long_train = set != nullptr && set->size() >= 2 * kManyEquations * threads;
    const Scheme best = long_train ? Scheme::kHalo : Scheme::kPipeline;
    std::stable_partition(fit.begin(), fit.end(), [&](Scheme scheme) { return scheme == best; });
    // Its one stepping thread has the whole train in its cache at every stage; trying it takes up to 64 MB of rows.
    if (long_train) std::erase(fit, Scheme::kPipeline);
    return fit;
  }

  /// Whether the system has equations to share, as many as threads, and the map knows so many threads.
  [[nodiscard]] bool fits(Scheme scheme, int threads) const {
    if (!sharesEquations(scheme)) return true;
    const EquationSet* set = problem_.system.equations();
    if (set == nullptr || static_cast<int>(set->equations().size()) < threads) return false;
    if (request_.sharing.map == EquationMap::kAuto) return true;
    try {
      (void)shareEquations(*set, request_.sharing.map, threads);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  }

  /// Says why no scheme fits the threads that were asked for.
  [[noreturn]] void refuse() const {
    const EquationSet* set = problem_.system.equations();
    if (set == nullptr || set->equations().size() < 2) {
      throw std::invalid_argument(
          fmt::format("{} of this form has no more than one equation to share; take --threads 1", method_.name));
    }
    if (request_.sharing.map != EquationMap::kAuto)
      (void)shareEquations(*set, request_.sharing.map, request_.sharing.threads);
    throw std::invalid_argument(
        fmt::format("{} threads for {} equations: every thread computes at least one; take at most {}",
                    request_.sharing.threads, set->equations().size(), set->equations().size()));
  }

  [[nodiscard]] Way way(Scheme scheme, int threads) const {
    const Sharing sharing{threads, scheme, request_.sharing.map};
    return {scheme, threads, [this, sharing](const Input& input, const Schedule& schedule, const Observer& show) {
              TeamPolicy untraced = request_.team;
              untraced.tracer = nullptr;
              (void)run({problem_.system, input, schedule, problem_.x0}, sharing, untraced, show);
            }};
  }

  /// All that were asked for: one, or those worth a trial.
  [[nodiscard]] std::vector<Way> ways() const {
    const Sharing& asked = request_.sharing;
    const bool serial = asked.scheme == Scheme::kSerial;
    std::vector<Way> ways;
    if (asked.threads == 1 || (asked.threads == 0 && (!asked.scheme || serial))) {
      ways.push_back(way(asked.scheme.value_or(Scheme::kSerial), 1));
    }
    std::vector<int> counts = {asked.threads};
    if (asked.threads == 0) counts = threadCounts(allowedCoreCount());
    if (const int most = method_.most_threads; asked.threads == 0 && most > 0) {
      std::erase_if(counts, [most](int threads) { return threads > most; });
    }
    for (const int threads : counts) {
      if (threads == 1 || serial) continue;
      if (!asked.scheme) {
        for (const Scheme scheme : schemes(threads)) ways.push_back(way(scheme, threads));
      } else if (asked.threads > 0 || fits(*asked.scheme, threads)) {
        ways.push_back(way(*asked.scheme, threads));
      }
    }
    if (ways.empty() && asked.threads == 0) ways.push_back(way(*asked.scheme, 1));
    if (ways.empty()) refuse();
    return ways;
  }

 private:
  static constexpr int kManyEquations = 16;

  const Method& method_;
  const RunProblem& problem_;
  const MethodSettings& settings_;
  const ThreadRequest& request_;
};

}  // namespace

SharedRun runShared(const Method& method, const RunProblem& problem, const MethodSettings& settings,
                    const Observer& observe, const ThreadRequest& request) {
  const SharedRuns runs(method, problem, settings, request);
  const std::vector<Way> ways = runs.ways();
  Decision decision{.scheme = ways.front().scheme, .threads = ways.front().threads};
  if (request.sharing.threads == 0 || ways.size() > 1) {
    const long steps = ways.size() > 1 ? stepsOfRun(problem.schedule, settings.step) : 0;
    decision = chooseWay({problem, steps, request.sharing.map}, ways);
  }
  SharedRun run = runs.run({decision.threads, decision.scheme, request.sharing.map}, observe);
  run.decision = std::move(decision);
  return run;
}

}  // namespace vehicle
