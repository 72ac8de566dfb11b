// The flat equations cut into equations: the bits of the whole from every cut, and the coupling's law.
#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/flat/flat_equation_set.h"
#include "libvehicle/flat/flat_form.h"
#include "tests/support/random_state.h"
#include "tests/support/refusal.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

std::vector<int> identity(int size) {
  std::vector<int> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

FlatEquationSet trainOf(const std::vector<FlatParameters>& vehicles, const std::vector<FlatCoupling>& couplings) {
  const int count = static_cast<int>(vehicles.size());
  return FlatEquationSet(vehicles, couplings, std::vector<FlatBodyNames>(vehicles.size()), identity(8 * count),
                         identity(4 * count));
}

FlatParameters parametersOf(const Vehicle& vehicle) { return buildFlatForm(compile(vehicle, 9.81))->parameters(); }

// Three vehicles, two unlike couplings, nothing symmetric.
FlatEquationSet mixedTrain() {
  return trainOf({parametersOf(asymmetricVehicle()), parametersOf(paperVehicle()), parametersOf(asymmetricVehicle())},
                 {{50e3, 20e3, 12.5, 11.0}, {70e3, 5e3, 9.0, 10.5}});
}

std::vector<double> wholeDerivative(const EquationSet& set, const std::vector<double>& x,
                                    const std::vector<double>& u) {
  std::vector<double> dx(x.size(), -1.0);
  set.derivative({.first = 0, .last = set.size() / 2, .x = x.data(), .u = u.data(), .u_count = set.channels(),
                  .dx = dx.data()});
  return dx;
}

TEST(FlatEquationSet, GivesTheBitsOfTheFormInItsOwnOrder) {
  for (const Vehicle& vehicle : {paperVehicle(), asymmetricVehicle(), heightsVehicle()}) {
    const auto form = buildFlatForm(compile(vehicle, 9.81));
    const EquationSet* set = form->equations();
    ASSERT_NE(set, nullptr);
    ASSERT_EQ(set->size(), form->size());
    for (const RandomState& state : randomStates(20, 8, 4)) {
      std::vector<double> expected(8);
      form->derivative(state.x, {state.u.data(), 8}, expected);
      std::vector<double> x(8), u(8);
      for (std::size_t i = 0; i < 8; ++i) x[i] = state.x[static_cast<std::size_t>(set->stateOrder()[i])];
      for (std::size_t i = 0; i < 4; ++i) {
        const auto channel = static_cast<std::size_t>(set->channelOrder()[i]);
        u[i] = state.u[channel];
        u[i + 4] = state.u[channel + 4];
      }
      const std::vector<double> dx = wholeDerivative(*set, x, u);
      for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(dx[i], expected[static_cast<std::size_t>(set->stateOrder()[i])]) << vehicle.name << " entry " << i;
      }
    }
  }
}

TEST(FlatEquationSet, BelongsToTheConsistentVariantOnly) {
  EXPECT_EQ(buildFlatForm(compile(paperVehicle(), 9.81), FlatVariant::kLiteral)->equations(), nullptr);
  EXPECT_EQ(buildFlatForm(compile(paperVehicle(), 9.81), FlatVariant::kPrinted7)->equations(), nullptr);
}

TEST(FlatEquationSet, NamesEquationsByTheirBody) {
  const auto form = buildFlatForm(compile(asymmetricVehicle(), 9.81));
  const std::vector<Equation>& equations = form->equations()->equations();
  ASSERT_EQ(equations.size(), 4u);
  EXPECT_EQ(equations[0].name, "carbody bounce (2)");
  EXPECT_EQ(equations[1].name, "carbody pitch (3)");
  EXPECT_EQ(equations[2].name, "front_bogie bounce (4)");
  EXPECT_EQ(equations[3].name, "rear_bogie bounce (5)");
}

// Every interval of equations, on arrays that hold what its equations say they read and NaN everywhere else: an
// undeclared read would show as NaN, a wrong offset as another number.
TEST(FlatEquationSet, EveryIntervalReadsWhatItDeclaresAndGivesTheBitsOfTheWhole) {
  const FlatEquationSet set = mixedTrain();
  const int equations = set.size() / 2;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const RandomState state = randomStates(1, static_cast<std::size_t>(set.size()),
                                         static_cast<std::size_t>(set.channels()))[0];
  const std::vector<double> u(state.u.begin(), state.u.begin() + 2 * set.channels());
  const std::vector<double> expected = wholeDerivative(set, state.x, u);
  for (int first = 0; first < equations; ++first) {
    for (int last = first + 1; last <= equations; ++last) {
      std::vector<double> x(state.x.size(), nan);
      std::vector<double> rail(u.size(), nan);
      int x_first = first;
      int u_first = set.channels();
      int u_last = 0;
      const auto show = [&](int e) {
        x[2 * static_cast<std::size_t>(e)] = state.x[2 * static_cast<std::size_t>(e)];
        x[2 * static_cast<std::size_t>(e) + 1] = state.x[2 * static_cast<std::size_t>(e) + 1];
        x_first = std::min(x_first, e);
      };
      for (int e = first; e < last; ++e) {
        const Equation& equation = set.equations()[static_cast<std::size_t>(e)];
        show(e);
        for (const int other : equation.reads) show(other);
        if (equation.first_channel == equation.last_channel) continue;
        u_first = std::min(u_first, equation.first_channel);
        u_last = std::max(u_last, equation.last_channel);
      }
      const int u_count = std::max(0, u_last - u_first);
      std::vector<double> window(2 * static_cast<std::size_t>(u_count));
      for (int c = 0; c < u_count; ++c) {
        window[static_cast<std::size_t>(c)] = u[static_cast<std::size_t>(u_first + c)];
        window[static_cast<std::size_t>(u_count + c)] = u[static_cast<std::size_t>(set.channels() + u_first + c)];
      }
      std::vector<double> dx(2 * static_cast<std::size_t>(last - first), nan);
      set.derivative({.first = first, .last = last, .x = x.data() + 2 * x_first, .x_first = x_first,
                      .u = window.data(), .u_first = u_first, .u_count = u_count, .dx = dx.data(),
                      .dx_first = first});
      EXPECT_EQ(std::memcmp(dx.data(), expected.data() + 2 * first, dx.size() * sizeof(double)), 0)
          << first << " .. " << last;
    }
  }
}

// Closed form: a coupling adds c r^T r to K and b r^T r to C with r = (1, -e_a, -1, -e_b) on (zk, phi) of both
// carbodies, docs/theory/vertical.md (4.1). Rounding of sums of a dozen terms of the size of the largest.
TEST(FlatEquationSet, CouplingAddsTheSquareOfItsRow) {
  const std::vector<FlatParameters> vehicles = {parametersOf(asymmetricVehicle()), parametersOf(paperVehicle())};
  const FlatCoupling coupling{50e3, 20e3, 12.5, 11.0};
  const FlatEquationSet coupled = trainOf(vehicles, {coupling});
  const FlatEquationSet uncoupled = trainOf(vehicles, {{}});
  const double r[4] = {1.0, -coupling.arm_ahead, -1.0, -coupling.arm_behind};
  const double inertia[4] = {vehicles[0].mk, vehicles[0].Jk, vehicles[1].mk, vehicles[1].Jk};
  const int place[4] = {0, 1, 4, 5};  // equations
  const std::vector<double> u(16, 0.0);
  for (int column = 0; column < 4; ++column) {
    for (const int rate : {0, 1}) {
      std::vector<double> x(16, 0.0);
      x[static_cast<std::size_t>(2 * place[column] + rate)] = 1.0;
      const std::vector<double> with = wholeDerivative(coupled, x, u);
      const std::vector<double> without = wholeDerivative(uncoupled, x, u);
      for (int row = 0; row < 4; ++row) {
        const auto entry = static_cast<std::size_t>(2 * place[row] + 1);
        const double law = (rate == 0 ? coupling.stiffness : coupling.damping) * r[row] * r[column];
        const double expected = -law / inertia[row];
        EXPECT_WITHIN(with[entry] - without[entry], expected,
                      8e-16 * (std::abs(expected) + 2.0 * std::abs(with[entry])));
      }
    }
  }
}

TEST(FlatEquationSet, ASingleVehicleIsATrainOfOne) {
  const auto form = buildFlatForm(compile(paperVehicle(), 9.81));
  const FlatEquationSet one = trainOf({form->parameters()}, {});
  const RandomState state = randomStates(1, 8, 4)[0];
  const std::vector<double> u(state.u.begin(), state.u.begin() + 8);
  EXPECT_EQ(wholeDerivative(one, state.x, u), wholeDerivative(*form->equations(), state.x, u));
}

TEST(FlatEquationSet, ArgumentsThatDoNotFitAreNamed) {
  const FlatParameters paper = parametersOf(paperVehicle());
  EXPECT_EQ(refusalOf([&] { trainOf({}, {}); }), "flat equation set: no vehicles, must have at least one");
  EXPECT_EQ(refusalOf([&] { trainOf({paper, paper}, {}); }),
            "flat equation set: couplings has 0 entries, must have 1, one between every two neighbours");
  EXPECT_EQ(refusalOf([&] { FlatEquationSet({paper}, {}, {{}}, {0, 1, 2, 3, 4, 5, 6, 6}, identity(4)); }),
            "flat equation set: state_order[7] = 6, must name every entry from 0 to 7 once");
}

}  // namespace
}  // namespace vehicle::test
