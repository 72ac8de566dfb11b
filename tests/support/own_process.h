#pragma once

#include <cstdio>
#include <exception>
#include <functional>
#include <optional>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vehicle::test {

/// What a process of its own that does that work takes; its memory is not mixed with that of what ran before. Nothing
/// where the work threw, which is printed, or the process ended otherwise.
inline std::optional<rusage> usageOf(const std::function<void()>& work) {
  std::fflush(nullptr);  // else both processes write what is buffered
  const pid_t process = fork();
  if (process == 0) {
    int status = 1;
    try {
      work();
      status = 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    _exit(status);
  }
  int status = 0;
  rusage usage{};
  if (process < 0 || wait4(process, &status, 0, &usage) != process || status != 0) return std::nullopt;
  return usage;
}

}  // namespace vehicle::test
