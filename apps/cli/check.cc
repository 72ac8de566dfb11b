#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/remarks.h"
#include "apps/cli/stdout_page.h"
#include "libvehicle/project/check_file.h"
#include "libvehicle/xml/text_guard.h"

namespace vehicle::cli {
namespace {

struct Judged {
  std::string file;
  CheckedFile found;
};

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

/// Several vehicles may show the same mistake of a scenario.
void appendNew(const ProblemList& found, ProblemList& problems) {
  for (const Problem& each : found) {
    const bool known = std::any_of(problems.begin(), problems.end(),
                                   [&](const Problem& other) { return other.text() == each.text(); });
    if (!known) problems.add(each);
  }
}

int checkFiles(const std::vector<std::string>& files, const std::vector<std::string>& set,
               const CommonOptions& common) {
  FileSource disk;
  Settings settings(set);
  std::vector<Judged> all;
  for (const std::string& file : namesOf(files, disk)) all.push_back({file, checkFile(file, disk, settings)});
  // A file that could not be read may be the one that has the name.
  const bool is_read =
      std::all_of(all.begin(), all.end(), [](const Judged& each) { return each.found.problems.empty(); });
  if (is_read) settings.requireRight();
  // Every scenario given is held against every vehicle given.
  for (Judged& scenario : all) {
    ProblemList found;
    for (const Judged& vehicle : all) appendNew(checkPair(vehicle.found, scenario.found), found);
    scenario.found.problems.append(found);
  }
  Table table{
      "files", {{"file", ""}, {"line", ""}, {"verdict", ""}, {"element", ""}, {"message", ""}, {"remedy", ""}}, {}};
  bool right = true;
  Warnings warnings;
  for (const auto& [file, found] : all) {
    right = right && found.problems.empty();
    if (found.problems.empty()) table.rows.push_back({file, {}, std::string("ok"), {}, {}, {}});
    for (const Problem& problem : found.problems) {
      table.rows.push_back({problem.place.file, static_cast<long>(problem.place.line), std::string("error"),
                            problem.element, problem.message, problem.remedy});
    }
    warnings.insert(warnings.end(), found.warnings.begin(), found.warnings.end());
    if (common.format != Format::kTable) continue;
    std::cout << (found.problems.empty() ? file + ": ok\n" : found.problems.text());
  }
  Document document{{}, {table}, {}};
  addWarnings(warnings, common, document);
  if (common.format != Format::kTable) printToStdout(document, common.format);
  std::cout.flush();  // the verdicts stand before what is said about them
  for (const Judged& judged : all) printNotes(judged.found.notes, common);
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
  return [options] { return checkFiles(options->files, options->settings, options->common); };
}

}  // namespace vehicle::cli
