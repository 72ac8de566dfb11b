#include "libvehicle/flat/flat_form.h"

#include <string>
#include <utility>
#include <vector>

#include "libvehicle/flat/flat_equation_set.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/flat/ordered_form.h"
#include "libvehicle/flat/printed_form.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

class PaperForm final : public OrderedForm<FlatRhs> {
 public:
  PaperForm(const CompiledModel& model, const FlatLayout& layout, const FlatLoads& loads,
            const FlatParameters& parameters)
      : OrderedForm(model, layout, loads, parameters, FlatRhs(parameters)), equations_(equationSet(layout)) {}

  FlatVariant variant() const override { return FlatVariant::kConsistent; }
  const FlatRhs* rhs() const override { return &innerEquations(); }
  const EquationSet* equations() const override { return &equations_; }

 private:
  [[nodiscard]] FlatEquationSet equationSet(const FlatLayout& layout) const {
    std::vector<int> cut_order;
    for (std::size_t i = 0; i < 4; ++i) cut_order.insert(cut_order.end(), {stateOrder()[i], stateOrder()[i + 4]});
    const auto nameOf = [&](int body) { return topology().bodies[at(body)].name; };
    const FlatBodyNames names = {nameOf(layout.carbody), nameOf(layout.bogie[0]), nameOf(layout.bogie[1])};
    return {std::vector{parameters()}, std::vector<FlatCoupling>{}, std::vector{names}, std::move(cut_order),
            std::vector<int>(wheelOrder().begin(), wheelOrder().end())};
  }

  FlatEquationSet equations_;
};

/// The layout, and what the variant cannot represent; the layout is whole where there is nothing.
FlatReading readFor(const Topology& topology, FlatVariant variant) {
  if (topology.units > 1 && variant != FlatVariant::kConsistent) {
    FlatReading train;
    train.problems.add({topology.origin, "<train name=\"" + topology.name + "\">",
                        "is a train; the printed equations are of one vehicle", "take the form flat"});
    return train;
  }
  FlatReading reading = readLayout(topology);
  if (reading.problems.empty() && variant != FlatVariant::kConsistent) {
    reading.problems.append(asymmetries(topology, reading.layout));
  }
  return reading;
}

}  // namespace

ProblemList flatUnsupported(const Topology& topology, FlatVariant variant) {
  return readFor(topology, variant).problems;
}

std::unique_ptr<FlatForm> buildFlatForm(const CompiledModel& model, FlatVariant variant) {
  FlatReading reading = readFor(model.topology, variant);
  if (!reading.problems.empty()) throw InvalidInput(std::move(reading.problems));
  const FlatLayout& layout = reading.layout;
  if (variant != FlatVariant::kConsistent) return buildPrintedForm(model, layout, variant);
  const FlatLoads loads = flatLoads(model, layout);
  return std::make_unique<PaperForm>(model, layout, loads, flatParameters(model.topology, layout, loads));
}

}  // namespace vehicle
