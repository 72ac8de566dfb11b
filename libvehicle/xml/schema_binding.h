#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libvehicle/definition/attribute_binding.h"
#include "libvehicle/xml/schema.h"

// Binds elements to members of the definition structs, with the attributes that the table has for each struct. A member
// pointer is a template argument, so the accessors are plain functions and the walks need no knowledge of the structs.
namespace vehicle::schema {

using attributes::IsOptional;
using attributes::IsVector;

template <class Object>
ElementRow object(std::string name, std::string sentence, std::string example, std::vector<ElementRow> children) {
  ElementRow row;
  row.name = std::move(name);
  row.sentence = std::move(sentence);
  row.example = std::move(example);
  const std::span<const AttributeRow> rows = attributesOf<Object>();
  row.attributes.assign(rows.begin(), rows.end());
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
ElementRow element(std::string name, std::string sentence, std::string example, std::vector<ElementRow> children = {}) {
  using Parent = ObjectOf<kMember>;
  using Type = TypeOf<kMember>;
  if constexpr (IsVector<Type>::value) {
    ElementRow row = object<typename Type::value_type>(std::move(name), std::move(sentence), std::move(example),
                                                       std::move(children));
    row.many = true;
    row.count = [](const void* parent) { return (static_cast<const Parent*>(parent)->*kMember).size(); };
    row.at = [](const void* parent, std::size_t index) -> const void* {
      return &(static_cast<const Parent*>(parent)->*kMember)[index];
    };
    row.add = [](void* parent) -> void* { return &(static_cast<Parent*>(parent)->*kMember).emplace_back(); };
    return row;
  } else if constexpr (IsOptional<Type>::value) {
    ElementRow row = object<typename Type::value_type>(std::move(name), std::move(sentence), std::move(example),
                                                       std::move(children));
    row.count = [](const void* parent) -> std::size_t {
      return (static_cast<const Parent*>(parent)->*kMember).has_value() ? 1 : 0;
    };
    row.at = [](const void* parent, std::size_t) -> const void* {
      return &*(static_cast<const Parent*>(parent)->*kMember);
    };
    row.add = [](void* parent) -> void* { return &(static_cast<Parent*>(parent)->*kMember).emplace(); };
    return row;
  } else {
    ElementRow row = object<Type>(std::move(name), std::move(sentence), std::move(example), std::move(children));
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

/// The root of a file: its attribute `format` stands after its name.
template <class Object>
ElementRow root(std::string name, std::string sentence, std::string example, std::vector<ElementRow> children) {
  ElementRow row = object<Object>(std::move(name), std::move(sentence), std::move(example), std::move(children));
  AttributeRow format;
  format.name = "format";
  format.kind = ValueKind::kFormat;
  format.sentence = "version of this file format";
  format.required = true;
  row.attributes.insert(row.attributes.begin() + 1, format);
  return row;
}

}  // namespace vehicle::schema
