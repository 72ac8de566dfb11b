#include "libvehicle/project/run_files.h"

#include <utility>

#include <fmt/format.h>

#include "libvehicle/project/speeds.h"
#include "libvehicle/project/together.h"

namespace vehicle {

RunRecord recordOf(const Model& model, const RunChoice& choice, const RunResult& result, const std::string& version) {
  RunRecord record;
  record.history = result.history;
  record.attributes = {{"version", version},
                       {"vehicle", model.vehicle.vehicle.name},
                       {"scenario", model.scenario.name},
                       {"form", result.form},
                       {"method", result.method},
                       {"speed", fmt::format("{} m/s", result.speed)},
                       {"gravity", fmt::format("{} m/s^2", model.scenario.gravity)}};
  const SettingsRead& reads = methodNamed(result.method).reads;
  if (reads.step) record.attributes.emplace_back("step", fmt::format("{} s", result.step));
  if (reads.tolerances) {
    record.attributes.emplace_back("relative tolerance", fmt::format("{}", choice.relative));
    record.attributes.emplace_back("absolute tolerance", fmt::format("{}", choice.absolute));
  }
  if (reads.accuracy) record.attributes.emplace_back("accuracy", fmt::format("{}", choice.accuracy));
  record.attributes.emplace_back("scheme", result.scheme);
  record.attributes.emplace_back("threads", fmt::format("{}", result.threads));
  record.attributes.emplace_back("steps", fmt::format("{}", result.statistics.steps));
  record.attributes.emplace_back("evaluations", fmt::format("{}", result.statistics.evaluations));
  record.attributes.emplace_back("rejected steps", fmt::format("{}", result.statistics.rejected));
  record.attributes.emplace_back("ended early", result.statistics.stopped ? "yes" : "no");
  record.attributes.emplace_back("warnings", fmt::format("{}", result.warnings.size()));
  for (std::size_t i = 0; i < result.warnings.size(); ++i) {
    record.attributes.emplace_back(fmt::format("warning {}", i + 1), result.warnings[i].text());
  }
  for (const Setting& each : model.settings) record.attributes.emplace_back("set " + each.address, each.value);
  record.inputs = model.inputs;
  return record;
}

RunResult simulateAndStore(const Model& model, RunChoice choice, const RunOutputs& outputs, const Progress& progress) {
  choice.keep = outputs.files.empty() ? Keep::kNothing : Keep::kOutputs;
  RunResult result = simulate(model.vehicle, model.scenario, choice, progress);
  const RunRecord record = recordOf(model, choice, result, outputs.version);
  for (const std::string& file : outputs.files) writeHistory(file, record);
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
    RunResult& run = runs.emplace_back(
        simulateAndStore(model, own, {filesAtSpeed(outputs.files, speed), outputs.version},
                         [&](double share) { return !progress || progress((before + share) / count); }));
    const std::vector<Channel>& columns = run.history.columns();
    run.history = TimeHistory(std::vector<Channel>(columns.begin() + 1, columns.end()));
    if (run.statistics.stopped) break;
  }
  return runs;
}

}  // namespace vehicle
