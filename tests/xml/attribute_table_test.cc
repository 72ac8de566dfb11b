#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/definition/parameter.h"
#include "libvehicle/definition/scenario_attributes.h"
#include "libvehicle/definition/study_attributes.h"
#include "libvehicle/definition/suite_attributes.h"
#include "libvehicle/definition/train_attributes.h"
#include "libvehicle/definition/vehicle_attributes.h"
#include "libvehicle/xml/reader.h"
#include "libvehicle/xml/writer.h"
#include "tests/support/vehicles.h"

// The rows of the table of attributes reach the files and the pages about them.
namespace vehicle {
namespace {

using Attribute = std::pair<std::string, std::string>;  // name, text

/// All attributes of a written file, each name with the number of its element in front.
std::vector<Attribute> attributesIn(const std::string& file) {
  std::vector<Attribute> all;
  int element = 0;
  for (std::size_t at = 0; at < file.size(); ++at) {
    if (file[at] == '<' && file[at + 1] != '/') ++element;
    if (file[at] != '=' || file[at + 1] != '"') continue;
    std::size_t begin = at;
    while (std::isalnum(static_cast<unsigned char>(file[begin - 1])) != 0 || file[begin - 1] == '_') --begin;
    const std::size_t end = file.find('"', at + 2);
    all.emplace_back(std::to_string(element) + ' ' + file.substr(begin, at - begin), file.substr(at + 2, end - at - 2));
    at = end;
  }
  return all;
}

/// The attributes in which two files differ: those of the second that the first does not have.
std::vector<Attribute> newIn(const std::string& after, const std::string& before) {
  std::vector<Attribute> found = attributesIn(after);
  for (const Attribute& each : attributesIn(before)) std::erase(found, each);
  return found;
}

Outcome<Vehicle> readAgain(const Vehicle& vehicle) { return readVehicleText(write(vehicle), "a.xml"); }
Outcome<Scenario> readAgain(const Scenario& scenario) { return readScenarioText(write(scenario), "a.xml"); }

/// Every parameter takes a value and gives it back, the file written of it differs in that attribute alone, and whoever
/// reads that file has the value to the bit.
template <class Owner>
void expectEachInItsAttribute(const Owner& owner) {
  ASSERT_EQ(readAgain(owner).problems.text(), "");
  const std::vector<ParameterOf<Owner>> all = parametersOf(owner);
  int read = 0;
  for (const ParameterOf<Owner>& each : all) {
    SCOPED_TRACE(each.address);
    Owner changed = owner;
    const double value = each.valueIn(owner).value_or(3.0) * (1.0 + 1.0 / 128.0) + 1.0 / 1024.0;
    each.setIn(changed, value);
    EXPECT_EQ(each.valueIn(changed), value);
    const std::string before = write(owner);
    const std::string after = write(changed);
    const std::vector<Attribute> differences = newIn(after, before);
    ASSERT_EQ(differences.size(), 1u) << after;
    EXPECT_EQ(differences.front().first.substr(differences.front().first.find(' ') + 1), each.row->name);
    EXPECT_EQ(newIn(before, after).size(), attributesIn(before).size() + 1 - attributesIn(after).size());
    const Outcome<Owner> again = readAgain(changed);
    if (!again.value) continue;  // a contradiction with another attribute, such as a height for one part alone
    EXPECT_EQ(each.valueIn(*again.value), value);
    ++read;
  }
  EXPECT_GT(read, 4);
}

Vehicle vehicleOfEveryPart() {
  Vehicle vehicle = test::contactVehicle();
  vehicle.groups.emplace_back().name = "front";
  Point& point = vehicle.points.emplace_back();
  point.name = "floor";
  point.body = vehicle.bodies.front().name;
  return vehicle;
}

TEST(AttributeTable, AParameterOfAVehicleIsWhatItsFileSays) { expectEachInItsAttribute(vehicleOfEveryPart()); }

TEST(AttributeTable, AParameterOfATrackIsWhatItsFileSays) {
  Scenario scenario;
  scenario.name = "track";
  scenario.run = {20.0, 10.0, {}, 0.01, {}};
  Track& track = scenario.track.emplace();
  track.fade_in = 50.0;
  track.harmonics.push_back({"wave", 25.0, 3.0, 0.002, 0.5, RailSide::kBoth, {}});
  track.dips.push_back({"dip", DipShape::kHalfSine, 0.008, 2.0, 20.0, RailSide::kBoth, {}});
  track.bumps.push_back({"bump", DipShape::kHalfSine, 0.008, 2.0, 30.0, RailSide::kBoth, {}});
  track.ramps.push_back({"ramp", 0.01, 5.0, 40.0, RailSide::kBoth, {}});
  expectEachInItsAttribute(scenario);
}

TEST(AttributeTable, AParameterOfARigIsWhatItsFileSays) {
  Scenario scenario;
  scenario.name = "rig";
  scenario.run.duration = 10.0;
  RigInput& input = scenario.rig.emplace().inputs.emplace_back();
  input.wheelset = "wheelset_1";
  RigSine& sine = input.sines.emplace_back();
  sine.name = "shake";
  sine.amplitude = 0.006;
  sine.frequency = 0.8;
  sine.phase = 0.3;
  expectEachInItsAttribute(scenario);
}

/// What stands between a beginning and the next end.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  return from == std::string::npos ? "" : text.substr(from, text.find(end, from + begin.size()) - from);
}

/// @param path  of an element that fills a Part, e.g. "vehicle.body"
template <class Part>
void expectOnThePages(const std::string& path) {
  SCOPED_TRACE(path);
  const bool is_root = path.find('.') == std::string::npos;
  std::string element = '<' + path + '>';
  for (std::size_t dot = element.find('.'); dot != std::string::npos; dot = element.find('.')) {
    element.replace(dot, 1, "><");
  }
  const std::string section = between(schemaMarkdown(), (is_root ? "\n## `" : "\n### `") + element + '`', "\n##");
  const std::string type = between(xsd(), "<xs:complexType name=\"" + path + '"', "</xs:complexType>");
  for (const AttributeRow& row : attributesOf<Part>()) {
    EXPECT_NE(section.find("\n| `" + std::string(row.name) + "` |"), std::string::npos) << row.name;
    EXPECT_NE(type.find("<xs:attribute name=\"" + std::string(row.name) + '"'), std::string::npos) << row.name;
  }
}

TEST(AttributeTable, EveryRowStandsInTheSchemaAndOnThePage) {
  expectOnThePages<Vehicle>("vehicle");
  expectOnThePages<Element>("vehicle.element");
  expectOnThePages<Body>("vehicle.body");
  expectOnThePages<Group>("vehicle.group");
  expectOnThePages<Wheelset>("vehicle.wheelset");
  expectOnThePages<Suspension>("vehicle.suspension");
  expectOnThePages<Point>("vehicle.point");
  expectOnThePages<Train>("train");
  expectOnThePages<TrainVehicle>("train.vehicle");
  expectOnThePages<Coupling>("train.coupling");
  expectOnThePages<Scenario>("scenario");
  expectOnThePages<vehicle::Run>("scenario.run");
  expectOnThePages<Track>("scenario.track");
  expectOnThePages<Harmonic>("scenario.track.harmonic");
  expectOnThePages<Dip>("scenario.track.dip");
  expectOnThePages<Bump>("scenario.track.bump");
  expectOnThePages<Ramp>("scenario.track.ramp");
  expectOnThePages<RigInput>("scenario.rig.input");
  expectOnThePages<RigSine>("scenario.rig.input.sine");
  expectOnThePages<InitialState>("scenario.initial_state");
  expectOnThePages<InitialBody>("scenario.initial_state.body");
  expectOnThePages<Suite>("suite");
  expectOnThePages<FileReference>("suite.vehicle");
  expectOnThePages<FileReference>("suite.scenario");
  expectOnThePages<SpeedRange>("suite.speed");
  expectOnThePages<NamedChoice>("suite.form");
  expectOnThePages<NamedChoice>("suite.method");
  expectOnThePages<Study>("study");
  expectOnThePages<FileReference>("study.vehicle");
  expectOnThePages<Vary>("study.vary");
  expectOnThePages<Plan>("study.plan");
  expectOnThePages<Search>("study.search");
  expectOnThePages<StudyDesign>("study.design");
  expectOnThePages<StudySet>("study.design.set");
  expectOnThePages<StudyMetric>("study.metric");
  expectOnThePages<Objective>("study.objective");
  expectOnThePages<Limit>("study.limit");
}

}  // namespace
}  // namespace vehicle
