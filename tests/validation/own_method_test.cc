// A method that a program brings itself: a stepper and a line of the table, as docs/how-to/add-an-integrator.md has it.
#include <cmath>
#include <stdexcept>

#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/system_rhs.h"
#include "libvehicle/simulate/simulate.h"
#include "libvehicle/validation/validation.h"
#include "tests/support/tolerance.h"
#include "tests/support/vehicles.h"

namespace vehicle {
namespace {

/// Heun's method of order 2: the trapezoidal rule with an Euler step for its end.
class Heun {
 public:
  static constexpr const char* kName = "heun";
  static constexpr int kEvaluations = 2;

  explicit Heun(const System& system)
      : rhs_(system), first_(static_cast<std::size_t>(system.size())), second_(first_.size()), end_(first_.size()) {}

  [[nodiscard]] int size() const { return static_cast<int>(first_.size()); }
  void step(double h, const double* u_begin, const double* /*u_middle*/, const double* u_end, double* x) {
    rhs_(x, u_begin, first_.data());
    for (std::size_t i = 0; i < end_.size(); ++i) end_[i] = x[i] + h * first_[i];
    rhs_(end_.data(), u_end, second_.data());
    for (std::size_t i = 0; i < end_.size(); ++i) x[i] += 0.5 * h * (first_[i] + second_[i]);
  }

 private:
  SystemRhs rhs_;
  std::vector<double> first_, second_, end_;
};

Method heun() {
  return {.name = Heun::kName,
          .summary = "fixed step, order 2",
          .reads = {.step = true},
          .error = {.law = ErrorLaw::kStepHalving, .order = 2},
          .make = [](const RunProblem& problem, const MethodSettings& settings) -> std::unique_ptr<Integrator> {
            return std::make_unique<FixedSteps<Heun>>(Heun(problem.system), problem.input, settings.step);
          }};
}

Scenario shortScenario() {
  Scenario scenario = test::paperScenario(History::kOnset);
  scenario.run.duration = 2.5;
  return scenario;
}

double errorAt(double step) {
  RunChoice choice;
  choice.form = "flat";
  choice.method = "exact";
  const std::vector<double> truth = simulate(test::paperVehicle(), shortScenario(), choice).history.column("carbody.z");
  choice.method = Heun::kName;
  choice.step = step;
  const std::vector<double> column =
      simulate(test::paperVehicle(), shortScenario(), choice).history.column("carbody.z");
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) worst = std::max(worst, std::abs(column[i] - truth[i]));
  return worst;
}

TEST(OwnMethod, ALineOfTheTableMakesItKnownToRunsAndValidation) {
  addMethod(heun());
  EXPECT_EQ(methodNames().back(), "heun");
  EXPECT_NE(methodSummaries().find("heun (fixed step, order 2)"), std::string::npos);
  EXPECT_THROW(addMethod(heun()), std::invalid_argument);

  // Halving the step quarters the error; what is left of the next order at 1 ms is below a tenth.
  EXPECT_WITHIN(errorAt(1e-3) / errorAt(0.5e-3), 4.0, 0.4);

  ValidationChoice choice;
  choice.shared.clear();
  choice.forms = {"flat", "matrix", "mbs"};
  choice.methods = {"exact", "heun"};
  const ValidationReport report = validate(test::paperVehicle(), shortScenario(), choice);
  EXPECT_TRUE(report.inside());
  int halved = 0;
  for (const ValidationRun& run : report.runs) {
    if (run.key.method != "heun" || run.key.refine == 1) continue;
    ++halved;
    if (run.key.form == "mbs") continue;  // without an exact solution there is no order to tell
    ASSERT_TRUE(run.order.has_value());
    EXPECT_WITHIN(*run.order, 2.0, 0.1) << run.key.text();  // what is left of the next order, as above
  }
  EXPECT_EQ(halved, 3);
}

TEST(OwnMethod, WithoutAMakerItIsRefused) {
  Method nothing;
  nothing.name = "nothing";
  EXPECT_THROW(addMethod(nothing), std::invalid_argument);
  EXPECT_THROW((void)methodNamed("nothing"), std::invalid_argument);
}

}  // namespace
}  // namespace vehicle
