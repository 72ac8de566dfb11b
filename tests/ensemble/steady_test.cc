#include "libvehicle/ensemble/steady.h"

#include <cmath>
#include <complex>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "libvehicle/ensemble/harmonic_orders.h"
#include "libvehicle/ensemble/spectrum_rail.h"
#include "libvehicle/linear/steady_state.h"
#include "tests/ensemble/designs.h"
#include "tests/ensemble/scalar_run.h"
#include "tests/support/refusal.h"

namespace vehicle::test {
namespace {

using Complex = std::complex<double>;

StateSpace matricesOf(const FlatParameters& vehicle) {
  const FlatRhs rhs(vehicle);
  StateSpace matrices{Eigen::MatrixXd(8, 8), Eigen::MatrixXd(8, 8)};
  const std::array<double, 8> zero{};
  for (Eigen::Index i = 0; i < 8; ++i) {
    std::array<double, 8> unit{};
    unit[static_cast<std::size_t>(i)] = 1.0;
    rhs(unit.data(), zero.data(), matrices.A.col(i).data());
    rhs(zero.data(), unit.data(), matrices.B.col(i).data());
  }
  return matrices;
}

/// Amplitudes of all columns by a dense complex solve: columns are linear, so each part goes through them apart.
std::vector<Complex> columnAmplitudes(EnsembleDesign design, const InputSegment& rail, int f) {
  design.wheel_load = {};
  const Eigen::VectorXcd X = steadyAmplitude(matricesOf(design.vehicle), rail, f);
  const auto F = rail.angular_frequency.size();
  const Complex iw(0.0, rail.angular_frequency[static_cast<std::size_t>(f)]);
  std::array<double, 8> x_re{}, x_im{};
  std::array<double, 12> u_re{}, u_im{};
  for (std::size_t i = 0; i < 8; ++i) {
    x_re[i] = X(static_cast<Eigen::Index>(i)).real();
    x_im[i] = X(static_cast<Eigen::Index>(i)).imag();
  }
  for (std::size_t j = 0; j < 4; ++j) {
    const std::size_t at = j * F + static_cast<std::size_t>(f);
    const Complex Y[3] = {Complex(rail.cosine[at], -rail.sine[at]), iw * Complex(rail.cosine[at], -rail.sine[at]),
                          iw * iw * Complex(rail.cosine[at], -rail.sine[at])};
    for (std::size_t k = 0; k < 3; ++k) {
      u_re[4 * k + j] = Y[k].real();
      u_im[4 * k + j] = Y[k].imag();
    }
  }
  const std::vector<double> re = columnsAt(design, x_re.data(), u_re.data());
  const std::vector<double> im = columnsAt(design, x_im.data(), u_im.data());
  std::vector<Complex> amplitudes;
  for (std::size_t k = 0; k < re.size(); ++k) amplitudes.emplace_back(re[k], im[k]);
  return amplitudes;
}

std::vector<EnsembleDesign> bothKinds(int symmetric, int asymmetric) {
  std::vector<EnsembleDesign> designs = symmetricDesigns(symmetric);
  for (const EnsembleDesign& each : asymmetricDesigns(asymmetric)) designs.push_back(each);
  return designs;
}

std::string isaName(const ::testing::TestParamInfo<Isa>& info) { return std::string(nameOf(info.param)); }
class SteadyLanes : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(EveryIsaOfThisMachine, SteadyLanes, ::testing::ValuesIn(supportedIsas()), isaName);

// Two eliminations of a matrix of condition 1e3 or so differ by some hundred roundings. Columns that are small
// differences of large numbers (a load far above resonance) cancel: measured against the sum of what they are made of.
TEST_P(SteadyLanes, SolveWhatADenseComplexSolveSolves) {
  const std::vector<EnsembleDesign> designs = bothKinds(9, 10);
  SteadyRun run;
  run.columns = allColumns();
  run.amplitudes = SteadyAmplitudes::kKept;
  run.isa = GetParam();
  const std::size_t K = run.columns.size();
  for (const double speed : {6.0, 20.0, 41.0}) {
    const Input input = railOf({.speed = speed, .wavelength = {25.0, 7.0, 3.1}, .amplitude = {5e-3, 2e-3, 1e-3}});
    const InputSegment* rail = &input.segment(0);
    const SteadyResult result = steadyEnsemble(designs, {&rail, 1}, run);
    ASSERT_TRUE(result.failures.empty());
    for (std::size_t i = 0; i < designs.size(); ++i) {
      std::vector<double> squares(K, 0.0);
      for (std::size_t f = 0; f < 3; ++f) {
        const std::vector<Complex> truth = columnAmplitudes(designs[i], *rail, static_cast<int>(f));
        const double w = rail->angular_frequency[f];
        for (std::size_t k = 0; k < K; ++k) {
          const Complex ours = result.amplitudes[0][(i * K + k) * 3 + f];
          const auto column = static_cast<int>(run.columns[k]);
          const bool is_force = column >= static_cast<int>(FlatColumn::kSecondaryFrontDeflection) &&
                                column < static_cast<int>(FlatColumn::kFirstPoint);
          // Heights of 5 mm, forces through some 5e6 N/m, accelerations of bogies behind 1e3 1/s^2.
          const double scale = is_force ? 5e-3 * 1e7 + 2e3 * w * w * 5e-3 : 5e-3 * (1.0 + w + 1e3 + w * w);
          const double allowed = 1e-13 * (is_force && column % 2 == 0 ? 1.0 : scale) + 1e-12 * std::abs(truth[k]);
          ASSERT_WITHIN(std::abs(ours - truth[k]), 0.0, allowed) << "design " << i << " column " << k << " line " << f;
          squares[k] += 0.5 * std::norm(ours);
        }
      }
      for (std::size_t k = 0; k < K; ++k) {
        const ColumnSummary& summary = result.summaries[i * K + k];
        // The same numbers once more: a rounding each.
        EXPECT_WITHIN(summary.rms * summary.rms, squares[k] + summary.mean * summary.mean,
                      1e-14 * (squares[k] + summary.mean * summary.mean));
      }
    }
  }
}

// The transient of the slowest mode (0.2 1/s) has decayed to e^-28 = 1e-12 after 140 s; RK4 at 0.2 ms is 2e-11 off. The
// samples cover one common period evenly, which makes their mean square exact for its harmonics.
TEST_P(SteadyLanes, AreWhereALongRunArrives) {
  const std::vector<EnsembleDesign> designs = bothKinds(4, 4);
  constexpr double kSettle = 140.0, kPeriod = 1.25, kSample = 5e-3;
  const Input input = railOf({.end = kSettle + kPeriod - kSample});
  EnsembleRun run;
  run.output_step = kSample;
  run.step = {.step = 2e-4};
  run.settle = kSettle;
  run.columns = allColumns();
  run.isa = GetParam();
  std::vector<double> mean, square;  // (designs x columns) over the samples
  const EnsembleResult in_time = runEnsemble(designs, input, run, [&](const StoredBlock& stored) {
    for (int i = 0; i < stored.designs(); ++i) {
      for (int k = 0; k < stored.columns(); ++k) {
        mean.push_back(0.0);
        square.push_back(0.0);
        for (int n = 0; n < stored.samples(i); ++n) {
          mean.back() += stored.at(i, k, n) / stored.samples(i);
          square.back() += stored.at(i, k, n) * stored.at(i, k, n) / stored.samples(i);
        }
      }
    }
  });
  const InputSegment* rail = &input.segment(0);
  const SteadyResult closed = steadyEnsemble(designs, {&rail, 1}, {.columns = run.columns, .isa = run.isa});
  ASSERT_TRUE(in_time.failures.empty() && closed.failures.empty());
  ASSERT_EQ(mean.size(), closed.summaries.size());
  for (std::size_t i = 0; i < closed.summaries.size(); ++i) {
    const double rms = closed.summaries[i].rms;
    EXPECT_WITHIN(std::sqrt(square[i]), rms, 1e-9 * rms) << "entry " << i;
    EXPECT_WITHIN(mean[i], closed.summaries[i].mean, 1e-9 * rms) << "entry " << i;
  }
}

// The summit between samples comes from a parabola through three: its error is y''' h^3 / 16 at most, half a sample
// off, with h = 2 pi / 64 of the highest order. A single sine has y''' = 0 at its summit; a mixture does not.
TEST_P(SteadyLanes, FindThePeaksBetweenTheSamples) {
  const std::vector<EnsembleDesign> designs = bothKinds(3, 4);
  const Input input = railOf({.wavelength = {25.0, 12.5, 5.0}, .amplitude = {5e-3, 1e-3, 2e-3}});
  const InputSegment* rail = &input.segment(0);
  const SteadyRun run{.columns = allColumns(), .peaks = SteadyPeaks::kSampled, .amplitudes = SteadyAmplitudes::kKept,
                .isa = GetParam()};
  const SteadyResult result = steadyEnsemble(designs, {&rail, 1}, run);
  const std::size_t K = run.columns.size();
  for (std::size_t i = 0; i < designs.size(); ++i) {
    for (std::size_t k = 0; k < K; ++k) {
      const Complex* X = result.amplitudes[0].data() + (i * K + k) * 3;
      const double mean = result.summaries[i * K + k].mean;
      double low = INFINITY, high = -INFINITY;
      for (int n = 0; n < 20000; ++n) {
        double value = mean;
        for (std::size_t f = 0; f < 3; ++f) {
          value += (X[f] * std::polar(1.0, rail->angular_frequency[f] * 1.25 * n / 20000.0)).real();
        }
        low = std::min(low, value);
        high = std::max(high, value);
      }
      const double size = (std::abs(X[0]) / 125.0 + std::abs(X[1]) / 15.625 + std::abs(X[2])) * 6e-5;  // orders 1, 2, 5
      EXPECT_WITHIN(result.summaries[i * K + k].highest, high, size) << i << " column " << k;
      EXPECT_WITHIN(result.summaries[i * K + k].lowest, low, size) << i << " column " << k;
    }
  }
}

bool sameBits(const ColumnSummary& a, const ColumnSummary& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST_P(SteadyLanes, GiveADesignTheSameBitsInAnyCompanyAndOverARailEach) {
  const std::vector<EnsembleDesign> designs = bothKinds(12, 13);
  std::vector<Input> inputs;
  for (int i = 0; i < 25; ++i) inputs.push_back(railOf({.speed = 10.0 + i % 7, .wavelength = {25.0, 5.0 + i % 3}}));
  SteadyRun run{.columns = allColumns(), .isa = GetParam()};
  std::vector<const InputSegment*> rails;
  for (const Input& input : inputs) rails.push_back(&input.segment(0));
  const std::size_t K = run.columns.size();
  const SteadyResult crossed = steadyEnsemble(designs, rails, run);
  const SteadyResult each = steadyEnsembleEach(designs, rails, run);
  ASSERT_EQ(crossed.summaries.size(), 25u * 25u * K);
  for (std::size_t i = 0; i < 25; ++i) {
    const std::size_t other = (7 * i + 3) % 25;
    const SteadyResult alone = steadyEnsemble({&designs[i], 1}, {&rails[other], 1}, run);
    for (std::size_t k = 0; k < K; ++k) {
      ASSERT_TRUE(sameBits(crossed.summaries[(i * 25 + i) * K + k], each.summaries[i * K + k])) << i;
      ASSERT_TRUE(sameBits(crossed.summaries[(other * 25 + i) * K + k], alone.summaries[k])) << i;
    }
  }
}

// A raised rail raises everything by as much, and no spring is deflected; a carbody without springs has no answer, and
// that is its own affair.
TEST_P(SteadyLanes, FollowAConstantHeightAndTellWhoCannot) {
  std::vector<EnsembleDesign> designs = bothKinds(5, 5);
  InputSegment raised = railOf({}).segment(0);
  for (std::size_t j = 0; j < 4; ++j) raised.polynomial[4 * j] = 0.01;
  const InputSegment* rail = &raised;
  SteadyRun run{.columns = {FlatColumn::kCarbodyZ, FlatColumn::kRearBogieZ, FlatColumn::kSecondaryRearDeflection,
                            FlatColumn::kWheel2Load},
                .isa = GetParam()};
  for (EnsembleDesign& design : designs) design.vehicle.k_g = 0.0;
  const SteadyResult before = steadyEnsemble(designs, {&rail, 1}, run);
  ASSERT_TRUE(before.failures.empty());
  for (std::size_t i = 0; i < designs.size(); ++i) {
    EXPECT_WITHIN(before.summaries[4 * i].mean, 0.01, 1e-15);      // some roundings of 10 mm
    EXPECT_WITHIN(before.summaries[4 * i + 1].mean, 0.01, 1e-15);
    EXPECT_WITHIN(before.summaries[4 * i + 2].mean, 0.0, 1e-16 * 20);
    EXPECT_WITHIN(before.summaries[4 * i + 3].mean, designs[i].wheel_load[1], 1e-8);  // 4e6 N/m of the same
  }
  for (const std::size_t i : {1u, 7u}) {
    FlatParameters& v = designs[i].vehicle;
    v.cs1 = v.cs2 = v.bs1 = v.bs2 = 0.0;
  }
  const SteadyResult after = steadyEnsemble(designs, {&rail, 1}, run);
  ASSERT_EQ(after.failures.size(), 2u);
  EXPECT_EQ(after.failures[0].design, 1);
  EXPECT_EQ(after.failures[1].design, 7);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (i == 1 || i == 7) EXPECT_TRUE(std::isnan(after.summaries[4 * i + k].rms));
      else EXPECT_TRUE(sameBits(after.summaries[4 * i + k], before.summaries[4 * i + k]));
    }
  }
}

// The rail itself is a column: its variance is that of the spectrum. The carbody's is the sum of |H|^2 S df with H from
// the dense solve of a rail of 1 m.
TEST_P(SteadyLanes, AnswerASpectrumByTheSumOfItsLines) {
  const std::array<double, 4> delay = {0.0, 0.15, 0.3725, 0.5225};
  std::vector<SpectrumLine> lines;
  double variance = 0.0;
  for (int f = 1; f <= 40; ++f) {
    lines.push_back({2.0 * std::numbers::pi * 0.25 * f, 1e-6 / (f * f), 0.25});
    variance += 1e-6 / (f * f) * 0.25;
  }
  const InputSegment segment = spectrumRail(lines, delay);
  const InputSegment* rail = &segment;
  const std::vector<EnsembleDesign> designs = bothKinds(2, 2);
  SteadyRun run{.columns = {FlatColumn::kWheel3RailZ, FlatColumn::kCarbodyAz}, .isa = GetParam()};
  const SteadyResult result = steadyEnsemble(designs, {&rail, 1}, run);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    EXPECT_WITHIN(result.summaries[2 * i].rms, std::sqrt(variance), 1e-15 * 40);  // a rounding a line
    double answer = 0.0;
    for (std::size_t f = 0; f < lines.size(); ++f) {
      InputSegment unit = spectrumRail({{{lines[f].angular_frequency, 0.5, 1.0}}}, delay);  // amplitude 1 m
      const Complex H = columnAmplitudes(designs[i], unit, 0)[static_cast<std::size_t>(FlatColumn::kCarbodyAz)];
      answer += std::norm(H) * lines[f].density * lines[f].width;
    }
    EXPECT_WITHIN(result.summaries[2 * i + 1].rms, std::sqrt(answer), 1e-12 * std::sqrt(answer));  // two eliminations
  }
}

TEST(HarmonicOrders, AreTheSmallestThatFit) {
  using Orders = std::vector<int>;
  const double w = 2.0 * std::numbers::pi * 20.0 / 25.0;
  EXPECT_EQ(harmonicOrders(std::vector<double>{w, 3.0 * w}), (Orders{1, 3}));
  EXPECT_EQ(harmonicOrders(std::vector<double>{3.0 * w, 2.0 * w}), (Orders{3, 2}));
  EXPECT_EQ(harmonicOrders(std::vector<double>{w / 3.0, w / 7.0}), (Orders{7, 3}));
  EXPECT_EQ(harmonicOrders(std::vector<double>{w, std::numbers::sqrt2 * w}), std::nullopt);
  EXPECT_EQ(harmonicOrders(std::vector<double>{w, 201.0 * w}), std::nullopt);
  EXPECT_EQ(harmonicOrders({}), Orders{});
}

TEST(SteadyEnsemble, NamesWhatDoesNotFit) {
  const std::vector<EnsembleDesign> designs = symmetricDesigns(2);
  const InputSegment good = railOf({}).segment(0);
  InputSegment ramp = good;
  ramp.polynomial[4 * 2 + 1] = 0.1;
  InputSegment odd = good;
  odd.angular_frequency[1] = std::numbers::sqrt2 * odd.angular_frequency[0];
  const std::vector<const InputSegment*> rails = {&good, &ramp};
  EXPECT_EQ(refusalOf([&] { (void)steadyEnsemble(designs, rails, {}); }),
            "steady ensemble: rail 1: the height of channel 2 holds a term s^1, which never repeats itself; only a "
            "constant and harmonics do");
  const std::vector<const InputSegment*> one = {&good};
  EXPECT_EQ(refusalOf([&] { (void)steadyEnsembleEach(designs, one, {}); }),
            "steady ensemble: 1 rails for 2 designs, must be one a design");
  const std::vector<const InputSegment*> irrational = {&odd};
  SteadyRun peaks;
  peaks.peaks = SteadyPeaks::kSampled;
  EXPECT_EQ(refusalOf([&] { (void)steadyEnsemble(designs, irrational, peaks); }),
            "steady ensemble: rail 0: its 2 harmonics have no common period of order 200 or less, so peaks have no "
            "closed form; run in time instead");
  const std::vector<const InputSegment*> null = {nullptr};
  EXPECT_EQ(refusalOf([&] { (void)steadyEnsemble(designs, null, {}); }), "steady ensemble: rail 0: is null");
  EXPECT_NE(refusalOf([&] { (void)spectrumRail({{{1.0, -1.0, 1.0}}}, {}); }), "accepted");
}

}  // namespace
}  // namespace vehicle::test
