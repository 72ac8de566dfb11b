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
#include "libvehicle/simulate/thread_choice.h"
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

std::vector<ThreadWork> workOf(const System& system, Scheme scheme, EquationMap map, int threads,
                               const std::vector<std::vector<int>>& shares) {
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
  if (map == EquationMap::kPaper && scheme == Scheme::kStages) {
    work[static_cast<std::size_t>(kRailThread)].what += ", the rail (6)";
  }
  return work;
}

/// One run as all ways see it.
class Sharing {
 public:
  Sharing(const std::string& method, const System& system, const MethodSettings& settings, std::span<const double> x0,
          const ThreadRequest& request)
      : method_(method), system_(system), settings_(settings), x0_(x0), request_(request) {}

  [[nodiscard]] SharedRun run(Scheme scheme, int threads, const Input& input, const Schedule& schedule,
                              const Observer& observe) const {
    TeamChoice team = request_.team;
    team.threads = threads;
    const auto* flat = dynamic_cast<const FlatForm*>(&system_);
    const auto made = [&](auto run) {
      SharedRun shared{run.statistics, scheme, threads, std::move(run.team), {}, {}};
      if (shared.team.members.empty()) return shared;
      std::vector<std::vector<int>> shares;
      if constexpr (requires { run.shares; }) shares = std::move(run.shares);
      shared.work = workOf(system_, scheme, request_.map, threads, shares);
      return shared;
    };
    switch (scheme) {
      case Scheme::kSerial:
        return {runMethod(method_, system_, input, schedule, settings_, x0_, observe), scheme, 1, {}, {}, {}};
      case Scheme::kPipeline:
        return made(flat != nullptr
                        ? runFlatPipeline(*flat, input, schedule, settings_.step, x0_, observe, team).run
                        : runPipeline(system_, input, schedule, settings_.step, x0_, observe, team).run);
      case Scheme::kSplit:
        if (const std::string misfit = splitMethodMisfit(method_, system_); !misfit.empty()) {
          throw std::invalid_argument(misfit);
        }
        return made(method_ == "exact_split"
                        ? runFlatExactSplit(*flat, input, schedule, x0_, observe, team)
                        : runFlatRk4Split(*flat, input, schedule, settings_.step, x0_, observe, team));
      case Scheme::kStages:
        if (flat == nullptr) break;
        return made(
            runFlatStages(*flat, input, schedule, settings_.step, x0_, observe, {scheme, request_.map, team}));
      case Scheme::kHalo:
      case Scheme::kRows:
        break;
    }
    return made(runPartitioned(system_, input, schedule, settings_.step, x0_, observe, {scheme, request_.map, team}));
  }

  /// Schemes that share the work of this method on this system, the likeliest first.
  [[nodiscard]] std::vector<Scheme> schemes(int threads) const {
    std::vector<Scheme> fit;
    for (const Scheme scheme : schemesOf(method_)) {
      if (scheme == Scheme::kSerial || !fits(scheme, threads)) continue;
      if (request_.map != EquationMap::kAuto && !sharesEquations(scheme)) continue;  // who names a map wants it used
      fit.push_back(scheme);
    }
    // Threads with many equations each are worth an exchange a step; with few, only the rail can be shared.
    const EquationSet* set = system_.equations();
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
    const EquationSet* set = system_.equations();
    if (set == nullptr || static_cast<int>(set->equations().size()) < threads) return false;
    if (request_.map == EquationMap::kAuto) return true;
    try {
      (void)shareEquations(*set, request_.map, threads);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  }

  /// Says why no scheme fits the threads that were asked for.
  [[noreturn]] void refuse() const {
    const EquationSet* set = system_.equations();
    if (set == nullptr || set->equations().size() < 2) {
      throw std::invalid_argument(
          fmt::format("{} of this form has no more than one equation to share; take --threads 1", method_));
    }
    if (request_.map != EquationMap::kAuto) (void)shareEquations(*set, request_.map, request_.threads);
    throw std::invalid_argument(
        fmt::format("{} threads for {} equations: every thread computes at least one; take at most {}",
                    request_.threads, set->equations().size(), set->equations().size()));
  }

  [[nodiscard]] Way way(Scheme scheme, int threads) const {
    return {scheme, threads,
            [this, scheme, threads](const Input& input, const Schedule& schedule, const Observer& show) {
              Sharing untraced(*this);
              untraced.request_.team.tracer = nullptr;
              (void)untraced.run(scheme, threads, input, schedule, show);
            }};
  }

 private:
  static constexpr int kManyEquations = 16;

  const std::string& method_;
  const System& system_;
  const MethodSettings& settings_;
  std::span<const double> x0_;
  ThreadRequest request_;
};

}  // namespace

SharedRun runShared(const std::string& method, const System& system, const Input& input, const Schedule& schedule,
                    const MethodSettings& settings, std::span<const double> x0, const Observer& observe,
                    const ThreadRequest& request) {
  const Sharing sharing(method, system, settings, x0, request);
  const bool any_scheme = request.scheme.empty();
  std::vector<Way> ways;
  if (request.threads == 1 || (request.threads == 0 && (any_scheme || request.scheme == nameOf(Scheme::kSerial)))) {
    ways.push_back(sharing.way(any_scheme ? Scheme::kSerial : schemeOf(request.scheme), 1));
  }
  std::vector<int> counts = {request.threads};
  if (request.threads == 0) counts = threadCounts(allowedCoreCount());
  if (request.threads == 0 && isSplitMethod(method)) std::erase_if(counts, [](int threads) { return threads > 2; });
  for (const int threads : counts) {
    if (threads == 1 || request.scheme == nameOf(Scheme::kSerial)) continue;
    if (!any_scheme) {
      const Scheme scheme = schemeOf(request.scheme);
      if (request.threads > 0 || sharing.fits(scheme, threads)) ways.push_back(sharing.way(scheme, threads));
      continue;
    }
    for (const Scheme scheme : sharing.schemes(threads)) ways.push_back(sharing.way(scheme, threads));
  }
  if (ways.empty() && request.threads == 0) ways.push_back(sharing.way(schemeOf(request.scheme), 1));
  if (ways.empty()) sharing.refuse();

  Decision decision{.scheme = ways.front().scheme, .threads = ways.front().threads};
  if (request.threads == 0 || ways.size() > 1) {
    const bool exact = method.starts_with("exact");
    const long steps = exact ? static_cast<long>(schedule.stretches().size()) : stepsOfRun(schedule, settings.step);
    decision = chooseWay({system, input, schedule, steps, exact, request.map, request.team}, ways);
  }
  SharedRun run = sharing.run(decision.scheme, decision.threads, input, schedule, observe);
  run.decision = std::move(decision);
  return run;
}

}  // namespace vehicle
