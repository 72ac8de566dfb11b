#pragma once

// The input of a run, block by block, computed by whoever has time.
//
//   slots     | 12 ready | 13 ready | 14 claimed by 2 | 15 claimed by 1 | 8 open ... | 11 read by member 0 |
//
// Member 0 steps and wants parcel after parcel; the others compute them ahead. Parcel p lives in slot p mod S,
// whose one atomic word says which parcel it is about and how far: open -> claimed -> ready -> open for p + S.
//
// 1. Claiming is one compare-exchange from open(p) to claimed(p): exactly one thread wins and writes the rows. It then
//    stores ready(p) (release); member 0 loads it (acquire) before it reads them, so the rows are whole.
// 2. Member 0 alone opens a slot again, by a store (release) after its last read; the next claim is an acquire. So
//    a slot is overwritten only after it was read. Nobody else ever leaves `claimed`, so a word cannot come back.
// 3. Nobody is waited for who might not run. Where the next parcel is open, member 0 takes it out of the slot and
//    computes it into a buffer of its own; where it is claimed, it computes later ones meanwhile, like everybody; and
//    where there is none left either, it waits kPatience and then computes the parcel again, into its own buffer: the
//    slot stays with the thread that claimed it, out of service until that has finished.
// 4. Every thread calls the same sweep for the same parcel, and Input::sweep depends on where a block lies in its grid
//    alone: rows have the same bits whoever computes them, so who was faster leaves no trace.
// 5. No fence, and no order between two different words is used: each arrow is one store and the load that saw it.

#include <atomic>
#include <chrono>
#include <functional>
#include <vector>

#include "libvehicle/integrate/step_walk.h"
#include "libvehicle/threads/team.h"

namespace vehicle {

/// Rows of the input at the half steps of a block: block.rows() of 2 w values.
using BlockRows = std::function<void(const StepBlock& block, double* u)>;

/// The blocks of FixedSteps in order, gathered to parcels of about kStepsPerBlock steps: a run along a broken or
/// stored rail has blocks of a few steps, each not worth handing over.
class InputParcels {
 public:
  InputParcels(const Schedule& schedule, FixedStep step);

  [[nodiscard]] long count() const { return count_; }
  /// Most rows of one parcel.
  [[nodiscard]] int mostRows() const { return most_rows_; }
  /// The blocks of a parcel. @param blocks  overwritten; holds kStepsPerBlock at most
  void read(long parcel, std::vector<StepBlock>& blocks) const;
  /// Steps of the run that a parcel is for.
  struct Steps {
    long first = 0;
    long last = 0;  // one past
  };
  [[nodiscard]] Steps stepsOf(long parcel) const;

 private:
  struct Grid {
    int segment = 0;
    double begin = 0.0;  // [s]
    double h = 0.0;      // [s]
    int steps = 0;
  };
  struct Group {  // one grid of many parcels, or several of one parcel together
    long first_parcel = 0;
    std::size_t first_grid = 0;
    std::size_t last_grid = 0;
    long first_step = 0;  // of the run
    long last_step = 0;   // one past
  };
  const Group& groupOf(long parcel) const;

  std::vector<Grid> grids_;
  std::vector<Group> groups_;
  long count_ = 0;
  int most_rows_ = 0;
};

/// What one run's helpers did; for reports and tests.
struct AheadCounts {
  long taken = 0;   // parcels that a helper had ready in time
  long own = 0;     // that member 0 computed when it wanted them
  long shared = 0;  // that member 0 computed ahead
  long redone = 0;  // of `own`: computed again because their helper did not come back
};

/// Rows of all parcels on their way from the threads that compute them to member 0.
class InputAhead {
 public:
  static constexpr int kMostSlots = 16;
  static constexpr std::size_t kMostBytes = std::size_t{1} << 26;  // of all slots; but there are two at least
  static constexpr std::chrono::microseconds kPatience{300};

  /// @param width  values of a row   @param rows  called by any thread, by several at a time
  InputAhead(const Schedule& schedule, FixedStep step, int width, const BlockRows& rows);

  /// Member 0, at every block of the walk in order: its rows. Valid until the next call.
  const double* enter(Member& me, const StepBlock& block);

  /// Every other member: computes parcels until there are none left.
  void help(Member& me);

  [[nodiscard]] const AheadCounts& counts() const { return counts_; }

 private:
  enum Phase : long { kOpen, kClaimed, kReady, kPhases };
  static constexpr long word(long parcel, Phase phase) { return kPhases * parcel + phase; }

  struct alignas(128) Slot {
    std::atomic<long> state{0};
    std::atomic<int> owner{0};  // of the latest claim, for the trace
    std::vector<double> rows;
  };
  /// Values of the rows of one parcel, at most.
  [[nodiscard]] std::size_t mostValues() const { return static_cast<std::size_t>(parcels_.mostRows()) * width_; }
  Slot& slotOf(long parcel) { return slots_[static_cast<std::size_t>(parcel % count_)]; }

  const double* acquire(Member& me);
  bool isReadyInTime(Member& me, Slot& slot);
  void release(Member& me);
  bool computeIfOpen(Member& me, long parcel, std::vector<StepBlock>& blocks);
  void compute(long parcel, std::vector<StepBlock>& blocks, double* u) const;

  const InputParcels parcels_;
  const std::size_t width_;
  const BlockRows& rows_;
  const long count_;  // of slots
  std::vector<Slot> slots_;
  alignas(128) std::atomic<long> done_{0};  // parcels that member 0 has left behind

  // Member 0's alone.
  alignas(128) long parcel_ = -1;
  long ahead_ = 0;               // no parcel before it is open
  bool from_slot_ = false;
  std::size_t block_ = 0;        // of the parcel
  const double* next_ = nullptr;  // rows of the next block
  std::vector<StepBlock> blocks_;
  std::vector<StepBlock> scratch_;
  std::vector<double> own_;
  AheadCounts counts_;
};

}  // namespace vehicle
