#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/cli/exit_status.h"
#include "apps/cli/progress.h"
#include "libvehicle/definition/notes.h"
#include "libvehicle/diagnostics/warning.h"
#include "libvehicle/report/document/document.h"

namespace vehicle::cli {

/// What every command takes: --format, --quiet and --strict.
struct CommonOptions {
  report::Format format = report::Format::kTable;
  bool quiet = false;   // no progress, no notes
  bool strict = false;  // a warning makes exit status 4

  [[nodiscard]] ProgressBar::Shown progress() const {
    return quiet ? ProgressBar::Shown::kNever : ProgressBar::Shown::kOnTerminal;
  }
};

/// Letters in a line of what people read on stdout: COLUMNS where the environment has a whole number > 0, else the width
/// of the terminal, else report::kAnyWidth: what goes to a file or a pipe is never broken.
[[nodiscard]] std::size_t pageWidth();

/// A document on stdout, at once. For csv and json with its warnings as a table; people have them on stderr.
void printDocument(report::Document document, const Warnings& warnings, const CommonOptions& common);

/// A choice that the program made for the user, on stderr: "note: ...". It is never an error; --quiet leaves it out.
void printNote(const std::string& text, const CommonOptions& common);

/// The same for what the program makes of values of files.
void printNotes(const std::vector<Note>& notes, const CommonOptions& common);

/// "written: FILE" on stderr for each; --quiet leaves it out.
void printWritten(const std::vector<std::string>& files, const CommonOptions& common);

/// Warnings, one line each on stderr (report::warningLines), --quiet or not.
void printWarnings(const Warnings& warnings);

/// The status of a command that has done its work: with --strict a warning makes it a check that did not hold.
[[nodiscard]] ExitStatus statusAfter(const Warnings& warnings, const CommonOptions& common);

}  // namespace vehicle::cli
