#pragma once

#include <string>

#include "libvehicle/report/document/document.h"

namespace vehicle::report {

/// One function for each kind of cell, for std::visit.
template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

/// "mass [kg]"
[[nodiscard]] std::string headerOf(const TableColumn& column);

/// For people: numbers of five significant digits, "-" for nothing.
[[nodiscard]] std::string formatted(const Cell& cell);

}  // namespace vehicle::report
