// The matrix form cut into equations: the bits of the whole from every cut, for a vehicle and for a train.
#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/flat/flat_train.h"
#include "libvehicle/matrix/matrix_form.h"
#include "tests/support/random_state.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::vector<Vehicle> vehicles() {
  return {paperVehicle(),    asymmetricBogiePitchVehicle(),   contactVehicle(),
          bogiePitchHeightsVehicle(), assembled(mixedTrain()), assembled(equalTrain(contactVehicle(), 5, 26.0))};
}

// A window with nothing in it but what the equations first .. last - 1 read, as a thread would hold it.
std::vector<double> computedAlone(const EquationSet& set, const std::vector<double>& x, const std::vector<double>& u,
                                  int first, int last) {
  int x_first = first, x_last = last, u_first = set.channels(), u_last = 0;
  for (int e = first; e < last; ++e) {
    const Equation& equation = set.equations()[at(e)];
    if (!equation.reads.empty()) {
      x_first = std::min(x_first, equation.reads.front());
      x_last = std::max(x_last, equation.reads.back() + 1);
    }
    if (equation.first_channel == equation.last_channel) continue;
    u_first = std::min(u_first, equation.first_channel);
    u_last = std::max(u_last, equation.last_channel);
  }
  u_first = std::min(u_first, u_last);
  const std::vector<double> own_x(x.begin() + 2 * x_first, x.begin() + 2 * x_last);
  std::vector<double> own_u(u.begin() + u_first, u.begin() + u_last);
  own_u.insert(own_u.end(), u.begin() + set.channels() + u_first, u.begin() + set.channels() + u_last);
  std::vector<double> dx(2 * at(last - first));
  set.derivative({.first = first, .last = last, .x = own_x.data(), .x_first = x_first, .u = own_u.data(),
                  .u_first = u_first, .u_count = u_last - u_first, .dx = dx.data(), .dx_first = first});
  return dx;
}

// Exact: the sums inside an equation run in one order, whoever computes them.
TEST(MatrixEquationSet, GivesTheBitsOfTheFormFromEveryCut) {
  for (const Vehicle& vehicle : vehicles()) {
    const auto form = buildMatrixForm(compile(vehicle, kGravity));
    const EquationSet& set = *form->equations();
    ASSERT_EQ(set.size(), form->size());
    const int equations = set.size() / 2;
    for (const RandomState& state : randomStates(3, at(form->size()), at(form->channels()))) {
      std::vector<double> expected(state.x.size());
      form->derivative(state.x, state.u, expected);
      std::vector<double> x, u;
      for (const int i : set.stateOrder()) x.push_back(state.x[at(i)]);
      for (const int shift : {0, form->channels()}) {
        for (const int j : set.channelOrder()) u.push_back(state.u[at(j + shift)]);
      }
      for (const int width : {1, 2, 5, equations}) {
        for (int first = 0; first < equations; first += width) {
          const int last = std::min(first + width, equations);
          const std::vector<double> dx = computedAlone(set, x, u, first, last);
          for (std::size_t i = 0; i < dx.size(); ++i) {
            ASSERT_EQ(dx[i], expected[at(set.stateOrder()[2 * at(first) + i])]) << vehicle.name << " cut by " << width;
          }
        }
      }
    }
  }
}

TEST(MatrixEquationSet, CountsFromTheFrontAndReadsNeighboursOnly) {
  const auto form = buildMatrixForm(compile(assembled(equalTrain(bogiePitchVehicle(), 4, 26.0)), kGravity));
  const std::vector<Equation>& equations = form->equations()->equations();
  ASSERT_EQ(equations.size(), 24u);
  EXPECT_EQ(equations[0].name, "coach_1.front_bogie.z");
  EXPECT_EQ(equations[23].name, "coach_4.rear_bogie.pitch");
  for (std::size_t e = 0; e < 24; ++e) {
    EXPECT_TRUE(std::is_sorted(equations[e].reads.begin(), equations[e].reads.end()));
    for (const int other : equations[e].reads) EXPECT_LE(std::abs(other / 6 - static_cast<int>(e) / 6), 1);
  }
  // A bogie stands on its two wheelsets.
  EXPECT_EQ(equations[6].first_channel, 4);
  EXPECT_EQ(equations[6].last_channel, 6);
}

// Two ways to write the same equations: terms of up to 60 m/s^2, a dozen roundings.
TEST(MatrixForm, OfATrainGivesTheAccelerationsAndColumnsOfTheFlatForm) {
  for (const Train& train : {mixedTrain(), equalTrain(heightsVehicle(), 3, 16.0)}) {
    const Vehicle vehicle = assembled(train);
    const auto matrix = buildMatrixForm(compile(vehicle, kGravity));
    const auto flat = buildFlatTrain(compile(vehicle, kGravity));
    for (const RandomState& state : randomStates(20, at(flat->size()), at(flat->channels()))) {
      std::vector<double> a(state.x.size()), b(state.x.size()), y(flat->outputs().size()), z(y.size());
      matrix->derivative(state.x, state.u, a);
      flat->derivative(state.x, state.u, b);
      for (std::size_t i = 0; i < a.size(); ++i) EXPECT_WITHIN(a[i], b[i], 1e-13);
      matrix->output(state.x, state.u, y);
      flat->output(state.x, state.u, z);
      for (std::size_t i = 0; i < y.size(); ++i) {
        // Loads of 2e5 N by two rules of statics, forces of 1e5 N: relative to their size.
        EXPECT_WITHIN(y[i], z[i], 1e-13 * std::max(1.0, std::abs(y[i]))) << flat->outputs()[i].name;
      }
    }
    const StateSpace of_matrix = *matrix->linear();
    const StateSpace of_flat = *flat->linear();
    EXPECT_WITHIN((of_matrix.A - of_flat.A).cwiseAbs().maxCoeff(), 0.0, 1e-15 * of_flat.A.cwiseAbs().maxCoeff() * 4);
    EXPECT_WITHIN((of_matrix.B - of_flat.B).cwiseAbs().maxCoeff(), 0.0, 1e-15 * of_flat.B.cwiseAbs().maxCoeff() * 4);
  }
}

// Stiffness, damping: symmetric by construction, not by luck.
TEST(MatrixForm, OfATrainHasSymmetricMatrices) {
  const SecondOrder m =
      buildMatrixForm(compile(assembled(equalTrain(contactVehicle(), 5, 26.0)), kGravity))->matrices();
  EXPECT_EQ(m.K, m.K.transpose());
  EXPECT_EQ(m.C, m.C.transpose());
}

// 300 coaches have 1800 coordinates: with its zeros a derivative would cost 13 million products, without 70 thousand.
// A second is a hundred times what the 100 derivatives and the building take, and a third of what the zeros would.
TEST(MatrixForm, OfALongTrainCostsNoMoreThanItsVehicles) {
  const Vehicle vehicle = assembled(equalTrain(bogiePitchVehicle(), 300, 26.0));
  const auto begin = std::chrono::steady_clock::now();
  const auto form = buildMatrixForm(compile(vehicle, kGravity));
  const RandomState state = randomStates(1, at(form->size()), at(form->channels())).front();
  std::vector<double> dx(state.x.size());
  for (int i = 0; i < 100; ++i) form->derivative(state.x, state.u, dx);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_LT(seconds, 1.0);
  EXPECT_THROW((void)form->linear(), std::invalid_argument);
  EXPECT_THROW((void)form->matrices(), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle::test
