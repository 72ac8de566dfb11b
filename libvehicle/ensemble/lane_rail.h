#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libvehicle/ensemble/block_rows.h"
#include "libvehicle/ensemble/kernel.h"
#include "libvehicle/integrate/run.h"
#include "libvehicle/system/schedule.h"

namespace vehicle::ensemble {

/// The grid of a run over one rail, as runFixedStep() walks it, in pieces of equal steps inside one segment.
struct LanePlan {
  struct Piece {
    int segment = 0;
    int next = 0;          // the segment that holds right after it
    double begin = 0.0;    // [s]
    double h = 0.0;        // [s]
    int steps = 0;         // of a stretch
    int stretches = 1;
    bool whole = false;    // stretches are whole output steps, each with a sample at its end
    bool sample = false;   // a sample at its end
  };
  const Input* input = nullptr;
  std::vector<Piece> pieces;
  int samples = 0;
  double output_step = 0.0;  // [s]

  LanePlan(const Input& rail, const Schedule& schedule, FixedStep step);
  [[nodiscard]] double time(int sample) const { return input->begin() + sample * output_step; }
};

/// Walks the designs of one block over a rail each. Lanes meet at every output sample; on the way there, one that has
/// fewer steps than its neighbours waits with steps of size 0. What a lane computes, and when its oscillators are
/// seeded anew, depends on its own plan alone.
class LaneRun {
 public:
  /// @param plans     (lanes)
  /// @param vehicles  (lanes)
  LaneRun(std::span<const LanePlan* const> plans, std::span<const FlatParameters* const> vehicles);

  /// From the first sample of all lanes to the last of the longest.
  void run(const Kernels& kernels, const Block& block, const Choice& choice, int first_counted);

 private:
  struct Lane {
    const LanePlan* plan = nullptr;
    const FlatParameters* vehicle = nullptr;
    std::size_t piece = 0;
    int stretch = 0;            // of the piece
    int left = 0;               // steps of the stretch, within a mixed interval
    bool at_sample = true;
    std::vector<double> turn;   // (2 F) cos - 1, sin of half a step
    [[nodiscard]] bool over() const { return piece >= plan->pieces.size(); }
    [[nodiscard]] const LanePlan::Piece& now() const { return plan->pieces[piece]; }
  };

  void enter(std::size_t lane, bool new_segment);
  void seed(std::size_t lane, double t);
  void setMoving(std::size_t lane, bool moving);
  void loadSegment(std::size_t lane, int segment);
  [[nodiscard]] int commonIntervals() const;
  [[nodiscard]] bool changesSegment(const Lane& lane, int intervals) const;
  void walkUniform(int intervals);
  void walkMixed();
  void afterSample();
  void call(const LaneLeg& leg);
  double& at(AlignedDoubles& rows, std::size_t row, std::size_t lane) { return rows[row * lanes_.size() + lane]; }

  std::vector<Lane> lanes_;
  std::size_t frequencies_ = 0;
  AlignedDoubles oscillator_, wheel_, force_polynomial_, wheel_polynomial_, half_step_, time_, last_sample_;
  LaneRail rail_;

  const Kernels* kernels_ = nullptr;
  const Block* block_ = nullptr;
  const Choice* choice_ = nullptr;
  int first_counted_ = 0;
  int number_ = 0;  // of the next sample
};

}  // namespace vehicle::ensemble
