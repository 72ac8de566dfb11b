#include "libvehicle/definition/vehicle_attributes.h"

#include "libvehicle/definition/attribute_binding.h"

namespace vehicle {

namespace {

using namespace attributes;
using enum Dimension;
using enum Sign;

constexpr AttributeRow kVehicle[] = {name<&Vehicle::name>("what results and reports call it")};

constexpr AttributeRow kElement[] = {
    name<&Element::name>("what suspensions call it"),
    parameter<&Element::stiffness_z>("stiffness_z", kStiffness, kNotNegative, "vertical stiffness").orElse("0 N/m"),
    parameter<&Element::damping_z>("damping_z", kDamping, kNotNegative, "vertical damping").orElse("0 N*s/m"),
    reservedQuantity("stiffness_x", kStiffness, "longitudinal stiffness"),
    reservedQuantity("stiffness_y", kStiffness, "lateral stiffness"),
    reservedQuantity("stiffness_roll", kRotationalStiffness, "stiffness about x"),
    reservedQuantity("stiffness_pitch", kRotationalStiffness, "stiffness about y"),
    reservedQuantity("stiffness_yaw", kRotationalStiffness, "stiffness about z"),
    reservedQuantity("damping_x", kDamping, "longitudinal damping"),
    reservedQuantity("damping_y", kDamping, "lateral damping"),
    reservedQuantity("damping_roll", kRotationalDamping, "damping about x"),
    reservedQuantity("damping_pitch", kRotationalDamping, "damping about y"),
    reservedQuantity("damping_yaw", kRotationalDamping, "damping about z"),
};

constexpr AttributeRow kGroup[] = {
    name<&Group::name>("front.x addresses its place in a study"),
    parameter<&Group::x>("x", kLength, kAny, "origin of the places inside").orElse("0 m"),
};

constexpr AttributeRow kBody[] = {
    name<&Body::name>("what suspensions, points and results call it"),
    parameter<&Body::mass>("mass", kMass, kPositive, "mass").asRequired(),
    parameter<&Body::pitch_inertia>("pitch_inertia", kInertia, kNotNegative,
                                    "moment of inertia about the lateral axis through the centre of gravity; "
                                    "above 0 where motion holds pitch"),
    parameter<&Body::x>("x", kLength, kAny, "centre of gravity, forward").orElse("0 m"),
    parameter<&Body::z>("z", kLength, kAny,
                        "centre of gravity, height above rail top at loaded rest; all heights or none"),
    choice<&Body::motion>("motion", {"x", "y", "z", "roll", "pitch", "yaw"},
                          "how it may move; the planar forms use z and pitch (nose-up positive)")
        .asRequired(),
    reservedQuantity("y", kLength, "centre of gravity, to the left"),
    reservedQuantity("roll_inertia", kInertia, "moment of inertia about x"),
    reservedQuantity("yaw_inertia", kInertia, "moment of inertia about z"),
};

constexpr AttributeRow kWheelset[] = {
    name<&Wheelset::name>("what suspensions, rigs and results call it"),
    parameter<&Wheelset::x>("x", kLength, kAny, "place, forward").orElse("0 m"),
    parameter<&Wheelset::z>("z", kLength, kAny, "height of the axle above rail top; all heights or none"),
    parameter<&Wheelset::mass>("mass", kMass, kPositive, "mass"),
    parameter<&Wheelset::load>("load", kForce, kPositive,
                               "static wheel-rail force Q0; else the one of the vehicle at rest"),
    parameter<&Wheelset::contact_stiffness>("contact_stiffness", kStiffness, kPositive, "linear contact spring"),
    parameter<&Wheelset::contact_damping>("contact_damping", kDamping, kNotNegative, "damper of the contact"),
    parameter<&Wheelset::hertz_constant>(
        "hertz_constant", kHertzConstant, kPositive,
        "C of the Hertz contact F = C delta^1.5; it is linearised at the static load and cannot open"),
    reservedQuantity("y", kLength, "place, to the left"),
    reservedQuantity("roll_inertia", kInertia, "moment of inertia about x"),
    reservedQuantity("pitch_inertia", kInertia, "moment of inertia about the axle"),
    reservedQuantity("yaw_inertia", kInertia, "moment of inertia about z"),
};

/// Both ends at one height.
constexpr AttributeRow endsRow() {
  AttributeRow row =
      quantity<&Suspension::z_upper>("z", kLength, kAny, "height of both ends").standingFor({"z_upper", "z_lower"});
  row.member = nullptr;
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

constexpr AttributeRow kSuspension[] = {
    name<&Suspension::name>("what results call it"),
    reference<&Suspension::element>("element", "the element that it is made of"),
    reference<&Suspension::upper>("upper", "the body that it carries"),
    reference<&Suspension::lower>("lower", "the body or wheelset that it stands on"),
    parameter<&Suspension::x>("x", kLength, kAny, "place, forward").orElse("0 m"),
    endsRow(),
    parameter<&Suspension::z_upper>("z_upper", kLength, kAny, "height of its upper end above rail top"),
    parameter<&Suspension::z_lower>("z_lower", kLength, kAny, "height of its lower end above rail top"),
    parameter<&Suspension::y>("y", kLength, kAny, "with sides=\"2\": one at +y and one at -y"),
    integer<&Suspension::sides>("sides", 1, 2, "2: two equal ones, twice the element's values").orElse("1"),
    parameter<&Suspension::preload>(
        "preload", kForce, kAny,
        "static load that it carries, compression positive; else the one of the vehicle at rest"),
};

constexpr AttributeRow kPoint[] = {
    name<&Point::name>("what results call it"),
    reference<&Point::body>("body", "the body that it sits on"),
    parameter<&Point::x>("x", kLength, kAny, "place, forward").orElse("0 m"),
};

}  // namespace

template <>
std::span<const AttributeRow> attributesOf<Vehicle>() {
  return kVehicle;
}
template <>
std::span<const AttributeRow> attributesOf<Element>() {
  return kElement;
}
template <>
std::span<const AttributeRow> attributesOf<Group>() {
  return kGroup;
}
template <>
std::span<const AttributeRow> attributesOf<Body>() {
  return kBody;
}
template <>
std::span<const AttributeRow> attributesOf<Wheelset>() {
  return kWheelset;
}
template <>
std::span<const AttributeRow> attributesOf<Suspension>() {
  return kSuspension;
}
template <>
std::span<const AttributeRow> attributesOf<Point>() {
  return kPoint;
}

}  // namespace vehicle
