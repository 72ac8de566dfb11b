#include "libvehicle/definition/scenario.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

constexpr Sign kAny = Sign::kAny;
constexpr Sign kNotNegative = Sign::kNotNegative;
constexpr Sign kPositive = Sign::kPositive;

template <auto kMember>
AttributeRow memberName() {
  AttributeRow row = name<kMember>("scenario.NAME.amplitude and the like are then parameters of a study");
  row.required = false;
  return row;
}

template <auto kMember>
AttributeRow railRow() {
  return choice<kMember>("rail", {"both", "left", "right"},
                         "the rail that it lies on; planar forms take the mean of both rails, so left or right alone "
                         "counts half")
      .orElse("both");
}

template <auto kMember>
AttributeRow shapeRow() {
  return choice<kMember>("shape", {"one_minus_cosine", "half_sine"}, "its form").asRequired();
}

ElementRow runRow() {
  ElementRow row = element<&Scenario::run>(
      "run", "How fast and how long.", R"(<run speed="20 m/s" duration="10 s" output_step="5 ms"/>)",
      {
          quantity<&Run::speed>("speed", Dimension::kSpeed, kNotNegative,
                                "running speed; above 0 on a track, a rig does not need it")
              .orElse("0 m/s"),
          quantity<&Run::duration>("duration", Dimension::kTime, kPositive,
                                   "time that the run lasts; this or distance"),
          quantity<&Run::distance>("distance", Dimension::kLength, kPositive,
                                   "way that the run lasts; this or duration"),
          quantity<&Run::output_step>("output_step", Dimension::kTime, kPositive, "time between samples of the result")
              .orElse("5 ms"),
      });
  row.required = true;
  return row;
}

ElementRow harmonicRow() {
  return element<&Track::harmonics>(
      "harmonic", "height = amplitude sin(2 pi order s / wavelength + phase)",
      R"(<harmonic wavelength="25 m" order="3" amplitude="2 mm"/>)",
      {
          memberName<&Harmonic::name>(),
          quantity<&Harmonic::wavelength>("wavelength", Dimension::kLength, kPositive, "wavelength of order 1")
              .asRequired(),
          quantity<&Harmonic::order>("order", Dimension::kNumber, kPositive, "waves per wavelength").orElse("1"),
          quantity<&Harmonic::amplitude>("amplitude", Dimension::kLength, kAny, "amplitude").asRequired(),
          quantity<&Harmonic::phase>("phase", Dimension::kAngle, kAny, "phase at s = 0").orElse("0 rad"),
          railRow<&Harmonic::rail>(),
      });
}

ElementRow dipRow() {
  return element<&Track::dips>(
      "dip",
      "one_minus_cosine: -depth/2 (1 - cos(2 pi (s - start)/length)); half_sine: -depth sin(pi (s - start)/length)",
      R"(<dip shape="half_sine" depth="8 mm" length="2 m" start="20 m"/>)",
      {
          memberName<&Dip::name>(),
          shapeRow<&Dip::shape>(),
          quantity<&Dip::depth>("depth", Dimension::kLength, kAny, "largest depth, positive downward").asRequired(),
          quantity<&Dip::length>("length", Dimension::kLength, kPositive, "length").asRequired(),
          quantity<&Dip::start>("start", Dimension::kLength, kAny, "where it begins").orElse("0 m"),
          railRow<&Dip::rail>(),
      });
}

ElementRow bumpRow() {
  return element<&Track::bumps>(
      "bump",
      "A dip turned upward. one_minus_cosine: height/2 (1 - cos(2 pi (s - start)/length)); half_sine: height sin(pi (s - "
      "start)/length)",
      R"(<bump shape="one_minus_cosine" height="10 mm" length="3 m" start="20 m"/>)",
      {
          memberName<&Bump::name>(),
          shapeRow<&Bump::shape>(),
          quantity<&Bump::height>("height", Dimension::kLength, kAny, "largest height, positive upward").asRequired(),
          quantity<&Bump::length>("length", Dimension::kLength, kPositive, "length").asRequired(),
          quantity<&Bump::start>("start", Dimension::kLength, kAny, "where it begins").orElse("0 m"),
          railRow<&Bump::rail>(),
      });
}

ElementRow rampRow() {
  return element<&Track::ramps>(
      "ramp", "Linear by rise over length from start, constant afterwards.",
      R"(<ramp rise="10 mm" length="5 m" start="20 m"/>)",
      {
          memberName<&Ramp::name>(),
          quantity<&Ramp::rise>("rise", Dimension::kLength, kAny, "height at its end, positive upward").asRequired(),
          quantity<&Ramp::length>("length", Dimension::kLength, kPositive, "length").asRequired(),
          quantity<&Ramp::start>("start", Dimension::kLength, kAny, "where it begins").orElse("0 m"),
          railRow<&Ramp::rail>(),
      });
}

ElementRow trackRow() {
  return element<&Scenario::track>(
      "track",
      "The rail's height over the distance s, which counts from the leading wheelset's position at t = 0; members add "
      "up.",
      R"(<track history="onset"> <harmonic wavelength="25 m" amplitude="5 mm"/> </track>)",
      {
          choice<&Track::history>("history", {"onset", "extended"},
                                  "what the rail was before: 0 for s < 0, or the profile for all s")
              .asRequired(),
          quantity<&Track::fade_in>("fade_in", Dimension::kLength, kPositive,
                                    "with onset: way over which harmonics grow from 0 to their height"),
      },
      {harmonicRow(), dipRow(), bumpRow(), rampRow()});
}

ElementRow rigRow() {
  return element<&Scenario::rig>(
      "rig", "A roller or shaker rig: each wheelset is driven in time. Stands instead of track.",
      R"(<rig> <input wheelset="wheelset_1"> <sine amplitude="6 mm" angular_frequency="5 rad/s"/> </input> </rig>)", {},
      {element<&Rig::inputs>(
          "input", "What one wheelset is given: the sum of its sines. Wheelsets without input stay at 0.",
          R"(<input wheelset="wheelset_1"> <sine amplitude="6 mm" angular_frequency="5 rad/s"/> </input>)",
          {reference<&RigInput::wheelset>("wheelset", "a wheelset of the vehicle")},
          {element<&RigInput::sines>(
              "sine",
              "height = amplitude sin(w t + phase), for all t; w is angular_frequency, or 2 pi frequency: one of the two "
              "is given",
              R"(<sine amplitude="6.2 mm" frequency="0.8 Hz" phase="0.3 rad"/>)",
              {
                  memberName<&RigSine::name>(),
                  quantity<&RigSine::amplitude>("amplitude", Dimension::kLength, kAny, "amplitude").asRequired(),
                  quantity<&RigSine::angular_frequency>("angular_frequency", Dimension::kAngularVelocity, kPositive,
                                                        "angular frequency; this or frequency"),
                  quantity<&RigSine::frequency>("frequency", Dimension::kFrequency, kPositive,
                                                "frequency; this or angular_frequency"),
                  quantity<&RigSine::phase>("phase", Dimension::kAngle, kAny, "phase at t = 0").orElse("0 rad"),
              })})});
}

ElementRow initialStateRow() {
  return element<&Scenario::initial_state>(
      "initial_state", "The state at t = 0; without it everything is 0.", R"(<initial_state from="periodic"/>)",
      {choice<&InitialState::from>("from", {"zero", "on_rail", "periodic"},
                                   "zero; rest on the rail's height; or the steady state under harmonics")
           .orElse("zero")},
      {element<&InitialState::bodies>(
          "body", "What is added to that for one body, or for a wheelset with a motion of its own.",
          R"(<body name="carbody" z="-3.1 mm" pitch="1.2 mrad" z_rate="22 mm/s" pitch_rate="-8.5 mrad/s"/>)",
          {
              reference<&InitialBody::name>("name", "a body or wheelset of the vehicle"),
              quantity<&InitialBody::z>("z", Dimension::kLength, kAny, "displacement, upward").orElse("0 m"),
              quantity<&InitialBody::pitch>("pitch", Dimension::kAngle, kAny, "pitch, nose-up").orElse("0 rad"),
              quantity<&InitialBody::z_rate>("z_rate", Dimension::kSpeed, kAny, "velocity, upward").orElse("0 m/s"),
              quantity<&InitialBody::pitch_rate>("pitch_rate", Dimension::kAngularVelocity, kAny,
                                                 "pitch velocity, nose-up")
                  .orElse("0 rad/s"),
          })});
}

}  // namespace

ElementRow scenarioRow() {
  return object<Scenario>(
      "scenario", "What the vehicle meets: speed, track or rig, initial state. It has either a track or a rig.",
      R"(<scenario name="paper-20mps" format="1"> ... </scenario>)",
      {name<&Scenario::name>("what results and reports call it"), format(),
       quantity<&Scenario::gravity>("gravity", Dimension::kAcceleration, kNotNegative, "acceleration of free fall")
           .orElse("9.81 m/s^2")},
      {text<&Scenario::title>("title", "One line for reports.", "<title>Two harmonics at 20 m/s</title>"),
       text<&Scenario::source>("source", "Where the numbers come from.", "<source>Line measurement of 2019</source>"),
       runRow(), trackRow(), rigRow(), initialStateRow()});
}

}  // namespace vehicle::schema
