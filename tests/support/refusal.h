#pragma once

#include <stdexcept>
#include <string>

namespace vehicle::test {

/// What a call says that refuses its arguments: the message of its std::invalid_argument; "accepted" if it throws
/// nothing.
template <class Call>
std::string refusalOf(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace vehicle::test
