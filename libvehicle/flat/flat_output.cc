#include "libvehicle/flat/flat_output.h"

#include <array>
#include <cstddef>

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

template <std::size_t n>
void fill(std::span<double> y, const std::array<int, n>& columns, const std::array<double, n>& values) {
  for (std::size_t i = 0; i < n; ++i) y[at(columns[i])] = values[i];
}

template <std::size_t n>
std::array<int, n> columnsOf(const OutputLayout& layout, PartKind part, int index,
                             const std::array<Quantity, n>& quantities) {
  std::array<int, n> columns{};
  for (std::size_t i = 0; i < n; ++i) columns[i] = layout.column(part, index, quantities[i]);
  return columns;
}

constexpr std::array kMotion = {Quantity::kZ,         Quantity::kPitch,         Quantity::kZRate,
                                Quantity::kPitchRate, Quantity::kZAcceleration, Quantity::kPitchAcceleration};
constexpr std::array kBounce = {Quantity::kZ, Quantity::kZRate, Quantity::kZAcceleration};
constexpr std::array kSpring = {Quantity::kDeflection, Quantity::kForce};
constexpr std::array kWheel = {Quantity::kRailZ, Quantity::kLoad};

}  // namespace

FlatOutput::FlatOutput(const CompiledModel& model, const FlatLayout& layout, const FlatParameters& parameters,
                       const FlatLoads& loads)
    : v_(parameters),
      wheel_load_(loads.wheel),
      carbody_(columnsOf(model.outputs, PartKind::kBody, layout.carbody, kMotion)) {
  const Topology& topology = model.topology;
  const OutputLayout& outputs = model.outputs;
  for (std::size_t i = 0; i < 2; ++i) {
    bogie_[i] = columnsOf(outputs, PartKind::kBody, layout.bogie[i], kBounce);
    secondary_[i] = columnsOf(outputs, PartKind::kSuspension, layout.secondary[i], kSpring);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    primary_[i] = columnsOf(outputs, PartKind::kSuspension, layout.primary[i], kSpring);
    wheelset_[i] = columnsOf(outputs, PartKind::kWheelset, layout.wheelset[i], kWheel);
    wheelset_mass_[i] = topology.wheelsets[at(layout.wheelset[i])].mass;
  }
  for (std::size_t p = 0; p < topology.points.size(); ++p) {
    const TopologyPoint& point = topology.points[p];
    const std::array<int, 3> columns = columnsOf(outputs, PartKind::kPoint, static_cast<int>(p), kBounce);
    if (point.body == layout.carbody) points_.push_back({columns, 0, point.arm});
    if (point.body == layout.bogie[0]) points_.push_back({columns, 2, 0.0});
    if (point.body == layout.bogie[1]) points_.push_back({columns, 3, 0.0});
  }
}

void FlatOutput::write(const double* x, const double* dx, const double* u, std::span<double> y) const {
  const double zk = x[0], phi = x[1], dzk = x[4], dphi = x[5];
  fill(y, carbody_, {zk, phi, dzk, dphi, dx[4], dx[5]});
  fill(y, bogie_[0], {x[2], x[6], dx[6]});
  fill(y, bogie_[1], {x[3], x[7], dx[7]});

  const double front = zk + v_.lf * phi - x[2];
  const double rear = zk - v_.lr * phi - x[3];
  fill(y, secondary_[0], {front, v_.cs1 * front + v_.bs1 * (dzk + v_.lf * dphi - x[6])});
  fill(y, secondary_[1], {rear, v_.cs2 * rear + v_.bs2 * (dzk - v_.lr * dphi - x[7])});
  for (std::size_t wheel = 0; wheel < 4; ++wheel) {
    const std::size_t bogie = wheel < 2 ? 2 : 3;
    const double elongation = x[bogie] - u[wheel];
    const double force = v_.cp[wheel] * elongation + v_.bp[wheel] * (x[bogie + 4] - u[4 + wheel]);
    fill(y, primary_[wheel], {elongation, force});
    // Newton for the wheelset: load - static load + force = m eta''.
    fill(y, wheelset_[wheel], {u[wheel], wheel_load_[wheel] - force + wheelset_mass_[wheel] * u[8 + wheel]});
  }
  for (const Point& point : points_) {
    const std::size_t z = point.inner;
    fill(y, point.columns, {x[z] + point.arm * phi, x[z + 4] + point.arm * dphi, dx[z + 4] + point.arm * dx[5]});
  }
}

}  // namespace vehicle
