#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/model/topology.h"
#include "libvehicle/system/layout.h"
#include "libvehicle/units/channel.h"

namespace vehicle {

// Where everything stands that a form takes and gives: the one walk over a topology that all forms share. What the
// numbers are is each form's own business.

enum class PartKind {
  kBody,
  kSuspension,
  kWheelset,
  kPoint
};

enum class Quantity {
  kZ,                  // ".z" [m]
  kPitch,              // ".pitch" [rad]
  kZRate,              // ".vz" [m/s]
  kPitchRate,          // ".pitch_rate" [rad/s]
  kZAcceleration,      // ".az" [m/s^2]
  kPitchAcceleration,  // ".pitch_acc" [rad/s^2]
  kDeflection,         // ".deflection" [m] elongation-positive, dynamic part
  kForce,              // ".force" [N] the same
  kRailZ,              // ".rail_z" [m]
  kLoad,               // ".load" [N] wheel-rail force, compression-positive, static part included
};

/// A column of a result by what it is.
struct OutputKey {
  PartKind part = PartKind::kBody;
  int index = 0;  // of the part in the topology
  Quantity quantity = Quantity::kZ;
  bool operator==(const OutputKey&) const = default;
};

/// The columns of a result after `time`, the same for every form: bodies, suspensions, wheelsets, points, each in the
/// order of the file; what a part has is the table in layout.cc.
class OutputLayout {
 public:
  explicit OutputLayout(const Topology& topology);

  [[nodiscard]] int size() const { return static_cast<int>(channels_.size()); }
  [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }  // names and units
  [[nodiscard]] const std::vector<OutputKey>& keys() const { return keys_; }        // what each of them is

  /// Column of that quantity of that part; -1 where it has none (a body that does not pitch).
  [[nodiscard]] int column(PartKind part, int index, Quantity quantity) const;
  [[nodiscard]] int column(const OutputKey& key) const { return column(key.part, key.index, key.quantity); }
  /// The key of the column that is called so, e.g. "carbody.az".
  [[nodiscard]] std::optional<OutputKey> find(std::string_view name) const;
  /// The column whose rate of change that column is: of "carbody.az" that of "carbody.vz"; -1 where there is none.
  [[nodiscard]] int levelOf(int column) const;

 private:
  std::vector<Channel> channels_;
  std::vector<OutputKey> keys_;
  std::vector<int> first_;    // (part kinds) place of a kind's first part in columns_
  std::vector<int> columns_;  // (parts x quantities) column, or -1
};

/// What each state x = (q, q') of that topology is: a column, too.
[[nodiscard]] std::vector<OutputKey> stateKeys(const Topology& topology);
/// Their names: "carbody.z" [m], "carbody.pitch" [rad], ..., "carbody.vz" [m/s], "carbody.pitch_rate" [rad/s], ...
[[nodiscard]] std::vector<Channel> stateChannels(const OutputLayout& outputs, const std::vector<OutputKey>& states);
[[nodiscard]] std::vector<Channel> stateChannels(const Topology& topology);

/// Columns of an OutputLayout.
[[nodiscard]] std::vector<Channel> resultChannels(const Topology& topology);

}  // namespace vehicle
