#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/definition/bound_study.h"
#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// Designs of a CSV file, one a row, under a header of parameters with the unit of their numbers:
///
///     secondary.stiffness_z [kN/m],carbody.mass [t]
///     600,32
///     860,32.5
struct DesignList {
  std::vector<std::size_t> parameters;  // (columns) in BoundStudy::parameters
  std::vector<double> values;           // [SI] (rows x columns)
  [[nodiscard]] std::uint64_t rows() const { return parameters.empty() ? 0 : values.size() / parameters.size(); }
};

/// The addresses that the header names, to be bound with the study.
/// @param file  what messages call the text
[[nodiscard]] Outcome<std::vector<std::string>> listedAddresses(std::string_view text, const std::string& file);

/// All rows, at most 20 problems: a unit of another kind, a field that is no number, too many or too few fields.
[[nodiscard]] Outcome<DesignList> readDesignList(std::string_view text, const std::string& file,
                                                 const BoundStudy& study);

}  // namespace vehicle
