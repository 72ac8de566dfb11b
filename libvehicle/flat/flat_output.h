#pragma once

#include <array>
#include <span>
#include <vector>

#include "libvehicle/definition/topology.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_model.h"
#include "libvehicle/flat/flat_statics.h"

namespace vehicle {

/// Where the columns of each part begin among resultChannels(); the others of a part follow its first.
struct ResultPlaces {
  std::vector<int> bodies;
  std::vector<int> suspensions;
  std::vector<int> wheelsets;
  std::vector<int> points;
};
[[nodiscard]] ResultPlaces resultPlacesOf(const Topology& topology);

/// The columns that one flat vehicle fills, alone or in a train: its bodies, suspensions, wheelsets, measuring points.
class FlatOutput {
 public:
  /// @param topology  of the vehicle or of the whole train, where the layout's parts stand
  FlatOutput(const Topology& topology, const ResultPlaces& places, const FlatLayout& layout,
             const FlatParameters& parameters, const FlatLoads& loads);

  /// @param x   (8) zk, phi, z1, z2, zk', phi', z1', z2'   @param dx  (8) its derivative
  /// @param u   (12) heights, rates and accelerations of the rail under the wheels 1 to 4
  /// @param y   all columns of the result
  void write(const double* x, const double* dx, const double* u, std::span<double> y) const;

 private:
  /// A measuring point: z + arm phi of its body.
  struct Point {
    int column = 0;
    std::size_t inner = 0;  // inner coordinate of the body's z: 0 carbody, 2 front, 3 rear bogie
    double arm = 0.0;       // [m] 0 on a bogie, which does not pitch
  };

  FlatParameters v_;
  std::array<double, 4> wheel_load_;       // [N] static
  std::array<double, 4> wheelset_mass_{};  // [kg]
  int carbody_ = 0;
  std::array<int, 2> bogie_{};
  std::array<int, 2> secondary_{};
  std::array<int, 4> primary_{};
  std::array<int, 4> wheelset_{};
  std::vector<Point> points_;
};

}  // namespace vehicle
