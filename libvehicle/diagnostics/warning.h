#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libvehicle/diagnostics/problem.h"

namespace vehicle {

/// What a warning is about. The word of each, in brackets at the end of its line, is what scripts look for;
/// docs/warnings.md lists them.
enum class WarningCode {
  kWheelLoad,        // a contact that cannot open pulls at the rail
  kLargeMotion,      // beyond the small angles and travels of linear kinematics
  kUnstableStep,     // an explicit step at which the method itself grows
  kCoarseStep,       // a step that does not resolve the fastest motion
  kCoarseSamples,    // a run so long that its fastest motion cannot be measured
  kCannotStand,      // the loaded rest position is unstable
  kUnstableMode,     // a motion that grows by itself
  kFreeMode,         // a motion without stiffness
  kGivenLoads,       // wheel loads of the file that miss the weight
  kRestDeflection,   // a spring that comes down by more than any railway spring has travel
  kIllConditioned,   // so stiff beside so soft that rounding shows
  kFreePitch,        // a body that pitches about springs at one place
  kFarFromWheelset,  // a primary suspension metres away from its wheelset
  kSamePlace,        // two axles at one place
  kOverlap,          // vehicles of a train that stand in each other
  kUnknownMode,      // a metric names a mode that the vehicle does not have
  kSampleSize,       // a Saltelli plan whose size is no power of two
  kNoIndex,          // a sensitivity index that cannot be given
  kNothingJudged,    // a suite or vehicle of which validate can compare nothing
};

struct WarningKind {
  WarningCode code;
  std::string_view word;      // "WHEEL_LOAD"
  std::string_view sentence;  // what it means and what to do, for the list of the documentation
};
/// All of them, in the order of the enumerators.
[[nodiscard]] std::span<const WarningKind> warningKinds();
[[nodiscard]] std::string_view wordOf(WarningCode code);

/// A result, or a vehicle, that is outside what its model can say. Unlike a Problem it stops nothing; --strict makes it
/// count.
struct Warning {
  WarningCode code{};
  Place place = {};                  // of the part in its file, where it has one
  std::string subject = {};          // column, part or option that it is about, e.g. "wheelset_1.load"
  std::string message = {};          // with the value and the rule that it breaks
  std::string remedy = {};           // may be empty
  std::optional<double> value = {};  // [unit]
  std::string unit = {};
  std::optional<double> time = {};  // [s] of the run

  /// FILE:LINE: warning: SUBJECT: MESSAGE; REMEDY [CODE]
  [[nodiscard]] std::string text() const;
};
using Warnings = std::vector<Warning>;

}  // namespace vehicle
