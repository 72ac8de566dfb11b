#pragma once

#include <chrono>
#include <string>

namespace vehicle::cli {

/// Ctrl-C, SIGTERM (timeout, batch systems) and SIGHUP (a terminal that closes) ask for an end instead of killing:
/// commands look here between samples. The second of a kind kills. A SIGHUP that was ignored at the start stays so.
void catchInterrupt();
[[nodiscard]] bool interrupted();

/// A bar on stderr with rate and time left, once the work has lasted a second and only on a terminal:
///   mbs rk4  [#########...........]  45 %  12.3 s/s  left 0:08
class ProgressBar {
 public:
  enum class Shown {
    kOnTerminal,
    kNever
  };
  /// @param total  what the whole work amounts to, in `unit`, for the rate
  ProgressBar(Shown shown, double total, std::string unit);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param share  done, 0..1
  /// @return false once the user has asked for an end
  bool update(double share, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled_;
  double total_;
  std::string unit_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
  bool drawn_ = false;
};

}  // namespace vehicle::cli
