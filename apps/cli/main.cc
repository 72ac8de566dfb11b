#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
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

int told(const std::string& page) {
  std::cout << page;
  return kDone;
}

struct Command {
  Action (*add)(CLI::App&);
  bool looks;  // whether it looks for interrupted() on its way; a signal ends the others at once
  const CLI::App* app = nullptr;
  Action action = {};
};

/// Their order is that of --help.
std::vector<Command> addCommands(CLI::App& program) {
  std::vector<Command> commands = {{addCheck, false},   {addInfo, false},   {addSimulate, true}, {addModes, false},
                                   {addValidate, true}, {addProfile, true}, {addStudy, true},    {addSchema, false}};
  for (Command& each : commands) {
    each.action = each.add(program);
    CLI::App* app = program.get_subcommands(nullptr).back();
    app->set_help_flag("--help", "this page");
    each.app = app;
  }
  return commands;
}

int run(int argc, char** argv) {
  CLI::App program("Rail vehicle dynamics: one XML vehicle, several forms that check each other.", "vehicle");
  program.formatter(std::make_shared<HelpLayout>());
  program.set_help_flag("--help", "this page; vehicle COMMAND --help tells what the command takes");
  program.set_version_flag("--version", "vehicle " VEHICLE_VERSION, "name and version");
  program.require_subcommand(1);
  program.footer("Example: vehicle simulate models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml");
  const std::vector<Command> commands = addCommands(program);

  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const CLI::App& asked = program.get_subcommands().empty() ? program : *program.get_subcommands().front();
    return perform([&] { return told(asked.help()); });
  } catch (const CLI::CallForVersion& version) {
    return perform([&] { return told(std::string(version.what()) + '\n'); });
  } catch (const CLI::ParseError& error) {
    std::cerr << explain(program, error) << '\n';
    return kCommandLineIsWrong;
  }
  for (const Command& each : commands) {
    if (each.app != program.get_subcommands().front()) continue;
    if (each.looks) catchInterrupt();
    return perform(each.action);
  }
  return kCommandLineIsWrong;
}

}  // namespace
}  // namespace vehicle::cli

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file as large as it may be is an error of its write, nothing to be killed for
  return vehicle::cli::run(argc, argv);
}
