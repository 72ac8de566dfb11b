#include "libvehicle/diagnostics/warning.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace vehicle {

namespace {

constexpr std::array kKinds = {
    WarningKind{
        WarningCode::kWheelLoad, "WHEEL_LOAD",
        "A wheel load fell below 0: the contact would have to pull, and a rail only pushes. From that instant on "
        "the result is not that of a vehicle."},
    WarningKind{WarningCode::kLargeMotion, "LARGE_MOTION",
                "A body pitched by more than 0.1 rad or a spring moved by more than 0.5 m: the linear equations do not "
                "hold that far."},
    WarningKind{
        WarningCode::kUnstableStep, "UNSTABLE_STEP",
        "At this step the method grows although the vehicle does not. Take a shorter step or leave --step out."},
    WarningKind{
        WarningCode::kCoarseStep, "COARSE_STEP",
        "The step does not resolve the fastest motion of the vehicle. Take a shorter step or leave --step out."},
    WarningKind{
        WarningCode::kCoarseSamples, "COARSE_SAMPLES",
        "The run is so long that its fastest motion is not measured with enough samples: peaks may be too small."},
    WarningKind{
        WarningCode::kCannotStand, "CANNOT_STAND",
        "The loaded rest position is unstable: a small push is enough and the vehicle tips over. Look at heights "
        "and stiffnesses."},
    WarningKind{
        WarningCode::kUnstableMode, "UNSTABLE_MODE",
        "A motion grows by itself, without any rail. Look at signs and values of the vehicle or take another form."},
    WarningKind{WarningCode::kFreeMode, "FREE_MODE",
                "Nothing holds a motion of a body: it has no rest position. Add a spring or leave the motion out."},
    WarningKind{WarningCode::kGivenLoads, "GIVEN_LOADS",
                "The wheel loads that the file gives miss the weight of the vehicle by more than 0.5 %."},
    WarningKind{WarningCode::kRestDeflection, "REST_DEFLECTION",
                "A spring is compressed or stretched by more than 0.5 m at rest; railway springs have less travel."},
    WarningKind{WarningCode::kIllConditioned, "ILL_CONDITIONED",
                "Very fast and very slow motions stand beside each other: rounding shows in the result."},
    WarningKind{WarningCode::kFreePitch, "FREE_PITCH",
                "A body may pitch, but all its springs stand at one place and do not resist."},
    WarningKind{WarningCode::kFarFromWheelset, "FAR_FROM_WHEELSET",
                "A suspension stands far from the wheelset that it stands on; an x is probably missing."},
    WarningKind{WarningCode::kSamePlace, "SAME_PLACE", "Two axles stand at one place; an x is probably missing."},
    WarningKind{WarningCode::kOverlap, "OVERLAP", "Vehicles of a train stand in each other; look at their spacing."},
    WarningKind{WarningCode::kUnknownMode, "UNKNOWN_MODE",
                "A metric names a mode that the vehicle does not have: it has no value in any design."},
    WarningKind{WarningCode::kSampleSize, "SAMPLE_SIZE",
                "The size of a Saltelli plan is no power of two: its points are not balanced and the indices converge "
                "more slowly."},
    WarningKind{WarningCode::kNoIndex, "NO_INDEX",
                "A sensitivity index cannot be given: the output does not vary, or designs without a value break the "
                "plan."},
    WarningKind{WarningCode::kNothingJudged, "NOTHING_JUDGED",
                "None of the forms and methods that a suite names makes two runs of a vehicle that could be compared: "
                "validate judges nothing of it, which is not a pass."},
};

}  // namespace

std::span<const WarningKind> warningKinds() { return kKinds; }

std::string_view wordOf(WarningCode code) { return kKinds[static_cast<std::size_t>(code)].word; }

std::string Warning::text() const {
  std::string line;
  if (!place.file.empty()) line = place.line > 0 ? fmt::format("{}:{}: ", place.file, place.line) : place.file + ": ";
  line += "warning: ";
  if (!subject.empty()) line += subject + ": ";
  line += message;
  if (!remedy.empty()) line += "; " + remedy;
  return fmt::format("{} [{}]", line, wordOf(code));
}

}  // namespace vehicle
