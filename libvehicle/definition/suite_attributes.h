#pragma once

#include <span>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/suite.h"

namespace vehicle {

template <>
std::span<const AttributeRow> attributesOf<Suite>();
template <>
std::span<const AttributeRow> attributesOf<FileReference>();
template <>
std::span<const AttributeRow> attributesOf<NamedChoice>();
template <>
std::span<const AttributeRow> attributesOf<SpeedRange>();

}  // namespace vehicle
