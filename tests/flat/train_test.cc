// The flat form of a train: each vehicle by the paper's equations, joined by couplings.
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "libvehicle/flat/flat_form.h"
#include "libvehicle/flat/flat_train.h"
#include "libvehicle/model/rest.h"
#include "libvehicle/model/topology.h"
#include "tests/support/allocations.h"
#include "tests/support/eigenvalues.h"
#include "tests/support/random_state.h"
#include "tests/support/tolerance.h"
#include "tests/support/trains.h"

namespace vehicle::test {
namespace {

constexpr double kGravity = 9.81;

std::vector<double> derivativeOf(const System& system, const RandomState& state) {
  std::vector<double> dx(state.x.size());
  system.derivative(state.x, state.u, dx);
  return dx;
}

std::vector<double> outputOf(const System& system, const RandomState& state) {
  std::vector<double> y(system.outputs().size());
  system.output(state.x, state.u, y);
  return y;
}

std::vector<RandomState> statesOf(const System& system, int count) {
  return randomStates(count, static_cast<std::size_t>(system.size()), static_cast<std::size_t>(system.channels()));
}

// What unit `unit` of the train is given, in the order of its own vehicle.
RandomState stateOfUnit(const Topology& train, const RandomState& state, const Topology& own, const std::string& unit) {
  const auto n = static_cast<std::size_t>(train.coordinates);
  const auto own_n = static_cast<std::size_t>(own.coordinates);
  RandomState made{std::vector<double>(2 * own_n), std::vector<double>(3 * own.wheelsets.size())};
  for (const TopologyBody& body : own.bodies) {
    for (const TopologyBody& each : train.bodies) {
      if (each.name != unit + '.' + body.name) continue;
      const auto take = [&](int to, int from) {
        if (to < 0) return;
        made.x[static_cast<std::size_t>(to)] = state.x[static_cast<std::size_t>(from)];
        made.x[own_n + static_cast<std::size_t>(to)] = state.x[n + static_cast<std::size_t>(from)];
      };
      take(body.z_index, each.z_index);
      take(body.pitch_index, each.pitch_index);
    }
  }
  for (std::size_t j = 0; j < own.wheelsets.size(); ++j) {
    for (std::size_t i = 0; i < train.wheelsets.size(); ++i) {
      if (train.wheelsets[i].name != unit + '.' + own.wheelsets[j].name) continue;
      for (std::size_t order = 0; order < 3; ++order) {
        made.u[order * own.wheelsets.size() + j] = state.u[order * train.wheelsets.size() + i];
      }
    }
  }
  return made;
}

double column(const System& system, const std::vector<double>& y, const std::string& name) {
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (system.outputs()[i].name == name) return y[i];
  }
  ADD_FAILURE() << "no column " << name;
  return NAN;
}

// Without forces in the couplings every column of a vehicle is the one it has alone. The arms are differences of
// places up to 50 m from the origin: 7e-15 m of some 5 m, times stiffness and 5 mm; forces of some 1e5 N round to
// 1e-11.
TEST(FlatTrain, WithoutCouplingForcesIsItsVehiclesAlone) {
  Train slack = mixedTrain();
  for (Coupling& each : slack.couplings) each.stiffness_z = each.damping_z = 0.0;
  Train loose = mixedTrain();
  loose.couplings.clear();
  for (const Train& train : {slack, loose}) {
    const Vehicle whole = assembled(train);
    const auto form = buildFlatTrain(compile(whole, kGravity));
    const Topology topology = topologyOf(whole);
    for (const RandomState& state : statesOf(*form, 10)) {
      const std::vector<double> y = outputOf(*form, state);
      for (std::size_t unit = 0; unit < 3; ++unit) {
        const Vehicle own = unit == 1 ? paperVehicle() : asymmetricVehicle();
        const auto alone = buildFlatForm(compile(own, kGravity));
        const std::vector<double> expected =
            outputOf(*alone, stateOfUnit(topology, state, topologyOf(own), whole.units[unit].name));
        for (std::size_t i = 0; i < expected.size(); ++i) {
          const std::string name = whole.units[unit].name + '.' + alone->outputs()[i].name;
          EXPECT_WITHIN(column(*form, y, name), expected[i], 1e-13 * std::max(1.0, std::abs(expected[i]))) << name;
        }
      }
    }
  }
}

// Bodies and rail lifted together strain nothing: what is left is rounding of forces of 3e6 N/m x 10 mm on 9 t.
TEST(FlatTrain, LiftedAsAWholeStaysAtRest) {
  const Vehicle whole = assembled(mixedTrain());
  const Topology topology = topologyOf(whole);
  const auto form = buildFlatTrain(compile(whole, kGravity));
  RandomState lifted{std::vector<double>(24, 0.0), std::vector<double>(36, 0.0)};
  for (const TopologyBody& body : topology.bodies) lifted.x[static_cast<std::size_t>(body.z_index)] = 0.01;
  for (std::size_t j = 0; j < 12; ++j) lifted.u[j] = 0.01;
  for (const double slope : derivativeOf(*form, lifted)) EXPECT_WITHIN(slope, 0.0, 1e-13);
}

// A straight line through ends that meet: couplings are not strained whatever the slope, and symmetric vehicles on a
// straight incline feel no force at all. Rounding: places of 50 m times the slope, 1e-17 m; forces 1e-10 N.
TEST(FlatTrain, OnAStraightInclineIsARigidChain) {
  const Vehicle whole = assembled(equalTrain(paperVehicle(), 4, 16.0));
  const Topology topology = topologyOf(whole);
  const auto form = buildFlatTrain(compile(whole, kGravity));
  constexpr double kSlope = 1e-3;
  RandomState inclined{std::vector<double>(32, 0.0), std::vector<double>(48, 0.0)};
  for (const TopologyBody& body : topology.bodies) {
    inclined.x[static_cast<std::size_t>(body.z_index)] = kSlope * body.x;
    if (body.pitch_index >= 0) inclined.x[static_cast<std::size_t>(body.pitch_index)] = kSlope;
  }
  for (std::size_t j = 0; j < 16; ++j) inclined.u[j] = kSlope * topology.wheelsets[j].x;
  const std::vector<double> y = outputOf(*form, inclined);
  for (const char* name : {"coupling_1", "coupling_2", "coupling_3"}) {
    EXPECT_WITHIN(column(*form, y, std::string(name) + ".deflection"), 0.0, 1e-16);
    EXPECT_WITHIN(column(*form, y, std::string(name) + ".force"), 0.0, 1e-11);
  }
  for (const double slope : derivativeOf(*form, inclined)) EXPECT_WITHIN(slope, 0.0, 1e-13);
}

// Hooke at one coupling: the carbody ahead a height h higher, all else at rest. (8.1)-(8.3) with ends at 8 m.
TEST(FlatTrain, ACouplingPullsTheHigherCarbodyDownAndBothNosesUp) {
  const auto form = buildFlatTrain(compile(assembled(equalTrain(paperVehicle(), 2, 16.0)), kGravity));
  const auto lone = buildFlatForm(compile(paperVehicle(), kGravity));
  RandomState state{std::vector<double>(16, 0.0), std::vector<double>(24, 0.0)};
  state.x[0] = 2e-3;
  RandomState own{std::vector<double>(8, 0.0), std::vector<double>(12, 0.0)};
  own.x[0] = 2e-3;
  const std::vector<double> dx = derivativeOf(*form, state);
  const std::vector<double> alone = derivativeOf(*lone, own);
  const double force = 50e3 * 2e-3;
  // Accelerations of some 0.2 m/s^2, rounded a few times.
  EXPECT_WITHIN(dx[8], alone[4] - force / 57e3, 1e-16);
  EXPECT_WITHIN(dx[9], alone[5] + 8.0 * force / 70e3, 1e-15);
  EXPECT_WITHIN(dx[12], force / 57e3, 1e-16);
  EXPECT_WITHIN(dx[13], 8.0 * force / 70e3, 1e-15);
}

// Newton's bookkeeping: what the inertia forces do is what suspensions and couplings do on the bodies. Each side sums
// 44 powers of up to 1e5 N x 0.1 m/s: 1e-16 x 1e4 W each.
TEST(FlatTrain, InertiaForcesDoTheWorkOfTheSuspensions) {
  const Vehicle whole = assembled(mixedTrain());
  const Topology topology = topologyOf(whole);
  const auto form = buildFlatTrain(compile(whole, kGravity));
  for (const RandomState& state : statesOf(*form, 20)) {
    const std::vector<double> dx = derivativeOf(*form, state);
    const std::vector<double> y = outputOf(*form, state);
    const auto velocity = [&](int body, double arm) {
      const TopologyBody& each = topology.bodies[static_cast<std::size_t>(body)];
      const auto rate = [&](int index) { return state.x[static_cast<std::size_t>(topology.coordinates + index)]; };
      return rate(each.z_index) + (each.pitch_index < 0 ? 0.0 : arm * rate(each.pitch_index));
    };
    double inertia = 0.0, work = 0.0;
    for (const TopologyBody& body : topology.bodies) {
      const auto z = static_cast<std::size_t>(topology.coordinates + body.z_index);
      inertia += body.mass * state.x[z] * dx[z];
      if (body.pitch_index < 0) continue;
      const auto pitch = static_cast<std::size_t>(topology.coordinates + body.pitch_index);
      inertia += body.pitch_inertia * state.x[pitch] * dx[pitch];
    }
    for (const TopologySuspension& each : topology.suspensions) {
      const double force = column(*form, y, each.name + ".force");
      work -= force * velocity(each.upper, each.arm_upper);
      if (each.lower_body >= 0) work += force * velocity(each.lower_body, each.arm_lower);
    }
    EXPECT_WITHIN(inertia, work, 1e-10);
  }
}

// Stiffness and damping matrices of a conservative joint are symmetric: M A is, entry by entry. Entries up to 6e6 N/m
// pass through 1/m and back: a few roundings.
TEST(FlatTrain, MassTimesAccelerationMatrixIsSymmetric) {
  const Vehicle whole = assembled(mixedTrain());
  const Topology topology = topologyOf(whole);
  const Eigen::MatrixXd A = buildFlatTrain(compile(whole, kGravity))->linear()->A;
  const Eigen::Index n = topology.coordinates;
  Eigen::VectorXd mass(n);
  for (const TopologyBody& body : topology.bodies) {
    mass[body.z_index] = body.mass;
    if (body.pitch_index >= 0) mass[body.pitch_index] = body.pitch_inertia;
  }
  for (const Eigen::Index part : {Eigen::Index{0}, n}) {
    const Eigen::MatrixXd K = mass.asDiagonal() * A.block(n, part, n, n);
    EXPECT_WITHIN((K - K.transpose()).cwiseAbs().maxCoeff(), 0.0, 4e-15 * K.cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(A.topRightCorner(n, n), Eigen::MatrixXd::Identity(n, n));
}

std::vector<std::complex<double>> sortedEigenvalues(const Eigen::MatrixXd& A) {
  const Eigen::VectorXcd values = test::eigenvaluesOf(A);
  std::vector<std::complex<double>> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::abs(a.imag() - b.imag()) > 1e-6 ? a.imag() < b.imag() : a.real() < b.real();
  });
  return sorted;
}

// Two equal symmetric vehicles are a mirror image of each other: a motion is even (equal bounce, opposite pitch) or
// odd. Even ones leave the coupling unstrained: the modes of the vehicle alone. Odd ones strain it by
// d = 2 (zk - e phi): the vehicle ahead with a spring of 2 k from its rear end to the ground, written here into the
// matrix of one vehicle.
TEST(FlatTrain, OfTwoEqualVehiclesHasEvenAndOddModes) {
  constexpr double kEnd = 8.0, kStiffness = 50e3, kDamping = 20e3;
  const Eigen::MatrixXd one = buildFlatForm(compile(paperVehicle(), kGravity))->linear()->A;
  std::vector<std::complex<double>> expected;
  for (const bool even : {true, false}) {
    Eigen::MatrixXd A = one;
    if (!even) {
      const Eigen::RowVector2d end(1.0, -kEnd);
      const Eigen::Vector2d push(-2.0 / 57e3, 2.0 * kEnd / 70e3);
      A.block(4, 0, 2, 2) += kStiffness * push * end;
      A.block(4, 4, 2, 2) += kDamping * push * end;
    }
    const Eigen::VectorXcd values = test::eigenvaluesOf(A);
    expected.insert(expected.end(), values.begin(), values.end());
  }
  std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) {
    return std::abs(a.imag() - b.imag()) > 1e-6 ? a.imag() < b.imag() : a.real() < b.real();
  });
  const auto actual =
      sortedEigenvalues(buildFlatTrain(compile(assembled(equalTrain(paperVehicle(), 2, 16.0)), kGravity))->linear()->A);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    // Backward error of the QR iteration, 1e-15 |A| = 1e-12, times condition numbers of order 10.
    EXPECT_WITHIN(std::abs(actual[i] - expected[i]), 0.0, 1e-10);
  }
}

// Both are f(x, u) by the same functions; only the way the numbers are brought together differs.
TEST(FlatTrain, GivesTheBitsOfItsEquations) {
  const auto form = buildFlatTrain(compile(assembled(mixedTrain()), kGravity));
  const EquationSet* set = form->equations();
  ASSERT_NE(set, nullptr);
  ASSERT_EQ(set->equations().size(), 12u);
  EXPECT_EQ(set->equations()[4].name, "al-oraiqat-2017_2.carbody bounce (2)");
  for (const RandomState& state : statesOf(*form, 20)) {
    const std::vector<double> expected = derivativeOf(*form, state);
    std::vector<double> x(24), u(24), dx(24);
    for (std::size_t i = 0; i < 24; ++i) x[i] = state.x[static_cast<std::size_t>(set->stateOrder()[i])];
    for (std::size_t j = 0; j < 12; ++j) {
      const auto channel = static_cast<std::size_t>(set->channelOrder()[j]);
      u[j] = state.u[channel];
      u[12 + j] = state.u[12 + channel];
    }
    EquationWindow window;
    window.last = 12;
    window.x = x.data();
    window.u = u.data();
    window.u_count = 12;
    window.dx = dx.data();
    set->derivative(window);
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(dx[i], expected[static_cast<std::size_t>(set->stateOrder()[i])]);
  }
}

TEST(FlatTrain, MatricesAreThoseOfTheDerivative) {
  const auto form = buildFlatTrain(compile(assembled(mixedTrain()), kGravity));
  const StateSpace matrices = *form->linear();
  for (const RandomState& state : statesOf(*form, 5)) {
    const Eigen::Map<const Eigen::VectorXd> x(state.x.data(), 24), u(state.u.data(), 24);
    const Eigen::VectorXd product = matrices.A * x + matrices.B * u;
    const std::vector<double> dx = derivativeOf(*form, state);
    for (std::size_t i = 0; i < 24; ++i) {
      // Two orders of summation of terms up to 30 m/s^2.
      EXPECT_WITHIN(product[static_cast<Eigen::Index>(i)], dx[i], 1e-13);
    }
  }
}

// A file may hold two coupled vehicles itself, the rear one first and the coupling told from behind.
TEST(FlatTrain, IsFoundInAnyOrderOfTheFile) {
  const Vehicle train = assembled(equalTrain(paperVehicle(), 2, 16.0));
  Vehicle turned = train;
  std::reverse(turned.bodies.begin(), turned.bodies.end());
  std::reverse(turned.suspensions.begin(), turned.suspensions.end());
  Suspension& coupling = named(turned.suspensions, "coupling_1");
  std::swap(coupling.upper, coupling.lower);
  std::swap(coupling.x, *coupling.x_lower);
  const auto form = buildFlatTrain(compile(train, kGravity));
  const auto other = buildFlatTrain(compile(turned, kGravity));
  for (const RandomState& state : statesOf(*form, 10)) {
    RandomState moved = state;
    for (std::size_t i = 0; i < 16; ++i) {
      for (std::size_t k = 0; k < 16; ++k) {
        if (other->states()[k].name == form->states()[i].name) moved.x[k] = state.x[i];
      }
    }
    const std::vector<double> y = outputOf(*form, state);
    const std::vector<double> turned_y = outputOf(*other, moved);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const std::string& name = form->outputs()[i].name;
      const double sign = name.find("coupling") == std::string::npos ? 1.0 : -1.0;
      EXPECT_EQ(column(*other, turned_y, name), sign * y[i]) << name;
    }
  }
}

// Static loads are each vehicle's own; a coupling that is given a load passes it on, as restOf() says.
TEST(FlatTrain, CarriesStaticLoadsAtHeights) {
  Vehicle train = assembled(equalTrain(heightsVehicle(), 3, 16.0));
  const double alone = buildFlatForm(compile(heightsVehicle(), kGravity))->parameters().k_g;
  const auto form = buildFlatTrain(compile(train, kGravity));
  for (const FlatParameters& each : form->vehicles()) {
    EXPECT_WITHIN(each.k_g, alone, 1e-13 * std::abs(alone));  // loads of 3e5 N, arms off by 1e-15 m
  }
  named(train.suspensions, "coupling_2").preload = 10e3;
  named(train.suspensions, "coupling_2").z_upper = 1.1;
  const auto loaded = buildFlatTrain(compile(train, kGravity));
  const Rest rest = restOf(topologyOf(train), kGravity);
  EXPECT_EQ(loaded->vehicles()[1].k_g, rest.pitch_stiffness[3]);
  EXPECT_GT(std::abs(loaded->vehicles()[1].k_g - alone), 1e3);  // 1 m x 10 kN, and the loads that move
}

TEST(FlatTrain, DerivativeAndOutputNeverAllocate) {
  const auto form = buildFlatTrain(compile(assembled(mixedTrain()), kGravity));
  const RandomState state = statesOf(*form, 1).front();
  std::vector<double> dx(state.x.size()), y(form->outputs().size());
  const long before = allocations();
  form->derivative(state.x, state.u, dx);
  form->output(state.x, state.u, y);
  EXPECT_EQ(allocations(), before);
}

TEST(FlatTrain, RefusesMatricesOfAVeryLongOne) {
  const auto form = buildFlatTrain(compile(assembled(equalTrain(paperVehicle(), 251, 16.0)), kGravity));
  try {
    (void)form->linear();
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "the form flat has 2008 states here, and its matrices are formed for at most 2000; take "
                               "the method rk4 or dopri5, which need none");
  }
}

TEST(FlatSystem, IsTheFlatFormOfAVehicleAndATrainOfSeveral) {
  EXPECT_NE(dynamic_cast<FlatForm*>(buildFlatSystem(compile(paperVehicle(), kGravity)).get()), nullptr);
  EXPECT_NE(
      dynamic_cast<FlatForm*>(buildFlatSystem(compile(assembled(equalTrain(paperVehicle(), 1, 16.0)), kGravity)).get()),
      nullptr);
  EXPECT_NE(dynamic_cast<FlatTrain*>(buildFlatSystem(compile(assembled(mixedTrain()), kGravity)).get()), nullptr);
  EXPECT_EQ(flatSystemUnsupported(topologyOf(assembled(mixedTrain()))).text(), "");
  EXPECT_EQ(flatSystemUnsupported(topologyOf(paperVehicle())).text(), "");
  EXPECT_EQ(flatSystemUnsupported(topologyOf(bogiePitchVehicle())).text(),
            flatUnsupported(topologyOf(bogiePitchVehicle()), FlatVariant::kConsistent).text());
}

TEST(FlatSystem, TellsTheUnsupportedOfVehiclesFromOneFileOnce) {
  Train train = equalTrain(bogiePitchVehicle(), 3, 26.0);
  for (std::size_t b = 0; b < 3; ++b) {
    train.vehicles[0].vehicle.bodies[b].origin.file = "coach.xml";
    train.vehicles[0].vehicle.bodies[b].origin.line = 40 + static_cast<int>(b);
  }
  EXPECT_EQ(flatSystemUnsupported(topologyOf(assembled(train))).text(),
            "coach.xml:41: error: <vehicle><body name=\"coach_1.front_bogie\">: has a pitch motion; the form flat "
            "computes the bounce of a bogie and no pitch; take the form matrix, which computes both\n"
            "coach.xml:42: error: <vehicle><body name=\"coach_1.rear_bogie\">: has a pitch motion; the form flat "
            "computes the bounce of a bogie and no pitch; take the form matrix, which computes both\n");
  EXPECT_THROW((void)buildFlatSystem(compile(assembled(train), kGravity)), InvalidInput);
}

TEST(FlatSystem, RefusesCouplingsThatMakeNoChain) {
  Vehicle train = assembled(equalTrain(paperVehicle(), 3, 16.0));
  Suspension second = named(train.suspensions, "coupling_1");
  second.name = "spare";
  train.suspensions.push_back(second);
  EXPECT_EQ(flatSystemUnsupported(topologyOf(train)).text(),
            "error: <suspension name=\"spare\">: stands beside \"coupling_1\" between the same vehicles; the form "
            "flat computes one coupling there; take the form matrix, which computes any train\n");
  train.suspensions.back().lower = "coach_3.carbody";
  EXPECT_EQ(flatSystemUnsupported(topologyOf(train)).text(),
            "error: <suspension name=\"spare\">: joins \"coach_1.carbody\" to \"coach_3.carbody\", which do not "
            "follow each other; the form flat computes couplings between neighbours; take the form matrix, which "
            "computes any train\n");
}

TEST(FlatSystem, ThePrintedVariantsKnowOneVehicle) {
  EXPECT_EQ(flatUnsupported(topologyOf(assembled(equalTrain(paperVehicle(), 2, 16.0))), FlatVariant::kLiteral).text(),
            "error: <train name=\"equal\">: is a train; the printed equations are of one vehicle; take the form "
            "flat\n");
}

}  // namespace
}  // namespace vehicle::test
