#include "libvehicle/definition/suite_attributes.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

/// An element that names one of several choices.
ElementRow named(ElementRow row) {
  row.attributes.front().sentence = row.name == "form" ? "name of the form" : "name of the method";
  return row;
}

}  // namespace

ElementRow suiteRow() {
  return root<Suite>(
      "suite", "Vehicles, scenarios, speeds, forms and methods that `validate` crosses.",
      R"(<suite name="paper-speeds" format="1"> ... </suite>)",
      {
          text<&Suite::title>("title", "One line for reports.", "<title>The paper's vehicle at its speeds</title>"),
          text<&Suite::source>("source", "Where the numbers come from.", "<source>Section III of the paper</source>"),
          element<&Suite::vehicles>("vehicle", "A vehicle file.", R"(<vehicle file="../vehicles/coach.xml"/>)"),
          element<&Suite::scenarios>("scenario", "A scenario file.", R"(<scenario file="../scenarios/track.xml"/>)"),
          element<&Suite::speeds>("speed", "Speeds evenly spaced, both ends included; without any, the scenarios' own.",
                                  R"(<speed from="20 km/h" to="150 km/h" count="14"/>)"),
          named(element<&Suite::forms>("form", "A form; without any, all that fit.", R"(<form name="mbs-linear"/>)")),
          named(
              element<&Suite::methods>("method", "A method; without any, all that fit.", R"(<method name="exact"/>)")),
      });
}

}  // namespace vehicle::schema
