#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "libvehicle/ensemble/ensemble.h"

// Designs and rails of the ensemble's tests, told in plain numbers.
namespace vehicle::test {

/// Numbers between 0 and 1 that look random and never change: SplitMix64.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * next(); }

 private:
  std::uint64_t state_;
};

/// The paper's vehicle.
inline EnsembleDesign paperDesign() {
  EnsembleDesign design;
  design.vehicle = {.mk = 57e3, .Jk = 70e3, .m1 = 9e3, .m2 = 9e3, .lf = 3.725, .lr = 3.725,
                    .cs1 = 2660e3, .bs1 = 100e3, .cs2 = 2660e3, .bs2 = 100e3,
                    .cp = {3040e3, 3040e3, 3040e3, 3040e3}, .bp = {30e3, 30e3, 30e3, 30e3}, .k_g = 0.0};
  design.wheel_load = {183937.5, 183937.5, 183937.5, 183937.5};
  return design;
}

/// Symmetric vehicles around the paper's.
inline std::vector<EnsembleDesign> symmetricDesigns(int count, std::uint64_t seed = 1) {
  Numbers numbers(seed);
  std::vector<EnsembleDesign> designs;
  for (int i = 0; i < count; ++i) {
    EnsembleDesign design = paperDesign();
    FlatParameters& v = design.vehicle;
    v.mk *= numbers.between(0.7, 1.4);
    v.Jk *= numbers.between(0.8, 9.0);
    v.m1 = v.m2 = 9e3 * numbers.between(0.7, 1.4);
    v.cs1 = v.cs2 = 2660e3 * numbers.between(0.4, 1.4);
    v.bs1 = v.bs2 = 100e3 * numbers.between(0.3, 1.6);
    v.cp.fill(3040e3 * numbers.between(0.6, 1.4));
    v.bp.fill(30e3 * numbers.between(0.5, 2.0));
    designs.push_back(design);
  }
  return designs;
}

/// Vehicles whose front and rear differ in everything, with wheelset masses, measuring points, a start off rest.
inline std::vector<EnsembleDesign> asymmetricDesigns(int count, std::uint64_t seed = 2) {
  Numbers numbers(seed);
  std::vector<EnsembleDesign> designs;
  for (int i = 0; i < count; ++i) {
    EnsembleDesign design = symmetricDesigns(1, seed + 100 + static_cast<std::uint64_t>(i))[0];
    FlatParameters& v = design.vehicle;
    v.m2 *= numbers.between(0.8, 1.2);
    v.lf = numbers.between(3.0, 4.5);
    v.lr = numbers.between(3.0, 4.5);
    v.cs2 *= numbers.between(0.7, 1.3);
    v.bs2 *= numbers.between(0.7, 1.3);
    for (double& c : v.cp) c *= numbers.between(0.8, 1.2);
    for (double& b : v.bp) b *= numbers.between(0.8, 1.2);
    v.k_g = numbers.between(-2e5, 2e5);
    for (double& q : design.wheel_load) q *= numbers.between(0.9, 1.1);
    for (double& m : design.wheelset_mass) m = numbers.between(1000.0, 2000.0);
    for (double& arm : design.point_arm) arm = numbers.between(-9.0, 9.0);
    for (std::size_t k = 0; k < 8; ++k) design.start[k] = numbers.between(-1e-3, 1e-3) * (k < 4 ? 1.0 : 10.0);
    designs.push_back(design);
  }
  return designs;
}

/// What a rail is made of. Each wheel meets it after its delay.
struct RailShape {
  double speed = 20.0;                                            // [m/s]
  double end = 2.0;                                               // [s]
  bool onset = false;                                             // flat for s < 0, else there from ever
  std::array<double, 4> behind = {0.0, 3.0, 7.45, 10.45};         // [m] leading wheel to wheel
  std::vector<double> wavelength = {25.0, 25.0 / 3.0};            // [m]
  std::vector<double> amplitude = {5e-3, 2e-3};                   // [m]
  double bump = 0.0;  // [m/s^2] b of a cubic b t'^2 (1 - t'/6), t' = time that the wheel has been on the profile
};

/// Segments between the arrivals of the wheels (onset), or one segment.
inline Input railOf(const RailShape& shape) {
  std::vector<double> borders = {0.0};
  if (shape.onset) {
    for (const double x : shape.behind) {
      if (x > 0.0 && x / shape.speed < shape.end) borders.push_back(x / shape.speed);
    }
  }
  borders.push_back(shape.end);
  const std::size_t F = shape.wavelength.size();
  std::vector<InputSegment> segments;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    InputSegment segment;
    segment.begin = borders[i];
    segment.end = borders[i + 1];
    segment.cosine.assign(4 * F, 0.0);
    segment.sine.assign(4 * F, 0.0);
    segment.polynomial.assign(16, 0.0);
    for (std::size_t f = 0; f < F; ++f) {
      segment.angular_frequency.push_back(2.0 * std::numbers::pi * shape.speed / shape.wavelength[f]);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const double since = segment.begin - shape.behind[j] / shape.speed;  // [s] the wheel has been on the profile
      if (shape.onset && since < -1e-12) continue;
      for (std::size_t f = 0; f < F; ++f) {
        const double angle = segment.angular_frequency[f] * since;
        segment.cosine[j * F + f] = shape.amplitude[f] * std::sin(angle);
        segment.sine[j * F + f] = shape.amplitude[f] * std::cos(angle);
      }
      // The cubic, told about the begin of the segment.
      const double b = shape.bump, t = since;
      double* p = segment.polynomial.data() + 4 * j;
      p[0] = b * (t * t - t * t * t / 6.0);
      p[1] = b * (2.0 * t - t * t / 2.0);
      p[2] = b * (1.0 - t / 2.0);
      p[3] = -b / 6.0;
    }
    segments.push_back(std::move(segment));
  }
  return Input(4, std::move(segments));
}

/// Every column there is.
inline std::vector<FlatColumn> allColumns() {
  std::vector<FlatColumn> columns;
  for (int i = 0; i < kFlatColumns; ++i) columns.push_back(static_cast<FlatColumn>(i));
  return columns;
}

}  // namespace vehicle::test
