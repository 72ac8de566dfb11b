#include <cmath>
#include <complex>
#include <iostream>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "libvehicle/linear/modes.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/xml/reader.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;
  std::string form;
  double gravity = 9.81;  // [m/s^2]
  CommonOptions common;
};

/// In (-180, 180]; what rounding leaves of 0 and of 180 is 0 and 180.
double phaseInDegrees(std::complex<double> entry) {
  const double phase = std::arg(entry) * 180.0 / std::numbers::pi;
  if (std::abs(phase) < 1e-9) return 0.0;
  return phase < -180.0 + 1e-9 ? 180.0 : phase;
}

/// Gravity acts on a motion through static loads at heights and through contacts that stiffen under load; what the
/// equations of this vehicle say of it is looked up in them.
void requireGravityUsed(const CLI::App& command, const Options& options, const std::string& form,
                        const Vehicle& vehicle, const System& system) {
  if (command.count("--gravity") == 0) return;
  const std::unique_ptr<System> heavier = buildForm(form, vehicle, 2.0 * options.gravity);
  if (system.linear()->A != heavier->linear()->A) return;
  throw std::invalid_argument(
      fmt::format("--gravity has no effect: the form {} of \"{}\" has no static load at a height and no Hertz contact, "
                  "so that its modes do not depend on gravity; omit it",
                  form, vehicle.name));
}

int printModes(const Options& options, const CLI::App& command) {
  const Vehicle vehicle = readVehicle(options.files.vehicle).orThrow();
  const std::string form = options.form.empty() ? defaultForm(vehicle) : options.form;
  if (!isLinearForm(form))
    throw std::invalid_argument(fmt::format("--form: modes need a linear form; {} is nonlinear", form));
  const std::unique_ptr<System> system = buildForm(form, vehicle, options.gravity);
  requireGravityUsed(command, options, form, vehicle, *system);
  const std::vector<Mode> modes = modesOf(*system);

  Table eigenvalues{"modes",
                    {{"mode", ""},
                     {"name", ""},
                     {"frequency", "Hz"},
                     {"damping", "-"},
                     {"real", "1/s"},
                     {"imaginary", "1/s"},
                     {"multiplicity", ""}},
                    {}};
  Table shapes{"shapes", {{"mode", ""}, {"coordinate", ""}, {"unit", ""}, {"size", ""}, {"phase", "deg"}}, {}};
  long number = 0;
  for (const Mode& mode : modes) {
    ++number;
    eigenvalues.rows.push_back({number, mode.name, mode.frequency, mode.damping_ratio, mode.eigenvalue.real(),
                                mode.eigenvalue.imag(), static_cast<long>(mode.multiplicity)});
    for (Eigen::Index i = 0; i < mode.shape.size(); ++i) {
      const Channel& coordinate = system->states()[static_cast<std::size_t>(i)];
      const double size = std::abs(mode.shape(i));
      // Below rounding a coordinate does not take part, and its phase would be noise.
      if (size < 1e-9) continue;
      shapes.rows.push_back({number, coordinate.name, coordinate.unit, size, phaseInDegrees(mode.shape(i))});
    }
  }
  print({{{"vehicle", vehicle.name, ""}, {"form", form, ""}}, {eigenvalues, shapes}, {}}, options.common.format,
        std::cout);
  return kDone;
}

}  // namespace

Action addModes(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("modes", "print eigenvalues, frequencies, damping and shapes of a linear form");
  addVehicleFile(*command, options->files);
  command
      ->add_option("--form", options->form,
                   "flat | matrix | mbs-linear | flat-7-printed | flat-literal | flat-literal-mb\n"
                   "(default: flat where it fits, else matrix)")
      ->type_name("NAME")
      ->check(oneOf(formNames()));
  addGravity(*command, options->gravity);
  addCommonOptions(*command, options->common);
  command->footer(
      "Of a pair the eigenvalue with positive imaginary part stands here. In a shape the largest coordinate is 1\n"
      "(m or rad); coordinates below 1e-9 are left out.\n"
      "Example: vehicle modes models/vehicles/al-oraiqat-2017.xml --form matrix");
  return [options, command] { return printModes(*options, *command); };
}

}  // namespace vehicle::cli
