#include "libvehicle/ensemble/design.h"

#include <array>

#include <gtest/gtest.h>

#include "libvehicle/flat/flat_form.h"
#include "tests/ensemble/scalar_run.h"
#include "tests/support/vehicles.h"

namespace vehicle::test {
namespace {

Vehicle withPoints(Vehicle vehicle) {
  double x = 5.0;
  for (const char* body : {"carbody", "front_bogie", "carbody", "rear_bogie"}) {
    Point point;
    point.name = std::string("on_") + body + std::to_string(static_cast<int>(x));
    point.body = body;
    point.x = x;
    vehicle.points.push_back(point);
    x -= 3.0;
  }
  return vehicle;
}

// Every column of the flat form under its own name, from a design of an ensemble: the same law, written twice, so the
// difference is a rounding of forces of 1e4 N and loads of 2e5 N.
TEST(EnsembleDesign, HasEveryColumnOfTheFlatFormUnderItsName) {
  for (Vehicle vehicle : {withPoints(paperVehicle()), withPoints(asymmetricVehicle())}) {
    vehicle.wheelsets[1].mass = 1800.0;
    const auto form = buildFlatForm(compile(vehicle, 9.81));
    const Topology topology = topologyOf(vehicle);
    const FlatLayout layout = readLayout(topology).layout;
    const EnsembleDesign design = ensembleDesign(topology, layout, 9.81);
    const std::array<double, 8> inner = {1e-3, -2e-3, 3e-3, 5e-3, 0.07, 0.011, -0.013, 0.017};
    const std::array<double, 12> rail = {4e-3, -1e-3, 2e-3, 7e-3, 0.01, 0.03, -0.02, 0.05, 1.1, -0.7, 0.3, 2.0};
    std::array<double, 8> x{};
    std::array<double, 12> u{};
    for (std::size_t i = 0; i < 8; ++i) x[static_cast<std::size_t>(form->stateOrder()[i])] = inner[i];
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 3; ++k) u[4 * k + static_cast<std::size_t>(form->wheelOrder()[j])] = rail[4 * k + j];
    }
    std::vector<double> y(form->outputs().size());
    form->output(x, u, y);
    const std::vector<double> ours = columnsAt(design, inner.data(), rail.data());
    for (std::size_t i = 0; i < y.size(); ++i) {
      const auto column = flatColumn(topology, layout, form->outputs()[i].name);
      ASSERT_TRUE(column) << form->outputs()[i].name;
      EXPECT_WITHIN(ours[static_cast<std::size_t>(*column)], y[i], 1e-15 * std::max(1.0, std::abs(y[i])) * 4)
          << form->outputs()[i].name;
    }
    for (const char* name : {"carbody", "carbody.x", "nobody.z", "primary_1.load", "wheelset_1.force", "", "."}) {
      EXPECT_FALSE(flatColumn(topology, layout, name)) << name;
    }
  }
}

TEST(EnsembleDesign, LeavesOutPointsBeyondTheEighth) {
  Vehicle vehicle = paperVehicle();
  for (int i = 0; i < 9; ++i) {
    Point point;
    point.name = "p" + std::to_string(i);
    point.body = "carbody";
    point.x = i;
    vehicle.points.push_back(point);
  }
  const Topology topology = topologyOf(vehicle);
  const FlatLayout layout = readLayout(topology).layout;
  EXPECT_EQ(flatColumn(topology, layout, "p7.az"), pointColumn(7, PointQuantity::kAz));
  EXPECT_FALSE(flatColumn(topology, layout, "p8.az"));
  EXPECT_EQ(ensembleDesign(topology, layout, 9.81).point_arm[7], 7.0);
}

}  // namespace
}  // namespace vehicle::test
