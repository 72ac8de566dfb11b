#include "libvehicle/definition/vehicle.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

constexpr Sign kAny = Sign::kAny;
constexpr Sign kNotNegative = Sign::kNotNegative;
constexpr Sign kPositive = Sign::kPositive;

ElementRow elementRow() {
  return element<&Vehicle::elements>(
      "element", "What a spring and damper in parallel are made of; every suspension that names it has these values.",
      R"(<element name="primary" stiffness_z="3040 kN/m" damping_z="30 kN*s/m"/>)",
      {
          name<&Element::name>("what suspensions call it"),
          quantity<&Element::stiffness_z>("stiffness_z", Dimension::kStiffness, kNotNegative, "vertical stiffness")
              .orElse("0 N/m"),
          quantity<&Element::damping_z>("damping_z", Dimension::kDamping, kNotNegative, "vertical damping")
              .orElse("0 N*s/m"),
          reservedQuantity("stiffness_x", Dimension::kStiffness, "longitudinal stiffness"),
          reservedQuantity("stiffness_y", Dimension::kStiffness, "lateral stiffness"),
          reservedQuantity("stiffness_roll", Dimension::kRotationalStiffness, "stiffness about x"),
          reservedQuantity("stiffness_pitch", Dimension::kRotationalStiffness, "stiffness about y"),
          reservedQuantity("stiffness_yaw", Dimension::kRotationalStiffness, "stiffness about z"),
          reservedQuantity("damping_x", Dimension::kDamping, "longitudinal damping"),
          reservedQuantity("damping_y", Dimension::kDamping, "lateral damping"),
          reservedQuantity("damping_roll", Dimension::kRotationalDamping, "damping about x"),
          reservedQuantity("damping_pitch", Dimension::kRotationalDamping, "damping about y"),
          reservedQuantity("damping_yaw", Dimension::kRotationalDamping, "damping about z"),
      });
}

ElementRow groupRow() {
  ElementRow row = element<&Vehicle::groups>(
      "group", "Parts that move together: each x inside counts from the group's x. Groups do not nest.",
      R"(<group name="front" x="3.725 m"> ... </group>)",
      {
          name<&Group::name>("front.x addresses its place in a study"),
          quantity<&Group::x>("x", Dimension::kLength, kAny, "origin of the places inside").orElse("0 m"),
      });
  row.is_group = true;
  return row;
}

ElementRow bodyRow() {
  return element<&Vehicle::bodies>(
      "body", "A rigid body on springs: carbody, bogie frame.",
      R"(<body name="carbody" mass="57 t" pitch_inertia="70 t*m^2" motion="z pitch"/>)",
      {
          name<&Body::name>("what suspensions, points and results call it"),
          quantity<&Body::mass>("mass", Dimension::kMass, kPositive, "mass").asRequired(),
          quantity<&Body::pitch_inertia>("pitch_inertia", Dimension::kInertia, kNotNegative,
                                         "moment of inertia about the lateral axis through the centre of gravity; "
                                         "above 0 where motion holds pitch"),
          quantity<&Body::x>("x", Dimension::kLength, kAny, "centre of gravity, forward").orElse("0 m"),
          quantity<&Body::z>("z", Dimension::kLength, kAny,
                             "centre of gravity, height above rail top at loaded rest; all heights or none"),
          choice<&Body::motion>("motion", {"x", "y", "z", "roll", "pitch", "yaw"},
                                "how it may move; the planar forms use z and pitch (nose-up positive)")
              .asRequired(),
          reservedQuantity("y", Dimension::kLength, "centre of gravity, to the left"),
          reservedQuantity("roll_inertia", Dimension::kInertia, "moment of inertia about x"),
          reservedQuantity("yaw_inertia", Dimension::kInertia, "moment of inertia about z"),
      });
}

ElementRow wheelsetRow() {
  return element<&Vehicle::wheelsets>(
      "wheelset",
      "One axle. Without mass it follows the rail; with mass and contact it has a motion z of its own; with mass and "
      "without contact it follows the rail and its inertia enters its load. Values are for both wheels together.",
      R"(<wheelset name="wheelset_1" x="5.225 m"/>)",
      {
          name<&Wheelset::name>("what suspensions, rigs and results call it"),
          quantity<&Wheelset::x>("x", Dimension::kLength, kAny, "place, forward").orElse("0 m"),
          quantity<&Wheelset::z>("z", Dimension::kLength, kAny,
                                 "height of the axle above rail top; all heights or none"),
          quantity<&Wheelset::mass>("mass", Dimension::kMass, kPositive, "mass"),
          quantity<&Wheelset::load>("load", Dimension::kForce, kPositive,
                                    "static wheel-rail force Q0; else the one of the vehicle at rest"),
          quantity<&Wheelset::contact_stiffness>("contact_stiffness", Dimension::kStiffness, kPositive,
                                                 "linear contact spring"),
          quantity<&Wheelset::contact_damping>("contact_damping", Dimension::kDamping, kNotNegative,
                                               "damper of the contact"),
          quantity<&Wheelset::hertz_constant>("hertz_constant", Dimension::kHertzConstant, kPositive,
                                              "C of the Hertz contact F = C delta^1.5; it is linearised at the static load and "
                                              "cannot open"),
          reservedQuantity("y", Dimension::kLength, "place, to the left"),
          reservedQuantity("roll_inertia", Dimension::kInertia, "moment of inertia about x"),
          reservedQuantity("pitch_inertia", Dimension::kInertia, "moment of inertia about the axle"),
          reservedQuantity("yaw_inertia", Dimension::kInertia, "moment of inertia about z"),
      });
}

/// Both ends at one height.
AttributeRow endsRow() {
  AttributeRow row = quantity<&Suspension::z_upper>("z", Dimension::kLength, kAny, "height of both ends")
                         .standingFor({"z_upper", "z_lower"});
  row.get = [](const void* object) {
    const auto* suspension = static_cast<const Suspension*>(object);
    return suspension->z_upper && suspension->z_upper == suspension->z_lower ? Value(*suspension->z_upper) : Value();
  };
  row.set = [](void* object, const Value& value) {
    auto* suspension = static_cast<Suspension*>(object);
    suspension->z_upper = suspension->z_lower = std::get<double>(value);
  };
  return row;
}

ElementRow suspensionRow() {
  return element<&Vehicle::suspensions>(
      "suspension",
      "A spring and damper between two parts, acting vertically. Without y it is the total across the track.",
      R"(<suspension name="primary_1" element="primary" upper="front_bogie" lower="wheelset_1" x="5.225 m"/>)",
      {
          name<&Suspension::name>("what results call it"),
          reference<&Suspension::element>("element", "the element that it is made of"),
          reference<&Suspension::upper>("upper", "the body that it carries"),
          reference<&Suspension::lower>("lower", "the body or wheelset that it stands on"),
          quantity<&Suspension::x>("x", Dimension::kLength, kAny, "place, forward").orElse("0 m"),
          endsRow(),
          quantity<&Suspension::z_upper>("z_upper", Dimension::kLength, kAny, "height of its upper end above rail top"),
          quantity<&Suspension::z_lower>("z_lower", Dimension::kLength, kAny, "height of its lower end above rail top"),
          quantity<&Suspension::y>("y", Dimension::kLength, kAny, "with sides=\"2\": one at +y and one at -y"),
          integer<&Suspension::sides>("sides", 1, 2, "2: two equal ones, twice the element's values").orElse("1"),
          quantity<&Suspension::preload>("preload", Dimension::kForce, kAny,
                                         "static load that it carries, compression positive; else the one of the "
                                         "vehicle at rest"),
      });
}

ElementRow pointRow() {
  return element<&Vehicle::points>(
      "point", "A measuring point on a body, with columns .z .vz .az in the results.",
      R"(<point name="floor_mid" body="carbody" x="0 m"/>)",
      {
          name<&Point::name>("what results call it"),
          reference<&Point::body>("body", "the body that it sits on"),
          quantity<&Point::x>("x", Dimension::kLength, kAny, "place, forward").orElse("0 m"),
      });
}

}  // namespace

ElementRow vehicleRow() {
  return object<Vehicle>(
      "vehicle", "A vehicle: bodies on suspensions on wheelsets.",
      R"(<vehicle name="coach" format="1"> ... </vehicle>)",
      {name<&Vehicle::name>("what results and reports call it"), format()},
      {
          text<&Vehicle::title>("title", "One line for reports.", "<title>Coach, tare</title>"),
          text<&Vehicle::source>("source", "Where the numbers come from.", "<source>Data sheet of the maker</source>"),
          elementRow(),
          bodyRow(),
          groupRow(),
          wheelsetRow(),
          suspensionRow(),
          pointRow(),
      });
}

}  // namespace vehicle::schema
