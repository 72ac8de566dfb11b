// Many designs at once against a run a design: the paper's vehicle and variants of it, 10 s in steps of 1 ms on the
// two-harmonic rail, and the steady state in closed form against a dense complex solve.
//
// A program of its own shape, because its results are shares of a peak and of another program's time: it ends with
// one line a claim. --results=FOLDER writes bench_ensemble.csv.

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <boost/numeric/odeint.hpp>
#include <Eigen/LU>
#include <fmt/format.h>

#include "benchmarks/built_by.h"
#include "benchmarks/measure.h"
#include "benchmarks/paper_case.h"
#include "libvehicle/ensemble/block_rows.h"
#include "libvehicle/ensemble/ensemble.h"
#include "libvehicle/ensemble/spectrum_rail.h"
#include "libvehicle/ensemble/steady.h"

namespace vehicle::bench {
namespace {

using Complex = std::complex<double>;

constexpr int kRepetitions = 9;
constexpr int kDesigns = 1024;

// Vector instructions in the loop of runShared() for one step of one register of designs, counted in its disassembly:
// what needs a multiplier (multiply, fused multiply-add), and additions. The peak counts what can be issued of the
// first kind; this machine adds on pipes of their own, others on the same.
constexpr double kMultiplies = 132.0;
constexpr double kAdditions = 44.0;

double wallSeconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Row {
  std::string problem, solver;
  double median = 0.0, deviation = 0.0;  // [ns]
  double error = 0.0;
  int threads = 1;
};
std::vector<Row> rows;

/// Median and spread of what run() takes [ns], divided by `per`.
double add(const std::string& problem, const std::string& solver, double per, double error, int threads,
           const std::function<void()>& run) {
  std::vector<double> took;
  run();
  for (int i = 0; i < kRepetitions; ++i) {
    const double begin = threads == 1 ? threadSeconds() : wallSeconds();
    run();
    took.push_back(1e9 * ((threads == 1 ? threadSeconds() : wallSeconds()) - begin) / per);
  }
  std::sort(took.begin(), took.end());
  double mean = 0.0, square = 0.0;
  for (const double each : took) mean += each / kRepetitions;
  for (const double each : took) square += (each - mean) * (each - mean) / (kRepetitions - 1);
  rows.push_back({problem, solver, took[kRepetitions / 2], std::sqrt(square), error, threads});
  fmt::print("{:<22} {:<24} {:>10.4g} ns +- {:.2g}   error {:.1e}\n", problem, solver, rows.back().median,
             rows.back().deviation, error);
  return rows.back().median;
}

// ---- peak

#if defined(__x86_64__)
#define VEHICLE_FOURTEEN(text)                                                                                     \
  text("0") text("1") text("2") text("3") text("4") text("5") text("6") text("7") text("8") text("9") text("10")   \
      text("11") text("12") text("13")
#define VEHICLE_FMA_256(n) "vfmadd231pd %%ymm14, %%ymm15, %%ymm" n "\n\t"
#define VEHICLE_FMA_512(n) "vfmadd231pd %%zmm14, %%zmm15, %%zmm" n "\n\t"
#define VEHICLE_VECTOR_REGISTERS                                                                                   \
  "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", \
      "xmm14", "xmm15"

constexpr int kPeakLoops = 200'000;
constexpr double kPeakInstructions = 14.0 * kPeakLoops;  // fourteen chains hide a latency of four or five cycles

void fused256() {
  asm volatile("vxorpd %%ymm14, %%ymm14, %%ymm14\n\tvxorpd %%ymm15, %%ymm15, %%ymm15\n\t" ::: VEHICLE_VECTOR_REGISTERS);
  for (int i = 0; i < kPeakLoops; ++i) asm volatile(VEHICLE_FOURTEEN(VEHICLE_FMA_256) ::: VEHICLE_VECTOR_REGISTERS);
  asm volatile("vzeroupper" ::: VEHICLE_VECTOR_REGISTERS);
}

void fused512() {
  asm volatile("vpxorq %%zmm14, %%zmm14, %%zmm14\n\tvpxorq %%zmm15, %%zmm15, %%zmm15\n\t" ::: VEHICLE_VECTOR_REGISTERS);
  for (int i = 0; i < kPeakLoops; ++i) asm volatile(VEHICLE_FOURTEEN(VEHICLE_FMA_512) ::: VEHICLE_VECTOR_REGISTERS);
  asm volatile("vzeroupper" ::: VEHICLE_VECTOR_REGISTERS);
}
#endif

/// Time of one fused multiply-add at the peak of an instruction set [ns]; 0 where it has none.
double peakOf(Isa isa) {
#if defined(__x86_64__)
  if (isa == Isa::kV3) return add("fma_issue_peak", "v3", kPeakInstructions, 0.0, 1, fused256);
  if (isa == Isa::kV4) return add("fma_issue_peak", "v4", kPeakInstructions, 0.0, 1, fused512);
#endif
  (void)isa;
  return 0.0;
}

// ---- runs

/// The paper's vehicle, then symmetric and asymmetric relatives of it.
std::vector<EnsembleDesign> designs(int count) {
  std::vector<EnsembleDesign> made(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < made.size(); ++i) {
    const double share = static_cast<double>(i) / count;
    made[i].vehicle = paperCase().form->parameters();
    made[i].vehicle.bs1 *= 1.0 + 0.5 * share;
    made[i].vehicle.bs2 = made[i].vehicle.bs1;
    made[i].vehicle.mk *= 1.0 + 0.2 * share;
    if (i % 2 == 1) made[i].vehicle.lf += 0.1 * share;
    made[i].wheel_load.fill(184e3);
  }
  return made;
}

double errorOf(Isa isa, bool each) {
  EnsembleRun run;
  run.isa = isa;
  run.columns = {FlatColumn::kCarbodyZ, FlatColumn::kCarbodyPitch, FlatColumn::kFrontBogieZ, FlatColumn::kRearBogieZ,
                 FlatColumn::kCarbodyVz, FlatColumn::kCarbodyPitchRate, FlatColumn::kFrontBogieVz,
                 FlatColumn::kRearBogieVz};
  const auto paper = designs(1);
  const Input* rail = &paperCase().input;
  State state{};
  const auto keep_last = [&](const StoredBlock& stored) {
    for (std::size_t i = 0; i < state.size(); ++i) state[i] = stored.at(0, static_cast<int>(i), stored.samples(0) - 1);
  };
  if (each) {
    (void)runEnsemble(paper, {&rail, 1}, run, keep_last);
  } else {
    (void)runEnsemble(paper, paperCase().input, run, keep_last);
  }
  return paperCase().errorOf(state);
}

State solveOdeint(const FlatParameters& vehicle) {
  const TimedEquations equations{FlatRhs(vehicle), {}};
  boost::numeric::odeint::runge_kutta4<State> stepper;
  State x{};
  boost::numeric::odeint::integrate_n_steps(stepper, std::cref(equations), x, 0.0, kStep, kSteps);
  return x;
}

void runs(std::vector<std::string>& claims) {
  const std::vector<EnsembleDesign> all = designs(kDesigns);
  const Input& rail = paperCase().input;
  const std::vector<const Input*> rails(all.size(), &rail);
  EnsembleRun run;
  run.columns = {FlatColumn::kCarbodyAz, FlatColumn::kSecondaryFrontDeflection, FlatColumn::kWheel1Load};
  const double steps = static_cast<double>(kSteps) * kDesigns;
  const double odeint_error = paperCase().errorOf(solveOdeint(all[0].vehicle));
  const double odeint = add("ensemble_step_1ms", "odeint_rk4", 4.0 * kSteps, odeint_error, 1, [&] {
    for (std::size_t i = 0; i < 4; ++i) benchmark::DoNotOptimize(solveOdeint(all[i].vehicle));
  });
  for (const Isa isa : supportedIsas()) {
    const std::string name(nameOf(isa));
    run.isa = isa;
    const double peak = peakOf(isa);
    const double shared = add("ensemble_step_1ms", "ours_" + name, steps, errorOf(isa, false), 1, [&] {
      benchmark::DoNotOptimize(runEnsemble(all, rail, run));
    });
    const double each = add("ensemble_step_1ms", "ours_" + name + "_rail_each", steps, errorOf(isa, true), 1, [&] {
      benchmark::DoNotOptimize(runEnsemble(all, rails, run));
    });
    claims.push_back(fmt::format("{}: {:.1f} x Boost.odeint's speed, {:.1f} x with a rail each", name, odeint / shared,
                                 odeint / each));
    EnsembleRun bare = run;  // hardly a sample: the steps and their rail alone
    bare.output_step = 0.5;
    const double alone = add("ensemble_step_1ms", "ours_" + name + "_steps_alone", steps, errorOf(isa, false), 1, [&] {
      benchmark::DoNotOptimize(runEnsemble(all, rail, bare));
    });
    const auto shareOf = [&](double took, const char* what) {
      const double slots = took * lanesOf(isa) / peak;  // instructions that could be issued in a step
      const double multiplies = 100.0 * kMultiplies / slots;
      const double arithmetic = 100.0 * (kMultiplies + kAdditions) / slots;
      claims.push_back(fmt::format("{}, {}: multiplies fill {:.0f} % of the FMA issue peak, all arithmetic {:.0f} %",
                                   name, what, multiplies, arithmetic));
    };
    if (peak > 0.0) {
      shareOf(alone, "steps alone");
      shareOf(shared, "with metrics");
    }
  }
  run.isa = bestIsa();
  const auto half = [&](int begin) {
    const auto some = std::span(all).subspan(static_cast<std::size_t>(begin), kDesigns / 2);
    benchmark::DoNotOptimize(runEnsemble(some, rail, run));
  };
  const double one = add("ensemble_threads", "ours_1_thread", steps, 0.0, 2, [&] {
    half(0);
    half(kDesigns / 2);
  });
  rows.back().threads = 1;
  const double two = add("ensemble_threads", "ours_2_threads", steps, 0.0, 2, [&] {
    std::thread other(half, 0);
    half(kDesigns / 2);
    other.join();
  });
  claims.push_back(fmt::format("2 threads: {:.2f} x the speed of one", one / two));
}

// ---- steady state

/// The dense system of one design and frequency, as a general program would write it.
Eigen::Matrix4cd matrixOf(const FlatParameters& v, double w) {
  const Complex k1(v.cs1, w * v.bs1), k2(v.cs2, w * v.bs2);
  const Complex p1(v.cp[0] + v.cp[1], w * (v.bp[0] + v.bp[1])), p2(v.cp[2] + v.cp[3], w * (v.bp[2] + v.bp[3]));
  Eigen::Matrix4cd A;
  A << k1 + k2 - w * w * v.mk, v.lf * k1 - v.lr * k2, -k1, -k2,  //
      v.lf * k1 - v.lr * k2, v.lf * v.lf * k1 + v.lr * v.lr * k2 + v.k_g - w * w * v.Jk, -v.lf * k1, v.lr * k2,  //
      -k1, -v.lf * k1, p1 + k1 - w * w * v.m1, 0.0,  //
      -k2, v.lr * k2, 0.0, p2 + k2 - w * w * v.m2;
  return A;
}

Eigen::Vector4cd forceOf(const FlatParameters& v, const InputSegment& rail, std::size_t f) {
  const double w = rail.angular_frequency[f];
  Eigen::Vector4cd b = Eigen::Vector4cd::Zero();
  for (std::size_t j = 0; j < 4; ++j) {
    const std::size_t at = j * rail.angular_frequency.size() + f;
    b(j < 2 ? 2 : 3) += Complex(v.cp[j], w * v.bp[j]) * Complex(rail.cosine[at], -rail.sine[at]);
  }
  return b;
}

void steady(std::vector<std::string>& claims) {
  constexpr int kFrequencies = 28;  // two harmonics at fourteen speeds
  constexpr int kCount = 64;
  InputSegment rail = paperCase().input.segment(0);
  std::vector<SpectrumLine> lines;
  for (int f = 1; f <= kFrequencies; ++f) lines.push_back({1.5 * f, 1e-6, 1.0});
  rail = spectrumRail(lines, {0.0, 0.15, 0.3725, 0.5225});
  for (const bool symmetric : {true, false}) {
    std::vector<EnsembleDesign> all = designs(kCount);
    for (EnsembleDesign& each : all) {
      if (symmetric) each.vehicle.lf = each.vehicle.lr;
      else each.vehicle.cs2 *= 1.05;
    }
    const double solves = static_cast<double>(kFrequencies) * kCount;
    const std::string problem = symmetric ? "steady_symmetric" : "steady_asymmetric";

    std::vector<Eigen::Matrix4cd> matrices;
    std::vector<Eigen::Vector4cd> forces, answers(all.size() * kFrequencies);
    for (const EnsembleDesign& each : all) {
      for (std::size_t f = 0; f < kFrequencies; ++f) {
        matrices.push_back(matrixOf(each.vehicle, rail.angular_frequency[f]));
        forces.push_back(forceOf(each.vehicle, rail, f));
      }
    }
    // Factor and solve alone: the matrices stand ready, while ours start from the vehicles' numbers.
    const double dense = add(problem, "eigen_lu_4x4", 20.0 * solves, 0.0, 1, [&] {
      for (int again = 0; again < 20; ++again) {
        for (std::size_t i = 0; i < matrices.size(); ++i) {
          answers[i] = Eigen::PartialPivLU<Eigen::Matrix4cd>(matrices[i]).solve(forces[i]);
        }
        benchmark::DoNotOptimize(answers.data());
      }
    });
    for (const Isa isa : supportedIsas()) {
      const ensemble::Kernels& kernels = ensemble::kernelsOf(isa);
      const auto lanes = static_cast<std::size_t>(kernels.lanes);
      std::vector<int> order(all.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
      ensemble::BlockRows block_rows(all, order, kernels.lanes, 0);
      ensemble::AlignedDoubles rail_rows(9 * lanes * kFrequencies), motion(8 * lanes * kFrequencies);
      std::vector<ensemble::Harmonic> harmonics;
      for (std::size_t f = 0; f < kFrequencies; ++f) {
        double* row = rail_rows.data() + 9 * lanes * f;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          row[lane] = rail.angular_frequency[f];
          for (std::size_t j = 0; j < 4; ++j) {
            row[(1 + j) * lanes + lane] = rail.cosine[j * kFrequencies + f];
            row[(5 + j) * lanes + lane] = -rail.sine[j * kFrequencies + f];
          }
        }
        harmonics.push_back({row, row + lanes});
      }
      double error = 0.0;
      const auto solveBlock = [&](int b) {
        ensemble::SteadyBlock block = block_rows.steadyBlock(b);
        block.motion = motion.data();
        block.range = nullptr;  // the solution alone, as its peers
        kernels.steady(block, {}, harmonics.data(), kFrequencies, symmetric);
      };
      for (int b = 0; b < block_rows.blocks(); ++b) {
        solveBlock(b);
        for (std::size_t f = 0; f < kFrequencies; ++f) {
          for (std::size_t lane = 0; lane < lanes; ++lane) {
            const Eigen::Vector4cd& truth = answers[(static_cast<std::size_t>(b) * lanes + lane) * kFrequencies + f];
            for (std::size_t i = 0; i < 4; ++i) {
              const Complex ours(motion[(8 * f + i) * lanes + lane], motion[(8 * f + 4 + i) * lanes + lane]);
              error = std::max(error, std::abs(ours - truth(static_cast<Eigen::Index>(i))) / truth.norm());
            }
          }
        }
      }
      const double ours = add(problem, "ours_" + std::string(nameOf(isa)), 200.0 * solves, error, 1, [&] {
        for (int again = 0; again < 200; ++again) {
          for (int b = 0; b < block_rows.blocks(); ++b) solveBlock(b);
          benchmark::DoNotOptimize(motion.data());
        }
      });
      claims.push_back(fmt::format("{}: steady state, {} vehicle: {:.1f} x a dense complex LU's speed", nameOf(isa),
                                   symmetric ? "symmetric" : "asymmetric", dense / ours));
    }
    const std::vector<EnsembleDesign> many = [&] {
      std::vector<EnsembleDesign> copies;
      for (int i = 0; i < 32; ++i) copies.insert(copies.end(), all.begin(), all.end());
      return copies;
    }();
    const SteadyRun run{.columns = {FlatColumn::kCarbodyAz, FlatColumn::kSecondaryFrontDeflection,
                                    FlatColumn::kWheel1Load}};
    const InputSegment* one = &rail;
    add(problem, "ours_rms_of_3_columns", 32.0 * solves, 0.0, 1, [&] {
      benchmark::DoNotOptimize(steadyEnsemble(many, {&one, 1}, run));
    });
  }
}

void write(const std::string& folder) {
  std::ofstream file(folder + "/bench_ensemble.csv");
  file << "problem,solver,median_ns,stddev_ns,error," << kBuiltByColumns << ",threads\n";
  for (const Row& row : rows) {
    file << fmt::format("{},{},{:.5g},{:.2g},{:.3e},{},{}\n", row.problem, row.solver, row.median, row.deviation,
                        row.error, builtBy(), row.threads);
  }
}

}  // namespace
}  // namespace vehicle::bench

int main(int argc, char** argv) {
  constexpr const char* kResults = "--results=";
  std::string results;
  for (int i = 1; i < argc; ++i) {
    if (std::strncmp(argv[i], kResults, std::strlen(kResults)) == 0) results = argv[i] + std::strlen(kResults);
  }
  vehicle::bench::requireKnownCommit(results);
  std::vector<std::string> claims;
  vehicle::bench::runs(claims);
  vehicle::bench::steady(claims);
  fmt::print("\n");
  for (const std::string& claim : claims) fmt::print("{}\n", claim);
  if (!results.empty()) vehicle::bench::write(results);
  return 0;
}
