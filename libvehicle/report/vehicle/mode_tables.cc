#include "libvehicle/report/vehicle/mode_tables.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>

namespace vehicle::report {
namespace {

/// In (-180, 180]; what rounding leaves of 0 and of 180 is 0 and 180.
double phaseInDegrees(std::complex<double> entry) {
  const double phase = std::arg(entry) * 180.0 / std::numbers::pi;
  if (std::abs(phase) < 1e-9) return 0.0;
  return phase < -180.0 + 1e-9 ? 180.0 : phase;
}

// Below rounding a coordinate does not take part, and its phase would be noise.
constexpr double kNoPart = 1e-9;

/// One line a mode and coordinate, for other programs.
Table shapeList(const std::vector<Mode>& modes, const std::vector<Channel>& states) {
  Table table{"shapes", {{"mode", ""}, {"coordinate", ""}, {"unit", ""}, {"size", ""}, {"phase", "deg"}}, {}};
  long number = 0;
  for (const Mode& mode : modes) {
    ++number;
    for (Eigen::Index i = 0; i < mode.shape.size(); ++i) {
      const Channel& coordinate = states[static_cast<std::size_t>(i)];
      const double size = std::abs(mode.shape(i));
      if (size < kNoPart) continue;
      table.rows.push_back({number, coordinate.name, coordinate.unit, size, phaseInDegrees(mode.shape(i))});
    }
  }
  return table;
}

/// Coordinates as rows, modes as columns, for people.
Table shapeMatrix(const std::vector<Mode>& modes, const std::vector<Channel>& states) {
  Table table{"shapes: amplitude (phase in degrees), the largest of a mode is 1", {{"coordinate", ""}}, {}, 1};
  for (std::size_t mode = 0; mode < modes.size(); ++mode)
    table.columns.push_back({fmt::format("mode {}", mode + 1), ""});
  for (std::size_t i = 0; i < states.size() / 2; ++i) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(fmt::format("{} [{}]", states[i].name, states[i].unit));
    for (const Mode& mode : modes) {
      const std::complex<double> entry = mode.shape(static_cast<Eigen::Index>(i));
      if (std::abs(entry) < kNoPart) {
        row.emplace_back("0");
      } else {
        row.emplace_back(fmt::format("{:.3g} ({:.0f})", std::abs(entry), std::round(phaseInDegrees(entry)) + 0.0));
      }
    }
  }
  return table;
}

}  // namespace

Table eigenvalueTable(const std::vector<Mode>& modes, const std::vector<UndampedMode>& undamped) {
  Table table{"modes",
              {{"mode", ""},
               {"frequency", "Hz"},
               {"damped frequency", "Hz"},
               {"undamped frequency", "Hz"},
               {"damping ratio", "-"},
               {"real", "1/s"},
               {"imaginary", "1/s"},
               {"multiplicity", ""},
               {"name", ""}},
              {}};
  for (const Mode& mode : modes) {
    std::vector<Cell>& row = table.rows.emplace_back();
    row.emplace_back(static_cast<long>(table.rows.size()));
    row.emplace_back(mode.frequency);
    std::optional<double> damped;
    if (mode.eigenvalue.imag() > 0.0) damped = mode.eigenvalue.imag() / (2.0 * std::numbers::pi);
    addCell(row, damped);
    addCell(row, undampedFrequencyOf(std::span(&mode, 1), undamped));
    row.emplace_back(mode.damping_ratio);
    row.emplace_back(mode.eigenvalue.real());
    row.emplace_back(mode.eigenvalue.imag());
    row.emplace_back(static_cast<long>(mode.multiplicity));
    row.emplace_back(mode.name);
  }
  return table;
}

Table shapeTable(const std::vector<Mode>& modes, const std::vector<Channel>& states, Format format) {
  return format == Format::kTable ? shapeMatrix(modes, states) : shapeList(modes, states);
}

}  // namespace vehicle::report
