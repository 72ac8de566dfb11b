#include "libvehicle/definition/scenario_attributes.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

ElementRow runRow() {
  ElementRow row = element<&Scenario::run>("run", "How fast and how long.",
                                           R"(<run speed="20 m/s" duration="10 s" output_step="5 ms"/>)");
  row.required = true;
  return row;
}

ElementRow trackRow() {
  return element<&Scenario::track>(
      "track",
      "The rail's height over the distance s, which counts from the leading wheelset's position at t = 0; members add "
      "up.",
      R"(<track history="onset"> <harmonic wavelength="25 m" amplitude="5 mm"/> </track>)",
      {
          element<&Track::harmonics>("harmonic", "height = amplitude sin(2 pi order s / wavelength + phase)",
                                     R"(<harmonic wavelength="25 m" order="3" amplitude="2 mm"/>)"),
          element<&Track::dips>("dip",
                                "one_minus_cosine: -depth/2 (1 - cos(2 pi (s - start)/length)); half_sine: -depth "
                                "sin(pi (s - start)/length)",
                                R"(<dip shape="half_sine" depth="8 mm" length="2 m" start="20 m"/>)"),
          element<&Track::bumps>("bump",
                                 "A dip turned upward. one_minus_cosine: height/2 (1 - cos(2 pi (s - start)/length)); "
                                 "half_sine: height sin(pi (s - start)/length)",
                                 R"(<bump shape="one_minus_cosine" height="10 mm" length="3 m" start="20 m"/>)"),
          element<&Track::ramps>("ramp", "Linear by rise over length from start, constant afterwards.",
                                 R"(<ramp rise="10 mm" length="5 m" start="20 m"/>)"),
      });
}

ElementRow rigRow() {
  return element<&Scenario::rig>(
      "rig", "A roller or shaker rig: each wheelset is driven in time. Stands instead of track.",
      R"(<rig> <input wheelset="wheelset_1"> <sine amplitude="6 mm" angular_frequency="5 rad/s"/> </input> </rig>)",
      {element<&Rig::inputs>(
          "input", "What one wheelset is given: the sum of its sines. Wheelsets without input stay at 0.",
          R"(<input wheelset="wheelset_1"> <sine amplitude="6 mm" angular_frequency="5 rad/s"/> </input>)",
          {element<&RigInput::sines>("sine",
                                     "height = amplitude sin(w t + phase), for all t; w is angular_frequency, or 2 pi "
                                     "frequency: one of the two "
                                     "is given",
                                     R"(<sine amplitude="6.2 mm" frequency="0.8 Hz" phase="0.3 rad"/>)")})});
}

ElementRow initialStateRow() {
  return element<&Scenario::initial_state>(
      "initial_state", "The state at t = 0; without it everything is 0.", R"(<initial_state from="periodic"/>)",
      {element<&InitialState::bodies>(
          "body", "What is added to that for one body, or for a wheelset with a motion of its own.",
          R"(<body name="carbody" z="-3.1 mm" pitch="1.2 mrad" z_rate="22 mm/s" pitch_rate="-8.5 mrad/s"/>)")});
}

}  // namespace

ElementRow scenarioRow() {
  return root<Scenario>(
      "scenario", "What the vehicle meets: speed, track or rig, initial state. It has either a track or a rig.",
      R"(<scenario name="paper-20mps" format="1"> ... </scenario>)",
      {text<&Scenario::title>("title", "One line for reports.", "<title>Two harmonics at 20 m/s</title>"),
       text<&Scenario::source>("source", "Where the numbers come from.", "<source>Line measurement of 2019</source>"),
       runRow(), trackRow(), rigRow(), initialStateRow()});
}

}  // namespace vehicle::schema
