#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/diagnostics/problem.h"
#include "libvehicle/model/bound_study.h"

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

/// The header of a list, to be bound with the study (bindStudy()), and all that is wrong with the text without knowing
/// the study: fields that are not separated by commas, a column without name and unit or that stands there twice, a row
/// with too many or too few fields, a field that is no number, no row at all. At most 20 problems.
/// @param file  what messages call the text
/// @returns the columns that can be read, problems or not
[[nodiscard]] Outcome<ListedColumns> listedColumns(std::string_view text, const std::string& file);

/// All rows of a text that listedColumns() finds in order. Problems, at most 20: a number that is infinite in SI.
/// @param study  bound with the columns of that list
[[nodiscard]] Outcome<DesignList> readDesignList(std::string_view text, const std::string& file,
                                                 const BoundStudy& study);

}  // namespace vehicle
