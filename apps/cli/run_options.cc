#include "apps/cli/run_options.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/options.h"
#include "libvehicle/partition/scheme.h"
#include "libvehicle/threads/waiting.h"
#include "libvehicle/simulate/thread_choice.h"

namespace vehicle::cli {
namespace {

/// Whether the command has the option and the user gave it.
bool isGiven(const CLI::App& command, const std::string& option) {
  const CLI::Option* known = command.get_option_no_throw(option);
  return known != nullptr && known->count() > 0;
}

struct Setting {
  const char* option;
  bool SettingsRead::*is_read;
  const char* rule;    // who reads it
  const char* remedy;  // the method that does
};
constexpr Setting kSettings[] = {
    {"--step", &SettingsRead::step, "only rk4 and rk4_split take steps of a given size", "rk4"},
    {"--rtol", &SettingsRead::tolerances, "only dopri5 has tolerances", "dopri5"},
    {"--atol", &SettingsRead::tolerances, "only dopri5 has tolerances", "dopri5"},
    {"--accuracy", &SettingsRead::accuracy, "only simbody_rkm has an accuracy", "simbody_rkm"},
};

/// One thread, known before the run: the number is 1, or the scheme says so.
bool isAlone(const RunChoice& choice) {
  return choice.sharing.threads == 1 || choice.sharing.scheme == Scheme::kSerial;
}

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

void refuseWithoutEffect(const std::string& option, const std::string& why, const std::string& remedy) {
  throw std::invalid_argument(fmt::format("{} has no effect: {}; {}", option, why, remedy));
}

void requireSettingsUsed(const CLI::App& command, const std::vector<std::string>& methods, const std::string& why) {
  for (const Setting& each : kSettings) {
    if (!isGiven(command, each.option)) continue;
    const bool is_read = std::any_of(methods.begin(), methods.end(), [&](const std::string& method) {
      return methodNamed(method).reads.*each.is_read;
    });
    if (!is_read) {
      refuseWithoutEffect(each.option, fmt::format("{}, and {}", why, each.rule),
                          fmt::format("omit it, or take --method {}", each.remedy));
    }
  }
}

void requireSpeedUsed(const CLI::App& command, const std::vector<Scenario>& scenarios) {
  if (!isGiven(command, "--speed") || scenarios.empty()) return;
  if (std::ranges::any_of(scenarios, wheelsRoll)) return;
  refuseWithoutEffect(
      "--speed",
      fmt::format("the scenario \"{}\" is a rig with a duration, where no wheel rolls", scenarios.front().name),
      "omit it");
}

void requireSharingUsed(const CLI::App& command, const RunChoice& choice) {
  if (!isAlone(choice)) return;
  const bool shares = choice.sharing.scheme && choice.sharing.scheme != Scheme::kSerial;
  if (isGiven(command, "--scheme") && shares) {
    refuseWithoutEffect(fmt::format("--scheme {}", nameOf(*choice.sharing.scheme)), "the run has one thread and shares nothing",
           "omit it, or add --threads 2");
  }
  if (isGiven(command, "--map")) {
    refuseWithoutEffect(fmt::format("--map {}", nameOf(choice.sharing.map)), "the run has one thread, which computes all equations",
           shares || !choice.sharing.scheme ? "omit it, or add --threads 2"
                                            : "omit it, or take --threads 2 with another scheme");
  }
}

void requireThreadsFor(const CLI::App& command, const std::vector<std::string>& options, const RunChoice& choice) {
  if (!isAlone(choice)) return;
  for (const std::string& each : options) {
    if (isGiven(command, each)) {
      refuseWithoutEffect(each, "the run has one thread, the program's own", "omit it, or take --threads 2");
    }
  }
}

void requireRunOptionsUsed(const CLI::App& command, const RunChoice& choice, const Model& model) {
  requireSharingUsed(command, choice);
  requireSpeedUsed(command, {model.scenario});
  const std::string form = choice.form.empty() ? defaultForm(model.vehicle.topology) : choice.form;
  const std::string method = choice.method.empty() ? defaultMethod(form, model.vehicle.topology) : choice.method;
  // A method that cannot run the form is what is to be said first; the run says it.
  if (!methodUnsupported(method, form).empty()) return;
  requireSettingsUsed(command, {method},
                      fmt::format("the method is {}{}", method, choice.method.empty() ? ", by default" : ""));
}

}  // namespace vehicle::cli
