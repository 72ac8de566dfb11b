#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/attribute.h"
#include "libvehicle/definition/origin.h"
#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/units/quantity.h"

namespace vehicle {

/// Judges the values of one part of a definition and words what is wrong with them, the same way everywhere:
///     coach.xml:57: error: <vehicle><body>: mass="-57 t"; must be > 0
/// A part that comes from no file is told by its name: <vehicle><body name="carbody">.
/// A value that the file's reader has refused already is not judged again.
class Judge {
 public:
  /// Bounds of any positive number [SI] and of any magnitude: no vehicle comes near them, and the products and
  /// quotients that the equations form of what lies between do not overflow.
  static constexpr double kSmallest = 1e-60;
  static constexpr double kLargest = 1e60;

  /// @param problems  where the words go; outlives the judge
  /// @param path      e.g. "<vehicle><body>"
  /// @param name      the part's own; "" where it has none
  Judge(ProblemList& problems, std::string_view path, std::string_view name, const Origin& origin);

  void say(std::string message, std::string remedy);

  /// Whether all of these attributes could be read: a check of several values needs each of them.
  [[nodiscard]] bool knows(std::initializer_list<std::string_view> attributes) const;

  /// Finite and within +-kLargest.
  /// @returns whether the value is known and in order; so do the others
  bool finite(std::string_view attribute, double value, Dimension dimension);
  bool positive(std::string_view attribute, double value, Dimension dimension);
  bool notNegative(std::string_view attribute, double value, Dimension dimension);
  /// An optional that is not given is in order.
  bool finite(std::string_view attribute, std::optional<double> value, Dimension dimension);
  bool positive(std::string_view attribute, std::optional<double> value, Dimension dimension);
  bool notNegative(std::string_view attribute, std::optional<double> value, Dimension dimension);

  /// A number of a part as its row of the table asks for: finite, > 0 or >= 0.
  /// @returns as above
  template <auto kMember>
  bool number(const ObjectOf<kMember>& part) {
    return number(rowOf<kMember>(), &part);
  }
  /// All numbers of a part in the order of the table but those of kElsewhere, which the caller judges itself
  /// because their order or their range depends on more than the row.
  template <auto... kElsewhere, class Part>
  void numbers(const Part& part) {
    for (const AttributeRow& row : attributesOf<Part>()) {
      const bool is_elsewhere = ((row.member == &kIdOf<kElsewhere>) || ...);
      if (row.kind == ValueKind::kQuantity && row.member != nullptr && !is_elsewhere) number(row, &part);
    }
  }

  /// A value as written [SI]; nothing, and told, if it is none of that dimension.
  /// @param item  the part of a list that is read; "": all of `text`
  std::optional<double> quantity(std::string_view attribute, const std::string& text, Dimension dimension,
                                 const std::string& item = "");

  /// A name is made of letters, digits, "_" and "-": parameters are addressed as name.attribute.
  bool properName(const std::string& name);
  /// The same, and not a word that stands for something else in a study (scenario, speed).
  bool partName(const std::string& name);

  /// attribute="30000 N/m", as the file says it. A value that the file does not give so (a study has set it, it comes
  /// from the command line) is formatted; a default that the file leaves out is followed by "(default)".
  [[nodiscard]] std::string written(std::string_view attribute, double value, Dimension dimension) const;
  [[nodiscard]] std::string written(std::string_view attribute, int value) const;

 private:
  bool number(const AttributeRow& row, const void* part);
  void sayOf(std::string_view attribute, std::string message, std::string remedy);

  ProblemList& problems_;
  std::string path_;
  Origin origin_;
};

/// attribute="30 kN/m", formatted: for values that stand in no file.
[[nodiscard]] std::string written(std::string_view attribute, double value, Dimension dimension);
/// attribute="text"; control characters become question marks, a message is one line.
[[nodiscard]] std::string written(std::string_view attribute, std::string_view text);
/// " (line 12)", or "" where that is not known.
[[nodiscard]] std::string inLine(const Place& place);
/// " (and in 2 more places: lines 12, 15)" for a message that stands for several equal ones; "" for no places.
[[nodiscard]] std::string andIn(const std::vector<Place>& others);

}  // namespace vehicle
