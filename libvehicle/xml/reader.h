#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/study.h"
#include "libvehicle/definition/suite.h"
#include "libvehicle/definition/train.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/xml/file_source.h"
#include "libvehicle/xml/schema.h"

namespace vehicle {

// Each file kind can be read from a text, from a source of files (file_source.h) that later readers share, or from disk
// by its path alone.

/// Reads a vehicle file. All problems are reported in one pass, in the order in which they stand in the file:
/// those of the file's form and values, then the contradictions that definition's check() finds.
/// A value is given only if there is no problem; nothing is thrown for a wrong file. A train file is a vehicle file
/// too: it gives the train assembled into one vehicle.
[[nodiscard]] Outcome<Vehicle> readVehicle(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Vehicle> readVehicle(const std::string& path);
/// @param file_name  what messages and origins call the text
[[nodiscard]] Outcome<Vehicle> readVehicleText(std::string_view text, const std::string& file_name);

/// The same for a train, with the vehicles that it names; their problems are reported at their own places.
[[nodiscard]] Outcome<Train> readTrain(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Train> readTrain(const std::string& path);
/// Does not read the files that the train names.
[[nodiscard]] Outcome<Train> readTrainText(std::string_view text, const std::string& file_name);

/// The same for a scenario. Names that only a vehicle can confirm are not judged: check(scenario, vehicle) does.
[[nodiscard]] Outcome<Scenario> readScenario(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Scenario> readScenario(const std::string& path);
[[nodiscard]] Outcome<Scenario> readScenarioText(std::string_view text, const std::string& file_name);

/// The same for a suite and a study. The files that they name are not read: readSuiteWork() and readStudyWork() of
/// `project` do.
[[nodiscard]] Outcome<Suite> readSuite(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Suite> readSuite(const std::string& path);
[[nodiscard]] Outcome<Suite> readSuiteText(std::string_view text, const std::string& file_name);
[[nodiscard]] Outcome<Study> readStudy(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Study> readStudy(const std::string& path);
[[nodiscard]] Outcome<Study> readStudyText(std::string_view text, const std::string& file_name);

// Drafts are for checks that look further than one file: a file as far as it could be read, with all its problems. There
// is a value unless nothing at all can be said; parts that could not be read are marked in their Origin.

/// The vehicle of a file, or each vehicle that a train names; their problems are those of readVehicle().
[[nodiscard]] std::vector<Vehicle> draftVehicles(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Scenario> draftScenario(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Suite> draftSuite(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<Study> draftStudy(const std::string& path, FileSource& files);

/// What a file is about, by its root element.
[[nodiscard]] Outcome<FileKind> kindOf(const std::string& path, FileSource& files);
[[nodiscard]] Outcome<FileKind> kindOf(const std::string& path);

}  // namespace vehicle
