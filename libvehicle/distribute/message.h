#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "libvehicle/study/evaluate/evaluation.h"

namespace vehicle {

/// What ranks tell each other; the values are MPI tags.
enum class Note : int {
  kWork = 1,     // leader: evaluate these designs (portion)
  kAbandon = 2,  // leader: drop what is not begun, say kIdle when the rest is sent
  kEnd = 3,      // leader: the same, then go; say kBye
  kBatch = 4,    // results (batch)
  kFailed = 5,   // what ended the work of this rank (text)
  kIdle = 6,
  kBye = 7,
};

/// A message being put together. All ranks run the same program on machines of one kind, so numbers travel as they
/// stand in memory, to the last bit.
class Packer {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    putAll(std::span<const T>(&value, 1));
  }
  template <class T>
  void putAll(std::span<const T> values) {
    const std::size_t size = bytes_.size();
    bytes_.resize(size + values.size_bytes());
    if (!values.empty()) std::memcpy(bytes_.data() + size, values.data(), values.size_bytes());
  }
  void putText(const std::string& text) {
    put<std::uint64_t>(text.size());
    putAll(std::span<const char>(text));
  }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// A message being read.
class Unpacker {
 public:
  explicit Unpacker(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class T>
  [[nodiscard]] T get() {
    T value{};
    getAll(std::span<T>(&value, 1));
    return value;
  }
  template <class T>
  void getAll(std::span<T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (values.size_bytes() > left_.size()) throw std::runtime_error("a message between ranks is shorter than it says");
    if (!values.empty()) std::memcpy(values.data(), left_.data(), values.size_bytes());
    left_ = left_.subspan(values.size_bytes());
  }
  [[nodiscard]] std::string getText() {
    const auto size = get<std::uint64_t>();
    if (size > left_.size()) throw std::runtime_error("a message between ranks is shorter than it says");
    std::string text(size, '\0');
    getAll(std::span<char>(text));
    return text;
  }

 private:
  std::span<const std::byte> left_;
};

[[nodiscard]] std::vector<std::byte> packBatch(const Batch& batch);
/// @throws std::runtime_error  unless its rows have so many columns: then the ranks do not see the same study
void unpackBatch(std::span<const std::byte> bytes, std::size_t columns, Batch& batch);

/// A range to be evaluated, with the numbers that its designs need besides.
struct Portion {
  DesignSpan range;
  std::vector<double> given;
};
[[nodiscard]] std::vector<std::byte> packPortion(const Task& task);
/// @param given  numbers of one design
[[nodiscard]] Portion unpackPortion(std::span<const std::byte> bytes, std::size_t given);

}  // namespace vehicle
