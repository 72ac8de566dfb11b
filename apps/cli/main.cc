#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/options.h"
#include "apps/cli/progress.h"
#include "libvehicle/diagnostics/problem.h"

namespace vehicle::cli {
namespace {

/// The action of the command chosen; its errors become messages on stderr and an exit status.
int perform(const Action& action) {
  try {
    const int status = action();
    if (!std::cout.flush()) throw RunFailed("stdout cannot be written");
    return status;
  } catch (const InvalidInput& wrong) {
    std::cerr << wrong.problems().text();
    return kInputIsWrong;
  } catch (const std::invalid_argument& wrong) {
    std::cerr << "vehicle: " << wrong.what() << '\n';
    return kCommandLineIsWrong;
  } catch (const std::exception& failure) {
    std::cerr << "vehicle: " << failure.what() << '\n';
    return kRunFailed;
  }
}

int run(int argc, char** argv) {
  CLI::App program("Rail vehicle dynamics: one XML vehicle, several forms that check each other.", "vehicle");
  program.formatter(std::make_shared<HelpLayout>());
  program.set_help_flag("--help", "this page; vehicle COMMAND --help tells what the command takes");
  program.set_version_flag("--version", "vehicle " VEHICLE_VERSION, "name and version");
  program.require_subcommand(1);
  program.footer("Example: vehicle simulate models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml");
  std::vector<std::pair<const CLI::App*, Action>> actions;
  for (Action (*add)(CLI::App&) : {addCheck, addInfo, addSimulate, addModes, addValidate, addProfile, addStudy, addSchema}) {
    Action action = add(program);
    CLI::App* command = program.get_subcommands(nullptr).back();
    command->set_help_flag("--help", "this page");
    actions.emplace_back(command, std::move(action));
  }

  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << (program.get_subcommands().empty() ? program : *program.get_subcommands().front()).help();
    return kDone;
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
    return kDone;
  } catch (const CLI::ParseError& error) {
    std::cerr << explain(program, error) << '\n';
    return kCommandLineIsWrong;
  }
  catchInterrupt();
  for (const auto& [command, action] : actions) {
    if (command == program.get_subcommands().front()) return perform(action);
  }
  return kCommandLineIsWrong;
}

}  // namespace
}  // namespace vehicle::cli

int main(int argc, char** argv) { return vehicle::cli::run(argc, argv); }
