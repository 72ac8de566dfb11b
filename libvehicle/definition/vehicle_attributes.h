#pragma once

#include <span>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/vehicle.h"

namespace vehicle {

template <>
std::span<const AttributeRow> attributesOf<Vehicle>();
template <>
std::span<const AttributeRow> attributesOf<Element>();
template <>
std::span<const AttributeRow> attributesOf<Group>();
template <>
std::span<const AttributeRow> attributesOf<Body>();
template <>
std::span<const AttributeRow> attributesOf<Wheelset>();
template <>
std::span<const AttributeRow> attributesOf<Suspension>();
template <>
std::span<const AttributeRow> attributesOf<Point>();

}  // namespace vehicle
