#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "libvehicle/ensemble/steady.h"
#include "libvehicle/study/evaluate/flat_block.h"
#include "libvehicle/study/evaluate/path.h"
#include "libvehicle/study/evaluate/steady_range.h"
#include "libvehicle/study/evaluate/steady_statistic.h"
#include "libvehicle/study/evaluate/summary_statistic.h"

// The steady state of the flat form under harmonics, many designs at once.
namespace vehicle {

namespace {

constexpr std::size_t kMostStatistics = 64;

bool needsPeaks(Statistic statistic) {
  return statistic == Statistic::kPeak || statistic == Statistic::kMin || statistic == Statistic::kMax;
}

class SteadyEnsemblePath final : public Path {
 public:
  explicit SteadyEnsemblePath(const StudyInputs& inputs)
      : inputs_(inputs),
        block_(inputs, Evaluation::kSteadyState),
        statistics_(std::max(kMostStatistics, inputs.bound.cases.size())) {
    for (std::size_t c = 0; c < inputs.bound.cases.size(); ++c) requests_.push_back(requestsOf(inputs.bound, c));
    run_.doubts = SteadyDoubts::kTold;
    fine_.amplitudes = SteadyAmplitudes::kKept;
    const auto addRange = [this](FlatColumn first, int count, RangeKind kind) {
      for (int i = 0; i < count; ++i) {
        range_.push_back({fine_.columns.size(), kind});
        fine_.columns.push_back(static_cast<FlatColumn>(static_cast<int>(first) + 2 * i));
      }
    };
    addRange(FlatColumn::kWheel1Load, 4, RangeKind::kLoad);
    addRange(FlatColumn::kCarbodyPitch, 1, RangeKind::kPitch);
    addRange(FlatColumn::kSecondaryFrontDeflection, 2, RangeKind::kTravel);
    addRange(FlatColumn::kPrimary1Deflection, 4, RangeKind::kTravel);
    // Every case is asked for the same columns: one run serves all.
    for (const ColumnRequest& request : requests_.front()) {
      run_.columns.push_back(block_.column(request.column));
      for (const MetricPlace& entry : request.entries) {
        if (needsPeaks(entry.metric.statistic)) run_.peaks = SteadyPeaks::kSampled;
        if (!comesFromSummary(entry.metric.statistic)) run_.amplitudes = SteadyAmplitudes::kKept;
      }
    }
  }

  void evaluate(DesignRows& rows) override {
    if (run_.columns.empty()) return;
    block_.prepare(rows);
    if (block_.alive().empty()) return;
    if (block_.railsAreShared()) {
      evaluateShared(rows);
    } else {
      for (std::size_t c = 0; c < requests_.size(); ++c) evaluateEach(c, rows);
    }
  }

 private:
  void evaluateShared(DesignRows& rows) {
    for (std::size_t group = 0; group < block_.groups(); ++group) {
      std::vector<std::size_t> cases;
      std::vector<const InputSegment*> rails;
      for (std::size_t c = 0; c < requests_.size(); ++c) {
        if (block_.groupOf(c) != group) continue;
        cases.push_back(c);
        rails.push_back(&block_.rail(c).segment(0));
      }
      const SteadyResult result = steadyEnsemble(block_.designs(group), rails, run_);
      const std::size_t designs = block_.alive().size();
      for (const SteadyFailure& each : result.failures) {
        leaveCaseEmpty(cases[static_cast<std::size_t>(each.rail)], static_cast<std::size_t>(each.design), rows);
      }
      for (std::size_t r = 0; r < cases.size(); ++r) {
        for (std::size_t i = 0; i < designs; ++i) {
          const Answer answer{result.summaries.data() + (r * designs + i) * run_.columns.size(),
                              amplitudesOf(result, r, i, *rails[r]), *rails[r]};
          write(cases[r], i, answer, rows);
          if (isInDoubt(cases[r], result.doubts[r * designs + i])) doubtful_.push_back(i);
        }
        judgeDoubtful(cases[r], [&](std::size_t) { return rails[r]; }, rows);
      }
    }
  }

  void evaluateEach(std::size_t study_case, DesignRows& rows) {
    const std::size_t designs = block_.alive().size();
    try {
      evaluateSome(study_case, 0, designs, rows);
    } catch (const std::invalid_argument&) {
      doubtful_.clear();
      // A rail without common period, or with a harmonic less, is the matter of its own design.
      for (std::size_t i = 0; i < designs; ++i) {
        try {
          evaluateSome(study_case, i, 1, rows);
        } catch (const std::invalid_argument& error) {
          leaveEmpty(requests_[study_case], block_.alive()[i], error.what(), rows);
        }
      }
    }
  }

  void evaluateSome(std::size_t study_case, std::size_t first, std::size_t count, DesignRows& rows) {
    std::vector<const InputSegment*> rails;
    for (std::size_t i = first; i < first + count; ++i) rails.push_back(&block_.rails(study_case)[i].segment(0));
    const std::vector<EnsembleDesign>& all = block_.designs(block_.groupOf(study_case));
    const SteadyResult result = steadyEnsembleEach(std::span(all).subspan(first, count), rails, run_);
    for (const SteadyFailure& each : result.failures) {
      leaveCaseEmpty(study_case, first + static_cast<std::size_t>(each.design), rows);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Answer answer{result.summaries.data() + i * run_.columns.size(), amplitudesOf(result, 0, i, *rails[i]),
                          *rails[i]};
      write(study_case, first + i, answer, rows);
      if (isInDoubt(study_case, result.doubts[i])) doubtful_.push_back(first + i);
    }
    judgeDoubtful(study_case, [&](std::size_t place) { return rails[place - first]; }, rows);
  }

  /// Without gravity loads are their dynamic part alone, and every one of them would be in doubt.
  [[nodiscard]] bool judgesLoads(std::size_t study_case) const {
    return inputs_.scenarios[inputs_.bound.cases[study_case].scenario].gravity > 0.0;
  }
  [[nodiscard]] bool isInDoubt(std::size_t study_case, const SteadyDoubt& doubt) const {
    return doubt.moves_far || (doubt.unloads && judgesLoads(study_case));
  }

  /// Looks closely at the few designs that may leave the range in this case, and forgets them.
  /// @param railOf  of a place of the block
  template <class RailOf>
  void judgeDoubtful(std::size_t study_case, RailOf railOf, DesignRows& rows) {
    if (doubtful_.empty()) return;
    const std::vector<EnsembleDesign>& all = block_.designs(block_.groupOf(study_case));
    std::vector<EnsembleDesign> designs;
    std::vector<const InputSegment*> rails;
    for (const std::size_t place : doubtful_) {
      designs.push_back(all[place]);
      rails.push_back(railOf(place));
    }
    const SteadyResult result = steadyEnsembleEach(designs, rails, fine_);
    const bool loads = judgesLoads(study_case);
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const std::size_t row = block_.alive()[doubtful_[i]];
      const std::size_t harmonics = rails[i]->angular_frequency.size();
      SteadyStatistic& statistic = statistics_.of(rails[i]->angular_frequency);
      for (const RangeColumn& each : range_) {
        if (rows.failed(row) || (each.kind == RangeKind::kLoad && !loads)) continue;
        const std::size_t place = i * fine_.columns.size() + each.column;
        const std::span amplitudes(result.amplitudes[0].data() + place * harmonics, harmonics);
        if (leavesRange(each.kind, result.summaries[place].mean, amplitudes, statistic)) {
          rows.warn(row, rangeCode(each.kind));
        }
      }
    }
    doubtful_.clear();
  }

  void leaveCaseEmpty(std::size_t study_case, std::size_t place, DesignRows& rows) const {
    leaveEmpty(requests_[study_case], block_.alive()[place],
               "no steady state: a harmonic meets an undamped mode, or nothing holds a motion", rows);
  }

  /// What came out for one design on one rail.
  struct Answer {
    const ColumnSummary* summaries;          // (columns)
    const std::complex<double>* amplitudes;  // (columns x harmonics) or null
    const InputSegment& rail;
  };

  [[nodiscard]] const std::complex<double>* amplitudesOf(const SteadyResult& result, std::size_t rail,
                                                         std::size_t design, const InputSegment& segment) const {
    if (run_.amplitudes == SteadyAmplitudes::kDropped) return nullptr;
    return result.amplitudes[rail].data() + design * run_.columns.size() * segment.angular_frequency.size();
  }

  void write(std::size_t study_case, std::size_t place, const Answer& answer, DesignRows& rows) {
    const std::size_t row = block_.alive()[place];
    if (rows.failed(row)) return;
    const std::size_t harmonics = answer.rail.angular_frequency.size();
    for (std::size_t k = 0; k < run_.columns.size(); ++k) {
      for (const MetricPlace& entry : requests_[study_case][k].entries) {
        if (rows.missing(row).contains(entry.place)) continue;  // its numbers are NaN, which must not reach a sort
        double& value = rows.metric(row, entry.place);
        if (comesFromSummary(entry.metric.statistic)) {
          value = fromSummary(entry.metric.statistic, answer.summaries[k]);
          continue;
        }
        try {
          value = statistics_.of(answer.rail.angular_frequency)(entry.metric, answer.summaries[k].mean,
                                                                {answer.amplitudes + k * harmonics, harmonics});
        } catch (const std::domain_error& error) {
          rows.leaveEmpty(row, entry.place, error.what());
        }
      }
    }
  }

  const StudyInputs& inputs_;
  FlatBlock block_;
  SteadyRun run_;
  SteadyRun fine_;                  // of designs that are in doubt
  std::vector<RangeColumn> range_;  // among the columns of fine_
  std::vector<std::size_t> doubtful_;  // places in the block
  std::vector<std::vector<ColumnRequest>> requests_;  // (cases)
  SteadyStatistics statistics_;
};

}  // namespace

std::unique_ptr<Path> makeSteadyEnsemblePath(const StudyInputs& inputs) {
  return std::make_unique<SteadyEnsemblePath>(inputs);
}

}  // namespace vehicle
