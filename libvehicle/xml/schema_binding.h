#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "libvehicle/xml/schema.h"

// Binds rows of the schema table to members of the definition structs. A member pointer is a template
// argument, so the accessors are plain functions and the walks need no knowledge of the structs.
namespace vehicle::schema {

template <class Pointer>
struct Member;
template <class Owner, class Held>
struct Member<Held Owner::*> {
  using Object = Owner;
  using Type = Held;
};
template <auto kMember>
using ObjectOf = typename Member<decltype(kMember)>::Object;
template <auto kMember>
using TypeOf = typename Member<decltype(kMember)>::Type;

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
AttributeRow bound(std::string name, ValueKind kind, std::string sentence) {
  AttributeRow row;
  row.name = std::move(name);
  row.kind = kind;
  row.sentence = std::move(sentence);
  row.get = &getMember<kMember>;
  row.set = &setMember<kMember>;
  return row;
}

template <auto kMember>
AttributeRow name(std::string sentence) {
  return bound<kMember>("name", ValueKind::kName, std::move(sentence)).asRequired();
}

template <auto kMember>
AttributeRow reference(std::string attribute_name, std::string sentence) {
  return bound<kMember>(std::move(attribute_name), ValueKind::kReference, std::move(sentence)).asRequired();
}

template <auto kMember>
AttributeRow quantity(std::string attribute_name, Dimension dimension, Sign sign, std::string sentence) {
  AttributeRow row = bound<kMember>(std::move(attribute_name), ValueKind::kQuantity, std::move(sentence));
  row.dimension = dimension;
  row.sign = sign;
  return row;
}

template <auto kMember>
AttributeRow integer(std::string attribute_name, int least, int most, std::string sentence) {
  AttributeRow row = bound<kMember>(std::move(attribute_name), ValueKind::kInteger, std::move(sentence));
  row.least = least;
  row.most = most;
  return row;
}

/// @param choices  words in the order of the enumerators
template <auto kMember>
AttributeRow choice(std::string attribute_name, std::vector<std::string> choices, std::string sentence) {
  constexpr ValueKind kind = IsVector<TypeOf<kMember>>::value ? ValueKind::kChoiceList : ValueKind::kChoice;
  AttributeRow row = bound<kMember>(std::move(attribute_name), kind, std::move(sentence));
  row.choices = std::move(choices);
  return row;
}

/// A quantity for forms to come: no member, it goes into the object's `reserved` as it is written.
inline AttributeRow reservedQuantity(std::string attribute_name, Dimension dimension, std::string sentence) {
  AttributeRow row;
  row.name = std::move(attribute_name);
  row.kind = ValueKind::kQuantity;
  row.sentence = std::move(sentence);
  row.reserved = true;
  row.dimension = dimension;
  return row;
}

template <class Object>
ElementRow object(std::string name, std::string sentence, std::string example, std::vector<AttributeRow> attributes,
                  std::vector<ElementRow> children) {
  ElementRow row;
  row.name = std::move(name);
  row.sentence = std::move(sentence);
  row.example = std::move(example);
  row.attributes = std::move(attributes);
  row.children = std::move(children);
  row.fresh = []() -> const void* {
    static const Object kFresh{};
    return &kFresh;
  };
  row.origin = [](void* each) { return &static_cast<Object*>(each)->origin; };
  if constexpr (requires(Object each) { each.group; }) {
    row.group = [](void* each) { return &static_cast<Object*>(each)->group; };
    row.in_group = true;
  }
  if constexpr (requires(Object each) { each.reserved; }) {
    row.reserved = [](void* each) { return &static_cast<Object*>(each)->reserved; };
  }
  return row;
}

/// An element whose member is a vector (any number), an optional (one or none) or a plain struct (one; none
/// means the defaults).
template <auto kMember>
ElementRow element(std::string name, std::string sentence, std::string example, std::vector<AttributeRow> attributes,
                   std::vector<ElementRow> children = {}) {
  using Parent = ObjectOf<kMember>;
  using Type = TypeOf<kMember>;
  if constexpr (IsVector<Type>::value) {
    ElementRow row = object<typename Type::value_type>(std::move(name), std::move(sentence), std::move(example),
                                                       std::move(attributes), std::move(children));
    row.many = true;
    row.count = [](const void* parent) { return (static_cast<const Parent*>(parent)->*kMember).size(); };
    row.at = [](const void* parent, std::size_t index) -> const void* {
      return &(static_cast<const Parent*>(parent)->*kMember)[index];
    };
    row.add = [](void* parent) -> void* { return &(static_cast<Parent*>(parent)->*kMember).emplace_back(); };
    return row;
  } else if constexpr (IsOptional<Type>::value) {
    ElementRow row = object<typename Type::value_type>(std::move(name), std::move(sentence), std::move(example),
                                                       std::move(attributes), std::move(children));
    row.count = [](const void* parent) -> std::size_t {
      return (static_cast<const Parent*>(parent)->*kMember).has_value() ? 1 : 0;
    };
    row.at = [](const void* parent, std::size_t) -> const void* {
      return &*(static_cast<const Parent*>(parent)->*kMember);
    };
    row.add = [](void* parent) -> void* { return &(static_cast<Parent*>(parent)->*kMember).emplace(); };
    return row;
  } else {
    ElementRow row = object<Type>(std::move(name), std::move(sentence), std::move(example), std::move(attributes),
                                  std::move(children));
    row.count = [](const void* parent) -> std::size_t {
      return static_cast<const Parent*>(parent)->*kMember == Type{} ? 0 : 1;
    };
    row.at = [](const void* parent, std::size_t) -> const void* {
      return &(static_cast<const Parent*>(parent)->*kMember);
    };
    row.add = [](void* parent) -> void* { return &(static_cast<Parent*>(parent)->*kMember); };
    return row;
  }
}

template <auto kMember>
ElementRow text(std::string name, std::string sentence, std::string example) {
  ElementRow row;
  row.name = std::move(name);
  row.sentence = std::move(sentence);
  row.example = std::move(example);
  row.text = [](void* parent) { return &(static_cast<ObjectOf<kMember>*>(parent)->*kMember); };
  return row;
}

inline AttributeRow format() {
  AttributeRow row;
  row.name = "format";
  row.kind = ValueKind::kFormat;
  row.sentence = "version of this file format";
  row.required = true;
  return row;
}

}  // namespace vehicle::schema
