#include "libvehicle/report/vehicle/vehicle_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "libvehicle/simulate/forms.h"

namespace vehicle::report {
namespace {

Cell orNothing(double value) { return value != 0.0 ? Cell(value) : Cell(); }

template <class Part>
void addReserved(Table& table, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    for (const ReservedQuantity& kept : part.reserved) table.rows.push_back({part.name, kept.attribute, kept.text});
  }
}

std::vector<Fact> factsOf(const CompiledModel& model, const VehicleFigures& figures) {
  const Vehicle& vehicle = model.vehicle;
  std::vector<Fact> facts = {{"vehicle", vehicle.name, ""}};
  if (!vehicle.title.empty()) facts.push_back({"title", vehicle.title, ""});
  if (!vehicle.source.empty()) facts.push_back({"source", vehicle.source, ""});
  if (!vehicle.units.empty()) facts.push_back({"vehicles", static_cast<long>(vehicle.units.size()), ""});
  facts.insert(facts.end(), {{"degrees of freedom", static_cast<long>(model.states.coordinates), ""},
                             {"total mass", figures.mass, "kg"},
                             {"unsprung mass", figures.unsprung_mass, "kg"},
                             {"heights given", model.topology.has_heights, ""},
                             {"gravity", model.gravity, "m/s^2"},
                             {"total weight", figures.weight, "N"}});
  if (figures.halves) {
    facts.push_back({"load of the front half", figures.halves->front, "N"});
    facts.push_back({"load of the rear half", figures.halves->rear, "N"});
  }
  return facts;
}

}  // namespace

Document documentOf(const CompiledModel& model, const VehicleFigures& figures, Format format) {
  const Vehicle& vehicle = model.vehicle;
  Document document;
  document.facts = factsOf(model, figures);
  document.tables = {bodyTable(model),        wheelsetTable(model, figures), suspensionTable(model),
                     carbodyTable(figures), formTable(model.topology),    unsupportedTable(model.topology)};
  if (!document.tables.back().rows.empty()) {
    document.remarks.push_back("a form that does not fit is no mistake in the file: the form " + defaultForm(model.topology) +
                               " computes this vehicle");
  }
  Table unused = unusedTable(vehicle);
  if (format != Format::kTable) {
    document.tables.push_back(std::move(unused));
  } else if (!unused.rows.empty()) {
    document.remarks.push_back(unusedLine(unused));
  }
  if (!vehicle.units.empty()) document.tables.insert(document.tables.begin(), unitTable(model));
  return document;
}

Table unitTable(const CompiledModel& train) {
  const Topology& topology = train.topology;
  struct Sum {
    double mass = 0.0;  // [kg]
    double load = 0.0;  // [N]
  };
  std::map<std::string_view, Sum> sums;
  const auto sumOf = [&sums](const std::string& part) -> Sum& {
    return sums[std::string_view(part).substr(0, part.find('.'))];
  };
  for (const TopologyBody& body : topology.bodies) sumOf(body.name).mass += body.mass;
  for (std::size_t j = 0; j < topology.wheelsets.size(); ++j) {
    Sum& sum = sumOf(topology.wheelsets[j].name);
    sum.mass += topology.wheelsets[j].mass;
    sum.load += train.rest.wheel_load[j];
  }
  Table table{"vehicles",
              {{"vehicle", ""}, {"x", "m", ColumnUnit::kAsGiven}, {"mass", "kg"}, {"static load", "N"}, {"title", ""}},
              {}};
  for (const TrainUnit& unit : train.vehicle.units) {
    const Sum& sum = sums[unit.name];
    table.rows.push_back({unit.name, unit.x, sum.mass, sum.load, unit.title});
  }
  return table;
}

Table bodyTable(const CompiledModel& model) {
  const Topology& topology = model.topology;
  Table table{"bodies",
              {{"body", ""},
               {"mass", "kg"},
               {"pitch inertia", "kg*m^2"},
               {"x", "m", ColumnUnit::kAsGiven},
               {"z", "m", ColumnUnit::kAsGiven},
               {"motion", ""},
               {"rest z", "m"},
               {"rest pitch", "rad"}},
              {}};
  for (std::size_t i = 0; i < topology.bodies.size(); ++i) {
    const TopologyBody& body = topology.bodies[i];
    std::string motion;
    for (const Motion each : model.vehicle.bodies[i].motion)
      motion += fmt::format("{}{}", motion.empty() ? "" : " ", nameOf(each));
    const auto at_rest = [&](int index) {
      if (index < 0) return Cell();
      const double value = model.rest.coordinates[static_cast<std::size_t>(index)];
      // A femtometre is what rounding leaves of a pitch that is zero.
      return Cell(std::abs(value) < 1e-14 ? 0.0 : value);
    };
    table.rows.push_back({body.name, body.mass, orNothing(body.pitch_inertia), body.x,
                          topology.has_heights ? Cell(body.z) : Cell(), motion, at_rest(body.z_index),
                          at_rest(body.pitch_index)});
  }
  return table;
}

Table wheelsetTable(const CompiledModel& model, const VehicleFigures& figures) {
  const Topology& topology = model.topology;
  const Rest& rest = model.rest;
  Table table{"wheelsets",
              {{"wheelset", ""},
               {"x", "m", ColumnUnit::kAsGiven},
               {"mass", "kg"},
               {"static load", "N"},
               {"contact stiffness", "N/m"},
               {"motion", ""}},
              {}};
  const std::vector<double>& deviations = figures.load_deviations;
  if (!deviations.empty()) table.columns.insert(table.columns.begin() + 4, {"from the mean", "%"});
  for (std::size_t i = 0; i < topology.wheelsets.size(); ++i) {
    const TopologyWheelset& wheelset = topology.wheelsets[i];
    std::vector<Cell>& row = table.rows.emplace_back();
    row = {wheelset.name, wheelset.x, orNothing(wheelset.mass), rest.wheel_load[i]};
    if (!deviations.empty()) row.emplace_back(1e2 * deviations[i]);
    row.push_back(orNothing(rest.contact_stiffness[i]));
    row.emplace_back(std::string(wheelset.z_index >= 0 ? "z" : "follows the rail"));
  }
  return table;
}

Table suspensionTable(const CompiledModel& model) {
  const Topology& topology = model.topology;
  const Rest& rest = model.rest;
  Table table{"suspensions",
              {{"suspension", ""},
               {"upper", ""},
               {"lower", ""},
               {"x", "m", ColumnUnit::kAsGiven},
               {"stiffness", "N/m"},
               {"damping", "N*s/m"},
               {"static load", "N"},
               {"rest deflection", "m"}},
              {}};
  for (std::size_t i = 0; i < topology.suspensions.size(); ++i) {
    const TopologySuspension& each = topology.suspensions[i];
    const std::string lower = each.lower_body >= 0
                                  ? topology.bodies[static_cast<std::size_t>(each.lower_body)].name
                                  : topology.wheelsets[static_cast<std::size_t>(each.lower_wheelset)].name;
    table.rows.push_back({each.name, topology.bodies[static_cast<std::size_t>(each.upper)].name, lower, each.x,
                          each.stiffness, each.damping, rest.suspension_load[i],
                          each.stiffness > 0.0 ? Cell(rest.suspension_load[i] / each.stiffness) : Cell()});
  }
  return table;
}

Table carbodyTable(const VehicleFigures& figures) {
  Table table{"carbody", {{"motion", ""}, {"frequency", "Hz"}, {"damping", "-"}}, {}};
  for (const CarbodyMotion& each : figures.carbody) {
    table.rows.push_back({each.name, each.frequency, each.damping_ratio});
  }
  return table;
}

Table formTable(const Topology& topology) {
  Table table{"forms", {{"form", ""}, {"fits", ""}}, {}};
  for (const std::string& form : formNames()) table.rows.push_back({form, formUnsupported(form, topology).empty()});
  return table;
}

Table unsupportedTable(const Topology& topology) {
  Table table{
      "why a form does not fit", {{"line", ""}, {"element", ""}, {"why", ""}, {"remedy", ""}, {"forms", ""}}, {}};
  for (const std::string& form : formNames()) {
    for (const Problem& each : formUnsupported(form, topology)) {
      const std::vector<Cell> reason = {static_cast<long>(each.place.line), each.element, each.message, each.remedy};
      const auto known = std::find_if(table.rows.begin(), table.rows.end(), [&](const std::vector<Cell>& row) {
        return std::equal(reason.begin(), reason.end(), row.begin());
      });
      if (known != table.rows.end()) {
        std::get<std::string>(known->back()) += ", " + form;
      } else {
        table.rows.push_back(reason);
        table.rows.back().push_back(form);
      }
    }
  }
  return table;
}

Table unusedTable(const Vehicle& vehicle) {
  Table table{"not used by the planar forms", {{"part", ""}, {"attribute", ""}, {"value", ""}}, {}};
  addReserved(table, vehicle.elements);
  addReserved(table, vehicle.bodies);
  addReserved(table, vehicle.wheelsets);
  addReserved(table, vehicle.suspensions);
  for (const Body& body : vehicle.bodies) {
    for (const Motion motion : body.motion) {
      if (motion != Motion::kZ && motion != Motion::kPitch) {
        table.rows.push_back({body.name, std::string("motion"), std::string(nameOf(motion))});
      }
    }
  }
  for (const Suspension& suspension : vehicle.suspensions) {
    if (suspension.y) table.rows.push_back({suspension.name, std::string("y"), fmt::format("{} m", *suspension.y)});
  }
  return table;
}

std::string unusedLine(const Table& unused) {
  struct Use {
    std::string attribute;
    std::string part;  // the first
    std::size_t count = 0;
  };
  std::vector<Use> uses;
  for (const std::vector<Cell>& row : unused.rows) {
    std::string attribute = std::get<std::string>(row[1]);
    if (attribute == "motion") attribute += ' ' + std::get<std::string>(row[2]);
    auto use = std::find_if(uses.begin(), uses.end(), [&](const Use& each) { return each.attribute == attribute; });
    if (use == uses.end()) use = uses.insert(uses.end(), {attribute, std::get<std::string>(row[0]), 0});
    ++use->count;
  }
  std::string line;
  for (const Use& each : uses) {
    line += line.empty() ? "not used by the planar forms: " : ", ";
    line += each.attribute + " of " + (each.count == 1 ? each.part : std::to_string(each.count) + " parts");
  }
  return line;
}

}  // namespace vehicle::report
