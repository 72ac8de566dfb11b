#include <memory>

#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "libvehicle/report/vehicle/vehicle_tables.h"
#include "libvehicle/simulate/file_warnings.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;
  double gravity = 9.81;  // [m/s^2]
  CommonOptions common;
};

int printInfo(const Options& options) {
  const CompiledModel model = readVehicleOf(options.files, options.gravity);
  const report::Document document = report::documentOf(model, figuresOf(model), options.common.format);
  const Warnings warnings = fileWarnings(model);
  printDocument(withSettings(document, Settings(options.files.settings).all()), warnings, options.common);
  printNotes(notesOn(model.vehicle), options.common);
  printWarnings(warnings);
  return statusAfter(warnings, options.common);
}

}  // namespace

Action addInfo(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "info",
      "describe a vehicle or train: masses, static loads, which sets of equations (forms) fit and why others do not");
  addVehicleFile(*command, options->files);
  addGravity(*command, options->gravity);
  addSet(*command, options->files.settings);
  addCommonOptions(*command, options->common);
  command->footer(
      "Rest positions and deflections count from unloaded springs; loads are static, compression positive.\n"
      "Example: vehicle info models/vehicles/al-oraiqat-2017.xml");
  return [options] { return printInfo(*options); };
}

}  // namespace vehicle::cli
