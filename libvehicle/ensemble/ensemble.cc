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

using ensemble::Block;
using ensemble::BlockRows;
using ensemble::Choice;
using ensemble::ColumnChoice;

constexpr int kMostDesigns = 2048;                      // laid out at once
constexpr double kMostStored = 64.0 * 1024.0 * 1024.0;  // [bytes] of histories at once

std::string text(double value) {
  std::ostringstream out;
  out.precision(12);
  out << value;
  return out.str();
}

Sampling samplingOf(const EnsembleRun& run) {
  if (!(run.settle >= 0.0) || !std::isfinite(run.settle)) {
    throw std::invalid_argument("ensemble: settle = " + text(run.settle) + " s, must be finite and >= 0");
  }
  Sampling sampling{.output_step = run.output_step, .fastest = run.fastest, .steps = run.steps};
  if (run.settle > 0.0 && run.output_step > 0.0) {
    sampling.count_from = SampleGrid(0.0, run.output_step).time(firstCounted(run.settle, run.output_step));
  }
  return sampling;
}

/// Number of the first point of the regular grid that counts.
int firstPoint(const EnsembleRun& run, int cut) { return firstCounted(run.settle, run.output_step) * cut; }

Schedule scheduleOf(const Input& rail, const EnsembleRun& run) {
  if (rail.channels() != 4) {
    throw std::invalid_argument("ensemble: the rail has " + std::to_string(rail.channels()) +
                                " channels, must have 4, one a wheelset");
  }
  const Sampling sampling = samplingOf(run);
  Schedule schedule(rail, sampling);
  const double length = rail.end() - rail.begin();
  if (sampling.count_from >= length * (1.0 - kSameInstant)) {
    throw std::invalid_argument("ensemble: settle = " + text(run.settle) + " s leaves nothing of a run of " +
                                text(length) + " s; settle less or run longer");
  }
  return schedule;
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
// @param measured  [s] that counts, of each   @param time  of a sample, of each
template <class Measured, class Time>
void summarise(const BlockRows& rows, int first, int columns, const Measured& measured, const Time& time,
               EnsembleResult& result) {
  for (int i = 0; i < rows.used(); ++i) {
    const double length = measured(i);
    result.extents[static_cast<std::size_t>(first + i)] = {rows.range(i, 0), rows.range(i, 1)};
    bool finite = true;
    ColumnSummary* summaries =
        result.summaries.data() + static_cast<std::size_t>(first + i) * static_cast<std::size_t>(columns);
    for (int k = 0; k < columns; ++k) {
      // Rounding may leave less than nothing of a column of zeros; NaN stays NaN.
      const double square = rows.metric(i, k, 1) / length;
      summaries[k] = {rows.metric(i, k, 0) / length, std::sqrt(square < 0.0 ? 0.0 : square), rows.metric(i, k, 2),
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
    result.extents[static_cast<std::size_t>(first + i)] = {};
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

// Designs with a rail each, batch by batch.
class OwnRails {
 public:
  OwnRails(std::span<const EnsembleDesign> designs, std::span<const Input* const> rails, const EnsembleRun& run,
           const StoredBlockSink& store)
      : designs_(designs),
        rails_(rails),
        run_(run),
        store_(store),
        columns_(run.columns),
        kernels_(ensemble::kernelsOf(run.isa)) {
    result_.summaries.resize(designs.size() * run.columns.size());
    result_.extents.resize(designs.size());
  }

  EnsembleResult run() {
    const int total = static_cast<int>(designs_.size());
    for (int first = 0; first < total;) {
      plans_.clear();
      const Batch batch = batchFrom(first, total);
      runBatch(batch);
      first += batch.count;
    }
    return std::move(result_);
  }

 private:
  struct Batch {
    int first = 0;    // design
    int count = 0;    // designs
    int longest = 0;  // samples that count, of the longest run
  };

  const ensemble::LanePlan& planOf(int design) {
    const Input* rail = rails_[static_cast<std::size_t>(design)];
    std::unique_ptr<ensemble::LanePlan>& plan = plans_[rail];
    if (!plan) {
      plan = std::make_unique<ensemble::LanePlan>(*rail, scheduleOf(*rail, run_), run_.step);
      if (cut_ == 0) cut_ = plan->cut;
      if (plan->cut != cut_) {
        throw std::invalid_argument("ensemble: an output step has " + std::to_string(plan->cut) +
                                    " points over one rail, " + std::to_string(cut_) + " over another; run them apart");
      }
      first_stored_ = firstPoint(run_, cut_);
    }
    return *plan;
  }

  [[nodiscard]] int storedOf(const ensemble::LanePlan& plan) const { return plan.points - first_stored_; }

  // A batch that stores is as large as its longest history lets it be.
  Batch batchFrom(int first, int total) {
    Batch batch{first, 0, 0};
    while (first + batch.count < total) {
      const int room = std::max(batch.longest, storedOf(planOf(first + batch.count)));
      if (batch.count > 0 && batch.count >= batchOf(run_, kernels_.lanes, room, static_cast<bool>(store_))) break;
      batch.longest = room;
      ++batch.count;
    }
    return batch;
  }

  void runBatch(const Batch& batch) {
    const std::vector<int> order = range(batch.first, batch.count);
    BlockRows rows(designs_, order, kernels_.lanes, columns_.count());
    Storage storage(static_cast<bool>(store_), rows, columns_.count(), batch.longest);
    for (int b = 0; b < rows.blocks(); ++b) runBlock(batch, b, rows, storage);
    std::vector<int> samples;
    for (int i = 0; i < batch.count; ++i) {
      const ensemble::LanePlan& plan = planOf(batch.first + i);
      samples.push_back(storedOf(plan));
      for (const auto& piece : plan.pieces) result_.steps += static_cast<long>(piece.steps) * piece.intervals;
    }
    const auto measured = [&](int i) { return planOf(batch.first + i).measured; };
    const auto time = [&](int i, int sample) {
      const ensemble::LanePlan& plan = planOf(batch.first + i);
      return plan.time(sample >= 0 ? sample : plan.points - 1);
    };
    summarise(rows, batch.first, columns_.count(), measured, time, result_);
    storage.handOut(store_, batch.first, samples);
  }

  void runBlock(const Batch& batch, int index, BlockRows& rows, Storage& storage) {
    std::vector<const ensemble::LanePlan*> plans;
    std::vector<const FlatParameters*> vehicles;
    for (int lane = 0; lane < kernels_.lanes; ++lane) {
      const int design = batch.first + std::min(index * kernels_.lanes + lane, batch.count - 1);
      plans.push_back(&planOf(design));
      vehicles.push_back(&designs_[static_cast<std::size_t>(design)].vehicle);
    }
    Block block = rows.block(index);
    block.stored = storage.of(index);
    ensemble::LaneRun(plans, vehicles).run(kernels_, block, columns_.get(), first_stored_);
  }

  std::span<const EnsembleDesign> designs_;
  std::span<const Input* const> rails_;
  const EnsembleRun& run_;
  const StoredBlockSink& store_;
  ColumnChoice columns_;
  const ensemble::Kernels& kernels_;
  int cut_ = 0;                                                        // points of an output step
  int first_stored_ = 0;                                               // point
  std::map<const Input*, std::unique_ptr<ensemble::LanePlan>> plans_;  // of the batch, one a distinct rail
  EnsembleResult result_;
};

}  // namespace

int firstCounted(double settle, double output_step) {
  return static_cast<int>(std::min(std::ceil(settle / output_step - kSameInstant), 1e9));
}

void StoredBlock::copyColumn(int design, int column, std::vector<double>& values) const {
  values.resize(static_cast<std::size_t>(samples(design)));
  for (int i = 0; i < samples(design); ++i) values[static_cast<std::size_t>(i)] = at(design, column, i);
}

int ensembleCut(const Input& rail, const EnsembleRun& run) { return Schedule(rail, samplingOf(run)).cut(); }

EnsembleResult runEnsemble(std::span<const EnsembleDesign> designs, const Input& rail, const EnsembleRun& run,
                           const StoredBlockSink& store) {
  checkIsa(run.isa);
  const Schedule schedule = scheduleOf(rail, run);
  const ColumnChoice columns(run.columns);
  const Choice choice = columns.get();
  const ensemble::Kernels& kernels = ensemble::kernelsOf(run.isa);
  const ensemble::LanePlan grid(rail, schedule, run.step);
  const int first_stored = firstPoint(run, schedule.cut());
  const int stored = grid.points - first_stored;
  const int total = static_cast<int>(designs.size());
  const int batch = batchOf(run, kernels.lanes, stored, static_cast<bool>(store));

  EnsembleResult result;
  result.summaries.resize(designs.size() * run.columns.size());
  result.extents.resize(designs.size());
  for (int first = 0; first < total; first += batch) {
    const std::vector<int> order = range(first, std::min(batch, total - first));
    BlockRows rows(designs, order, kernels.lanes, columns.count(), kernels.packs);
    Storage storage(static_cast<bool>(store), rows, columns.count(), stored);
    ensemble::SharedRail pieces(rail, schedule, run.step, first_stored);
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
    summarise(
        rows, first, columns.count(), [&](int) { return grid.measured; },
        [&](int, int sample) { return schedule.time(sample >= 0 ? sample : schedule.samples() - 1); }, result);
    storage.handOut(store, first, std::vector<int>(order.size(), stored));
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
  return OwnRails(designs, rails, run, store).run();
}

}  // namespace vehicle
