#pragma once

#include <string>
#include <string_view>

#include "libvehicle/definition/scenario.h"
#include "libvehicle/definition/study.h"
#include "libvehicle/definition/suite.h"
#include "libvehicle/definition/train.h"
#include "libvehicle/definition/vehicle.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/xml/schema.h"

namespace vehicle {

/// Reads a vehicle file. All problems are told in one pass, in the order in which they stand in the file:
/// those of the file's form and values, then the contradictions that definition's check() finds.
/// A value is given only if there is no problem; nothing is thrown for a wrong file. A train file is a vehicle file
/// too: it gives the train assembled into one vehicle.
[[nodiscard]] Outcome<Vehicle> readVehicle(const std::string& path);
/// @param file_name  what messages and origins call the text
[[nodiscard]] Outcome<Vehicle> readVehicleText(std::string_view text, const std::string& file_name);

/// The same for a train, with the vehicles that it names; their problems are told at their own places.
[[nodiscard]] Outcome<Train> readTrain(const std::string& path);
/// Does not read the files that the train names.
[[nodiscard]] Outcome<Train> readTrainText(std::string_view text, const std::string& file_name);

/// The same for a scenario. Names that only a vehicle can confirm are not judged: check(scenario, vehicle) does.
[[nodiscard]] Outcome<Scenario> readScenario(const std::string& path);
[[nodiscard]] Outcome<Scenario> readScenarioText(std::string_view text, const std::string& file_name);

/// The same for a suite; every file that it names must be there and be of the right kind.
[[nodiscard]] Outcome<Suite> readSuite(const std::string& path);
/// Does not look for the files that the suite names.
[[nodiscard]] Outcome<Suite> readSuiteText(std::string_view text, const std::string& file_name);

/// The same for a study. Its vehicle and scenarios are read too: their problems are told where the study names them,
/// and the names and values of the study are held against them (bindStudy() of definition).
[[nodiscard]] Outcome<Study> readStudy(const std::string& path);
/// Does not look for the files that the study names.
[[nodiscard]] Outcome<Study> readStudyText(std::string_view text, const std::string& file_name);

/// What a file is about, told by its root element.
[[nodiscard]] Outcome<FileKind> kindOf(const std::string& path);

/// All problems of a file of any kind; empty: the file is right.
[[nodiscard]] ProblemList checkFile(const std::string& path);

/// The file that `naming_file` means by `named`: relative names count from the naming file's folder.
[[nodiscard]] std::string resolvePath(const std::string& naming_file, const std::string& named);

}  // namespace vehicle
