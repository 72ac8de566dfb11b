#pragma once

#include <span>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/study.h"

namespace vehicle {

template <>
std::span<const AttributeRow> attributesOf<Study>();
template <>
std::span<const AttributeRow> attributesOf<Vary>();
template <>
std::span<const AttributeRow> attributesOf<Plan>();
template <>
std::span<const AttributeRow> attributesOf<Search>();
template <>
std::span<const AttributeRow> attributesOf<StudyDesign>();
template <>
std::span<const AttributeRow> attributesOf<StudySet>();
template <>
std::span<const AttributeRow> attributesOf<StudyMetric>();
template <>
std::span<const AttributeRow> attributesOf<Objective>();
template <>
std::span<const AttributeRow> attributesOf<Limit>();

}  // namespace vehicle
