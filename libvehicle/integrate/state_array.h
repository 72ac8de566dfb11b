#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace vehicle {

/// Number of states known at run time only.
inline constexpr int kDynamicSize = -1;

/// n doubles: in place where the size is known to the compiler, allocated once where it is not.
template <int N>
class StateArray {
 public:
  /// @throws std::invalid_argument unless size > 0 and, for a fixed N, size == N
  explicit StateArray(int size) {
    if (size < 1 || (N != kDynamicSize && size != N)) {
      throw std::invalid_argument("number of states = " + std::to_string(size) +
                                  (N == kDynamicSize ? ", must be > 0" : ", must be " + std::to_string(N)));
    }
    if constexpr (N == kDynamicSize) values_.resize(static_cast<std::size_t>(size));
  }

  [[nodiscard]] int size() const {
    if constexpr (N != kDynamicSize) return N;
    else return static_cast<int>(values_.size());
  }
  [[nodiscard]] double* data() { return values_.data(); }
  [[nodiscard]] const double* data() const { return values_.data(); }
  double& operator[](int i) { return values_[static_cast<std::size_t>(i)]; }
  double operator[](int i) const { return values_[static_cast<std::size_t>(i)]; }
  void swap(StateArray& other) noexcept { values_.swap(other.values_); }

 private:
  using Fixed = std::array<double, static_cast<std::size_t>(N < 1 ? 1 : N)>;
  std::conditional_t<N == kDynamicSize, std::vector<double>, Fixed> values_{};
};

}  // namespace vehicle
