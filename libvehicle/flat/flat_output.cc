#include "libvehicle/flat/flat_output.h"

#include <algorithm>
#include <initializer_list>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void writeFrom(std::span<double> y, int column, std::initializer_list<double> values) {
  std::copy(values.begin(), values.end(), y.begin() + column);
}

}  // namespace

ResultPlaces resultPlacesOf(const Topology& topology) {
  constexpr int kOrders = 3;  // displacement, velocity, acceleration
  ResultPlaces places;
  int next = 0;
  const auto give = [&next](std::vector<int>& to, int columns) {
    to.push_back(next);
    next += columns;
  };
  for (const TopologyBody& body : topology.bodies) {
    give(places.bodies, kOrders * ((body.z_index >= 0 ? 1 : 0) + (body.pitch_index >= 0 ? 1 : 0)));
  }
  for (std::size_t s = 0; s < topology.suspensions.size(); ++s) give(places.suspensions, 2);
  for (const TopologyWheelset& wheelset : topology.wheelsets) {
    give(places.wheelsets, wheelset.z_index >= 0 ? 2 + kOrders : 2);
  }
  for (std::size_t p = 0; p < topology.points.size(); ++p) give(places.points, kOrders);
  return places;
}

FlatOutput::FlatOutput(const Topology& topology, const ResultPlaces& places, const FlatLayout& layout,
                       const FlatParameters& parameters, const FlatLoads& loads)
    : v_(parameters), wheel_load_(loads.wheel), carbody_(places.bodies[at(layout.carbody)]) {
  for (std::size_t i = 0; i < 2; ++i) {
    bogie_[i] = places.bodies[at(layout.bogie[i])];
    secondary_[i] = places.suspensions[at(layout.secondary[i])];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    primary_[i] = places.suspensions[at(layout.primary[i])];
    wheelset_[i] = places.wheelsets[at(layout.wheelset[i])];
    wheelset_mass_[i] = topology.wheelsets[at(layout.wheelset[i])].mass;
  }
  for (std::size_t p = 0; p < topology.points.size(); ++p) {
    const TopologyPoint& point = topology.points[p];
    if (point.body == layout.carbody) points_.push_back({places.points[p], 0, point.arm});
    if (point.body == layout.bogie[0]) points_.push_back({places.points[p], 2, 0.0});
    if (point.body == layout.bogie[1]) points_.push_back({places.points[p], 3, 0.0});
  }
}

void FlatOutput::write(const double* x, const double* dx, const double* u, std::span<double> y) const {
  const double zk = x[0], phi = x[1], dzk = x[4], dphi = x[5];
  writeFrom(y, carbody_, {zk, phi, dzk, dphi, dx[4], dx[5]});
  writeFrom(y, bogie_[0], {x[2], x[6], dx[6]});
  writeFrom(y, bogie_[1], {x[3], x[7], dx[7]});

  const double front = zk + v_.lf * phi - x[2];
  const double rear = zk - v_.lr * phi - x[3];
  writeFrom(y, secondary_[0], {front, v_.cs1 * front + v_.bs1 * (dzk + v_.lf * dphi - x[6])});
  writeFrom(y, secondary_[1], {rear, v_.cs2 * rear + v_.bs2 * (dzk - v_.lr * dphi - x[7])});
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    const std::size_t bogie = wheel < 2 ? 2 : 3;
    const double elongation = x[bogie] - u[wheel];
    const double force = v_.cp[wheel] * elongation + v_.bp[wheel] * (x[bogie + 4] - u[4 + wheel]);
    writeFrom(y, primary_[wheel], {elongation, force});
    // Newton for the wheelset: load - static load + force = m eta''.
    writeFrom(y, wheelset_[wheel], {u[wheel], wheel_load_[wheel] - force + wheelset_mass_[wheel] * u[8 + wheel]});
  }
  for (const Point& point : points_) {
    const std::size_t z = point.inner;
    writeFrom(y, point.column, {x[z] + point.arm * phi, x[z + 4] + point.arm * dphi, dx[z + 4] + point.arm * dx[5]});
  }
}

}  // namespace vehicle
