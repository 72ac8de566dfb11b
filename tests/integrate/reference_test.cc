#include <array>
#include <map>
#include <string>
#include <vector>

#include "libvehicle/integrate/fixed_steps.h"
#include "libvehicle/integrate/rk4.h"
#include "tests/integrate/cases.h"
#include "tests/support/paper_matrices.h"
#include "tests/support/source_tree.h"
#include "tests/support/table.h"
#include "tests/support/tolerance.h"

// The paper's vehicle against its solution in 40 digits (tests/paper/data): displacements, velocities, accelerations.
// The matrices come from tests/support, so an error here is an error of integration.
namespace vehicle::test {
namespace {

constexpr std::array<const char*, 12> kColumns = {"zk", "phik", "z1", "z2", "dzk", "dphik",
                                                  "dz1", "dz2", "ddzk", "ddphik", "ddz1", "ddz2"};

using Table = std::map<std::string, std::vector<double>>;

const Table& reference(const std::string& history) {
  static std::map<std::string, Table> tables;
  if (!tables.contains(history)) {
    tables[history] = readTable(sourcePath("tests/paper/data/ref_consistent_J70t_") + history + ".csv");
  }
  return tables[history];
}

/// Largest error over the samples, relative to each column's peak; the worst of the first `columns`.
template <class Run>
double errorOf(const std::string& history, int columns, const Run& run) {
  const Table& table = reference(history);
  const StateSpace matrices = paperMatrices();
  const MatrixSystem system(matrices);
  const Input input = history == "onset" ? paperOnset() : paperExtended();
  const Schedule schedule(input, 5e-3);
  EXPECT_EQ(static_cast<std::size_t>(schedule.samples()), table.at("t").size());
  std::array<double, 12> error{}, peak{};
  Eigen::VectorXd u(8);
  const std::vector<double> rest(8, 0.0);
  run(RunProblem{system, input, schedule, rest}, [&](int sample, int segment, double t, States state) {
    input.evaluate(segment, t, {u.data(), 8});
    const Eigen::Map<const Eigen::VectorXd> x(state.data(), 8);
    const Eigen::VectorXd slope = matrices.A * x + matrices.B * u;
    for (int i = 0; i < 12; ++i) {
      const double truth = table.at(kColumns[static_cast<std::size_t>(i)])[static_cast<std::size_t>(sample)];
      const double value = i < 8 ? x(i) : slope(i - 4);
      auto& worst = error[static_cast<std::size_t>(i)];
      worst = std::max(worst, std::abs(value - truth));
      peak[static_cast<std::size_t>(i)] = std::max(peak[static_cast<std::size_t>(i)], std::abs(truth));
    }
    return true;
  });
  double worst = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(columns); ++i) worst = std::max(worst, error[i] / peak[i]);
  return worst;
}

double rk4Error(const std::string& history, FixedStep step) {
  return errorOf(history, 8, [&](const RunProblem& problem, const Observer& o) { return runRk4(problem, step, o); });
}

TEST(PaperVehicle, ExactAgreesToRoundingAccelerationsIncluded) {
  for (const char* history : {"onset", "extended"}) {
    // 2000 steps; accelerations are sums that cancel to a tenth of their terms.
    EXPECT_WITHIN(errorOf(history, 12, runExact), 0.0, 3e-13) << history;
  }
}

TEST(PaperVehicle, Dopri5AtTightTolerancesIsBelowOnePartInAHundredMillionAccelerationsIncluded) {
  for (const char* history : {"onset", "extended"}) {
    const double error = errorOf(history, 12, [](const RunProblem& problem, const Observer& o) {
      return runDopri5(problem, {.relative = 1e-10, .absolute = 1e-12}, o);
    });
    EXPECT_WITHIN(error, 0.0, 1e-8) << history;
  }
}

TEST(PaperVehicle, Rk4AtOneMillisecondIsBelowOnePartInTenMillion) {
  for (const char* history : {"onset", "extended"}) {
    EXPECT_WITHIN(rk4Error(history, {.step = 1e-3}), 0.0, 1e-7) << history;
  }
}

// The same bounds as in rk4_test.cc: the stiffest mode has w h = 0.04 at 1 ms.
TEST(PaperVehicle, Rk4ShowsOrderFourOnBothHistories) {
  for (const char* history : {"onset", "extended"}) {
    const double ratio = rk4Error(history, {.step = 1e-3}) / rk4Error(history, {.step = 1e-3, .refine = 2});
    EXPECT_GT(ratio, 15.0) << history;
    EXPECT_LT(ratio, 17.0) << history;
  }
}

}  // namespace
}  // namespace vehicle::test
