#include "libvehicle/flat/flat_form.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libvehicle/flat/flat_equation_set.h"
#include "libvehicle/flat/flat_layout.h"
#include "libvehicle/flat/flat_order.h"
#include "libvehicle/flat/flat_output.h"
#include "libvehicle/flat/flat_statics.h"
#include "libvehicle/flat/flat_unit_response.h"
#include "libvehicle/flat/printed_form.h"

namespace vehicle {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

class PaperForm final : public FlatForm {
 public:
  PaperForm(const CompiledModel& model, const FlatLayout& layout)
      : model_(model),
        order_(model, layout),
        loads_(flatLoads(model, layout)),
        parameters_(flatParameters(model.topology, layout, loads_)),
        rhs_(parameters_),
        equations_(equationSet(layout)),
        output_(model, layout, parameters_, loads_) {}

  int channels() const override { return model_.inputs.channels; }
  StateLayout layout() const override { return model_.states; }
  const std::vector<Channel>& states() const override { return model_.state_channels; }
  const std::vector<Channel>& outputs() const override { return model_.outputs.channels(); }
  FlatVariant variant() const override { return FlatVariant::kConsistent; }
  const FlatParameters& parameters() const override { return parameters_; }
  const FlatRhs* rhs() const override { return &rhs_; }
  const std::array<int, 8>& stateOrder() const override { return order_.state; }
  const std::array<int, 4>& wheelOrder() const override { return order_.wheel; }
  const EquationSet* equations() const override { return &equations_; }
  std::optional<StateSpace> linear() const override { return unitResponses(*this); }

  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    const Inner inner = innerDerivative(x, u.first(8));
    order_.scatterState(inner.dx, dx);
  }

  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override {
    const Inner inner = innerDerivative(x, u.first(8));
    std::array<double, 12> rail;
    order_.gatherRail(u, rail);
    output_.write(inner.x.data(), inner.dx.data(), rail.data(), y);
  }

 private:
  /// State and derivative counted from the front.
  struct Inner {
    std::array<double, 8> x;
    std::array<double, 8> dx;
  };

  Inner innerDerivative(std::span<const double> x, std::span<const double> u) const {
    Inner inner;
    std::array<double, 8> rail;
    order_.gatherState(x, inner.x);
    order_.gatherRail(u, rail);
    rhs_(inner.x.data(), rail.data(), inner.dx.data());
    return inner;
  }

  [[nodiscard]] FlatEquationSet equationSet(const FlatLayout& layout) const {
    std::vector<int> cut_order;
    for (std::size_t i = 0; i < 4; ++i) cut_order.insert(cut_order.end(), {order_.state[i], order_.state[i + 4]});
    const auto nameOf = [&](int body) { return model_.topology.bodies[at(body)].name; };
    const FlatBodyNames names = {nameOf(layout.carbody), nameOf(layout.bogie[0]), nameOf(layout.bogie[1])};
    return {std::vector{parameters_}, std::vector<FlatCoupling>{}, std::vector{names}, std::move(cut_order),
            std::vector<int>(order_.wheel.begin(), order_.wheel.end())};
  }

  CompiledModel model_;
  FlatOrder order_;
  FlatLoads loads_;
  FlatParameters parameters_;
  FlatRhs rhs_;
  FlatEquationSet equations_;
  FlatOutput output_;
};

}  // namespace

ProblemList flatUnsupported(const Topology& topology, FlatVariant variant) {
  ProblemList problems;
  if (topology.units > 1 && variant != FlatVariant::kConsistent) {
    problems.add({topology.origin, "<train name=\"" + topology.name + "\">",
                  "is a train; the printed equations are of one vehicle", "take the form flat"});
    return problems;
  }
  const FlatReading reading = readLayout(topology);
  problems.append(reading.problems);
  if (problems.empty() && variant != FlatVariant::kConsistent) {
    problems.append(asymmetries(topology, reading.layout));
  }
  return problems;
}

std::unique_ptr<FlatForm> buildFlatForm(const CompiledModel& model, FlatVariant variant) {
  ProblemList problems = flatUnsupported(model.topology, variant);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  const FlatLayout layout = readLayout(model.topology).layout;
  if (variant != FlatVariant::kConsistent) return buildPrintedForm(model, layout, variant);
  return std::make_unique<PaperForm>(model, layout);
}

}  // namespace vehicle
