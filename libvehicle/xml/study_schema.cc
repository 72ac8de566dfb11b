#include "libvehicle/definition/study.h"

#include "libvehicle/xml/schema_binding.h"
#include "libvehicle/xml/schema_files.h"

namespace vehicle::schema {

namespace {

constexpr int kMostDesigns = 1'000'000'000;

template <auto kMember>
AttributeRow words(std::string attribute_name, std::string sentence) {
  return bound<kMember>(std::move(attribute_name), ValueKind::kText, std::move(sentence));
}

ElementRow varyRow() {
  return element<&Study::varies>(
      "vary",
      "A parameter, or several tied ones, that takes a range or a list of values. parameter=\"speed\" with count or "
      "values: every design runs at each of them.",
      R"(<vary parameter="secondary.damping_z" from="20 kN*s/m" to="120 kN*s/m" count="11"/>)",
      {
          words<&Vary::parameter>("parameter",
                                  "PART.ATTRIBUTE of the vehicle, speed, scenario.gravity, scenario.MEMBER.ATTRIBUTE; "
                                  "several with commas between get the same value")
              .asRequired(),
          choice<&Vary::kind>("kind", {"absolute", "relative"},
                              "whether values are the parameter's own or multiples of the design's (80 %, 1.2)")
              .orElse("absolute"),
          words<&Vary::from>("from", "lower end of the range"),
          words<&Vary::to>("to", "upper end of the range"),
          integer<&Vary::count>(
              "count", 2, 1'000'000,
              "steps of the range, both ends included; without it a plan that samples takes any value"),
          choice<&Vary::spacing>("spacing", {"linear", "logarithmic"}, "how the range is divided").orElse("linear"),
          words<&Vary::values>("values", "list with commas between, instead of a range"),
      });
}

ElementRow planRow() {
  return element<&Study::plan>(
      "plan",
      "How values become designs: grid crosses all of them; latin_hypercube and sobol fill the space with size "
      "designs; "
      "saltelli makes size * (parameters + 2) designs for sensitivity indices, with second_order size * (2 parameters "
      "+ "
      "2); list reads a CSV file, one design a row.",
      R"(<plan kind="sobol" size="1000" seed="1"/>)",
      {
          choice<&Plan::kind>("kind", {"grid", "latin_hypercube", "sobol", "saltelli", "list"}, "which plan")
              .asRequired(),
          integer<&Plan::size>("size", 1, kMostDesigns,
                               "designs of a plan that samples; blocks of a saltelli plan, best a power of two"),
          integer<&Plan::seed>("seed", 0, kMostDesigns,
                               "of a plan that samples, without it 1: another seed, another sample; sobol takes 0 for its "
                               "plain sequence"),
           choice<&Plan::second_order>("second_order", {"no", "yes"},
                                       "of a saltelli plan: the indices of pairs of parameters too")
               .orElse("no"),
          bound<&Plan::file>("file", ValueKind::kFile,
                             "of a list: header PARAMETER [UNIT],..., counted from the folder of this file"),
      });
}

ElementRow searchRow() {
  return element<&Study::search>(
      "search", "Multi-objective optimisation within the ranges, instead of a plan.",
      R"(<search method="nsga2" population="100" generations="200"/>)",
      {
          choice<&Search::method>("method", {"nsga2", "nspso"}, "genetic algorithm or particle swarm").asRequired(),
          integer<&Search::population>("population", 4, 1'000'000, "designs of a generation; nsga2: a multiple of 4")
              .orElse("100"),
          integer<&Search::generations>("generations", 1, 1'000'000, "how many generations").orElse("100"),
          integer<&Search::seed>("seed", 0, kMostDesigns, "another seed, another search").orElse("1"),
      });
}

ElementRow designRow() {
  return element<&Study::designs>(
      "design",
      "A named design, compared with the vehicle as its file says it (the design base); the plan is crossed with each.",
      R"(<design name="soft"> <set parameter="secondary.stiffness_z" value="600 kN/m"/> </design>)",
      {name<&StudyDesign::name>("what tables call it")},
      {text<&StudyDesign::title>("title", "One line for reports.", "<title>Air spring of 2019</title>"),
       element<&StudyDesign::sets>("set", "A parameter, or several tied ones, with the value of this design.",
                                   R"(<set parameter="secondary.stiffness_z" value="600 kN/m"/>)",
                                   {
                                       words<&StudySet::parameter>("parameter", "as in vary").asRequired(),
                                       words<&StudySet::value>("value", "value with its unit").asRequired(),
                                   })});
}

}  // namespace

ElementRow studyRow() {
  const auto file = [] {
    return bound<&FileReference::file>("file", ValueKind::kFile, "path, counted from the folder of this file")
        .asRequired();
  };
  ElementRow vehicle =
      element<&Study::vehicle>("vehicle", "The vehicle file.", R"(<vehicle file="../vehicles/coach.xml"/>)", {file()});
  vehicle.required = true;
  return object<Study>(
      "study", "Many designs of one vehicle, compared.", R"(<study name="secondary-damping" format="1"> ... </study>)",
      {
          name<&Study::name>("what reports call it"),
          format(),
          quantity<&Study::settle>("settle", Dimension::kTime, Sign::kNotNegative,
                                   "start of each run that the metrics leave out; a steady state has none")
              .orElse("0 s"),
          choice<&Study::evaluation>("evaluation", {"run", "steady_state"},
                                     "a run over the scenario, or the periodic motion under harmonics in closed form")
              .orElse("run"),
      },
      {
          text<&Study::title>("title", "One line for reports.", "<title>Damping of the secondary suspension</title>"),
          text<&Study::source>("source", "Where the numbers come from.", "<source>Tender of 2019</source>"),
          std::move(vehicle),
          element<&Study::scenarios>("scenario", "A scenario file; every design runs over each.",
                                     R"(<scenario file="../scenarios/track.xml"/>)", {file()}),
          varyRow(),
          planRow(),
          searchRow(),
          designRow(),
          element<&Study::metrics>(
              "metric",
              "A number by which designs are compared: COLUMN.rms, .mean, .peak (max of |x|), .min, .max, .p99.85 "
              "(percentile), .abs_p95 (of |x|), .band(4..8 Hz) (r.m.s. between two frequencies); of the natural mode "
              "that is called NAME in the vehicle as its file says it: mode.NAME.frequency (|lambda| / 2 pi), "
              "mode.NAME.damped_frequency (|Im lambda| / 2 pi), mode.NAME.undamped_frequency (of masses and "
              "stiffnesses alone), mode.NAME.damping (the damping ratio); static.SUSPENSION.deflection, "
              "static.NAME.load.",
              R"(<metric name="carbody.az.rms"/>)", {words<&StudyMetric::name>("name", "as said above").asRequired()}),
          element<&Study::objectives>(
              "objective", "What is sought: the Pareto front is taken over all objectives.",
              R"(<objective metric="carbody.az.rms" goal="minimise"/>)",
              {
                  words<&Objective::metric>("metric", "a metric of this study").asRequired(),
                  choice<&Objective::goal>("goal", {"minimise", "maximise"}, "which way is better")
                      .alsoWritten({"minimize", "maximize"})
                      .asRequired(),
                  choice<&Objective::over>("over", {"worst", "mean"}, "how speeds and scenarios become one value")
                      .orElse("worst"),
              }),
          element<&Study::limits>("limit", "A bound that every speed and scenario has to keep.",
                                  R"(<limit metric="secondary_front.deflection.peak" below="30 mm"/>)",
                                  {
                                      words<&Limit::metric>("metric", "a metric of this study").asRequired(),
                                      words<&Limit::below>("below", "at most this"),
                                      words<&Limit::above>("above", "at least this"),
                                  }),
      });
}

}  // namespace vehicle::schema
