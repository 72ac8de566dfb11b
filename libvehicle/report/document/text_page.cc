#include "libvehicle/report/document/text_page.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include "libvehicle/report/document/cell_text.h"
#include "libvehicle/report/document/engineering_units.h"
#include "libvehicle/report/document/text_table.h"

namespace vehicle::report {
namespace {

/// The number in the unit found for it; the unit is changed with it.
void showHandy(Fact& fact) {
  double* number = std::get_if<double>(&fact.value);
  if (number == nullptr || !std::isfinite(*number)) return;
  const ShownUnit shown = shownUnit(fact.unit, std::abs(*number), Velocity::kOfTravel);
  *number *= shown.factor;
  fact.unit = shown.name;
}

/// One unit a column, by the largest of its numbers.
void showHandy(Table& table) {
  for (std::size_t j = 0; j < table.columns.size(); ++j) {
    TableColumn& column = table.columns[j];
    if (column.unit.empty() || column.shown == ColumnUnit::kAsGiven) continue;
    double largest = 0.0;
    const auto visitNumbers = [&](const auto& visit) {
      for (std::vector<Cell>& row : table.rows) {
        double* number = std::get_if<double>(&row[j]);
        if (number != nullptr && std::isfinite(*number)) visit(*number);
      }
    };
    visitNumbers([&](double& number) { largest = std::max(largest, std::abs(number)); });
    const ShownUnit shown = shownUnit(column.unit, largest, Velocity::kOfTravel);
    visitNumbers([&](double& number) { number *= shown.factor; });
    column.unit = shown.name;
  }
}

void printFacts(const std::vector<Fact>& facts, std::size_t width, std::ostream& out) {
  constexpr std::size_t kGap = 2;
  std::size_t names = 0;
  for (const Fact& fact : facts) names = std::max(names, lettersOf(fact.name));
  for (Fact fact : facts) {
    showHandy(fact);
    const std::string text = formatted(fact.value) + (fact.unit.empty() ? "" : " ") + fact.unit;
    out << fact.name << std::string(names - lettersOf(fact.name) + kGap, ' ') << wrapped(text, width, names + kGap)
        << '\n';
  }
}

}  // namespace

void printPage(const Document& document, std::size_t width, std::ostream& out) {
  printFacts(document.facts, width, out);
  bool first = document.facts.empty();
  for (Table table : document.tables) {
    if (table.rows.empty()) continue;
    if (!first) out << '\n';
    first = false;
    showHandy(table);
    printTable(table, width, out);
  }
  if (!document.remarks.empty() && !first) out << '\n';
  for (const std::string& remark : document.remarks) out << wrapped(remark, width) << '\n';
}

}  // namespace vehicle::report
