#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "libvehicle/definition/attribute.h"

// Makes rows of the table of attributes from members of the structs. A member pointer is a template argument, so the
// accessors are plain functions and the walks need no knowledge of the structs.
namespace vehicle::attributes {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <auto kMember>
Value getMember(const void* object) {
  using Type = TypeOf<kMember>;
  const Type& member = static_cast<const ObjectOf<kMember>*>(object)->*kMember;
  if constexpr (IsOptional<Type>::value) {
    return member ? Value(*member) : Value();
  } else if constexpr (IsVector<Type>::value) {
    std::vector<int> indices;
    for (const auto each : member) indices.push_back(static_cast<int>(each));
    return indices;
  } else if constexpr (std::is_enum_v<Type>) {
    return static_cast<int>(member);
  } else {
    return member;
  }
}

template <auto kMember>
void setMember(void* object, const Value& value) {
  using Type = TypeOf<kMember>;
  Type& member = static_cast<ObjectOf<kMember>*>(object)->*kMember;
  if constexpr (IsOptional<Type>::value) {
    member = std::get<typename Type::value_type>(value);
  } else if constexpr (IsVector<Type>::value) {
    member.clear();
    for (const int index : std::get<std::vector<int>>(value)) {
      member.push_back(static_cast<typename Type::value_type>(index));
    }
  } else if constexpr (std::is_enum_v<Type>) {
    member = static_cast<Type>(std::get<int>(value));
  } else {
    member = std::get<Type>(value);
  }
}

template <auto kMember>
constexpr AttributeRow bound(std::string_view name, ValueKind kind, std::string_view sentence) {
  AttributeRow row;
  row.name = name;
  row.kind = kind;
  row.sentence = sentence;
  row.member = &kIdOf<kMember>;
  row.get = &getMember<kMember>;
  row.set = &setMember<kMember>;
  return row;
}

template <auto kMember>
constexpr AttributeRow name(std::string_view sentence) {
  return bound<kMember>("name", ValueKind::kName, sentence).asRequired();
}

template <auto kMember>
constexpr AttributeRow reference(std::string_view attribute_name, std::string_view sentence) {
  return bound<kMember>(attribute_name, ValueKind::kReference, sentence).asRequired();
}

template <auto kMember>
constexpr AttributeRow file(std::string_view sentence) {
  return bound<kMember>("file", ValueKind::kFile, sentence);
}

template <auto kMember>
constexpr AttributeRow words(std::string_view attribute_name, std::string_view sentence) {
  return bound<kMember>(attribute_name, ValueKind::kText, sentence);
}

/// A quantity that stays as the file says it.
template <auto kMember>
constexpr AttributeRow quantity(std::string_view attribute_name, Dimension dimension, Sign sign,
                                std::string_view sentence) {
  AttributeRow row = bound<kMember>(attribute_name, ValueKind::kQuantity, sentence);
  row.dimension = dimension;
  row.sign = sign;
  return row;
}

/// A quantity that studies may vary and --set may set.
template <auto kMember>
constexpr AttributeRow parameter(std::string_view attribute_name, Dimension dimension, Sign sign,
                                 std::string_view sentence) {
  AttributeRow row = quantity<kMember>(attribute_name, dimension, sign, sentence);
  row.varies = true;
  return row;
}

template <auto kMember>
constexpr AttributeRow integer(std::string_view attribute_name, int least, int most, std::string_view sentence) {
  AttributeRow row = bound<kMember>(attribute_name, ValueKind::kInteger, sentence);
  row.least = least;
  row.most = most;
  return row;
}

/// @param choices  words in the order of the enumerators
template <auto kMember>
constexpr AttributeRow choice(std::string_view attribute_name, Words choices, std::string_view sentence) {
  constexpr ValueKind kind = IsVector<TypeOf<kMember>>::value ? ValueKind::kChoiceList : ValueKind::kChoice;
  AttributeRow row = bound<kMember>(attribute_name, kind, sentence);
  row.choices = choices;
  return row;
}

/// A quantity for forms to come: no member, it goes into the object's `reserved` as it is written.
constexpr AttributeRow reservedQuantity(std::string_view attribute_name, Dimension dimension,
                                        std::string_view sentence) {
  AttributeRow row;
  row.name = attribute_name;
  row.kind = ValueKind::kQuantity;
  row.sentence = sentence;
  row.reserved = true;
  row.dimension = dimension;
  return row;
}

}  // namespace vehicle::attributes
