#include "apps/cli/options.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/exit_status.h"
#include "apps/cli/help_layout.h"
#include "apps/cli/stdout_page.h"
#include "apps/cli/text_wrap.h"
#include "libvehicle/diagnostics/problem.h"

namespace vehicle::cli {
namespace {

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> commandNames(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::string argumentOf(const CLI::Option& option) {
  std::string name = option.get_type_name();
  if (option.get_items_expected_max() > 1) name += "...";
  return option.get_required() ? name : "[" + name + "]";
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.ends_with('.') ? text : text + ".";
}

/// An option, not an argument or a list, that is given more than once; null where there is none.
const CLI::Option* repeatedIn(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const bool is_list = option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (!option->get_positional() && !is_list && option->count() > 1) return option;
  }
  return nullptr;
}

std::string longNameOf(const CLI::Option& option) { return "--" + option.get_lnames().front(); }

/// Letters of a line of help: no more than people read with ease.
std::size_t helpWidth() {
  constexpr std::size_t kWidest = 100;
  return std::min(kWidest, pageWidth());
}

/// Two columns; what does not fit stands below the beginning of `right`.
std::string twoColumns(const std::vector<std::pair<std::string, std::string>>& lines) {
  std::size_t width = 0;
  for (const auto& [left, right] : lines) width = std::max(width, left.size());
  std::string text;
  for (const auto& [left, right] : lines) {
    text += "  " + left + std::string(width - left.size() + 2, ' ') + wrapped(right, helpWidth(), width + 4) + '\n';
  }
  return text;
}

/// Sentences as wide as the page; command lines as they are, to be copied.
std::string footerOf(const std::string& footer) {
  std::istringstream stream(footer);
  std::string text;
  for (std::string line; std::getline(stream, line);) {
    const bool is_command = line.starts_with("Example: ") || line.starts_with(' ') || line.ends_with('\\');
    text += (is_command ? line : wrapped(line, helpWidth())) + '\n';
  }
  return text;
}

}  // namespace

void addCommonOptions(CLI::App& command, CommonOptions& options) {
  static const std::map<std::string, Format> formats = {
      {"table", Format::kTable}, {"csv", Format::kCsv}, {"json", Format::kJson}};
  command
      .add_option_function<std::string>(
          "--format", [&options](const std::string& name) { options.format = formats.at(name); },
          "table | csv | json, on stdout; csv holds the tables only   (default: table)")
      ->type_name("NAME")
      ->check(oneOf({"table", "csv", "json"}));
  command.add_flag("--quiet,-q", options.quiet,
                   "or -q: no progress or notes on stderr; warnings and errors remain");
  command.add_flag("--strict", options.strict,
                   "exit status 4 where there is a warning   (default: warnings only print)");
}

CLI::Option* addQuantity(CLI::App& command, const std::string& name, Dimension dimension, const std::string& help,
                         std::function<void(double)> store) {
  const auto read = [name, dimension, store = std::move(store)](const std::string& text) {
    const ParsedQuantity quantity = parseQuantity(text, dimension);
    if (!quantity.si) {
      throw CLI::ValidationError(fmt::format("{}: \"{}\" {}; {}", name, text, quantity.message, quantity.remedy),
                                 CLI::ExitCodes::ValidationError);
    }
    if (!(std::isfinite(*quantity.si) && *quantity.si > 0.0)) {
      throw CLI::ValidationError(fmt::format("{}: \"{}\" must be finite and > 0", name, text),
                                 CLI::ExitCodes::ValidationError);
    }
    store(*quantity.si);
  };
  std::string type(dimension == Dimension::kNumber ? "number" : describe(dimension).name);
  std::transform(type.begin(), type.end(), type.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return command.add_option_function<std::string>(name, read, help)->type_name(type);
}

CLI::Option* addCount(CLI::App& command, const std::string& name, int& count, const std::string& help, int most) {
  const auto read = [name, most, &count](const std::string& text) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, count);
    if (error == std::errc() && stop == end && count >= 1 && count <= most) return;
    throw CLI::ValidationError(fmt::format("{}: \"{}\" must be a whole number 1..{}", name, text, most),
                               CLI::ExitCodes::ValidationError);
  };
  return command.add_option_function<std::string>(name, read, help)->type_name("N");
}

void addRunSettings(CLI::App& command, RunChoice& choice) {
  addQuantity(command, "--step", Dimension::kTime,
              "rk4: largest step, shortened to end on samples and breakpoints of the rail   "
              "(default: \"1 ms\", or less as the fastest motion asks)",
              [&choice](double value) { choice.step = value; });
  addQuantity(command, "--rtol", Dimension::kNumber, "dopri5: relative tolerance   (default: 1e-10)",
              [&choice](double value) { choice.relative = value; });
  addQuantity(command, "--atol", Dimension::kNumber,
              "dopri5: absolute tolerance, in m, rad, m/s, rad/s   (default: 1e-12)",
              [&choice](double value) { choice.absolute = value; });
  addQuantity(command, "--accuracy", Dimension::kNumber,
              "simbody_rkm: 100 to 300 times tighter than the error wanted   (default: 1e-10)",
              [&choice](double value) { choice.accuracy = value; });
}

CLI::Validator oneOf(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](std::string& word) {
        return std::find(names.begin(), names.end(), word) != names.end() ? std::string()
                                                                          : unknownName("", word, names);
      },
      "");
}

std::string HelpLayout::make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const {
  const bool is_program = app->get_parent() == nullptr;
  std::string usage = is_program ? "usage: vehicle COMMAND" : "usage: vehicle " + app->get_name();
  std::vector<std::pair<std::string, std::string>> arguments, options, commands;
  for (const CLI::Option* option : app->get_options()) {
    if (option->get_positional()) {
      usage += " " + argumentOf(*option);
      arguments.emplace_back(option->get_type_name(), option->get_description());
    } else {
      std::string left = longNameOf(*option);
      // Flags take nothing.
      if (option->get_items_expected_max() > 0) left += " " + option->get_type_name();
      options.emplace_back(left, option->get_description());
    }
  }
  for (const CLI::App* command : app->get_subcommands(nullptr)) {
    commands.emplace_back(command->get_name(), command->get_description());
  }
  std::string text = wrapped(usage + " [options]", helpWidth(), 4) + "\n\n" +
                     wrapped(sentence(app->get_description()), helpWidth()) + "\n\n";
  if (!commands.empty()) text += twoColumns(commands) + "\n";
  if (!arguments.empty()) text += twoColumns(arguments) + "\n";
  const std::string exit_status = "Exit status: ";
  text += twoColumns(options) + "\n" + footerOf(app->get_footer());
  return text + exit_status + wrapped(kExitStatusHelp, helpWidth(), exit_status.size()) + "\n";
}

void requireGivenOnce(const CLI::App& command) {
  if (repeatedIn(command) != nullptr) throw CLI::ParseError("repeated", CLI::ExitCodes::ArgumentMismatch);
}

std::string explain(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App& app = chosen.empty() ? program : *chosen.front();
  const std::string name = chosen.empty() ? "vehicle" : "vehicle " + app.get_name();
  // A mistyped option leaves its value among the arguments, so it is looked for before anything else is said.
  // What a command does not know goes up to the program.
  std::vector<std::string> unread = app.remaining();
  if (!chosen.empty()) {
    for (const std::string& word : program.remaining()) unread.push_back(word);
  }
  for (const std::string& word : unread) {
    if (word.size() > 1 && word.front() == '-') {
      return fmt::format("{}: {}", name, unknownName("option", word.substr(0, word.find('=')), optionNames(app)));
    }
  }
  if (chosen.empty() && !unread.empty())
    return fmt::format("{}: {}", name, unknownName("command", unread.front(), commandNames(program)));
  if (chosen.empty()) return fmt::format("{}: a command is missing; see vehicle --help", name);
  if (!unread.empty())
    return fmt::format("{}: \"{}\" is one argument too many; see {} --help", name, unread.front(), name);
  if (const CLI::Option* repeated = repeatedIn(app)) {
    return fmt::format("{}: {} is given {} times; give it once", name, longNameOf(*repeated), repeated->count());
  }
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() && option->get_required() && option->count() == 0) {
      return fmt::format("{}: {} is missing; see {} --help", name, option->get_type_name(), name);
    }
  }
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
    const std::string text = error.what();  // "--xsd excludes --markdown"
    return fmt::format("{}: {} and {} exclude each other; give one of them", name, text.substr(0, text.find(' ')),
                       text.substr(text.rfind(' ') + 1));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const std::string text = error.what();
    return fmt::format("{}: {} needs a value; see {} --help", name, text.substr(0, text.find(':')), name);
  }
  return fmt::format("{}: {}; see {} --help", name, error.what(), name);
}

}  // namespace vehicle::cli
