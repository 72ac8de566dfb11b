#pragma once

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/parts.h"

namespace vehicle {

// The names of a vehicle, for its checks. Private to this room.

/// What a reference means.
struct Meaning {
  enum class Kind {
    kExact,      // the part of that name
    kMisspelt,   // no part has the name; `name` is the nearest one
    kWrongKind,  // a part of another kind has it
    kNowhere,    // no part has a name like it
    kNotKnown,   // the reference could not be read, or the part that it means could not
  };
  Kind kind = Kind::kNotKnown;
  std::string_view name;        // of the part that is meant; "" where that is open
  const Part* other = nullptr;  // of kWrongKind: the part that has the name
};

class PartNames {
 public:
  using Kinds = std::initializer_list<std::string_view>;

  /// @param vehicle, parts  of it; outlive the object
  PartNames(const Vehicle& vehicle, const std::vector<Part>& parts);

  /// @param from        the part that refers
  /// @param attribute   whose value is `name`
  /// @param kinds       what is expected there
  [[nodiscard]] Meaning meaningOf(const Origin& from, std::string_view attribute, const std::string& name,
                                  Kinds kinds) const;

  /// Whether an element that the reader did not understand speaks of that name.
  [[nodiscard]] bool isStrange(std::string_view name) const { return strange_.contains(name); }

 private:
  const std::vector<Part>& parts_;
  std::multimap<std::string_view, const Part*> by_name_;
  std::set<std::string_view> nameless_;  // kinds of which a part may have any name: it could not be read
  std::set<std::string_view> strange_;
  mutable std::map<std::string, std::string_view> nearest_;  // of names that were looked for already
};

/// Both ends and the element of a suspension.
struct SuspensionEnds {
  Meaning element;
  Meaning upper;
  Meaning lower;
};
[[nodiscard]] SuspensionEnds endsOf(const Suspension& suspension, const PartNames& names);

/// Bodies that no chain of springs carries, and wheelsets that nothing stands on.
[[nodiscard]] ProblemList checkCarried(const Vehicle& vehicle, const PartNames& names);

}  // namespace vehicle
