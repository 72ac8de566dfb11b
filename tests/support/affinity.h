#pragma once

#include <sched.h>

#include <vector>

namespace vehicle::test {

inline cpu_set_t maskOfThisThread() {
  cpu_set_t mask;
  CPU_ZERO(&mask);
  sched_getaffinity(0, sizeof mask, &mask);
  return mask;
}

/// The calling thread may run on that core only, until the end of the scope.
class OnlyCore {
 public:
  explicit OnlyCore(int core) : before_(maskOfThisThread()) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<unsigned>(core), &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OnlyCore() { sched_setaffinity(0, sizeof before_, &before_); }
  OnlyCore(const OnlyCore&) = delete;
  OnlyCore& operator=(const OnlyCore&) = delete;

 private:
  cpu_set_t before_;
};

}  // namespace vehicle::test
