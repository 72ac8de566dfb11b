#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/options.h"
#include "libvehicle/excitation/excitation.h"
#include "libvehicle/statics/rest.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::cli {
namespace {

/// What a definition still hides when its own values are right: a weight that its springs cannot carry, a rail
/// that jumps, names that the vehicle does not have.
ProblemList checkPair(const Vehicle& vehicle, const std::optional<Scenario>& scenario) {
  try {
    const Topology topology = topologyOf(vehicle);
    constexpr double kGravity = 9.81;  // [m/s^2]
    static_cast<void>(restOf(topology, scenario ? scenario->gravity : kGravity));
    if (!scenario) return {};
    if (ProblemList problems = check(*scenario, vehicle); !problems.empty()) return problems;
    static_cast<void>(inputOf(*scenario, topology, scenario->run.speed));
  } catch (const InvalidInput& wrong) {
    return wrong.problems();
  }
  return {};
}

struct Judged {
  std::string file;
  ProblemList problems;
  std::optional<Vehicle> vehicle;
  std::optional<Scenario> scenario;
};

Judged judge(const std::string& file) {
  Judged judged{file, checkFile(file), {}, {}};
  if (!judged.problems.empty()) return judged;
  const FileKind kind = kindOf(file).value.value_or(FileKind::kSuite);
  if (kind == FileKind::kVehicle || kind == FileKind::kTrain) judged.vehicle = readVehicle(file).value;
  if (kind == FileKind::kScenario) judged.scenario = readScenario(file).value;
  if (judged.vehicle) judged.problems = checkPair(*judged.vehicle, std::nullopt);
  return judged;
}

int checkFiles(const std::vector<std::string>& files, const CommonOptions& common) {
  std::vector<Judged> all;
  for (const std::string& file : files) all.push_back(judge(file));
  // Every scenario given is held against every vehicle given.
  for (Judged& scenario : all) {
    if (!scenario.scenario || !scenario.problems.empty()) continue;
    for (const Judged& vehicle : all) {
      if (vehicle.vehicle && vehicle.problems.empty()) {
        scenario.problems.append(checkPair(*vehicle.vehicle, scenario.scenario));
      }
    }
  }
  Table table{
      "files", {{"file", ""}, {"line", ""}, {"verdict", ""}, {"element", ""}, {"message", ""}, {"remedy", ""}}, {}};
  ExitStatus status = kDone;
  for (const Judged& judged : all) {
    if (judged.problems.empty()) table.rows.push_back({judged.file, {}, std::string("ok"), {}, {}, {}});
    for (const Problem& problem : judged.problems) {
      table.rows.push_back({problem.place.file, static_cast<long>(problem.place.line), std::string("error"),
                            problem.element, problem.message, problem.remedy});
      status = kInputIsWrong;
    }
    if (common.format != Format::kTable) continue;
    std::cout << (judged.problems.empty() ? judged.file + ": ok\n" : judged.problems.text());
  }
  if (common.format != Format::kTable) print({{}, {table}, {}}, common.format, std::cout);
  return status;
}

}  // namespace

Action addCheck(CLI::App& program) {
  struct Options {
    std::vector<std::string> files;
    CommonOptions common;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("check", "judge files of any kind; print all problems");
  command
      ->add_option("files", options->files,
                   "files of any kind; each scenario is also held against each vehicle and train given")
      ->type_name("FILE")
      ->required()
      ->expected(1, 1 << 20);
  addCommonOptions(*command, options->common);
  command->footer(
      "Example: vehicle check models/vehicles/*.xml models/scenarios/*.xml\n"
      "Problems go to stdout, one a line: FILE:LINE: error: ELEMENT: what is wrong; what to write instead.");
  return [options] { return checkFiles(options->files, options->common); };
}

}  // namespace vehicle::cli
