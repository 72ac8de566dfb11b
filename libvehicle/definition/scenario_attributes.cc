#include "libvehicle/definition/scenario_attributes.h"

#include "libvehicle/definition/attribute_binding.h"

namespace vehicle {

namespace {

using namespace attributes;
using enum Dimension;
using enum Sign;

template <auto kMember>
constexpr AttributeRow memberName() {
  AttributeRow row = name<kMember>("scenario.NAME.amplitude and the like are then parameters of a study");
  row.required = false;
  return row;
}

template <auto kMember>
constexpr AttributeRow railRow() {
  return choice<kMember>("rail", {"both", "left", "right"},
                         "the rail that it lies on; planar forms take the mean of both rails, so left or right alone "
                         "counts half")
      .orElse("both");
}

template <auto kMember>
constexpr AttributeRow shapeRow() {
  return choice<kMember>("shape", {"one_minus_cosine", "half_sine"}, "its form").asRequired();
}

constexpr AttributeRow kScenario[] = {
    name<&Scenario::name>("what results and reports call it"),
    parameter<&Scenario::gravity>("gravity", kAcceleration, kNotNegative, "acceleration of free fall")
        .orElse("9.81 m/s^2"),
};

constexpr AttributeRow kRun[] = {
    parameter<&Run::speed>("speed", kSpeed, kNotNegative, "running speed; above 0 on a track, a rig does not need it")
        .orElse("0 m/s"),
    parameter<&Run::duration>("duration", kTime, kPositive, "time that the run lasts; this or distance"),
    parameter<&Run::distance>("distance", kLength, kPositive, "way that the run lasts; this or duration"),
    parameter<&Run::output_step>("output_step", kTime, kPositive, "time between samples of the result").orElse("5 ms"),
};

constexpr AttributeRow kTrack[] = {
    choice<&Track::history>("history", {"onset", "extended"},
                            "what the rail was before: 0 for s < 0, or the profile for all s")
        .asRequired(),
    parameter<&Track::fade_in>("fade_in", kLength, kPositive,
                               "with onset: way over which harmonics grow from 0 to their height"),
};

constexpr AttributeRow kHarmonic[] = {
    memberName<&Harmonic::name>(),
    parameter<&Harmonic::wavelength>("wavelength", kLength, kPositive, "wavelength of order 1").asRequired(),
    parameter<&Harmonic::order>("order", kNumber, kPositive, "waves per wavelength").orElse("1"),
    parameter<&Harmonic::amplitude>("amplitude", kLength, kAny, "amplitude").asRequired(),
    parameter<&Harmonic::phase>("phase", kAngle, kAny, "phase at s = 0").orElse("0 rad"),
    railRow<&Harmonic::rail>(),
};

constexpr AttributeRow kDip[] = {
    memberName<&Dip::name>(),
    shapeRow<&Dip::shape>(),
    parameter<&Dip::depth>("depth", kLength, kAny, "largest depth, positive downward").asRequired(),
    parameter<&Dip::length>("length", kLength, kPositive, "length").asRequired(),
    parameter<&Dip::start>("start", kLength, kAny, "where it begins").orElse("0 m"),
    railRow<&Dip::rail>(),
};

constexpr AttributeRow kBump[] = {
    memberName<&Bump::name>(),
    shapeRow<&Bump::shape>(),
    parameter<&Bump::height>("height", kLength, kAny, "largest height, positive upward").asRequired(),
    parameter<&Bump::length>("length", kLength, kPositive, "length").asRequired(),
    parameter<&Bump::start>("start", kLength, kAny, "where it begins").orElse("0 m"),
    railRow<&Bump::rail>(),
};

constexpr AttributeRow kRamp[] = {
    memberName<&Ramp::name>(),
    parameter<&Ramp::rise>("rise", kLength, kAny, "height at its end, positive upward").asRequired(),
    parameter<&Ramp::length>("length", kLength, kPositive, "length").asRequired(),
    parameter<&Ramp::start>("start", kLength, kAny, "where it begins").orElse("0 m"),
    railRow<&Ramp::rail>(),
};

constexpr AttributeRow kRigInput[] = {reference<&RigInput::wheelset>("wheelset", "a wheelset of the vehicle")};

constexpr AttributeRow kRigSine[] = {
    memberName<&RigSine::name>(),
    parameter<&RigSine::amplitude>("amplitude", kLength, kAny, "amplitude").asRequired(),
    parameter<&RigSine::angular_frequency>("angular_frequency", kAngularVelocity, kPositive,
                                           "angular frequency; this or frequency"),
    parameter<&RigSine::frequency>("frequency", kFrequency, kPositive, "frequency; this or angular_frequency"),
    parameter<&RigSine::phase>("phase", kAngle, kAny, "phase at t = 0").orElse("0 rad"),
};

constexpr AttributeRow kInitialState[] = {
    choice<&InitialState::from>("from", {"zero", "on_rail", "periodic"},
                                "zero; rest on the rail's height; or the steady state under harmonics")
        .orElse("zero"),
};

constexpr AttributeRow kInitialBody[] = {
    reference<&InitialBody::name>("name", "a body or wheelset of the vehicle"),
    quantity<&InitialBody::z>("z", kLength, kAny, "displacement, upward").orElse("0 m"),
    quantity<&InitialBody::pitch>("pitch", kAngle, kAny, "pitch, nose-up").orElse("0 rad"),
    quantity<&InitialBody::z_rate>("z_rate", kSpeed, kAny, "velocity, upward").orElse("0 m/s"),
    quantity<&InitialBody::pitch_rate>("pitch_rate", kAngularVelocity, kAny, "pitch velocity, nose-up")
        .orElse("0 rad/s"),
};

}  // namespace

template <>
std::span<const AttributeRow> attributesOf<Scenario>() {
  return kScenario;
}
template <>
std::span<const AttributeRow> attributesOf<Run>() {
  return kRun;
}
template <>
std::span<const AttributeRow> attributesOf<Track>() {
  return kTrack;
}
template <>
std::span<const AttributeRow> attributesOf<Harmonic>() {
  return kHarmonic;
}
template <>
std::span<const AttributeRow> attributesOf<Dip>() {
  return kDip;
}
template <>
std::span<const AttributeRow> attributesOf<Bump>() {
  return kBump;
}
template <>
std::span<const AttributeRow> attributesOf<Ramp>() {
  return kRamp;
}
template <>
std::span<const AttributeRow> attributesOf<Rig>() {
  return {};
}
template <>
std::span<const AttributeRow> attributesOf<RigInput>() {
  return kRigInput;
}
template <>
std::span<const AttributeRow> attributesOf<RigSine>() {
  return kRigSine;
}
template <>
std::span<const AttributeRow> attributesOf<InitialState>() {
  return kInitialState;
}
template <>
std::span<const AttributeRow> attributesOf<InitialBody>() {
  return kInitialBody;
}

}  // namespace vehicle
