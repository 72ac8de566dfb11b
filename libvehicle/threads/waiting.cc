#include "libvehicle/threads/waiting.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

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

void requireCounts(int threads, int cores) {
  if (threads < 1) throw std::invalid_argument("waiting: threads = " + std::to_string(threads) + ", must be >= 1");
  if (cores < 1) throw std::invalid_argument("waiting: cores = " + std::to_string(cores) + ", must be >= 1");
}

}  // namespace

Waiting waitingFor(int threads, int cores) {
  requireCounts(threads, cores);
  return {.pauses = threads <= cores ? kLongPauses : kTurnPauses, .yields = kYields, .sleep = kSleep};
}

const std::vector<std::string>& waitingNames() {
  static const std::vector<std::string> names = {"auto", "spin", "yield", "sleep"};
  return names;
}

Waiting waitingNamed(const std::string& name, int threads, int cores) {
  requireCounts(threads, cores);
  if (name == "auto") return waitingFor(threads, cores);
  if (name == "yield") return {.pauses = kShortPauses, .yields = Waiting::kForever, .sleep = 0.0};
  if (name == "sleep") return {.pauses = kShortPauses, .yields = 0, .sleep = kSleep};
  if (name == "spin") {
    if (threads > cores) {
      throw std::invalid_argument("waiting \"spin\": " + std::to_string(threads) + " threads on " +
                                  std::to_string(cores) + (cores == 1 ? " core" : " cores") +
                                  " would keep each other from running; take at most " + std::to_string(cores) +
                                  ", or auto | yield | sleep");
    }
    return {.pauses = Waiting::kForever, .yields = 0, .sleep = 0.0};
  }
  std::string message = "unknown waiting \"" + name + "\"; must be ";
  for (std::size_t i = 0; i < waitingNames().size(); ++i) message += (i == 0 ? "" : " | ") + waitingNames()[i];
  throw std::invalid_argument(message);
}

bool givesWay(const Waiting& waiting) {
  return waiting.pauses != Waiting::kForever && waiting.yields != Waiting::kForever && waiting.sleep > 0.0;
}

void Patience::giveWay() {
  if (waiting_->yields == Waiting::kForever || yielded_ < waiting_->yields || waiting_->sleep <= 0.0) {
    yielded_ = std::min(yielded_, Waiting::kForever - 1) + 1;
    std::this_thread::yield();
  } else {
    std::this_thread::sleep_for(std::chrono::duration<double>(waiting_->sleep));
  }
}

}  // namespace vehicle
