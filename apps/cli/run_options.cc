#include "apps/cli/run_options.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/partition/scheme.h"

namespace vehicle::cli {
namespace {

/// Whether the command has the option and the user gave it.
bool isGiven(const CLI::App& command, const std::string& option) {
  const CLI::Option* known = command.get_option_no_throw(option);
  return known != nullptr && known->count() > 0;
}

[[noreturn]] void refuse(const std::string& option, const std::string& why, const std::string& remedy) {
  throw std::invalid_argument(fmt::format("{} has no effect: {}; {}", option, why, remedy));
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

}  // namespace

void requireSettingsUsed(const CLI::App& command, const std::vector<std::string>& methods, const std::string& why) {
  for (const Setting& each : kSettings) {
    if (!isGiven(command, each.option)) continue;
    const bool is_read = std::any_of(methods.begin(), methods.end(),
                                     [&](const std::string& method) { return settingsReadBy(method).*each.is_read; });
    if (!is_read) {
      refuse(each.option, fmt::format("{}, and {}", why, each.rule),
             fmt::format("omit it, or take --method {}", each.remedy));
    }
  }
}

void requireSpeedUsed(const CLI::App& command, const std::vector<Scenario>& scenarios) {
  if (!isGiven(command, "--speed") || scenarios.empty()) return;
  const auto needs = [](const Scenario& each) { return each.track.has_value() || each.run.distance.has_value(); };
  if (std::any_of(scenarios.begin(), scenarios.end(), needs)) return;
  refuse("--speed",
         fmt::format("the scenario \"{}\" is a rig with a duration, where no wheel rolls", scenarios.front().name),
         "omit it");
}

void requireSharingUsed(const CLI::App& command, const RunChoice& choice) {
  if (!isAlone(choice)) return;
  const bool shares = choice.sharing.scheme && choice.sharing.scheme != Scheme::kSerial;
  if (isGiven(command, "--scheme") && shares) {
    refuse(fmt::format("--scheme {}", nameOf(*choice.sharing.scheme)), "the run has one thread and shares nothing",
           "omit it, or add --threads 2");
  }
  if (isGiven(command, "--map")) {
    refuse(fmt::format("--map {}", nameOf(choice.sharing.map)), "the run has one thread, which computes all equations",
           shares || !choice.sharing.scheme ? "omit it, or add --threads 2"
                                            : "omit it, or take --threads 2 with another scheme");
  }
}

void requireThreadsFor(const CLI::App& command, const std::vector<std::string>& options, const RunChoice& choice) {
  if (!isAlone(choice)) return;
  for (const std::string& each : options) {
    if (isGiven(command, each)) {
      refuse(each, "the run has one thread, the program's own", "omit it, or take --threads 2");
    }
  }
}

void requireRunOptionsUsed(const CLI::App& command, const RunChoice& choice, const Model& model) {
  requireSharingUsed(command, choice);
  requireSpeedUsed(command, {model.scenario});
  const std::string form = choice.form.empty() ? defaultForm(model.vehicle) : choice.form;
  const std::string method = choice.method.empty() ? defaultMethod(form, model.vehicle) : choice.method;
  // A method that cannot run the form is what is to be said first; the run says it.
  if (!methodMisfit(method, form).empty()) return;
  requireSettingsUsed(command, {method},
                      fmt::format("the method is {}{}", method, choice.method.empty() ? ", by default" : ""));
}

}  // namespace vehicle::cli
