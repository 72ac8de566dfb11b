#include <cmath>
#include <complex>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/remarks.h"
#include "apps/cli/stdout_page.h"
#include "libvehicle/linear/modes.h"
#include "libvehicle/linear/undamped.h"
#include "libvehicle/simulate/file_warnings.h"
#include "libvehicle/simulate/simulate.h"

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

// Below rounding a coordinate does not take part, and its phase would be noise.
constexpr double kNoPart = 1e-9;

Table eigenvalueTable(const std::vector<Mode>& modes, const std::vector<UndampedMode>& undamped) {
  Table table{"modes",
              {{"mode", ""},
               {"frequency", "Hz"},
               {"damped frequency", "Hz"},
               {"undamped frequency", "Hz"},
               {"damping ratio", "-"},
               {"real", "1/s"},
               {"imaginary", "1/s"},
               {"multiplicity", ""},
               {"name", ""}},
              {}};
  for (const Mode& mode : modes) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(static_cast<long>(table.rows.size()));
    row.emplace_back(mode.frequency);
    std::optional<double> damped;
    if (mode.eigenvalue.imag() > 0.0) damped = mode.eigenvalue.imag() / (2.0 * std::numbers::pi);
    addCell(row, damped);
    addCell(row, undampedFrequencyOf(std::span(&mode, 1), undamped));
    row.emplace_back(mode.damping_ratio);
    row.emplace_back(mode.eigenvalue.real());
    row.emplace_back(mode.eigenvalue.imag());
    row.emplace_back(static_cast<long>(mode.multiplicity));
    row.emplace_back(mode.name);
  }
  return table;
}

/// One line a mode and coordinate, for other programs.
Table shapeList(const std::vector<Mode>& modes, const std::vector<Channel>& states) {
  Table table{"shapes", {{"mode", ""}, {"coordinate", ""}, {"unit", ""}, {"size", ""}, {"phase", "deg"}}, {}};
  long number = 0;
  for (const Mode& mode : modes) {
    ++number;
    for (Eigen::Index i = 0; i < mode.shape.size(); ++i) {
      const Channel& coordinate = states[static_cast<std::size_t>(i)];
      const double size = std::abs(mode.shape(i));
      if (size < kNoPart) continue;
      table.rows.push_back({number, coordinate.name, coordinate.unit, size, phaseInDegrees(mode.shape(i))});
    }
  }
  return table;
}

/// Coordinates as rows, modes as columns, for people.
Table shapeMatrix(const std::vector<Mode>& modes, const std::vector<Channel>& states) {
  Table table{"shapes: amplitude (phase in degrees), the largest of a mode is 1", {{"coordinate", ""}}, {}, 1};
  for (std::size_t mode = 0; mode < modes.size(); ++mode)
    table.columns.push_back({fmt::format("mode {}", mode + 1), ""});
  for (std::size_t i = 0; i < states.size() / 2; ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(fmt::format("{} [{}]", states[i].name, states[i].unit));
    for (const Mode& mode : modes) {
      const std::complex<double> entry = mode.shape(static_cast<Eigen::Index>(i));
      if (std::abs(entry) < kNoPart) {
        row.emplace_back("0");
      } else {
        row.emplace_back(fmt::format("{:.3g} ({:.0f})", std::abs(entry), std::round(phaseInDegrees(entry)) + 0.0));
      }
    }
  }
  return table;
}

/// Gravity acts on a motion through static loads at heights and through contacts that stiffen under load; what the
/// equations of this vehicle say of it is looked up in them.
void requireGravityUsed(const CLI::App& command, const Options& options, const std::string& form,
                        const CompiledModel& model, const System& system) {
  if (command.count("--gravity") == 0) return;
  const std::unique_ptr<System> heavier = buildForm(form, compileChecked(model.vehicle, 2.0 * options.gravity));
  if (system.linear()->A != heavier->linear()->A) return;
  throw std::invalid_argument(
      fmt::format("--gravity has no effect: the form {} of \"{}\" has no static load at a height and no Hertz contact, "
                  "so that its modes do not depend on gravity; omit it",
                  form, model.vehicle.name));
}

int printModes(const Options& options, const CLI::App& command) {
  const CompiledModel model = compileChecked(readVehicleOf(options.files), options.gravity);
  const std::string form = options.form.empty() ? defaultForm(model.topology) : options.form;
  if (!isLinearForm(form))
    throw std::invalid_argument(fmt::format("--form: modes need a linear form; {} is nonlinear", form));
  const std::unique_ptr<System> system = buildForm(form, model);
  requireGravityUsed(command, options, form, model, *system);
  const std::vector<Mode> modes = modesOf(*system);
  const std::vector<UndampedMode> undamped = undampedModesOf(system->linear().value().A, system->states());
  const bool formatted = options.common.format == Format::kTable;
  const Warnings warnings = fileWarnings(model);
  Document document{{{"vehicle", model.vehicle.name, ""}, {"form", form, ""}},
                    {eigenvalueTable(modes, undamped),
                     formatted ? shapeMatrix(modes, system->states()) : shapeList(modes, system->states())},
                    {}};
  addSettings(Settings(options.files.settings).all(), document);
  addWarnings(warnings, options.common, document);
  printToStdout(document, options.common.format);
  std::cout.flush();
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
