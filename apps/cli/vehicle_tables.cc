#include "apps/cli/vehicle_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "apps/cli/vehicle_figures.h"
#include "libvehicle/simulate/forms.h"

namespace vehicle::cli {
namespace {

Cell orNothing(double value) { return value != 0.0 ? Cell(value) : Cell(); }

template <class Part>
void addReserved(Table& table, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    for (const ReservedQuantity& kept : part.reserved) table.rows.push_back({part.name, kept.attribute, kept.text});
  }
}

}  // namespace

Table unitTable(const Vehicle& train, const Topology& topology, const Rest& rest) {
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
    sum.load += rest.wheel_load[j];
  }
  Table table{"vehicles",
              {{"vehicle", ""}, {"x", "m", ColumnUnit::kAsGiven}, {"mass", "kg"}, {"static load", "N"}, {"title", ""}},
              {}};
  for (const TrainUnit& unit : train.units) {
    const Sum& sum = sums[unit.name];
    table.rows.push_back({unit.name, unit.x, sum.mass, sum.load, unit.title});
  }
  return table;
}

Table bodyTable(const Vehicle& vehicle, const Topology& topology, const Rest& rest) {
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
    for (const Motion each : vehicle.bodies[i].motion)
      motion += fmt::format("{}{}", motion.empty() ? "" : " ", nameOf(each));
    const auto at_rest = [&](int index) {
      if (index < 0) return Cell();
      const double value = rest.coordinates[static_cast<std::size_t>(index)];
      // A femtometre is what rounding leaves of a pitch that is zero.
      return Cell(std::abs(value) < 1e-14 ? 0.0 : value);
    };
    table.rows.push_back({body.name, body.mass, orNothing(body.pitch_inertia), body.x,
                          topology.has_heights ? Cell(body.z) : Cell(), motion, at_rest(body.z_index),
                          at_rest(body.pitch_index)});
  }
  return table;
}

Table wheelsetTable(const Topology& topology, const Rest& rest) {
  Table table{"wheelsets",
              {{"wheelset", ""},
               {"x", "m", ColumnUnit::kAsGiven},
               {"mass", "kg"},
               {"static load", "N"},
               {"contact stiffness", "N/m"},
               {"motion", ""}},
              {}};
  const std::vector<double> deviations = loadDeviations(topology, rest);
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

Table suspensionTable(const Topology& topology, const Rest& rest) {
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

Table formTable(const Topology& topology) {
  Table table{"forms", {{"form", ""}, {"fits", ""}}, {}};
  for (const std::string& form : formNames()) table.rows.push_back({form, formMisfits(form, topology).empty()});
  return table;
}

Table misfitTable(const Topology& topology) {
  Table table{
      "why a form does not fit", {{"line", ""}, {"element", ""}, {"why", ""}, {"remedy", ""}, {"forms", ""}}, {}};
  for (const std::string& form : formNames()) {
    for (const Problem& misfit : formMisfits(form, topology)) {
      const std::vector<Cell> reason = {static_cast<long>(misfit.place.line), misfit.element, misfit.message,
                                        misfit.remedy};
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

}  // namespace vehicle::cli
