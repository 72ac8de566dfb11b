#include "libvehicle/ensemble/steady.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

#include "libvehicle/ensemble/block_rows.h"
#include "libvehicle/ensemble/harmonic_orders.h"
#include "libvehicle/ensemble/kernel.h"

namespace vehicle {
namespace {

using ensemble::AlignedDoubles;
using ensemble::BlockRows;
using ensemble::Choice;
using ensemble::ColumnChoice;
using ensemble::Harmonic;
using ensemble::Kernels;
using ensemble::SteadyBlock;

constexpr int kSamplesPerPeriod = 64;   // of the highest order; a parabola then finds peaks to 6e-5 of it
constexpr std::size_t kHarmonicRows = 9;  // w, real parts, imaginary parts

std::string place(std::size_t rail) { return "steady ensemble: rail " + std::to_string(rail) + ": "; }

void checkRail(std::size_t index, const InputSegment* rail) {
  if (rail == nullptr) throw std::invalid_argument(place(index) + "is null");
  requireClosedForm("steady ensemble", "run each design by itself", *rail);
  const std::size_t F = rail->angular_frequency.size();
  if (rail->cosine.size() != 4 * F || rail->sine.size() != 4 * F || rail->polynomial.size() != 16) {
    throw std::invalid_argument(place(index) + "must have 4 channels, one a wheelset");
  }
  for (std::size_t i = 0; i < 16; ++i) {
    if (i % 4 == 0 || rail->polynomial[i] == 0.0) continue;
    throw std::invalid_argument(place(index) + "the height of channel " + std::to_string(i / 4) +
                                " holds a term s^" + std::to_string(i % 4) +
                                ", which never repeats itself; only a constant and harmonics do");
  }
}

bool hasConstant(const InputSegment& rail) {
  return std::any_of(rail.polynomial.begin(), rail.polynomial.end(), [](double value) { return value != 0.0; });
}

bool isSymmetric(const FlatParameters& v) {
  const auto all = [](const std::array<double, 4>& values) {
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values[0]; });
  };
  return v.lf == v.lr && v.cs1 == v.cs2 && v.bs1 == v.bs2 && v.m1 == v.m2 && all(v.cp) && all(v.bp);
}

// The harmonics of one block's lanes, the constant part first where there is one.
class HarmonicRows {
 public:
  HarmonicRows(std::size_t lanes, std::size_t frequencies, bool constant)
      : lanes_(lanes), constant_(constant ? 1 : 0), rows_((frequencies + constant_) * kHarmonicRows * lanes) {
    for (std::size_t f = 0; f < frequencies + constant_; ++f) {
      const double* row = rows_.data() + f * kHarmonicRows * lanes;
      harmonics_.push_back({row, row + lanes});
    }
  }
  void set(std::size_t lane, const InputSegment& rail) {
    const std::size_t F = rail.angular_frequency.size();
    for (std::size_t f = 0; f < F + constant_; ++f) {
      double* row = rows_.data() + f * kHarmonicRows * lanes_ + lane;
      const bool is_constant = f < constant_;
      row[0] = is_constant ? 0.0 : rail.angular_frequency[f - constant_];
      for (std::size_t j = 0; j < 4; ++j) {
        const std::size_t at = j * F + f - constant_;
        row[(1 + j) * lanes_] = is_constant ? rail.polynomial[4 * j] : rail.cosine[at];
        row[(5 + j) * lanes_] = is_constant ? 0.0 : -rail.sine[at];
      }
    }
  }
  const Harmonic* data() const { return harmonics_.data(); }
  int count() const { return static_cast<int>(harmonics_.size()); }
  std::size_t constant() const { return constant_; }

 private:
  std::size_t lanes_, constant_;
  AlignedDoubles rows_;
  std::vector<Harmonic> harmonics_;
};

std::vector<int> ordersOf(std::size_t index, const InputSegment& rail) {
  const auto orders = harmonicOrders(rail.angular_frequency);
  if (orders) return *orders;
  throw std::invalid_argument(place(index) + "its " + std::to_string(rail.angular_frequency.size()) +
                              " harmonics have no common period of order " + std::to_string(kMostOrder) +
                              " or less, so peaks have no closed form; run in time instead");
}

// Designs of one kind, computed together; what a design gets depends on its own kind alone.
using Kind = std::tuple<bool, bool, std::vector<int>, std::size_t>;  // symmetric, constant, orders, harmonics

class Computation {
 public:
  Computation(std::span<const EnsembleDesign> designs, const SteadyRun& run)
      : designs_(designs), run_(run), columns_(run.columns), kernels_(ensemble::kernelsOf(run.isa)) {
    if (supports(run.isa)) return;
    throw std::invalid_argument("steady ensemble: this machine has no instruction set \"" +
                                std::string(nameOf(run.isa)) + "\"");
  }

  /// @param railOf  the rail that a design meets   @param number  of the rail in the result
  template <class RailOf>
  void add(const RailOf& railOf, std::size_t number, SteadyResult& result) {
    std::map<Kind, std::vector<int>> kinds;
    for (std::size_t i = 0; i < designs_.size(); ++i) {
      const InputSegment& rail = railOf(i);
      const bool sampled = run_.peaks == SteadyPeaks::kSampled;
      kinds[{isSymmetric(designs_[i].vehicle), hasConstant(rail),
             sampled ? ordersOf(number, rail) : std::vector<int>{}, rail.angular_frequency.size()}]
          .push_back(static_cast<int>(i));
    }
    std::vector<int> failed;
    for (const auto& [kind, order] : kinds) addKind(kind, order, railOf, number, result, failed);
    std::sort(failed.begin(), failed.end());
    for (const int design : failed) result.failures.push_back({static_cast<int>(number), design});
  }

 private:
  template <class RailOf>
  void addKind(const Kind& kind, const std::vector<int>& order, const RailOf& railOf, std::size_t number,
               SteadyResult& result, std::vector<int>& failed) {
    const auto& [symmetric, constant, orders, F] = kind;
    const auto lanes = static_cast<std::size_t>(kernels_.lanes);
    const auto K = run_.columns.size();
    const Choice choice = columns_.get();
    BlockRows rows(designs_, order, kernels_.lanes, columns_.count());
    HarmonicRows harmonics(lanes, F, constant);
    const bool keeps = run_.amplitudes == SteadyAmplitudes::kKept;
    const bool samples_peaks = run_.peaks == SteadyPeaks::kSampled;
    AlignedDoubles amplitude(keeps || samples_peaks ? static_cast<std::size_t>(harmonics.count()) * K * 2 * lanes : 0);
    const int highest = orders.empty() ? 1 : *std::max_element(orders.begin(), orders.end());
    const int samples = kSamplesPerPeriod * highest;
    const std::vector<double> circle =
        samples_peaks ? circleOf(orders, samples, harmonics.constant()) : std::vector<double>{};
    const InputSegment* last = nullptr;  // the rail in all lanes, or null
    for (int b = 0; b < rows.blocks(); ++b) {
      const auto begin = static_cast<std::size_t>(b) * lanes;
      const std::size_t used = std::min(lanes, order.size() - begin);
      setRails(order, begin, used, railOf, harmonics, last);
      SteadyBlock block = rows.steadyBlock(b);
      std::fill_n(block.metrics, K * ensemble::kMetricRows * lanes, 0.0);
      block.amplitude = amplitude.size() == 0 ? nullptr : amplitude.data();
      if (run_.doubts == SteadyDoubts::kIgnored) block.range = nullptr;
      kernels_.steady(block, choice, harmonics.data(), harmonics.count(), symmetric);
      if (samples_peaks) kernels_.extremes(block, choice, circle.data(), harmonics.count(), samples);
      for (std::size_t lane = 0; lane < used; ++lane) {
        const auto design = static_cast<std::size_t>(order[begin + lane]);
        const int place = static_cast<int>(begin + lane);
        if (block.range != nullptr) {
          result.doubts[number * designs_.size() + design] = {rows.range(place, 0) > 0.0, rows.range(place, 1) > 0.0};
        }
        if (!summarise(rows, place, design, number, result)) {
          failed.push_back(static_cast<int>(design));
        }
        if (!keeps) continue;
        std::complex<double>* kept = result.amplitudes[number].data() + design * K * F;
        for (std::size_t k = 0; k < K; ++k) {
          for (std::size_t f = 0; f < F; ++f) {
            const double* x = amplitude.data() + ((f + harmonics.constant()) * K + k) * 2 * lanes + lane;
            kept[k * F + f] = {x[0], x[lanes]};
          }
        }
      }
    }
  }

  template <class RailOf>
  void setRails(const std::vector<int>& order, std::size_t begin, std::size_t used, const RailOf& railOf,
                HarmonicRows& harmonics, const InputSegment*& last) const {
    const InputSegment* first = &railOf(static_cast<std::size_t>(order[begin]));
    bool one_rail = true;
    for (std::size_t lane = 0; lane < used; ++lane) {
      one_rail = one_rail && &railOf(static_cast<std::size_t>(order[begin + lane])) == first;
    }
    if (one_rail && first == last) return;
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(kernels_.lanes); ++lane) {
      harmonics.set(lane, railOf(static_cast<std::size_t>(order[begin + std::min(lane, used - 1)])));
    }
    last = one_rail ? first : nullptr;
  }

  bool summarise(const BlockRows& rows, int lane, std::size_t design, std::size_t number, SteadyResult& result) const {
    const auto K = run_.columns.size();
    ColumnSummary* summaries = result.summaries.data() + (number * designs_.size() + design) * K;
    bool finite = true;
    for (std::size_t k = 0; k < K; ++k) {
      const int column = static_cast<int>(k);
      // Static loads are no answer to the rail: they join the mean here.
      const int wheel = static_cast<int>(run_.columns[k]) - static_cast<int>(FlatColumn::kWheel1Load);
      const bool is_load = wheel >= 0 && wheel <= 6 && wheel % 2 == 0;
      const double load = is_load ? designs_[design].wheel_load[static_cast<std::size_t>(wheel / 2)] : 0.0;
      const double mean = rows.metric(lane, column, 0) + load;
      summaries[k] = {mean, std::sqrt(mean * mean + rows.metric(lane, column, 1)), 0.0, 0.0};
      if (run_.peaks == SteadyPeaks::kSampled) {
        summaries[k].lowest = rows.metric(lane, column, 2) + load;
        summaries[k].highest = rows.metric(lane, column, 3) + load;
      }
      finite = finite && std::isfinite(summaries[k].rms);
    }
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    if (!finite) std::fill_n(summaries, K, ColumnSummary{kNan, kNan, kNan, kNan});
    return finite;
  }

  std::span<const EnsembleDesign> designs_;
  const SteadyRun& run_;
  ColumnChoice columns_;
  const Kernels& kernels_;
};

}  // namespace

SteadyResult steadyEnsemble(std::span<const EnsembleDesign> designs, std::span<const InputSegment* const> rails,
                            const SteadyRun& run) {
  SteadyResult result;
  result.summaries.resize(rails.size() * designs.size() * run.columns.size());
  if (run.doubts == SteadyDoubts::kTold) result.doubts.resize(rails.size() * designs.size());
  Computation computation(designs, run);
  for (std::size_t number = 0; number < rails.size(); ++number) {
    checkRail(number, rails[number]);
    if (run.amplitudes == SteadyAmplitudes::kKept) {
      result.amplitudes.emplace_back(designs.size() * run.columns.size() * rails[number]->angular_frequency.size());
    }
    computation.add([&](std::size_t) -> const InputSegment& { return *rails[number]; }, number, result);
  }
  return result;
}

SteadyResult steadyEnsembleEach(std::span<const EnsembleDesign> designs, std::span<const InputSegment* const> rails,
                                const SteadyRun& run) {
  if (rails.size() != designs.size()) {
    throw std::invalid_argument("steady ensemble: " + std::to_string(rails.size()) + " rails for " +
                                std::to_string(designs.size()) + " designs, must be one a design");
  }
  SteadyResult result;
  result.summaries.resize(designs.size() * run.columns.size());
  if (run.doubts == SteadyDoubts::kTold) result.doubts.resize(designs.size());
  for (std::size_t i = 0; i < rails.size(); ++i) checkRail(i, rails[i]);
  if (run.amplitudes == SteadyAmplitudes::kKept && !rails.empty()) {
    const std::size_t F = rails[0]->angular_frequency.size();
    for (std::size_t i = 0; i < rails.size(); ++i) {
      if (rails[i]->angular_frequency.size() == F) continue;
      throw std::invalid_argument(place(i) + "has " + std::to_string(rails[i]->angular_frequency.size()) +
                                  " harmonics, must have " + std::to_string(F) +
                                  " as the first one where amplitudes are kept");
    }
    result.amplitudes.emplace_back(designs.size() * run.columns.size() * F);
  }
  Computation(designs, run).add([&](std::size_t design) -> const InputSegment& { return *rails[design]; }, 0, result);
  return result;
}

}  // namespace vehicle
