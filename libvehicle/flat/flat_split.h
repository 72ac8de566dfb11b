#pragma once

#include <array>
#include <string>
#include <vector>

#include "libvehicle/flat/flat_form.h"

namespace vehicle {

/// x' = f(x, u) of one half of the symmetric vehicle, (3.4)-(3.7) of docs/theory/vertical.md: one body on the two
/// bogies, which move as one. By type and of fixed size, as FlatRhs.
///
///     inertia y'' = - 2 a F - k_g y                                  F = c_k (a y - b) + b_k (a y' - b')
///     mb b''      = F - 2 cb (b - eta) - 2 bb (b' - eta')
///
/// Bounce: y = zk, a = 1, b = (z1 + z2)/2, eta = mean of the four wheels. Pitch: y = phi, a = ak,
/// b = (z1 - z2)/2, eta = (eta1 + eta2 - eta3 - eta4)/4.
/// State x = (y, b, y', b'), input u = (eta, eta').
class FlatHalfRhs {
 public:
  static constexpr int kStates = 4;
  static constexpr int kInputs = 2;

  /// @param inertia  [kg or kg m^2]   @param arm  a [- or m]   @param k_g  [N m/rad] 0 in bounce
  FlatHalfRhs(const FlatParameters& symmetric, double inertia, double arm, double k_g)
      : yy_(-(2.0 * arm * symmetric.cs1 * arm + k_g) / inertia), yb_(2.0 * arm * symmetric.cs1 / inertia),
        dyy_(-2.0 * arm * symmetric.bs1 * arm / inertia), dyb_(2.0 * arm * symmetric.bs1 / inertia),
        by_(symmetric.cs1 * arm / symmetric.m1), bb_(-(symmetric.cs1 + 2.0 * symmetric.cp[0]) / symmetric.m1),
        dby_(symmetric.bs1 * arm / symmetric.m1), dbb_(-(symmetric.bs1 + 2.0 * symmetric.bp[0]) / symmetric.m1),
        eta_(2.0 * symmetric.cp[0] / symmetric.m1), deta_(2.0 * symmetric.bp[0] / symmetric.m1) {}

  /// @param x  (4)   @param u  (2)   @param dx  (4)
  [[gnu::always_inline]] inline void operator()(const double* x, const double* u, double* dx) const {
    // Four states leave a processor nothing to do while it waits for a sum: what counts is how many operations stand
    // one after the other. So each equation is multiplied out and its four products are summed in pairs.
    const double upper = (yy_ * x[0] + yb_ * x[1]) + (dyy_ * x[2] + dyb_ * x[3]);
    const double rail = eta_ * u[0] + deta_ * u[1];
    const double lower = ((by_ * x[0] + bb_ * x[1]) + (dby_ * x[2] + dbb_ * x[3])) + rail;
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = upper;
    dx[3] = lower;
  }

 private:
  double yy_, yb_, dyy_, dyb_;  // y'' per y, b, y', b'
  double by_, bb_, dby_, dbb_;  // b'' per y, b, y', b'
  double eta_, deta_;           // b'' per eta, eta'
};

/// One half as a System: 4 states, one channel, its states for outputs. Immutable, serves any number of threads.
class FlatHalf final : public System {
 public:
  FlatHalf(FlatHalfRhs rhs, std::vector<Channel> states) : rhs_(rhs), states_(std::move(states)) {}

  int channels() const override { return 1; }
  StateLayout layout() const override { return {.coordinates = 2}; }
  const std::vector<Channel>& states() const override { return states_; }
  const std::vector<Channel>& outputs() const override { return states_; }
  [[nodiscard]] const FlatHalfRhs& rhs() const { return rhs_; }
  void derivative(std::span<const double> x, std::span<const double> u, std::span<double> dx) const override {
    rhs_(x.data(), u.data(), dx.data());
  }
  void output(std::span<const double> x, std::span<const double> u, std::span<double> y) const override;
  std::optional<StateSpace> linear() const override;

 private:
  FlatHalfRhs rhs_;
  std::vector<Channel> states_;
};

/// Why bounce and pitch of this vehicle do not part: the pairs of parameters of front and rear, and of the four
/// primaries, that are not the same bit for bit; or that the form is a printed variant. Empty if they do.
[[nodiscard]] std::string splitUnsupported(const FlatForm& form);

/// The symmetric vehicle as two systems that know nothing of each other, and the ways there and back.
class FlatSplit {
 public:
  /// @throws std::invalid_argument with splitUnsupported()
  explicit FlatSplit(const FlatForm& form);

  [[nodiscard]] const FlatHalf& bounce() const { return bounce_; }
  [[nodiscard]] const FlatHalf& pitch() const { return pitch_; }

  /// Row 0 makes the channel of bounce of the form's channels, row 1 that of pitch; (2 x 4), row-major.
  [[nodiscard]] const std::array<double, 8>& mixing() const { return mixing_; }

  /// States of bounce, then of pitch (8), of the form's x (8), and back. Each way rounds the bogies' sum and
  /// difference once.
  void toHalves(std::span<const double> x, std::span<double> halves) const;
  void fromHalves(std::span<const double> halves, std::span<double> x) const;

 private:
  FlatHalf bounce_;
  FlatHalf pitch_;
  std::array<double, 8> mixing_{};
  std::array<std::size_t, 8> place_{};  // of (zk, phi, z1, z2, zk', phi', z1', z2') in the form's x
};

}  // namespace vehicle
