#include "libvehicle/definition/suite_attributes.h"

#include "libvehicle/definition/attribute_binding.h"

namespace vehicle {

namespace {

using namespace attributes;
using enum Dimension;
using enum Sign;

// A suite crosses its speeds with everything else: beyond this a typing error is likelier than a wish.
constexpr int kMostSpeeds = 10'000;

constexpr AttributeRow kSuite[] = {name<&Suite::name>("what reports call it")};

constexpr AttributeRow kFileReference[] = {
    file<&FileReference::file>("path, counted from the folder of this file").asRequired()};

constexpr AttributeRow kNamedChoice[] = {name<&NamedChoice::name>("name of what is chosen")};

/// One speed instead of a range.
constexpr AttributeRow singleSpeedRow() {
  AttributeRow row =
      quantity<&SpeedRange::from>("value", kSpeed, kPositive, "one speed alone").standingFor({"from", "to", "count"});
  row.member = nullptr;
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

constexpr AttributeRow kSpeedRange[] = {
    singleSpeedRow(),
    quantity<&SpeedRange::from>("from", kSpeed, kPositive, "first speed").asRequired(),
    quantity<&SpeedRange::to>("to", kSpeed, kPositive, "last speed").asRequired(),
    integer<&SpeedRange::count>("count", 1, kMostSpeeds, "how many").asRequired(),
};

}  // namespace

template <>
std::span<const AttributeRow> attributesOf<Suite>() {
  return kSuite;
}
template <>
std::span<const AttributeRow> attributesOf<FileReference>() {
  return kFileReference;
}
template <>
std::span<const AttributeRow> attributesOf<NamedChoice>() {
  return kNamedChoice;
}
template <>
std::span<const AttributeRow> attributesOf<SpeedRange>() {
  return kSpeedRange;
}

}  // namespace vehicle
