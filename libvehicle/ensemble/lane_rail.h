#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libvehicle/ensemble/block_rows.h"
#include "libvehicle/ensemble/kernel.h"
#include "libvehicle/ensemble/part_looks.h"
#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/system/schedule.h"

namespace vehicle::ensemble {

/// The grid of a run over one rail, as FixedSteps walks it, in pieces of equal steps inside one part of the schedule.
struct LanePlan {
  struct Piece {
    int segment = 0;
    double begin = 0.0;  // [s]
    double h = 0.0;      // [s]
    int steps = 0;       // of an interval
    int intervals = 1;
    bool whole = false;  // intervals are whole steps of the regular grid, each ends on a point of it
    std::size_t part = 0;
    std::size_t first = 0;  // number of its first interval in that part
    bool ends_part = false;
  };
  const Input* input = nullptr;
  std::vector<Piece> pieces;
  std::vector<Schedule::Part> parts;
  std::vector<PartLooks> looks;  // (parts)
  int cut = 1;                   // points of an output step
  int points = 0;                // of the regular grid, the one at the start included
  double measured = 0.0;         // [s] that counts
  double point_step = 0.0;       // [s]

  LanePlan(const Input& rail, const Schedule& schedule, FixedStep step);
  [[nodiscard]] double time(int point) const { return input->begin() + point * point_step; }
  /// Whether an interval of a piece ends on a point of the regular grid.
  [[nodiscard]] bool endsOnPoint(const Piece& piece, int interval) const;
};

/// Walks the designs of one block over a rail each. Lanes meet at every point of the regular grid; on the way there, one
/// that has fewer steps than its neighbours waits with steps of size 0, and samples of one lane alone (both sides of a
/// breakpoint, points between those of the grid) weigh nothing in the others. What a lane computes, and when its
/// oscillators are seeded anew, depends on its own plan alone.
class LaneRun {
 public:
  /// @param plans     (lanes) with the same points of an output step
  /// @param vehicles  (lanes)
  LaneRun(std::span<const LanePlan* const> plans, std::span<const FlatParameters* const> vehicles);

  /// From the first sample of all lanes to the last of the longest.
  /// @param first_stored  number of the first point that is stored
  void run(const Kernels& kernels, const Block& block, const Choice& choice, int first_stored);

 private:
  struct Lane {
    const LanePlan* plan = nullptr;
    const FlatParameters* vehicle = nullptr;
    std::size_t piece = 0;
    int interval = 0;  // of the piece
    int left = 0;      // steps of the interval, within a mixed interval
    bool at_point = true;
    std::vector<double> turn;   // (2 F) cos - 1, sin of half a step
    [[nodiscard]] bool over() const { return piece >= plan->pieces.size(); }
    [[nodiscard]] const LanePlan::Piece& now() const { return plan->pieces[piece]; }
    /// How the sample at the end of the interval is measured that comes `further` intervals later.
    [[nodiscard]] Look<double> lookAfter(int further) const;
    [[nodiscard]] Look<double> lookAtBegin() const { return plan->looks[now().part].at(0); }
    /// Whether so many intervals on it is at the end of a part.
    [[nodiscard]] bool endsPart(int intervals) const {
      return !over() && now().ends_part && interval + intervals == now().intervals;
    }
  };

  void enter(std::size_t lane, bool new_segment);
  void seed(std::size_t lane, double t);
  void setMoving(std::size_t lane, bool moving);
  void loadSegment(std::size_t lane, int segment);
  [[nodiscard]] int commonIntervals() const;
  void walkUniform(int intervals);
  void walkMixed();
  void finishInterval(std::size_t lane);
  void nextPiece(std::size_t lane);
  void reseed();

  void clearLooks(int intervals);
  void setLook(int interval, std::size_t lane, const Look<double>& look);
  void step(int steps);
  void meet(int steps, int intervals);
  void lookAlone();
  double& at(AlignedDoubles& rows, std::size_t row, std::size_t lane) { return rows[row * lanes_.size() + lane]; }

  std::vector<Lane> lanes_;
  std::size_t frequencies_ = 0;
  AlignedDoubles oscillator_, wheel_, force_polynomial_, wheel_polynomial_, half_step_, time_, looks_;
  LaneRail rail_;
  std::vector<Look<double>> common_;  // (lanes) of the next point where all meet, in a mixed interval

  const Kernels* kernels_ = nullptr;
  const Block* block_ = nullptr;
  const Choice* choice_ = nullptr;
  int first_stored_ = 0;
  int number_ = 0;  // of the next point
  int points_ = 0;  // of the longest run
};

}  // namespace vehicle::ensemble
