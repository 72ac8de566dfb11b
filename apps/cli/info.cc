#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/remarks.h"
#include "apps/cli/stdout_page.h"
#include "apps/cli/vehicle_figures.h"
#include "apps/cli/vehicle_tables.h"
#include "libvehicle/definition/notes.h"
#include "libvehicle/simulate/file_warnings.h"

namespace vehicle::cli {
namespace {

struct Options {
  ModelFiles files;
  double gravity = 9.81;  // [m/s^2]
  CommonOptions common;
};

int printInfo(const Options& options) {
  const CompiledModel model = compileChecked(readVehicleOf(options.files), options.gravity);
  const Vehicle& vehicle = model.vehicle;
  const Topology& topology = model.topology;
  const Rest& rest = model.rest;

  double bodies = 0.0, wheelsets = 0.0;
  for (const TopologyBody& body : topology.bodies) bodies += body.mass;
  for (const TopologyWheelset& wheelset : topology.wheelsets) wheelsets += wheelset.mass;
  Document document;
  document.facts = {{"vehicle", vehicle.name, ""}};
  if (!vehicle.title.empty()) document.facts.push_back({"title", vehicle.title, ""});
  if (!vehicle.source.empty()) document.facts.push_back({"source", vehicle.source, ""});
  if (!vehicle.units.empty()) document.facts.push_back({"vehicles", static_cast<long>(vehicle.units.size()), ""});
  document.facts.insert(document.facts.end(), {{"degrees of freedom", static_cast<long>(topology.coordinates), ""},
                                               {"total mass", bodies + wheelsets, "kg"},
                                               {"unsprung mass", wheelsets, "kg"},
                                               {"heights given", topology.has_heights, ""},
                                               {"gravity", options.gravity, "m/s^2"}});
  addSettings(Settings(options.files.settings).all(), document);
  for (Fact& fact : loadFacts(model)) document.facts.push_back(std::move(fact));
  document.tables = {bodyTable(vehicle, topology, rest),
                     wheelsetTable(topology, rest),
                     suspensionTable(topology, rest),
                     carbodyTable(model),
                     formTable(topology),
                     misfitTable(topology)};
  if (const std::string form = defaultForm(topology); !document.tables.back().rows.empty()) {
    document.remarks.push_back("a form that does not fit is no mistake in the file: the form " + form +
                               " computes this vehicle");
  }
  Table unused = unusedTable(vehicle);
  if (options.common.format != Format::kTable) {
    document.tables.push_back(std::move(unused));
  } else if (!unused.rows.empty()) {
    document.remarks.push_back(unusedLine(unused));
  }
  if (!vehicle.units.empty()) {
    document.tables.insert(document.tables.begin(), unitTable(vehicle, topology, rest));
  }
  const Warnings warnings = fileWarnings(model);
  addWarnings(warnings, options.common, document);
  printToStdout(document, options.common.format);
  std::cout.flush();
  printNotes(notesOn(vehicle), options.common);
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
