#include "libvehicle/definition/study_attributes.h"
#include "libvehicle/definition/suite_attributes.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

ElementRow planRow() {
  return element<&Study::plan>(
      "plan",
      "How values become designs: grid crosses all of them; latin_hypercube and sobol fill the space with size "
      "designs; "
      "saltelli makes size * (parameters + 2) designs for sensitivity indices, with second_order size * (2 parameters "
      "+ "
      "2); list reads a CSV file, one design a row.",
      R"(<plan kind="sobol" size="1000" seed="1"/>)");
}

ElementRow designRow() {
  return element<&Study::designs>(
      "design",
      "A named design, compared with the vehicle as its file says it (the design base); the plan is crossed with each.",
      R"(<design name="soft"> <set parameter="secondary.stiffness_z" value="600 kN/m"/> </design>)",
      {text<&StudyDesign::title>("title", "One line for reports.", "<title>Air spring of 2019</title>"),
       element<&StudyDesign::sets>("set", "A parameter, or several tied ones, with the value of this design.",
                                   R"(<set parameter="secondary.stiffness_z" value="600 kN/m"/>)")});
}

}  // namespace

ElementRow studyRow() {
  ElementRow vehicle =
      element<&Study::vehicle>("vehicle", "The vehicle file.", R"(<vehicle file="../vehicles/coach.xml"/>)");
  vehicle.required = true;
  return root<Study>(
      "study", "Many designs of one vehicle, compared.", R"(<study name="secondary-damping" format="1"> ... </study>)",
      {
          text<&Study::title>("title", "One line for reports.", "<title>Damping of the secondary suspension</title>"),
          text<&Study::source>("source", "Where the numbers come from.", "<source>Tender of 2019</source>"),
          std::move(vehicle),
          element<&Study::scenarios>("scenario", "A scenario file; every design runs over each.",
                                     R"(<scenario file="../scenarios/track.xml"/>)"),
          element<&Study::varies>(
              "vary",
              "A parameter, or several tied ones, that takes a range or a list of values. parameter=\"speed\" with "
              "count or values: every design runs at each of them.",
              R"(<vary parameter="secondary.damping_z" from="20 kN*s/m" to="120 kN*s/m" count="11"/>)"),
          planRow(),
          element<&Study::search>("search", "Multi-objective optimisation within the ranges, instead of a plan.",
                                  R"(<search method="nsga2" population="100" generations="200"/>)"),
          designRow(),
          element<&Study::metrics>(
              "metric",
              "A number by which designs are compared: COLUMN.rms, .mean, .peak (max of |x|), .min, .max, .p99.85 "
              "(percentile), .abs_p95 (of |x|), .band(4..8 Hz) (r.m.s. between two frequencies); of the natural mode "
              "that is called NAME in the vehicle as its file says it: mode.NAME.frequency (|lambda| / 2 pi), "
              "mode.NAME.damped_frequency (|Im lambda| / 2 pi), mode.NAME.undamped_frequency (of masses and "
              "stiffnesses alone), mode.NAME.damping (the damping ratio); static.SUSPENSION.deflection, "
              "static.NAME.load.",
              R"(<metric name="carbody.az.rms"/>)"),
          element<&Study::objectives>("objective", "What is sought: the Pareto front is taken over all objectives.",
                                      R"(<objective metric="carbody.az.rms" goal="minimise"/>)"),
          element<&Study::limits>("limit", "A bound that every speed and scenario has to keep.",
                                  R"(<limit metric="secondary_front.deflection.peak" below="30 mm"/>)"),
      });
}

}  // namespace vehicle::schema
