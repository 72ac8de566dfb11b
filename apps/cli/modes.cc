#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "libvehicle/linear/modes.h"
#include "libvehicle/linear/undamped.h"
#include "libvehicle/report/vehicle/mode_tables.h"
#include "libvehicle/simulate/file_warnings.h"
#include "libvehicle/simulate/forms.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;
  std::string form;
  double gravity = 9.81;  // [m/s^2]
  CommonOptions common;
};

/// Gravity acts on a motion through static loads at heights and through contacts that stiffen under load; what the
/// equations of this vehicle say of it is looked up in them.
void requireGravityUsed(const CLI::App& command, const Options& options, const std::string& form,
                        const CompiledModel& model, const System& system) {
  if (command.count("--gravity") == 0) return;
  if (system.linear()->A != buildForm(form, compileChecked(model.vehicle, 2.0 * options.gravity))->linear()->A) return;
  throw std::invalid_argument(
      fmt::format("--gravity has no effect: the form {} of \"{}\" has no static load at a height and no Hertz contact, "
                  "so that its modes do not depend on gravity; omit it",
                  form, model.vehicle.name));
}

int printModes(const Options& options, const CLI::App& command) {
  const CompiledModel model = readVehicleOf(options.files, options.gravity);
  const std::string form = options.form.empty() ? defaultForm(model.topology) : options.form;
  if (!isLinearForm(form))
    throw std::invalid_argument(fmt::format("--form: modes need a linear form; {} is nonlinear", form));
  const std::unique_ptr<System> system = buildForm(form, model);
  requireGravityUsed(command, options, form, model, *system);
  const std::vector<Mode> modes = modesOf(*system);
  const std::vector<UndampedMode> undamped = undampedModesOf(system->linear().value().A, system->states());
  const report::Format format = options.common.format;
  const Warnings warnings = fileWarnings(model);
  const report::Document document{
      {{"vehicle", model.vehicle.name, ""}, {"form", form, ""}},
      {report::eigenvalueTable(modes, undamped), report::shapeTable(modes, system->states(), format)},
      {}};
  printDocument(withSettings(document, Settings(options.files.settings).all()), warnings, options.common);
  printWarnings(warnings);
  return statusAfter(warnings, options.common);
}

}  // namespace

Action addModes(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("modes", "print eigenvalues, frequencies, damping and shapes of a linear form");
  addVehicleFile(*command, options->files);
  command
      ->add_option("--form", options->form,
                   "flat | matrix | mbs-linear | flat-7-printed | flat-literal | flat-literal-mb "
                   "(default: flat where it fits, else matrix)")
      ->type_name("NAME")
      ->check(oneOf(formNames()));
  addGravity(*command, options->gravity);
  addSet(*command, options->files.settings);
  addCommonOptions(*command, options->common);
  command->footer(
      "frequency is |lambda| / 2 pi, damped frequency |Im lambda| / 2 pi, undamped frequency that of masses and "
      "stiffnesses alone, damping ratio -Re lambda / |lambda|. An aperiodic mode has two real roots, one line each: "
      "no damped frequency, and |lambda| is a decay rate. Of a pair the root with positive imaginary part stands "
      "here.\n"
      "In a shape the largest coordinate is 1 (m or rad). Tables show shapes as a matrix, csv and json one number a "
      "line; coordinates below 1e-9 are 0 there and left out here.\n"
      "Example: vehicle modes models/vehicles/al-oraiqat-2017.xml --form matrix");
  return [options, command] { return printModes(*options, *command); };
}

}  // namespace vehicle::cli
