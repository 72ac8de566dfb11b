// docs/theory/errata.md is held against the program: every number of its evidence and eigenvalue tables is
// computed here and compared to the digits that the page prints.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "libvehicle/flat/first_order.h"
#include "libvehicle/flat/flat_form.h"
#include "libvehicle/linear/modes.h"
#include "libvehicle/simulate/simulate.h"
#include "tests/support/eigenvalues.h"
#include "tests/support/source_tree.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

// A number as the page prints it, and half a unit of its last digit.
struct Printed {
  double value = 0.0;
  double half_digit = 0.0;
};

std::vector<Printed> numbersIn(const std::string& cell) {
  std::vector<Printed> numbers;
  for (std::size_t at = 0; at < cell.size();) {
    const auto isDigit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(cell[i])) != 0; };
    const bool starts = isDigit(at) || (cell[at] == '-' && at + 1 < cell.size() && isDigit(at + 1));
    if (!starts) {
      ++at;
      continue;
    }
    std::size_t used = 0;
    const double value = std::stod(cell.substr(at), &used);
    const std::string text = cell.substr(at, used);
    const std::size_t point = text.find('.');
    const auto decimals = point == std::string::npos ? 0.0 : static_cast<double>(text.size() - point - 1);
    numbers.push_back({value, 0.5 * std::pow(10.0, -decimals)});
    at += used;
  }
  return numbers;
}

std::vector<std::vector<std::string>> tableRows() {
  std::ifstream page(sourcePath("docs/theory/errata.md"));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.empty() || line[0] != '|') continue;
    std::vector<std::string> cells;
    std::stringstream cellsOf(line.substr(1));
    for (std::string cell; std::getline(cellsOf, cell, '|');) cells.push_back(cell);
    rows.push_back(cells);
  }
  return rows;
}

// The last cell of the evidence row of that label.
std::vector<Printed> evidence(const std::string& label) {
  for (const auto& cells : tableRows()) {
    if (cells.size() == 3 && cells[0] == " " + label + " ") return numbersIn(cells[2]);
  }
  ADD_FAILURE() << "errata.md has no evidence row " << label;
  return {};
}

void expectPrinted(const std::string& label, const std::vector<double>& found) {
  const std::vector<Printed> printed = evidence(label);
  ASSERT_EQ(printed.size(), found.size()) << label;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], printed[i].value, printed[i].half_digit * (1.0 + 1e-9)) << label;
  }
}

void expectBelowPrinted(const std::string& label, double found) {
  const std::vector<Printed> printed = evidence(label);
  ASSERT_EQ(printed.size(), 1u) << label;
  EXPECT_LT(found, printed[0].value) << label;
}

// Positions in q of the paper's vehicle.
constexpr int kZk = 0, kZ1 = 2, kZ2 = 3;
constexpr double kMk = 57e3, kMb = 9e3, kCb = 3040e3;

StateSpace matricesOf(const std::string& form, const Vehicle& vehicle = paperVehicle()) {
  return *buildForm(form, compile(vehicle, 9.81))->linear();
}

// Rows of A below the kinematic ones are -M^-1 K and -M^-1 C.
double stiffness(const StateSpace& s, double inertia, int row, int column) { return -inertia * s.A(4 + row, column); }
double damping(const StateSpace& s, double inertia, int row, int column) { return -inertia * s.A(4 + row, 4 + column); }

TEST(Errata, ForceAfterUniformLiftAndLostSymmetryAreAsPrinted) {
  const StateSpace literal = matricesOf("flat-literal");
  const StateSpace consistent = matricesOf("flat");
  const double h = 1e-3;
  double spring = 0.0;
  for (const int part : {kZk, kZ1, kZ2}) spring += stiffness(literal, kMk, kZk, part) * h;
  expectPrinted("E1", {spring});
  // To the letter the "mass" of bogie 1 in (4) is cb.
  expectPrinted("E2", {stiffness(literal, kCb, kZ1, kZk) - stiffness(consistent, kMk, kZk, kZ1)});
  expectPrinted("E3", {stiffness(literal, kMb, kZ2, kZk) - stiffness(consistent, kMk, kZk, kZ2)});
  expectPrinted("E4", {damping(literal, kMb, kZ2, kZk) - damping(consistent, kMk, kZk, kZ2)});
}

std::vector<double> bounce(const std::string& form, const Scenario& scenario) {
  RunChoice choice;
  choice.form = form;
  choice.method = "exact";
  return simulate(paperVehicle(), scenario, choice).history.column("carbody.z");
}

double largestShare(const std::vector<double>& a, const std::vector<double>& b) {
  double peak = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    peak = std::max(peak, std::abs(b[i]));
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference / peak;
}

TEST(Errata, PrintedListOfSymbolsChangesTheBounceAsPrinted) {
  std::vector<double> percent;
  for (const History history : {History::kOnset, History::kExtended}) {
    const Scenario scenario = paperScenario(history);
    percent.push_back(100.0 * largestShare(bounce("flat-7-printed", scenario), bounce("flat", scenario)));
  }
  expectPrinted("E5", percent);
}

TEST(Errata, EquationSevenIsTwoToFiveUnderTheReadingOfRowNine) {
  const std::unique_ptr<FlatForm> form = buildFlatForm(compile(paperVehicle(), 9.81));
  const Equation7 seven = equation7(lettersOf(form->parameters(), Mapping::kConsistent));
  // Entry i of (7)'s state stands at kPlace[i] of (zk, phi, z1, z2, zk', phi', z1', z2').
  constexpr std::array<std::size_t, 8> kPlace = {2, 6, 3, 7, 0, 4, 1, 5};
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double worst = 0.0;
  for (int state = 0; state < 1000; ++state) {
    std::array<double, 8> x{}, u{}, dx{}, difference{};
    for (double& value : x) value = unit(generator);
    for (double& value : u) value = unit(generator);
    (*form->rhs())(x.data(), u.data(), dx.data());
    double largest = 0.0;
    for (std::size_t row = 0; row < 8; ++row) {
      double sum = 0.0;
      for (std::size_t column = 0; column < 8; ++column) {
        sum += seven.A[row][column] * x[kPlace[column]] + seven.B[row][column] * u[column];
      }
      difference[row] = std::abs(sum - dx[kPlace[row]]);
      largest = std::max(largest, std::abs(dx[kPlace[row]]));
    }
    worst = std::max(worst, *std::max_element(difference.begin(), difference.end()) / largest);
  }
  expectBelowPrinted("E6", worst);
}

TEST(Errata, DelaysAndRadiiOfGyrationAreAsPrinted) {
  expectPrinted("E7", {2.0 * (5e-3 + 2e-3) / 20.0 * 1e3});
  expectPrinted("E8", {std::sqrt(70e3 / kMk), std::sqrt(70.0 * 9806.65 / kMk)});
}

TEST(Errata, TwiceTheRailGivesTwiceTheAnswer) {
  Scenario twice = paperScenario(History::kOnset);
  for (Harmonic& each : twice.track->harmonics) each.amplitude *= 2.0;
  std::vector<double> half = bounce("flat", twice);
  for (double& z : half) z *= 0.5;
  expectBelowPrinted("E9", largestShare(half, bounce("flat", paperScenario(History::kOnset))));
}

double growth(double dampers) {
  Vehicle vehicle = paperVehicle();
  for (Element& each : vehicle.elements) each.damping_z *= dampers;
  return test::eigenvaluesOf(matricesOf("flat-literal", vehicle).A).real().maxCoeff();
}

TEST(Errata, LiteralEquationsLoseTheirStabilityAsPrinted) {
  double unstable = 0.3, stable = 1.0;
  ASSERT_GT(growth(unstable), 0.0);
  ASSERT_LT(growth(stable), 0.0);
  while (stable - unstable > 1e-6) {
    const double middle = 0.5 * (stable + unstable);
    (growth(middle) > 0.0 ? unstable : stable) = middle;
  }
  expectPrinted("E10", {unstable});
}

TEST(Errata, EigenvaluesOfAllFourReadingsAreAsPrinted) {
  const std::vector<std::string> forms = {"flat", "flat-7-printed", "flat-literal", "flat-literal-mb"};
  std::size_t compared = 0;
  for (const auto& cells : tableRows()) {
    if (cells.size() != 4 || cells[0].find('j') == std::string::npos) continue;
    for (std::size_t column = 0; column < forms.size(); ++column) {
      // "-0.883650 +- 7.932963j": the second number is read from behind the sign pair.
      const std::size_t sign = cells[column].find("+-");
      const Printed re = numbersIn(cells[column].substr(0, sign)).at(0);
      const Printed im = numbersIn(cells[column].substr(sign + 2)).at(0);
      double nearest = INFINITY;
      for (const Mode& mode : modesOf(*buildForm(forms[column], compile(paperVehicle(), 9.81)))) {
        nearest = std::min(nearest, std::max(std::abs(mode.eigenvalue.real() - re.value) / re.half_digit,
                                             std::abs(mode.eigenvalue.imag() - im.value) / im.half_digit));
      }
      EXPECT_LE(nearest, 1.0 + 1e-6) << forms[column] << cells[column];
      ++compared;
    }
  }
  EXPECT_EQ(compared, 16u);
}

}  // namespace
}  // namespace vehicle::test
