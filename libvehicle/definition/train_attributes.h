#pragma once

#include <span>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/train.h"

namespace vehicle {

template <>
std::span<const AttributeRow> attributesOf<Train>();
template <>
std::span<const AttributeRow> attributesOf<TrainVehicle>();
template <>
std::span<const AttributeRow> attributesOf<Coupling>();

}  // namespace vehicle
