#include "libvehicle/definition/study_attributes.h"

#include "libvehicle/definition/attribute_binding.h"

namespace vehicle {

namespace {

using namespace attributes;

constexpr int kMostDesigns = 1'000'000'000;
// A grid of more steps has been mistyped; sampling plans take any value of a range.
constexpr int kMostSteps = 1'000'000;

constexpr AttributeRow kStudy[] = {
    name<&Study::name>("what reports call it"),
    quantity<&Study::settle>("settle", Dimension::kTime, Sign::kNotNegative,
                             "start of each run that the metrics leave out; a steady state has none")
        .orElse("0 s"),
    choice<&Study::evaluation>("evaluation", {"run", "steady_state"},
                               "a run over the scenario, or the periodic motion under harmonics in closed form")
        .orElse("run"),
};

constexpr AttributeRow kVary[] = {
    words<&Vary::parameter>("parameter",
                            "PART.ATTRIBUTE of the vehicle, speed, scenario.gravity, scenario.MEMBER.ATTRIBUTE; "
                            "several with commas between get the same value")
        .asRequired(),
    choice<&Vary::kind>("kind", {"absolute", "relative"},
                        "whether values are the parameter's own or multiples of the design's (80 %, 1.2)")
        .orElse("absolute"),
    words<&Vary::from>("from", "lower end of the range"),
    words<&Vary::to>("to", "upper end of the range"),
    integer<&Vary::count>("count", 2, kMostSteps,
                          "steps of the range, both ends included; without it a plan that samples takes any value"),
    choice<&Vary::spacing>("spacing", {"linear", "logarithmic"}, "how the range is divided").orElse("linear"),
    words<&Vary::values>("values", "list with commas between, instead of a range"),
};

constexpr AttributeRow kPlan[] = {
    choice<&Plan::kind>("kind", {"grid", "latin_hypercube", "sobol", "saltelli", "list"}, "which plan").asRequired(),
    integer<&Plan::size>("size", 1, kMostDesigns,
                         "designs of a plan that samples; blocks of a saltelli plan, best a power of two"),
    integer<&Plan::seed>("seed", 0, kMostDesigns,
                         "of a plan that samples, without it 1: another seed, another sample; sobol takes 0 for its "
                         "plain sequence"),
    choice<&Plan::second_order>("second_order", {"no", "yes"},
                                "of a saltelli plan: the indices of pairs of parameters too")
        .orElse("no"),
    file<&Plan::file>("of a list: header PARAMETER [UNIT],..., counted from the folder of this file"),
};

constexpr AttributeRow kSearch[] = {
    choice<&Search::method>("method", {"nsga2", "nspso"}, "genetic algorithm or particle swarm").asRequired(),
    integer<&Search::population>("population", 4, 1'000'000, "designs of a generation; nsga2: a multiple of 4")
        .orElse("100"),
    integer<&Search::generations>("generations", 1, 1'000'000, "how many generations").orElse("100"),
    integer<&Search::seed>("seed", 0, kMostDesigns, "another seed, another search").orElse("1"),
};

constexpr AttributeRow kStudyDesign[] = {name<&StudyDesign::name>("what tables call it")};

constexpr AttributeRow kStudySet[] = {
    words<&StudySet::parameter>("parameter", "as in vary").asRequired(),
    words<&StudySet::value>("value", "value with its unit").asRequired(),
};

constexpr AttributeRow kStudyMetric[] = {words<&StudyMetric::name>("name", "as said above").asRequired()};

constexpr AttributeRow kObjective[] = {
    words<&Objective::metric>("metric", "a metric of this study").asRequired(),
    choice<&Objective::goal>("goal", {"minimise", "maximise"}, "which way is better")
        .alsoWritten({"minimize", "maximize"})
        .asRequired(),
    choice<&Objective::over>("over", {"worst", "mean"}, "how speeds and scenarios become one value").orElse("worst"),
};

constexpr AttributeRow kLimit[] = {
    words<&Limit::metric>("metric", "a metric of this study").asRequired(),
    words<&Limit::below>("below", "at most this"),
    words<&Limit::above>("above", "at least this"),
};

}  // namespace

template <>
std::span<const AttributeRow> attributesOf<Study>() {
  return kStudy;
}
template <>
std::span<const AttributeRow> attributesOf<Vary>() {
  return kVary;
}
template <>
std::span<const AttributeRow> attributesOf<Plan>() {
  return kPlan;
}
template <>
std::span<const AttributeRow> attributesOf<Search>() {
  return kSearch;
}
template <>
std::span<const AttributeRow> attributesOf<StudyDesign>() {
  return kStudyDesign;
}
template <>
std::span<const AttributeRow> attributesOf<StudySet>() {
  return kStudySet;
}
template <>
std::span<const AttributeRow> attributesOf<StudyMetric>() {
  return kStudyMetric;
}
template <>
std::span<const AttributeRow> attributesOf<Objective>() {
  return kObjective;
}
template <>
std::span<const AttributeRow> attributesOf<Limit>() {
  return kLimit;
}

}  // namespace vehicle
