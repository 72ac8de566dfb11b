#include "apps/cli/run_files.h"

#include <algorithm>

#include <fmt/format.h>

namespace vehicle::cli {

RunRecord recordOf(const Model& model, const RunChoice& choice, const RunResult& result) {
  RunRecord record;
  record.history = result.history;
  record.attributes = {{"version", VEHICLE_VERSION},
                       {"vehicle", model.vehicle.vehicle.name},
                       {"scenario", model.scenario.name},
                       {"form", result.form},
                       {"method", result.method},
                       {"speed", fmt::format("{} m/s", result.speed)},
                       {"gravity", fmt::format("{} m/s^2", model.scenario.gravity)}};
  for (const Setting& each : model.settings) record.attributes.emplace_back("set " + each.address, each.value);
  if (result.method == "rk4" || result.method == "rk4_split") {
    record.attributes.emplace_back("step", fmt::format("{} s", result.step));
  }
  if (result.method == "dopri5") {
    record.attributes.emplace_back("relative tolerance", fmt::format("{}", choice.relative));
    record.attributes.emplace_back("absolute tolerance", fmt::format("{}", choice.absolute));
  }
  if (result.method == "simbody_rkm") record.attributes.emplace_back("accuracy", fmt::format("{}", choice.accuracy));
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
  record.inputs = model.inputs;
  return record;
}

}  // namespace vehicle::cli
