#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/options.h"
#include "apps/cli/study_work.h"

namespace vehicle::cli {

Action addStudy(CLI::App& program) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command = program.add_subcommand("study", "compare many designs of a vehicle, and keep every one");
  command
      ->add_option("study", options->study,
                   "study file, e.g. models/studies/secondary-suspensions.xml; or the word show")
      ->type_name("STUDY|show")
      ->required();
  command->add_option("database", options->shown, "after show: a database that a study has written")
      ->type_name("DATABASE");
  command
      ->add_option("--output", options->database,
                   "database of the designs, .sqlite; it must not exist unless --resume is given   (required)")
      ->type_name("FILE");
  command->add_flag("--resume", options->resume,
                    "go on with --output where it ends, if it is there   (default: refuse to touch it)");
  addCount(*command, "--jobs", options->jobs, "threads   (default: every processor this program may use)", 1024);
  addCount(*command, "--best", options->best, "designs shown of each objective   (default: 5)", 1000);
  command
      ->add_option("--write-best", options->best_folder,
                   "vehicle files of these designs; without objectives, of the named designs   (default: none)")
      ->type_name("FOLDER");
  command->add_option("--export", options->csv, "the whole table as CSV   (default: none)")->type_name("FILE");
  addCommonOptions(*command, options->common);
  command->footer(
      "Every design is kept at once: a study that is killed loses a few seconds and goes on with --resume.\n"
      "vehicle study show FILE.sqlite reads an old study. On several machines: mpirun -n 4 vehicle study ...\n"
      "Example: vehicle study models/studies/secondary-suspensions.xml --output suspensions.sqlite");
  return [options] {
    if (options->study == "show") {
      if (options->shown.empty()) throw std::invalid_argument("study show: DATABASE is missing");
      if (!options->database.empty() || options->resume) {
        throw std::invalid_argument("study show reads only; leave out --output and --resume");
      }
      return showStudy(*options);
    }
    if (!options->shown.empty()) {
      throw std::invalid_argument(
          fmt::format("study: \"{}\" is one file too many; only `study show` takes a second", options->shown));
    }
    if (options->database.empty()) {
      throw std::invalid_argument("study: --output is missing, e.g. --output study.sqlite: every design is kept there");
    }
    return runStudyFile(*options);
  };
}

}  // namespace vehicle::cli
