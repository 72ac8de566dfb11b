#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/units/quantity.h"

namespace vehicle {

/// Judges the values of one part of a definition and words what is wrong with them, the same way everywhere:
///     coach.xml:57: error: <vehicle><body>: mass="-57 t"; must be > 0
/// A part that comes from no file is told by its name: <vehicle><body name="carbody">.
class Judge {
 public:
  /// Bounds of any positive number [SI] and of any magnitude: no vehicle comes near them, and the products and
  /// quotients that the equations form of what lies between do not overflow.
  static constexpr double kSmallest = 1e-60;
  static constexpr double kLargest = 1e60;

  /// @param problems  where the words go; outlives the judge
  /// @param path      e.g. "<vehicle><body>"
  /// @param name      the part's own; "" where it has none
  Judge(ProblemList& problems, std::string_view path, std::string_view name, const Place& place);

  void say(std::string message, std::string remedy);

  /// Finite and within +-kLargest.
  bool finite(std::string_view attribute, double value, Dimension dimension);
  bool positive(std::string_view attribute, double value, Dimension dimension);
  bool notNegative(std::string_view attribute, double value, Dimension dimension);
  /// An optional that is not given is in order.
  bool finite(std::string_view attribute, std::optional<double> value, Dimension dimension);
  bool positive(std::string_view attribute, std::optional<double> value, Dimension dimension);
  bool notNegative(std::string_view attribute, std::optional<double> value, Dimension dimension);

  /// A value as written [SI]; nothing, and told, if it is none of that dimension.
  std::optional<double> quantity(std::string_view attribute, const std::string& text, Dimension dimension);

  /// A name is made of letters, digits, "_" and "-": parameters are addressed as name.attribute.
  bool properName(const std::string& name);
  /// The same, and not a word that stands for something else in a study (scenario, speed).
  bool partName(const std::string& name);

 private:
  ProblemList& problems_;
  std::string path_;
  Place place_;
};

/// attribute="30 kN/m", as a file would say it.
[[nodiscard]] std::string written(std::string_view attribute, double value, Dimension dimension);
/// attribute="text"; control characters become question marks, a message is one line.
[[nodiscard]] std::string written(std::string_view attribute, std::string_view text);
/// " (line 12)", or "" where that is not known.
[[nodiscard]] std::string inLine(const Place& place);

}  // namespace vehicle
