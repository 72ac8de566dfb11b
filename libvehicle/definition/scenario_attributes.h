#pragma once

#include <span>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/scenario.h"

namespace vehicle {

template <>
std::span<const AttributeRow> attributesOf<Scenario>();
template <>
std::span<const AttributeRow> attributesOf<Run>();
template <>
std::span<const AttributeRow> attributesOf<Track>();
template <>
std::span<const AttributeRow> attributesOf<Harmonic>();
template <>
std::span<const AttributeRow> attributesOf<Dip>();
template <>
std::span<const AttributeRow> attributesOf<Bump>();
template <>
std::span<const AttributeRow> attributesOf<Ramp>();
template <>
std::span<const AttributeRow> attributesOf<Rig>();
template <>
std::span<const AttributeRow> attributesOf<RigInput>();
template <>
std::span<const AttributeRow> attributesOf<RigSine>();
template <>
std::span<const AttributeRow> attributesOf<InitialState>();
template <>
std::span<const AttributeRow> attributesOf<InitialBody>();

}  // namespace vehicle
