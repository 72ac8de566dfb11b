#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "libvehicle/project/check_file.h"
#include "libvehicle/report/document/problem_table.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle::cli {
namespace {

/// Standard input in messages, as compilers call it. What it names is looked up from the current folder.
constexpr const char* kStandardInput = "<stdin>";

/// The names of the files, standard input read into the source where "-" asks for it.
/// @throws std::invalid_argument  it is asked for twice
std::vector<std::string> namesOf(std::vector<std::string> files, FileSource& source) {
  const auto first = std::find(files.begin(), files.end(), "-");
  if (first == files.end()) return files;
  if (std::find(first + 1, files.end(), "-") != files.end()) {
    throw std::invalid_argument("check: \"-\" is given twice, and standard input can be read once; give it once");
  }
  *first = kStandardInput;
  // One byte more than a file may have is enough to know that it is too large.
  std::string text(kMostBytes + 1, '\0');
  std::cin.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::cin.gcount()));
  source.hold(kStandardInput, std::move(text));
  return files;
}

int checkAndPrint(const std::vector<std::string>& files, const std::vector<std::string>& set,
                  const CommonOptions& common) {
  FileSource disk;
  Settings settings(set);
  const std::vector<NamedCheck> all = checkFiles(namesOf(files, disk), disk, settings);
  report::Table table = report::problemTable();
  bool right = true;
  Warnings warnings;
  for (const auto& [file, found] : all) {
    right = right && found.problems.empty();
    report::addProblems(file, found.problems, table);
    warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
    if (common.format != report::Format::kTable) continue;
    std::cout << (found.problems.empty() ? file + ": ok\n" : found.problems.text());
  }
  if (common.format != report::Format::kTable) printDocument({{}, {table}, {}}, warnings, common);
  std::cout.flush();  // the verdicts stand before what is said about them
  for (const NamedCheck& each : all) printNotes(each.found.notes, common);
  printWarnings(warnings);
  return right ? statusAfter(warnings, common) : kInputIsWrong;
}

}  // namespace

Action addCheck(CLI::App& program) {
  struct Options {
    std::vector<std::string> files;
    std::vector<std::string> settings;
    CommonOptions common;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("check", "check files of any kind and print every problem");
  command
      ->add_option("files", options->files,
                   "files of any kind, - for standard input (<stdin> in messages); each scenario is "
                   "also checked together with each vehicle and train given")
      ->type_name("FILE")
      ->required()
      ->expected(1, 1 << 20);
  addSet(*command, options->settings, "; in every file that has the name");
  addCommonOptions(*command, options->common);
  command->footer(
      "Example: vehicle check models/vehicles/*.xml models/scenarios/*.xml\n"
      "Problems go to stdout, one a line: FILE:LINE: error: ELEMENT: what is wrong; what to write instead.\n"
      "Warnings and notes about files without problems go to stderr.");
  return [options] { return checkAndPrint(options->files, options->settings, options->common); };
}

}  // namespace vehicle::cli
