#include "libvehicle/statics/rest_balance.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "libvehicle/law/linear_spring_damper.h"
#include "tests/support/tolerance.h"

namespace vehicle {
namespace {

RestSpring spring(Eigen::VectorXd row, double stiffness) {
  return {std::move(row), std::make_shared<const LinearSpringDamper>(stiffness, 0.0), std::nullopt};
}

// A beam of weight W on two springs at +a and -b: by the lever rule they carry W b/(a+b) and W a/(a+b).
TEST(SolveRest, ABeamOnTwoSpringsLoadsThemByTheLeverRule) {
  const double W = 6e5, a = 3.0, b = 5.0, c = 2e6;
  RestBalance balance;
  balance.weight = Eigen::Vector2d(W, 0.0);
  balance.total = W;
  balance.springs = {spring(Eigen::Vector2d(1.0, a), c), spring(Eigen::Vector2d(1.0, -b), c)};
  const RestSolution rest = solveRest(balance);
  // Rounding of a 2 x 2 solve with one refinement: some ulps of the loads.
  EXPECT_WITHIN(rest.spring_load[0], W * b / (a + b), 1e-14 * W);
  EXPECT_WITHIN(rest.spring_load[1], W * a / (a + b), 1e-14 * W);
  EXPECT_WITHIN(rest.deflection[0] + a * rest.deflection[1], -rest.spring_load[0] / c, 1e-14);
  EXPECT_LT(rest.left.cwiseAbs().maxCoeff(), 1e-14 * W * a);
}

TEST(SolveRest, WhatNoSpringHoldsIsLeftAndStays) {
  RestBalance balance;
  balance.weight = Eigen::Vector2d(1e5, 2e4);
  balance.total = 1.2e5;
  balance.springs = {spring(Eigen::Vector2d(1.0, 0.0), 1e6)};
  const RestSolution rest = solveRest(balance);
  EXPECT_EQ(rest.deflection[1], 0.0);
  EXPECT_EQ(rest.left[1], -2e4);
  EXPECT_WITHIN(rest.left[0], 0.0, 1e-10);  // rounding of 1e5 N
}

TEST(SolveRest, AGivenPreloadTakesThePlaceOfTheSpringsForce) {
  RestBalance balance;
  balance.weight = Eigen::VectorXd::Constant(1, 1e5);
  balance.total = 1e5;
  balance.springs = {spring(Eigen::VectorXd::Ones(1), 1e6), spring(Eigen::VectorXd::Ones(1), 1e6)};
  balance.springs[0].preload = 7e4;
  const RestSolution rest = solveRest(balance);
  EXPECT_EQ(rest.spring_load[0], 7e4);
  EXPECT_WITHIN(rest.spring_load[1], 3e4, 1e-10);  // rounding of 1e5 N
  EXPECT_WITHIN(rest.given[0], -3e4, 0.0);
}

// F = C delta^1.5 carries wheelset and load: delta = (F/C)^(2/3).
TEST(SolveRest, AHertzContactComesDownAsItsLawSays) {
  const double C = 9.37e10, load = 1.1e5, own = 1.5e4;
  RestBalance balance;
  balance.weight = Eigen::Vector2d(load, own);
  balance.total = load;
  balance.springs = {spring(Eigen::Vector2d(1.0, -1.0), 1e6)};
  balance.contacts = {{.coordinate = 1, .weight = own, .above = {0}, .stiffness = {}, .hertz_constant = C}};
  const RestSolution rest = solveRest(balance);
  EXPECT_WITHIN(rest.contact_load[0], load + own, 1e-9);  // rounding of 1e5 N
  // The secant stiffness C^(2/3) F^(1/3) at the load of the last iteration: equal to it within 1e-15.
  EXPECT_WITHIN(-rest.deflection[1], std::pow((load + own) / C, 2.0 / 3.0), 1e-16);
}

TEST(SolveRest, AWheelsetThatFollowsTheRailCarriesWhatStandsOnIt) {
  RestBalance balance;
  balance.weight = Eigen::VectorXd::Constant(1, 8e4);
  balance.total = 8e4;
  balance.springs = {spring(Eigen::VectorXd::Ones(1), 1e6), spring(Eigen::VectorXd::Ones(1), 3e6)};
  balance.contacts = {{.weight = 1e4, .above = {0}, .stiffness = {}}, {.weight = 1e4, .above = {1}, .stiffness = {}}};
  const RestSolution rest = solveRest(balance);
  EXPECT_WITHIN(rest.contact_load[0], 1e4 + 2e4, 1e-10);  // rounding of 1e5 N
  EXPECT_WITHIN(rest.contact_load[1], 1e4 + 6e4, 1e-10);
}

}  // namespace
}  // namespace vehicle
