#include "apps/cli/thread_options.h"

#include <charconv>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "apps/cli/remarks.h"
#include "libvehicle/partition/scheme.h"
#include "libvehicle/simulate/thread_choice.h"
#include "libvehicle/threads/waiting.h"

namespace vehicle::cli {
namespace {

int threadsOf(const std::string& text) {
  if (text == "auto") return 0;
  int threads = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, threads);
  if (error != std::errc() || stop != end || threads < 1 || threads > kMostThreads) {
    throw CLI::ValidationError(
        fmt::format("--threads: \"{}\" must be a whole number 1..{}, or auto", text, kMostThreads),
        CLI::ExitCodes::ValidationError);
  }
  return threads;
}

void addName(CLI::App& command, const char* option, const std::vector<std::string>& names, const char* help,
             const std::function<void(const std::string&)>& take) {
  command.add_option_function<std::string>(option, take, help)->type_name("NAME")->check(oneOf(names));
}

// A table of names and what they stand for makes an option of its own type.
template <class Value>
void addChoice(CLI::App& command, const char* option, Value& value, const std::map<std::string, Value>& known,
               const char* help) {
  std::vector<std::string> names;
  for (const auto& [name, meaning] : known) names.push_back(name);
  command
      .add_option_function<std::string>(
          option, [&value, known](const std::string& name) { value = known.at(name); }, help)
      ->type_name("NAME")
      ->check(oneOf(names));
}

/// Nothing where it was not found out.
Cell nanoseconds(double seconds) { return seconds > 0.0 ? Cell(1e9 * seconds) : Cell(); }

}  // namespace

void addSharing(CLI::App& command, RunChoice& choice, const std::string& default_threads) {
  command
      .add_option_function<std::string>(
          "--threads", [&choice](const std::string& text) { choice.sharing.threads = threadsOf(text); },
          "threads that share the run, or auto: what a short calibration finds to be fastest   (default: " +
              default_threads + ")")
      ->type_name("N");
  addName(command, "--scheme", schemeNames(),
          "how they share it: serial | stages | halo | pipeline (rk4), split (rk4_split)   (default: serial on 1 "
          "thread, else the fastest known for the method)",
          [&choice](const std::string& name) { choice.sharing.scheme = schemeOf(name); });
  addName(command, "--map", equationMapNames(),
          "stages, halo: who computes which equation, paper | body | auto   (default: auto)",
          [&choice](const std::string& name) { choice.sharing.map = equationMapOf(name); });
}

void addTeam(CLI::App& command, TeamPolicy& team) {
  addName(command, "--waiting", waitingNames(),
          "how a thread waits for another: auto | spin | yield | sleep   (default: auto)",
          [&team](const std::string& name) { team.waiting = waitingKindOf(name); });
  addChoice(command, "--pinning", team.pinning,
            std::map<std::string, Pinning>{{"cores", Pinning::kCores}, {"free", Pinning::kFree}},
            "cores: each thread stays on a core of its own as far as there are enough; free: the scheduler moves "
            "them   (default: cores)");
  addChoice(command, "--priority", team.priority,
            std::map<std::string, Priority>{
                {"normal", Priority::kNormal}, {"raised", Priority::kRaised}, {"fifo", Priority::kFifo}},
            "normal | raised | fifo, as far as the system permits   (default: normal, with --realtime fifo)");
}

std::vector<Fact> sharingFacts(const RunResult& result) {
  std::vector<Fact> facts = {{"scheme", result.scheme, ""}, {"threads", static_cast<long>(result.threads), ""}};
  if (!result.decision.reason.empty()) {
    facts.push_back({"chosen because", result.decision.reason, ""});
    facts.push_back({"calibration", 1e3 * result.decision.calibration, "ms"});
  }
  return facts;
}

void noteUnshared(const RunChoice& choice, const RunResult& result, const CommonOptions& common) {
  constexpr int kSeveral = 2;
  if (choice.sharing.threads != 0 || canBeShared(result.form, result.method)) return;
  printNote("--threads auto is one thread: " + threadsUnsupported(result.form, result.method, {.threads = kSeveral}),
            common);
}

Table decisionTable(const Decision& decision) {
  Table table{"ways to run it",
              {{"scheme", ""}, {"threads", ""}, {"predicted", "ns/step"}, {"measured", "ns/step"}, {"taken", ""}},
              {},
              2};
  if (decision.reason.empty()) return table;
  for (const Candidate& each : decision.candidates) {
    table.rows.push_back({std::string(nameOf(each.scheme)), static_cast<long>(each.threads),
                          nanoseconds(each.predicted), nanoseconds(each.measured),
                          each.scheme == decision.scheme && each.threads == decision.threads});
  }
  return table;
}

}  // namespace vehicle::cli
