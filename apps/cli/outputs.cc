#include "apps/cli/outputs.h"

#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>

namespace vehicle::cli {

void addOverwrite(CLI::App& command, Overwrite& overwrite, const std::string& more) {
  command.add_flag_callback(
      "--overwrite", [&overwrite] { overwrite = Overwrite::kAnyFile; },
      "replace files that this program has not written, too, but no input" + more +
          "   (default: only outputs of earlier runs and empty files are replaced)");
}

void requireOutputForOverwrite(const CLI::App& command, const std::vector<std::string>& outputs) {
  if (command.count("--overwrite") == 0) return;
  std::string names;
  for (const std::string& each : outputs) {
    if (command.count(each) > 0) return;
    names += (names.empty() ? "" : " or ") + each;
  }
  throw std::invalid_argument(
      fmt::format("--overwrite has no effect: nothing is to be written; omit it, or add {}", names));
}

void protectModel(OutputGuard& guard, const Model& model) {
  for (const InputFile& each : model.inputs) guard.protect(each.name, "the input file");
}

}  // namespace vehicle::cli
