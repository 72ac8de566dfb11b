#include "libvehicle/definition/suite.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

/// One speed instead of a range.
AttributeRow singleSpeedRow() {
  AttributeRow row = quantity<&SpeedRange::from>("value", Dimension::kSpeed, Sign::kPositive, "one speed alone")
                         .standingFor({"from", "to", "count"});
  row.get = [](const void* object) {
    const auto* speed = static_cast<const SpeedRange*>(object);
    return speed->count == 1 && speed->from == speed->to ? Value(speed->from) : Value();
  };
  row.set = [](void* object, const Value& value) {
    auto* speed = static_cast<SpeedRange*>(object);
    speed->from = speed->to = std::get<double>(value);
    speed->count = 1;
  };
  return row;
}

AttributeRow fileRow() {
  return bound<&FileReference::file>("file", ValueKind::kFile, "path, counted from the folder of this file")
      .asRequired();
}

}  // namespace

ElementRow suiteRow() {
  constexpr Sign kPositive = Sign::kPositive;
  return object<Suite>(
      "suite", "Vehicles, scenarios, speeds, forms and methods that `validate` crosses.",
      R"(<suite name="paper-speeds" format="1"> ... </suite>)", {name<&Suite::name>("what reports call it"), format()},
      {
          text<&Suite::title>("title", "One line for reports.", "<title>The paper's vehicle at its speeds</title>"),
          text<&Suite::source>("source", "Where the numbers come from.", "<source>Section III of the paper</source>"),
          element<&Suite::vehicles>("vehicle", "A vehicle file.", R"(<vehicle file="../vehicles/coach.xml"/>)",
                                    {fileRow()}),
          element<&Suite::scenarios>("scenario", "A scenario file.", R"(<scenario file="../scenarios/track.xml"/>)",
                                     {fileRow()}),
          element<&Suite::speeds>(
              "speed", "Speeds evenly spaced, both ends included; without any, the scenarios' own.",
              R"(<speed from="20 km/h" to="150 km/h" count="14"/>)",
              {
                  singleSpeedRow(),
                  quantity<&SpeedRange::from>("from", Dimension::kSpeed, kPositive, "first speed").asRequired(),
                  quantity<&SpeedRange::to>("to", Dimension::kSpeed, kPositive, "last speed").asRequired(),
                  integer<&SpeedRange::count>("count", 1, 10000, "how many").asRequired(),
              }),
          element<&Suite::forms>("form", "A form; without any, all that fit.", R"(<form name="mbs-linear"/>)",
                                 {name<&NamedChoice::name>("name of the form")}),
          element<&Suite::methods>("method", "A method; without any, all that fit.", R"(<method name="exact"/>)",
                                   {name<&NamedChoice::name>("name of the method")}),
      });
}

}  // namespace vehicle::schema
