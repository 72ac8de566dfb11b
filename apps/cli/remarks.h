#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/cli/document.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/options.h"
#include "libvehicle/definition/notes.h"
#include "libvehicle/diagnostics/warning.h"

namespace vehicle::cli {

/// A choice that the program made for the user, on stderr: "note: ...". It is never an error; --quiet leaves it out.
void printNote(const std::string& text, const CommonOptions& common);

/// The same for what the program makes of values of files.
void printNotes(const std::vector<Note>& notes, const CommonOptions& common);

/// Those on scenarios, each line once.
void printNotesOn(const std::vector<Scenario>& scenarios, const CommonOptions& common);

/// Warnings, one line each on stderr, --quiet or not; of many of one code the first kMostOfACode and how many more.
inline constexpr std::size_t kMostOfACode = 4;
void printWarnings(const Warnings& warnings);

/// The status of a command that has done its work: with --strict a warning makes it a check that did not hold.
[[nodiscard]] ExitStatus statusAfter(const Warnings& warnings, const CommonOptions& common);

/// The same for csv and json: {code, file, line, subject, value, unit, time, message}; no rows without warnings.
[[nodiscard]] Table warningTable(const Warnings& warnings);

/// Adds warningTable() to what goes to stdout; a table for people has them on stderr already.
void addWarnings(const Warnings& warnings, const CommonOptions& common, Document& document);

}  // namespace vehicle::cli
