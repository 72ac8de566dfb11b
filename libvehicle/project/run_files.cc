#include "libvehicle/project/run_files.h"

#include <utility>

#include <fmt/format.h>

#include "libvehicle/project/speeds.h"
#include "libvehicle/project/together.h"
#include "libvehicle/simulate/methods.h"

namespace vehicle {

RunDescription descriptionOf(const Model& model, const RunChoice& choice, const RunResult& result,
                             const std::string& version) {
  RunDescription description;
  description.attributes = {{"version", version},
                            {"vehicle", model.vehicle.vehicle.name},
                            {"scenario", model.scenario.name},
                            {"form", result.form},
                            {"method", result.method},
                            {"speed", fmt::format("{} m/s", result.speed)},
                            {"gravity", fmt::format("{} m/s^2", model.scenario.gravity)}};
  const SettingsRead& reads = methodNamed(result.method).reads;
  if (reads.step) description.attributes.emplace_back("step", fmt::format("{} s", result.step));
  if (reads.tolerances) {
    description.attributes.emplace_back("relative tolerance", fmt::format("{}", choice.relative));
    description.attributes.emplace_back("absolute tolerance", fmt::format("{}", choice.absolute));
  }
  if (reads.accuracy) description.attributes.emplace_back("accuracy", fmt::format("{}", choice.accuracy));
  description.attributes.emplace_back("scheme", result.scheme);
  description.attributes.emplace_back("threads", fmt::format("{}", result.threads));
  description.attributes.emplace_back("steps", fmt::format("{}", result.statistics.steps));
  description.attributes.emplace_back("evaluations", fmt::format("{}", result.statistics.evaluations));
  description.attributes.emplace_back("rejected steps", fmt::format("{}", result.statistics.rejected));
  description.attributes.emplace_back("ended early", result.statistics.stopped ? "yes" : "no");
  description.attributes.emplace_back("warnings", fmt::format("{}", result.warnings.size()));
  for (std::size_t i = 0; i < result.warnings.size(); ++i) {
    description.attributes.emplace_back(fmt::format("warning {}", i + 1), result.warnings[i].text());
  }
  for (const Setting& each : model.settings) description.attributes.emplace_back("set " + each.address, each.value);
  description.inputs = model.inputs;
  return description;
}

RunResult simulateAndStore(const Model& model, RunChoice choice, const RunOutputs& outputs, const Progress& progress) {
  choice.keep = Keep::kNothing;
  HistoryFiles files(outputs.files);
  RunResult result = simulate(model.vehicle, model.scenario, choice, progress, files.empty() ? nullptr : &files);
  files.publish(descriptionOf(model, choice, result, outputs.version));
  return result;
}

std::vector<RunResult> simulateSpeeds(const Model& model, const RunChoice& choice, const std::vector<double>& speeds,
                                      const RunOutputs& outputs, const Progress& progress) {
  ProblemList problems;
  for (const double speed : speeds) problems.append(checkTogether(model.vehicle, model.scenario, speed));
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  const double count = static_cast<double>(speeds.size());
  std::vector<RunResult> runs;
  for (const double speed : speeds) {
    RunChoice own = choice;
    own.speed = speed;
    const double before = static_cast<double>(runs.size());
    runs.push_back(simulateAndStore(model, own, {filesAtSpeed(outputs.files, speed), outputs.version},
                                    [&](double share) { return !progress || progress((before + share) / count); }));
    if (runs.back().statistics.stopped) break;
  }
  return runs;
}

}  // namespace vehicle
