#include "libvehicle/threads/waiting.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <thread>

#include "libvehicle/threads/trace.h"

namespace vehicle {

namespace {

// About 60 us of pauses: longer than any exchange of microseconds lasts, shorter than a turn of the scheduler.
constexpr int kLongPauses = 2000;
// Threads take turns on the other cores too: about as long as one change of threads takes (1.3 us).
constexpr int kTurnPauses = 48;
constexpr int kShortPauses = 64;
constexpr int kYields = 1000;
// Linux adds its timer slack of 50 us to whatever is asked; less would only burn system calls.
constexpr double kSleep = 50e-6;  // [s]
// Another thread of the team gives the core back within microseconds, a stranger keeps it for milliseconds.
constexpr std::uint64_t kLongYield = 300'000;  // [ticks] 0.1 to 0.3 ms

void requireCounts(int threads, int cores) {
  if (threads < 1) throw std::invalid_argument("waiting: threads = " + std::to_string(threads) + ", must be >= 1");
  if (cores < 1) throw std::invalid_argument("waiting: cores = " + std::to_string(cores) + ", must be >= 1");
}

}  // namespace

const std::vector<std::string>& waitingNames() {
  static const std::vector<std::string> names = {"auto", "spin", "yield", "sleep"};
  return names;
}

const char* nameOf(WaitingKind kind) { return waitingNames()[static_cast<std::size_t>(kind)].c_str(); }

WaitingKind waitingKindOf(const std::string& name) {
  const std::vector<std::string>& names = waitingNames();
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<WaitingKind>(found - names.begin());
  std::string message = "unknown waiting \"" + name + "\"; must be ";
  for (std::size_t i = 0; i < names.size(); ++i) message += (i == 0 ? "" : " | ") + names[i];
  throw std::invalid_argument(message);
}

Waiting waitingFor(WaitingKind kind, int threads, int cores) {
  requireCounts(threads, cores);
  switch (kind) {
    case WaitingKind::kAuto:
      break;
    case WaitingKind::kSpin:
      if (threads > cores) {
        throw std::invalid_argument("waiting \"spin\": " + std::to_string(threads) + " threads on " +
                                    std::to_string(cores) + (cores == 1 ? " core" : " cores") +
                                    " would keep each other from running; take at most " + std::to_string(cores) +
                                    ", or auto | yield | sleep");
      }
      return {.pauses = Waiting::kForever, .yields = 0, .sleep = 0.0};
    case WaitingKind::kYield:
      return {.pauses = kShortPauses, .yields = Waiting::kForever, .sleep = 0.0};
    case WaitingKind::kSleep:
      return {.pauses = kShortPauses, .yields = 0, .sleep = kSleep};
  }
  return {.pauses = threads <= cores ? kLongPauses : kTurnPauses, .yields = kYields, .sleep = kSleep};
}

bool givesWay(const Waiting& waiting) {
  return waiting.pauses != Waiting::kForever && waiting.yields != Waiting::kForever && waiting.sleep > 0.0;
}

void YieldMemory::yield() {
  const std::uint64_t begin = stampTicks();
  std::this_thread::yield();
  if (stampTicks() - begin > kLongYield) waits_without_ = kWaitsWithout;
}

bool Patience::giveWay() {
  const bool may_block = waiting_->sleep > 0.0 && waiting_->yields != Waiting::kForever;
  if (may_block && (yielded_ >= waiting_->yields || !memory_->mayYield())) return false;
  yielded_ = std::min(yielded_, Waiting::kForever - 1) + 1;
  memory_->yield();
  return true;
}

}  // namespace vehicle
