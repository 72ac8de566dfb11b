#pragma once

#include <cstddef>
#include <string>
#include <system_error>

namespace vehicle {

/// What is told where the system starts no more threads.
/// @param number  of the thread that was refused, counted from 1   @param threads  wanted
[[nodiscard]] inline std::string refusedThread(std::size_t number, int threads, const std::system_error& refused) {
  return "thread " + std::to_string(number) + " of " + std::to_string(threads) + " was refused by the system (" +
         refused.what() + "); take fewer threads";
}

}  // namespace vehicle
