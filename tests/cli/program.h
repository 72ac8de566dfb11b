#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/test_folder.h"

namespace vehicle::test {

/// What a run of the program `vehicle` left behind.
struct ProgramRun {
  int status = -1;  // exit status; 128 + signal if one killed it
  std::string out;
  std::string err;
};

/// Runs build/.../bin/vehicle with these arguments, stdout and stderr apart, no terminal.
/// @param while_running  called once after `delay`, with the process id
[[nodiscard]] ProgramRun runVehicle(const std::vector<std::string>& arguments,
                                    const std::function<void(int)>& while_running = {},
                                    std::chrono::milliseconds delay = std::chrono::milliseconds(0));

/// models/..., as an absolute path.
[[nodiscard]] std::string model(const std::string& name);

/// A vehicle file of two bodies' worth: one body on one wheelset, enough for every command.
[[nodiscard]] std::string smallVehicle();
/// @param run  attributes of <run>, e.g. R"(speed="20 m/s" duration="1 s" output_step="5 ms")"
[[nodiscard]] std::string smallScenario(const std::string& run);

}  // namespace vehicle::test
