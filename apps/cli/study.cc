#include <memory>

#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/outputs.h"
#include "apps/cli/study_options.h"
#include "apps/cli/study_work.h"

namespace vehicle::cli {

Action addStudy(CLI::App& program) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command =
      program.add_subcommand("study", "compare many designs of a vehicle and store every one in a database");
  command
      ->add_option("study", options->study,
                   "study file, e.g. models/studies/secondary-suspensions.xml; or the word show")
      ->type_name("STUDY|show")
      ->required();
  command->add_option("database", options->shown, "after show: a database that a study has written")
      ->type_name("DATABASE");
  command
      ->add_option("--output", options->database,
                   "database of the designs, .sqlite; one that exists asks for --resume or --overwrite   (required)")
      ->type_name("FILE");
  command->add_flag("--resume", options->resume,
                    "continue the study in --output, if that exists   (default: it is not touched)");
  addSet(*command, options->settings, "; of the vehicle and all scenarios, before the study changes anything");
  addCount(*command, "--jobs", options->jobs, "threads   (default: every processor this program may use)", 1024);
  addCount(*command, "--best", options->best, "designs shown of each objective   (default: 5)", 1000);
  command
      ->add_option("--write-best", options->best_folder,
                   "vehicle files of these designs; without objectives, of the named designs   (default: none)")
      ->type_name("FOLDER");
  command->add_option("--export", options->csv, "the whole table, .csv   (default: none)")->type_name("FILE");
  addOverwrite(*command, options->overwrite, "; an existing study in --output is started anew");
  addCommonOptions(*command, options->common);
  command->footer(
      "Designs are stored as they are evaluated: a study that is killed loses a few seconds and continues "
      "with --resume. "
      "`vehicle study show FILE.sqlite` prints a stored study. On several machines: mpirun -n 4 vehicle study ...\n"
      "Example: vehicle study models/studies/secondary-suspensions.xml --output suspensions.sqlite");
  return [options, command] {
    requireStudyOptions(*command, *options);
    return options->study == "show" ? showStudy(*options, *command) : runStudyFile(*options, *command);
  };
}

}  // namespace vehicle::cli
