#include "apps/cli/progress.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace vehicle::cli {
namespace {

// A signal handler can reach nothing but a global. Any thread may ask for it: the one that observes a shared run does.
std::atomic<bool> interrupt_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void onInterrupt(int) { interrupt_asked.store(true, std::memory_order_relaxed); }

}  // namespace

void catchInterrupt() {
  struct sigaction action = {};
  action.sa_handler = onInterrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // Under nohup a hang-up is ignored on purpose.
  struct sigaction before = {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

bool interrupted() { return interrupt_asked.load(std::memory_order_relaxed); }

ProgressBar::ProgressBar(Shown shown, double total, std::string unit)
    : enabled_(shown == Shown::kOnTerminal && isatty(STDERR_FILENO) == 1), total_(total), unit_(std::move(unit)) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

bool ProgressBar::update(double share, const std::string& what) {
  if (interrupted()) return false;
  if (!enabled_) return true;
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  constexpr double kQuietStart = 1.0;       // [s]
  constexpr double kBetweenDrawings = 0.1;  // [s]
  if (elapsed < kQuietStart || std::chrono::duration<double>(now - last_).count() < kBetweenDrawings) return true;
  last_ = now;
  constexpr int kWidth = 24;
  const int full = static_cast<int>(share * kWidth);
  std::string bar(static_cast<std::size_t>(full), '#');
  bar.resize(kWidth, '.');
  const std::string rate = fmt::format("{:.3g} {}/s", share * total_ / elapsed, unit_);
  const int left = share > 0.0 ? static_cast<int>(elapsed * (1.0 - share) / share) : 0;
  const std::string line = fmt::format("\r\033[K{}  [{}] {:3.0f} %  {}  left {}:{:02}", what, bar, 100.0 * share, rate,
                                       left / 60, left % 60);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
  return true;
}

}  // namespace vehicle::cli
