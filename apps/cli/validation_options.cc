#include "apps/cli/validation_options.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/run_options.h"
#include "libvehicle/validation/plan.h"

namespace vehicle::cli {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& why, const std::string& remedy) {
  throw std::invalid_argument(fmt::format("{} has no effect: {}; {}", option, why, remedy));
}

void requireOnce(const char* option, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& each : names) {
    if (!seen.insert(each).second) throw std::invalid_argument(fmt::format("{} {} is given twice", option, each));
  }
}

/// What runs in any of the cases.
struct Planned {
  std::set<std::string> methods;
  bool shares = false;  // some run among threads, unless --serial omits them
};

Planned plannedOf(const SuiteWork& work) {
  ValidationChoice choice = work.choice;
  choice.shared = usualSharedColumns();
  Planned planned;
  for (const ValidationCase& each : work.cases) {
    const ValidationPlan plan = validationPlanOf(modelOf(work, each), choice);
    for (const RunKey& run : plan.runs) {
      planned.methods.insert(run.method);
      planned.shares = planned.shares || !run.scheme.empty();
    }
  }
  return planned;
}

bool isAnyGiven(const CLI::App& command, const std::vector<std::string>& options) {
  return std::any_of(options.begin(), options.end(),
                     [&](const std::string& option) { return command.count(option) > 0; });
}

void requireSharedRunsFor(const CLI::App& command, const ValidationWork& work, bool shares) {
  const bool serial = command.count("--serial") > 0;
  const std::string none = "none of these runs is shared among threads, as only some of the form flat are";
  if (serial && !shares) refuse("--serial", none, "omit it");
  if (shares && !serial) return;
  const std::string why = serial ? "--serial omits the runs that threads share" : none;
  if (command.count("--time-limit") > 0) refuse("--time-limit", why, "omit it");
  // A suite may have cases of which nothing can be judged for other reasons.
  if (command.count("--allow-unjudged") > 0 && !work.hasSeveral()) refuse("--allow-unjudged", why, "omit it");
}

}  // namespace

void requireValidationOptionsUsed(const CLI::App& command, const ValidationWork& work, const ValidationChoice& given,
                                  const CommonOptions& common) {
  requireOnce("--form", given.forms);
  requireOnce("--method", given.methods);
  requireSpeedUsed(command, work.cases.scenarios);
  if (command.count("--details") > 0 && work.hasSeveral()) {
    refuse("--details", work.is_suite ? "a suite prints one line for each case" : "several speeds print one line each",
           work.is_suite ? "omit it, or validate one vehicle and scenario" : "omit it, or give one speed");
  }
  if (command.count("--details") > 0 && common.format != Format::kTable) {
    refuse("--details", "csv and json hold every detail always", "omit it");
  }
  // The plan asks for eigenvalues of every vehicle: only where something depends on it.
  if (!isAnyGiven(command,
                  {"--step", "--rtol", "--atol", "--accuracy", "--serial", "--time-limit", "--allow-unjudged"})) {
    return;
  }
  const Planned planned = plannedOf(work.cases);
  std::string names;
  for (const std::string& each : planned.methods) names += (names.empty() ? "" : ", ") + each;
  requireSettingsUsed(command, {planned.methods.begin(), planned.methods.end()},
                      "the methods that run here are " + names);
  requireSharedRunsFor(command, work, planned.shares);
}

}  // namespace vehicle::cli
