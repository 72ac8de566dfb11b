#pragma once

#include <functional>

#include "apps/cli/cli11.h"

namespace vehicle::cli {

/// What a command does once its line is read; returns the exit status.
using Action = std::function<int()>;

// Each adds its command to the program and returns its action. One file each.
[[nodiscard]] Action addCheck(CLI::App& program);
[[nodiscard]] Action addInfo(CLI::App& program);
[[nodiscard]] Action addSimulate(CLI::App& program);
[[nodiscard]] Action addModes(CLI::App& program);
[[nodiscard]] Action addValidate(CLI::App& program);
[[nodiscard]] Action addProfile(CLI::App& program);
[[nodiscard]] Action addStudy(CLI::App& program);
[[nodiscard]] Action addSchema(CLI::App& program);

}  // namespace vehicle::cli
