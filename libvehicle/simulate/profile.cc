#include "libvehicle/simulate/profile.h"

#include <algorithm>

namespace vehicle {
namespace {

constexpr int kRounds = 5;
constexpr double kEnough = 2.0;  // [s]

/// The time a step of a run, unless that was ended early.
void addTime(const RunResult& result, StepTimes& times) {
  if (!result.statistics.stopped && result.statistics.steps > 0) {
    times.seconds.push_back(result.wall_seconds / static_cast<double>(result.statistics.steps));
  }
}

}  // namespace

double StepTimes::median() const {
  if (seconds.empty()) return 0.0;
  std::vector<double> sorted = seconds;
  std::ranges::sort(sorted);
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

double StepTimes::least() const { return seconds.empty() ? 0.0 : std::ranges::min(seconds); }

Profile profileOf(const CompiledModel& model, const Scenario& scenario, const RunChoice& choice, int every,
                  const Progress& progress) {
  Profile profile;
  RunChoice serial = choice;
  serial.sharing = {.threads = 1, .scheme = Scheme::kSerial};
  RunChoice plain = choice;
  Tracer tracer(every);  // one for all rounds: after the first its memory is at hand
  const double begin = secondsNow();
  double round_took = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0 && secondsNow() - begin + round_took > kEnough) break;
    const double round_begin = secondsNow();
    const auto run = [&](RunChoice each, StepTimes& times, int number) {
      each.measures = false;  // the steps are what is timed
      RunResult result = simulate(model, scenario, each, [&](double share) {
        return !progress || progress((3.0 * round + number + share) / (3.0 * kRounds));
      });
      addTime(result, times);
      profile.stopped = profile.stopped || result.statistics.stopped;
      return result;
    };
    const RunResult alone = run(serial, profile.serial, 0);
    if (profile.stopped) return profile;
    const RunResult shared = run(plain, profile.plain, 1);
    if (profile.stopped) return profile;
    // Where the choice was left open, the traced run and the runs after it take what was found first.
    plain.sharing.threads = shared.threads;
    plain.sharing.scheme = schemeOf(shared.scheme);
    if (shared.threads == 1)
      plain.sharing.map = EquationMap::kAuto;  // nobody is left to share the equations that it names
    RunChoice watched = plain;
    watched.team.tracer = &tracer;
    const Decision decision = round == 0 ? shared.decision : profile.run.decision;
    profile.run = run(watched, profile.traced, 2);
    profile.run.decision = decision;
    if (profile.stopped) return profile;
    profile.trace = tracer.trace();
    round_took = secondsNow() - round_begin;
  }
  return profile;
}

}  // namespace vehicle
