#include "libvehicle/threads/doorbell.h"

#if defined(__linux__)
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <climits>
#include <cmath>
#include <ctime>
#else
#include <chrono>
#include <thread>
#endif

namespace vehicle {

// Anything that ends the sleep early is as good as a ring: the caller looks again.
void Doorbell::sleep(std::uint32_t heard, double most) {
#if defined(__linux__)
  static_assert(sizeof rings_ == sizeof heard && std::atomic<std::uint32_t>::is_always_lock_free);
  const double whole = std::floor(most);
  const timespec limit{.tv_sec = static_cast<time_t>(whole), .tv_nsec = static_cast<long>(1e9 * (most - whole))};
  syscall(SYS_futex, &rings_, FUTEX_WAIT_PRIVATE, heard, &limit, nullptr, 0);
#else
  if (rings_.load(std::memory_order_relaxed) == heard) std::this_thread::sleep_for(std::chrono::duration<double>(most));
#endif
}

void Doorbell::wake() {
  rings_.fetch_add(1, std::memory_order_release);
#if defined(__linux__)
  syscall(SYS_futex, &rings_, FUTEX_WAKE_PRIVATE, INT_MAX, nullptr, nullptr, 0);
#endif
}

}  // namespace vehicle
