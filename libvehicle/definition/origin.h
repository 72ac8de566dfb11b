#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// One attribute of a part as its file has it.
struct AttributeText {
  std::string name;     // "z_upper": as the schema calls it
  std::string written;  // "z": as the file calls it, which may stand for several or be misspelt
  std::string text;     // "57 t"; of an attribute that the file leaves out its default, or ""
  int line = 0;
  bool given = true;  // false: the file leaves it out
  bool known = true;  // false: wrong, missing, or perhaps meant by something that the reader did not understand
};

/// What a file says of a part: messages quote it, and checks learn from it which values they may judge.
struct PartText {
  std::vector<AttributeText> attributes;  // those given, those with a default, and those that are not known
  bool whole = true;                      // every attribute is known
  bool readable = true;                   // false: the part itself is missing or not understood; no attribute is known
  /// Of the root: the words inside elements that mean nothing. They may name any part, e.g. carry a body.
  std::vector<std::string> strange_words;
  bool has_strange = false;  // of the root: there are such elements
};

/// Where a part of a definition was written, and how. It is no part of the value: two parts that say the same in
/// different places are equal.
struct Origin : Place {
  /// Null for a part that comes from no file. Shared because it never changes after the file has been read, and
  /// because trains and studies copy their parts thousands of times.
  std::shared_ptr<const PartText> text = {};

  bool operator==(const Origin&) const { return true; }

  /// What the file says of an attribute; null where that is not recorded.
  [[nodiscard]] const AttributeText* find(std::string_view attribute) const {
    if (!text) return nullptr;
    const auto found = std::find_if(text->attributes.begin(), text->attributes.end(),
                                    [&](const AttributeText& each) { return each.name == attribute; });
    return found == text->attributes.end() ? nullptr : &*found;
  }

  /// False where the file's value could not be read: what stands in the struct then is some value in range.
  [[nodiscard]] bool knows(std::string_view attribute) const {
    if (!text || text->whole) return true;
    if (!text->readable) return false;
    const AttributeText* found = find(attribute);
    return found == nullptr || found->known;
  }

  [[nodiscard]] bool knowsAll() const { return !text || text->whole; }
  /// Of a root: whether the file holds elements that the reader did not understand.
  [[nodiscard]] bool hasStrange() const { return text && text->has_strange; }
};

/// A quantity the file holds for formulations that this program does not build yet (y, roll_inertia, ...):
/// kept as written and written back unchanged.
struct ReservedQuantity {
  std::string attribute;  // e.g. "roll_inertia"
  std::string text;       // e.g. "56.8 t*m^2"
  bool operator==(const ReservedQuantity&) const = default;
};

}  // namespace vehicle
