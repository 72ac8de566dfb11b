#include "apps/cli/run_files.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "libvehicle/storage/atomic_file.h"

namespace vehicle::cli {

void requireWritable(const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    static_cast<void>(historyFormatOf(outputs[i]));
    if (std::find(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(i), outputs[i]) !=
        outputs.begin() + static_cast<std::ptrdiff_t>(i)) {
      throw std::invalid_argument(fmt::format("--output {} is given twice", outputs[i]));
    }
  }
  // Opened and given up again: the old file stays as it is.
  for (const std::string& output : outputs) const AtomicFile probe(output);
}

RunRecord recordOf(const Model& model, const RunChoice& choice, const RunResult& result) {
  RunRecord record;
  record.history = result.history;
  record.attributes = {{"version", VEHICLE_VERSION},
                       {"vehicle", model.vehicle.name},
                       {"scenario", model.scenario.name},
                       {"form", result.form},
                       {"method", result.method},
                       {"speed", fmt::format("{} m/s", result.speed)},
                       {"gravity", fmt::format("{} m/s^2", model.scenario.gravity)}};
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
