#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libvehicle/units/quantity.h"

namespace vehicle {

// The one table of what may be said of a part: vehicle_attributes.h, train_attributes.h, scenario_attributes.h,
// study_attributes.h and suite_attributes.h. Reader, writer, XSD and docs page (`xml`), check() (judge.h) and the
// parameters of studies (parameter.h) walk its rows: a new attribute is one member of a struct and one row.

/// What the text of an attribute is.
enum class ValueKind {
  kFormat,      // version of the file format; bound to no member
  kName,        // letters, digits, "_" and "-", beginning with a letter or digit; unique in the file
  kReference,   // the name of another part; of a train's part "coach_2.carbody"
  kFile,        // a path, counted from the folder of the naming file
  kText,        // words that check() and bindStudy() read
  kQuantity,    // number with unit
  kInteger,     // whole number without unit
  kChoice,      // one word of a list
  kChoiceList,  // some words of a list, each once, with spaces between
};

/// Range of a quantity.
enum class Sign {
  kAny,
  kNotNegative,
  kPositive
};

/// A value between file and struct: quantity in SI, integer or index of a choice, text, indices of choices;
/// monostate: not given.
using Value = std::variant<std::monostate, double, int, std::string, std::vector<int>>;

/// A few words, fixed when the program is compiled.
class Words {
 public:
  constexpr Words() = default;
  consteval Words(std::initializer_list<std::string_view> words) {
    for (const std::string_view each : words) words_.at(size_++) = each;
  }

  [[nodiscard]] constexpr const std::string_view* begin() const { return words_.data(); }
  [[nodiscard]] constexpr const std::string_view* end() const { return words_.data() + size_; }
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  [[nodiscard]] constexpr std::string_view operator[](std::size_t i) const { return words_[i]; }
  /// For those who look for the nearest one or list them.
  [[nodiscard]] std::vector<std::string> strings() const { return {begin(), end()}; }

 private:
  std::array<std::string_view, 6> words_;  // as many as the longest list, the motions of a body
  std::size_t size_ = 0;
};

/// One attribute of one kind of part.
struct AttributeRow {
  std::string_view name;
  ValueKind kind = ValueKind::kName;
  std::string_view sentence;  // for the reader of the docs
  bool required = false;
  bool reserved = false;                     // checked, kept as text in `reserved`, used by no planar form
  bool varies = false;                       // of a kQuantity: studies may vary it, --set may set it
  Dimension dimension = Dimension::kNumber;  // of a kQuantity
  Sign sign = Sign::kAny;                    // of a kQuantity
  int least = 0;                             // of a kInteger
  int most = 0;                              // of a kInteger
  Words choices = {};                        // of kChoice and kChoiceList; the index is the enumerator's value
  Words spellings = {};                      // of kChoice: each choice as others spell it; read and never written
  std::string_view fallback = {};            // the struct's default, as a file would say it
  Words sets = {};                           // attributes that this one stands for (`z` for both ends)

  const void* member = nullptr;  // idOf<kMember>; null where the attribute is no single member
  Value (*get)(const void* object) = nullptr;
  void (*set)(void* object, const Value& value) = nullptr;

  /// Of a kQuantity with a member [SI]; nothing where the object gives no value.
  [[nodiscard]] std::optional<double> numberIn(const void* object) const {
    const Value value = get(object);
    const double* number = std::get_if<double>(&value);
    return number != nullptr ? std::optional<double>(*number) : std::nullopt;
  }

  /// The same row with one thing changed, so that a table line reads as a sentence.
  [[nodiscard]] constexpr AttributeRow asRequired() const;
  [[nodiscard]] constexpr AttributeRow orElse(std::string_view text) const;
  [[nodiscard]] constexpr AttributeRow alsoWritten(Words words) const;
  [[nodiscard]] constexpr AttributeRow standingFor(Words names) const;
};

constexpr AttributeRow AttributeRow::asRequired() const {
  AttributeRow row = *this;
  row.required = true;
  return row;
}

constexpr AttributeRow AttributeRow::orElse(std::string_view text) const {
  AttributeRow row = *this;
  row.fallback = text;
  return row;
}

constexpr AttributeRow AttributeRow::alsoWritten(Words words) const {
  AttributeRow row = *this;
  row.spellings = words;
  return row;
}

constexpr AttributeRow AttributeRow::standingFor(Words names) const {
  AttributeRow row = *this;
  row.sets = names;
  return row;
}

/// The rows of a kind of part, in the order in which files write them. Specialised in the tables for each struct.
template <class Part>
[[nodiscard]] std::span<const AttributeRow> attributesOf();

/// Names a member of a struct: equal pointers, equal members.
template <auto kMember>
inline constexpr char kIdOf = 0;

template <class Pointer>
struct MemberPointer;
template <class Owner, class Held>
struct MemberPointer<Held Owner::*> {
  using Object = Owner;
  using Type = Held;
};
template <auto kMember>
using ObjectOf = typename MemberPointer<decltype(kMember)>::Object;
template <auto kMember>
using TypeOf = typename MemberPointer<decltype(kMember)>::Type;

/// The row that fills a member, which has to have one.
template <auto kMember>
[[nodiscard]] const AttributeRow& rowOf() {
  static const AttributeRow& kRow = [&]() -> const AttributeRow& {
    const std::span<const AttributeRow> rows = attributesOf<ObjectOf<kMember>>();
    std::size_t i = 0;
    while (i < rows.size() && rows[i].member != &kIdOf<kMember>) ++i;
    assert(i < rows.size());  // a member that check() judges and no file gives
    return rows[i];
  }();
  return kRow;
}

}  // namespace vehicle
