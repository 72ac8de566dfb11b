#include "libvehicle/ensemble/ensemble.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>

#include "libvehicle/ensemble/block_rows.h"
#include "libvehicle/ensemble/lane_rail.h"
#include "libvehicle/ensemble/shared_rail.h"

namespace vehicle {
namespace {

using ensemble::BlockRows;
using ensemble::Block;
using ensemble::Choice;
using ensemble::ColumnChoice;

constexpr int kMostDesigns = 2048;                         // laid out at once
constexpr double kMostStored = 64.0 * 1024.0 * 1024.0;     // [bytes] of histories at once
constexpr double kSameInstant = 1e-9;                      // of an output step

std::string text(double value) {
  std::ostringstream out;
  out.precision(12);
  out << value;
  return out.str();
}

// Number of the first sample that counts.
int firstCounted(const EnsembleRun& run) {
  if (!(run.settle >= 0.0) || !std::isfinite(run.settle)) {
    throw std::invalid_argument("ensemble: settle = " + text(run.settle) + " s, must be finite and >= 0");
  }
  return static_cast<int>(std::min(std::ceil(run.settle / run.output_step - kSameInstant), 1e9));
}

void checkRail(const Input& rail, const Schedule& schedule, const EnsembleRun& run) {
  if (rail.channels() != 4) {
    throw std::invalid_argument("ensemble: the rail has " + std::to_string(rail.channels()) +
                                " channels, must have 4, one a wheelset");
  }
  if (firstCounted(run) >= schedule.samples()) {
    throw std::invalid_argument("ensemble: settle = " + text(run.settle) + " s leaves no sample of a run of " +
                                text((schedule.samples() - 1) * run.output_step) + " s; settle less or run longer");
  }
}

void checkIsa(Isa isa) {
  if (supports(isa)) return;
  throw std::invalid_argument("ensemble: this machine has no instruction set \"" + std::string(nameOf(isa)) +
                              "\"; take \"" + std::string(nameOf(bestIsa())) + "\"");
}

// Designs that are laid out at once.
int batchOf(const EnsembleRun& run, int lanes, int counted_samples, bool stores) {
  if (!stores || run.columns.empty()) return kMostDesigns;
  const double of_one = 8.0 * counted_samples * static_cast<double>(run.columns.size());
  const int fits = static_cast<int>(std::min<double>(kMostDesigns, kMostStored / of_one));
  return std::max(1, fits / lanes) * lanes;
}

std::vector<int> range(int first, int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

// What was gathered of some designs, as means and extremes.
// @param counted  samples that count, of each   @param time  of a sample, of each
template <class Counted, class Time>
void summarise(const BlockRows& rows, int first, int columns, const Counted& counted, const Time& time,
               EnsembleResult& result) {
  for (int i = 0; i < rows.used(); ++i) {
    const double n = counted(i);
    bool finite = true;
    ColumnSummary* summaries =
        result.summaries.data() + static_cast<std::size_t>(first + i) * static_cast<std::size_t>(columns);
    for (int k = 0; k < columns; ++k) {
      summaries[k] = {rows.metric(i, k, 0) / n, std::sqrt(rows.metric(i, k, 1) / n), rows.metric(i, k, 2),
                      rows.metric(i, k, 3)};
      finite = finite && std::isfinite(summaries[k].mean) && std::isfinite(summaries[k].rms);
    }
    const double failed = rows.failedAt(i);
    if (failed == std::numeric_limits<double>::infinity() && finite) continue;
    // A motion may stay finite to the end while its square does not.
    const int sample = std::isfinite(failed) ? static_cast<int>(failed) : -1;
    result.failures.push_back({first + i, time(i, sample)});
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    std::fill_n(summaries, columns, ColumnSummary{kNan, kNan, kNan, kNan});
  }
}

// Histories of a batch, one room of samples for each block of lanes.
class Storage {
 public:
  Storage(bool stores, const BlockRows& rows, int columns, int room) : columns_(columns), room_(room), rows_(rows) {
    if (stores) values_ = ensemble::AlignedDoubles(offset(rows.blocks()));
  }
  double* of(int block) { return values_.size() == 0 ? nullptr : values_.data() + offset(block); }
  void handOut(const StoredBlockSink& store, int first, const std::vector<int>& samples) const {
    if (values_.size() == 0) return;
    store(StoredBlock(first, rows_.used(), rows_.lanes(), columns_, samples.data(), room_, values_.data()));
  }

 private:
  std::size_t offset(int block) const {
    return static_cast<std::size_t>(block) * static_cast<std::size_t>(room_) * static_cast<std::size_t>(columns_) *
           static_cast<std::size_t>(rows_.lanes());
  }
  int columns_, room_;
  const BlockRows& rows_;
  ensemble::AlignedDoubles values_;
};

}  // namespace

void StoredBlock::copyColumn(int design, int column, std::vector<double>& values) const {
  values.resize(static_cast<std::size_t>(samples(design)));
  for (int i = 0; i < samples(design); ++i) values[static_cast<std::size_t>(i)] = at(design, column, i);
}

EnsembleResult runEnsemble(std::span<const EnsembleDesign> designs, const Input& rail, const EnsembleRun& run,
                           const StoredBlockSink& store) {
  checkIsa(run.isa);
  const Schedule schedule(rail, run.output_step);
  checkRail(rail, schedule, run);
  const ColumnChoice columns(run.columns);
  const Choice choice = columns.get();
  const ensemble::Kernels& kernels = ensemble::kernelsOf(run.isa);
  const int first_counted = firstCounted(run);
  const int counted = schedule.samples() - first_counted;
  const int total = static_cast<int>(designs.size());
  const int batch = batchOf(run, kernels.lanes, counted, static_cast<bool>(store));

  EnsembleResult result;
  result.summaries.resize(designs.size() * run.columns.size());
  for (int first = 0; first < total; first += batch) {
    const std::vector<int> order = range(first, std::min(batch, total - first));
    BlockRows rows(designs, order, kernels.lanes, columns.count(), kernels.packs);
    Storage storage(static_cast<bool>(store), rows, columns.count(), counted);
    ensemble::SharedRail pieces(rail, schedule, run.step, first_counted, columns.readsRail());
    while (pieces.next()) {
      for (int b = 0; b < rows.blocks(); b += kernels.packs) {
        std::vector<Block> blocks;
        for (int i = b; i < b + kernels.packs; ++i) {
          blocks.push_back(rows.block(i));
          blocks.back().stored = storage.of(i);
        }
        kernels.runShared(blocks.data(), choice, pieces.legs().data(), static_cast<int>(pieces.legs().size()));
      }
    }
    result.steps += pieces.steps() * rows.used();
    summarise(rows, first, columns.count(), [&](int) { return counted; },
              [&](int, int sample) { return schedule.time(sample >= 0 ? sample : schedule.samples() - 1); }, result);
    storage.handOut(store, first, std::vector<int>(order.size(), counted));
  }
  return result;
}

EnsembleResult runEnsemble(std::span<const EnsembleDesign> designs, std::span<const Input* const> rails,
                           const EnsembleRun& run, const StoredBlockSink& store) {
  checkIsa(run.isa);
  if (rails.size() != designs.size() || std::find(rails.begin(), rails.end(), nullptr) != rails.end()) {
    throw std::invalid_argument("ensemble: " + std::to_string(rails.size()) + " rails for " +
                                std::to_string(designs.size()) + " designs, must be one a design and none null");
  }
  const ColumnChoice columns(run.columns);
  const Choice choice = columns.get();
  const ensemble::Kernels& kernels = ensemble::kernelsOf(run.isa);
  const int first_counted = firstCounted(run);
  const int total = static_cast<int>(designs.size());

  EnsembleResult result;
  result.summaries.resize(designs.size() * run.columns.size());
  for (int first = 0; first < total;) {
    // Plans of the batch, one a distinct rail; a batch that stores is as large as its longest history lets it be.
    std::map<const Input*, std::unique_ptr<ensemble::LanePlan>> plans;
    int longest = 0;
    const auto planOf = [&](int design) -> const ensemble::LanePlan& {
      const Input* rail = rails[static_cast<std::size_t>(design)];
      std::unique_ptr<ensemble::LanePlan>& plan = plans[rail];
      if (!plan) {
        const Schedule schedule(*rail, run.output_step);
        checkRail(*rail, schedule, run);
        plan = std::make_unique<ensemble::LanePlan>(*rail, schedule, run.step);
      }
      return *plan;
    };
    int count = 0;
    while (first + count < total) {
      const int room = std::max(longest, planOf(first + count).samples - first_counted);
      if (count > 0 && count >= batchOf(run, kernels.lanes, room, static_cast<bool>(store))) break;
      longest = room;
      ++count;
    }
    const std::vector<int> order = range(first, count);
    BlockRows rows(designs, order, kernels.lanes, columns.count());
    Storage storage(static_cast<bool>(store), rows, columns.count(), longest);
    for (int b = 0; b < rows.blocks(); ++b) {
      std::vector<const ensemble::LanePlan*> lane_plans;
      std::vector<const FlatParameters*> vehicles;
      for (int lane = 0; lane < kernels.lanes; ++lane) {
        const int design = first + std::min(b * kernels.lanes + lane, count - 1);
        lane_plans.push_back(&planOf(design));
        vehicles.push_back(&designs[static_cast<std::size_t>(design)].vehicle);
      }
      Block block = rows.block(b);
      block.stored = storage.of(b);
      ensemble::LaneRun(lane_plans, vehicles).run(kernels, block, choice, first_counted);
    }
    std::vector<int> samples;
    for (int i = 0; i < count; ++i) {
      const ensemble::LanePlan& plan = planOf(first + i);
      samples.push_back(plan.samples - first_counted);
      for (const auto& piece : plan.pieces) result.steps += static_cast<long>(piece.steps) * piece.stretches;
    }
    summarise(rows, first, columns.count(), [&](int i) { return samples[static_cast<std::size_t>(i)]; },
              [&](int i, int sample) {
                const ensemble::LanePlan& plan = planOf(first + i);
                return plan.time(sample >= 0 ? sample : plan.samples - 1);
              },
              result);
    storage.handOut(store, first, samples);
    first += count;
  }
  return result;
}

}  // namespace vehicle
