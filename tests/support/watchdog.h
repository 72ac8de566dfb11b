#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace vehicle::test {

/// Ends the test program if the scope lasts longer: a hang must fail, and here nothing else could end it.
class Watchdog {
 public:
  explicit Watchdog(std::chrono::seconds patience = std::chrono::minutes(10))
      : guard_([this, patience] {
          std::unique_lock lock(mutex_);
          if (done_.wait_for(lock, patience, [this] { return over_; })) return;
          std::fprintf(stderr, "watchdog: the team hangs\n");
          std::_Exit(1);
        }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    done_.notify_one();
    guard_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable done_;
  bool over_ = false;
  std::thread guard_;
};

}  // namespace vehicle::test
