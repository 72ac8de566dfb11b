#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/help_layout.h"
#include "apps/cli/options.h"
#include "apps/cli/progress.h"
#include "apps/cli/request.h"
#include "libvehicle/diagnostics/problem.h"

namespace vehicle::cli {
namespace {

/// The action of the command chosen; its errors become messages on stderr and an exit status.
int perform(const Action& action) {
  try {
    const int status = action();
    // A terminal that has hung up takes no more; what was done is saved all the same.
    if (!std::cout.flush() && status != kInterrupted) throw RunFailed("stdout cannot be written");
    return status;
  } catch (const InvalidInput& wrong) {
    std::cerr << wrong.problems().text();
    return kInputIsWrong;
  } catch (const std::invalid_argument& wrong) {
    std::istringstream lines(wrong.what());
    for (std::string line; std::getline(lines, line);) std::cerr << "vehicle: " << line << '\n';
    return kCommandLineIsWrong;
  } catch (const std::exception& failure) {
    std::cerr << "vehicle: " << failure.what() << '\n';
    return kRunFailed;
  }
}

int printPage(const std::string& page) {
  return perform([&page] {
    std::cout << page;
    return static_cast<int>(kDone);
  });
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
    app->set_help_flag("--help", "this page; -h and vehicle help " + app->get_name() + " print it too");
    each.app = app;
  }
  return commands;
}

int run(const std::vector<std::string>& line) {
  CLI::App program(
      "Rail vehicle dynamics: one XML vehicle, several independent formulations (forms) that check each other.",
      "vehicle");
  program.formatter(std::make_shared<HelpLayout>());
  program.set_help_flag("--help", "this page; vehicle help COMMAND shows what the command takes");
  program.set_version_flag("--version", "vehicle " VEHICLE_VERSION, "name and version");
  program.require_subcommand(1);
  program.footer("Example: vehicle simulate models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml");
  const std::vector<Command> commands = addCommands(program);
  std::vector<std::string> names;
  for (const Command& each : commands) names.push_back(each.app->get_name());

  Request request = requestOf(line, names);
  if (request.kind == Request::Kind::kVersion) return printPage("vehicle " VEHICLE_VERSION "\n");
  if (request.kind == Request::Kind::kHelp) {
    const CLI::App& asked = request.command.empty() ? program : *program.get_subcommand(request.command);
    return printPage(asked.help());
  }
  try {
    std::reverse(request.words.begin(), request.words.end());  // as CLI11 takes them
    program.parse(request.words);
    requireGivenOnce(*program.get_subcommands().front());
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
  return vehicle::cli::run({argv + std::min(argc, 1), argv + argc});
}
