#include "libvehicle/report/document/cell_text.h"

#include <fmt/format.h>

namespace vehicle::report {

std::string headerOf(const TableColumn& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

std::string formatted(const Cell& cell) {
  return std::visit(Cases{[](std::monostate) { return std::string("-"); }, [](const std::string& text) { return text; },
                          // + 0.0 turns -0 into 0
                          [](double number) { return fmt::format("{:.5g}", number + 0.0); },
                          [](long number) { return fmt::format("{}", number); },
                          [](bool yes) { return std::string(yes ? "yes" : "no"); }},
                    cell);
}

}  // namespace vehicle::report
