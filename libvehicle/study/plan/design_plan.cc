#include "libvehicle/study/plan/design_plan.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace vehicle {

namespace {

constexpr std::uint64_t kMostDesigns = 1'000'000'000;

/// What a named design sets and a list gives too: the list would undo it.
void checkListed(const Study& study, const BoundStudy& bound, const DesignList& list, ProblemList& problems) {
  for (std::size_t named = 1; named < bound.designs.size(); ++named) {
    for (const auto& [parameter, value] : bound.designs[named].sets) {
      if (std::find(list.parameters.begin(), list.parameters.end(), parameter) == list.parameters.end()) continue;
      problems.add(study.designs[named - 1].origin, "<study><design>",
                   fmt::format("sets {}, which the list of designs gives too", bound.parameters[parameter].address),
                   "leave it out of one of them");
    }
  }
}

void checkSearched(const DesignPlan& plan, const Search& search, ProblemList& problems) {
  const auto generations = static_cast<std::uint64_t>(search.generations) + 1;  // the random start counts
  const std::uint64_t searched = generations * static_cast<std::uint64_t>(search.population);
  if (plan.size() + searched <= kMostDesigns) return;
  problems.add(search.origin, "<study><search>",
               fmt::format("makes {} designs in {} generations; at most {} are kept", searched, generations,
                           kMostDesigns),
               "take fewer generations or a smaller population");
}

}  // namespace

std::size_t saltelliMembers(std::size_t factors, SecondOrder order) {
  return order == SecondOrder::kYes ? 2 * factors + 2 : factors + 2;
}

Outcome<DesignPlan> DesignPlan::of(const Study& study, BoundStudy bound, DesignList list) {
  Outcome<DesignPlan> outcome;
  DesignPlan made;
  made.study_ = std::move(bound);
  const Plan plan = study.plan.value_or(Plan{});
  const Place& place = study.plan ? study.plan->origin : study.origin;
  const bool varies = !made.study_.factors.empty() || plan.kind == PlanKind::kList;
  if (varies && !study.search) {
    switch (plan.kind) {
      case PlanKind::kGrid:
        made.takeGrid();
        break;
      case PlanKind::kList:
        checkListed(study, made.study_, list, outcome.problems);
        made.points_ = list.rows();
        made.plan_ = std::move(list);
        break;
      case PlanKind::kLatinHypercube:
        made.points_ = static_cast<std::uint64_t>(plan.size.value_or(0));
        made.plan_.emplace<LatinHypercube>(made.points_, made.study_.factors.size(),
                                           static_cast<std::uint64_t>(plan.seed.value_or(kPlanSeed)));
        break;
      case PlanKind::kSobol:
      case PlanKind::kSaltelli:
        if (!made.takeSequence(plan, place, outcome.problems)) return outcome;
        break;
    }
  }
  if (made.size() > kMostDesigns) {
    const bool sampled = plan.kind != PlanKind::kGrid && plan.kind != PlanKind::kList;
    outcome.problems.add(place, "<study><plan>",
                         fmt::format("makes more than {} designs, base and named ones counted", kMostDesigns),
                         sampled ? "take a smaller size"
                                 : "take fewer steps, or let latin_hypercube or sobol choose among them");
  }
  if (study.search) checkSearched(made, *study.search, outcome.problems);
  if (outcome.problems.empty()) outcome.value = std::move(made);
  return outcome;
}

void DesignPlan::takeGrid() {
  points_ = 1;
  for (const Factor& factor : study_.factors) {
    // Stopping at the limit keeps the product from overflowing.
    points_ = std::min<std::uint64_t>(points_ * factor.levels.size(), kMostDesigns + 1);
  }
}

bool DesignPlan::takeSequence(const Plan& plan, const Place& place, ProblemList& problems) {
  const std::size_t factors = study_.factors.size();
  const bool saltelli = plan.kind == PlanKind::kSaltelli;
  const std::size_t dimensions = saltelli ? 2 * factors : factors;
  if (dimensions > SobolSequence::kMostDimensions) {
    problems.add(place, "<study><plan>", fmt::format("varies {} parameters", factors),
                 fmt::format("a Sobol sequence has at most {} dimensions{}", SobolSequence::kMostDimensions,
                             saltelli ? ", saltelli takes two a parameter" : ""));
    return false;
  }
  const std::uint64_t members = saltelli ? saltelliMembers(factors, plan.second_order) : 1;
  points_ = static_cast<std::uint64_t>(plan.size.value_or(0)) * members;
  SobolSequence sequence(dimensions, static_cast<std::uint64_t>(plan.seed.value_or(kPlanSeed)));
  if (saltelli) {
    plan_ = Saltelli{std::move(sequence), members};
  } else {
    plan_ = std::move(sequence);
  }
  return true;
}

std::uint64_t DesignPlan::size() const {
  const std::uint64_t named = study_.designs.size();
  return named + named * points_;
}

DesignIdentity DesignPlan::identityOf(std::uint64_t design) const {
  if (design >= size()) {
    throw std::invalid_argument(fmt::format("DesignPlan: number {} of a study of {} designs", design, size()));
  }
  const std::uint64_t named = study_.designs.size();
  if (design < named) return {static_cast<std::size_t>(design), std::nullopt};
  return {static_cast<std::size_t>((design - named) / points_), (design - named) % points_};
}

std::string DesignPlan::nameOf(std::uint64_t design) const {
  const DesignIdentity identity = identityOf(design);
  const std::string& named = study_.designs[identity.named].name;
  if (!identity.point) return named;
  return identity.named == 0 ? fmt::format("#{}", *identity.point) : fmt::format("{} #{}", named, *identity.point);
}

void DesignPlan::setNamed(std::size_t named, std::span<double> values) const {
  for (std::size_t i = 0; i < study_.parameters.size(); ++i) values[i] = study_.parameters[i].base;
  for (const auto& [parameter, value] : study_.designs[named].sets) values[parameter] = value;
}

void DesignPlan::setFactor(std::size_t factor, double value, std::span<double> values) const {
  const Factor& own = study_.factors[factor];
  for (const std::size_t parameter : own.parameters) {
    values[parameter] = own.kind == Variation::kRelative ? values[parameter] * value : value;
  }
}

void DesignPlan::valuesOf(std::uint64_t design, std::span<double> values) const {
  const DesignIdentity identity = identityOf(design);
  setNamed(identity.named, values);
  if (identity.point) setPoint(*identity.point, values);
}

void DesignPlan::valuesAt(std::size_t named, std::span<const double> unit, std::span<double> values) const {
  setNamed(named, values);
  for (std::size_t i = 0; i < study_.factors.size(); ++i) setFactor(i, valueAt(study_.factors[i], unit[i]), values);
}

void DesignPlan::setPoint(std::uint64_t point, std::span<double> values) const {
  const std::size_t factors = study_.factors.size();
  if (std::holds_alternative<Grid>(plan_)) {
    for (std::size_t i = factors; i-- > 0;) {
      const std::vector<double>& levels = study_.factors[i].levels;
      setFactor(i, levels[point % levels.size()], values);
      point /= levels.size();
    }
    return;
  }
  if (const auto* list = std::get_if<DesignList>(&plan_)) {
    const std::size_t columns = list->parameters.size();
    for (std::size_t i = 0; i < columns; ++i) values[list->parameters[i]] = list->values[point * columns + i];
    return;
  }
  std::vector<double> unit(factors);
  if (const auto* hypercube = std::get_if<LatinHypercube>(&plan_)) {
    hypercube->point(point, unit);
  } else if (const auto* sequence = std::get_if<SobolSequence>(&plan_)) {
    sequence->point(point, unit);
  } else {
    // A is the first half of the coordinates, B the second; AB_i is A with coordinate i of B, BA_i B with that of A.
    const auto& saltelli = std::get<Saltelli>(plan_);
    const std::uint64_t member = point % saltelli.members;
    std::vector<double> both(2 * factors);
    saltelli.sequence.point(point / saltelli.members, both);
    const bool mostly_b = member == 1 || member >= factors + 2;
    for (std::size_t i = 0; i < factors; ++i) {
      const bool exchanged = member == i + 2 || member == factors + i + 2;
      unit[i] = both[mostly_b != exchanged ? factors + i : i];
    }
  }
  for (std::size_t i = 0; i < factors; ++i) setFactor(i, valueAt(study_.factors[i], unit[i]), values);
}

}  // namespace vehicle
