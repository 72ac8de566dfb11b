#include "libvehicle/definition/vehicle_attributes.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

ElementRow groupRow() {
  ElementRow row = element<&Vehicle::groups>(
      "group", "Parts that move together: each x inside counts from the group's x. Groups do not nest.",
      R"(<group name="front" x="3.725 m"> ... </group>)");
  row.is_group = true;
  return row;
}

}  // namespace

ElementRow vehicleRow() {
  return root<Vehicle>(
      "vehicle", "A vehicle: bodies on suspensions on wheelsets.",
      R"(<vehicle name="coach" format="1"> ... </vehicle>)",
      {
          text<&Vehicle::title>("title", "One line for reports.", "<title>Coach, tare</title>"),
          text<&Vehicle::source>("source", "Where the numbers come from.", "<source>Data sheet of the maker</source>"),
          element<&Vehicle::elements>(
              "element",
              "What a spring and damper in parallel are made of; every suspension that names it has these values.",
              R"(<element name="primary" stiffness_z="3040 kN/m" damping_z="30 kN*s/m"/>)"),
          element<&Vehicle::bodies>("body", "A rigid body on springs: carbody, bogie frame.",
                                    R"(<body name="carbody" mass="57 t" pitch_inertia="70 t*m^2" motion="z pitch"/>)"),
          groupRow(),
          element<&Vehicle::wheelsets>(
              "wheelset",
              "One axle. Without mass it follows the rail; with mass and contact it has a motion z of its own; with "
              "mass and without contact it follows the rail and its inertia enters its load. Values are for both "
              "wheels together.",
              R"(<wheelset name="wheelset_1" x="5.225 m"/>)"),
          element<&Vehicle::suspensions>(
              "suspension",
              "A spring and damper between two parts, acting vertically. Without y it is the total across the track.",
              R"(<suspension name="primary_1" element="primary" upper="front_bogie" lower="wheelset_1" x="5.225 m"/>)"),
          element<&Vehicle::points>("point", "A measuring point on a body, with columns .z .vz .az in the results.",
                                    R"(<point name="floor_mid" body="carbody" x="0 m"/>)"),
      });
}

}  // namespace vehicle::schema
