#include "apps/cli/study_options.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/outputs.h"
#include "apps/cli/study_best.h"

namespace vehicle::cli {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

bool isShown(const StudyOptions& options) { return options.study == "show"; }

void requireForShow(const CLI::App& command, const StudyOptions& options) {
  if (options.shown.empty()) refuse("study show: DATABASE is missing");
  for (const char* option : {"--output", "--resume", "--set", "--jobs"}) {
    if (command.count(option) > 0) {
      refuse(fmt::format("{} has no effect: study show evaluates nothing; omit it", option));
    }
  }
  requireOutputForOverwrite(command, {"--export", "--write-best"});
}

}  // namespace

void requireStudyOptions(const CLI::App& command, const StudyOptions& options) {
  if (isShown(options)) return requireForShow(command, options);
  if (!options.shown.empty()) {
    refuse(fmt::format("study: \"{}\" is one file too many; only `study show` takes a second", options.shown));
  }
  if (command.count("--output") == 0) {
    refuse("study: --output is missing, e.g. --output study.sqlite: every design is kept there");
  }
  if (options.resume) requireOutputForOverwrite(command, {"--export", "--write-best"});
}

void requireUsedByStudy(const CLI::App& command, const Study& study) {
  if (command.count("--best") > 0 && study.objectives.empty()) {
    refuse(
        fmt::format("--best has no effect: the study \"{}\" has no <objective>, so no design is better than another; "
                    "omit it, or add one to the study",
                    study.name));
  }
  if (command.count("--write-best") > 0 && study.objectives.empty() && study.designs.empty()) {
    refuse(
        fmt::format("--write-best has no effect: the study \"{}\" has neither an <objective> nor a named <design>; "
                    "omit it, or add one to the study",
                    study.name));
  }
}

void claimOutputs(OutputGuard& guard, const CLI::App& command, const StudyOptions& options, const StudyWork& work) {
  if (isShown(options)) {
    guard.protectDatabase(options.shown, "the database");
  } else {
    guard.protect(options.study, "the study file");
    const std::filesystem::path folder = std::filesystem::path(options.study).parent_path();
    for (const InputFile& each : work.texts) {
      if (each.name == kSettingsName) continue;  // no file
      guard.protect((folder / each.name).lexically_normal(), "the input file");
    }
    if (options.resume) {
      guard.resumeDatabase(options.database, "--output");
    } else {
      guard.claimDatabase(options.database, "--output");
    }
  }
  if (command.count("--export") > 0) guard.claim(options.csv, "--export", OutputKind::kStudyTable);
  if (command.count("--write-best") > 0) {
    guard.claimFolder(options.best_folder, "--write-best", OutputKind::kVehicle,
                      filesOfBest(BestNames(work, static_cast<std::size_t>(options.best)), work));
  }
}

}  // namespace vehicle::cli
