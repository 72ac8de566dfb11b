#include "libvehicle/integrate/exact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>

#include "libvehicle/integrate/matrix_exponential.h"
#include "libvehicle/system/dense_solvers.h"

namespace vehicle {
namespace {

// |w X| / |G| in balanced coordinates beyond which gain = X (e^(iwh) - 1) - E X would lose more than three digits.
constexpr double kLargestParticular = 1e3;

double powerOfTwoNear(double value) {
  return value > 0.0 && std::isfinite(value) ? std::exp2(std::round(std::log2(value))) : 1.0;
}

// A in coordinates D^-1 x, and columns in the same coordinates brought to the size of A.
struct Balanced {
  Eigen::VectorXd scales;
  Eigen::MatrixXd A;

  explicit Balanced(const Eigen::MatrixXd& unbalanced)
      : scales(balancingScales(unbalanced)),
        A(scales.cwiseInverse().asDiagonal() * unbalanced * scales.asDiagonal()) {}

  double columnScale(const Eigen::MatrixXd& columns) const {
    return powerOfTwoNear(columns.cwiseAbs().maxCoeff() / A.cwiseAbs().maxCoeff());
  }
};

// [e^(Ah) - I, gains] of the frequencies from `first` on, from one augmented exponential; in balanced coordinates.
Eigen::MatrixXd augmented(const Eigen::MatrixXd& A, const Eigen::MatrixXd& forcing, const double* w, double h) {
  const Eigen::Index n = A.rows();
  const Eigen::Index drivers = forcing.cols();
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n + drivers, n + drivers);
  M.topLeftCorner(n, n) = h * A;
  M.topRightCorner(n, drivers) = h * forcing;
  for (Eigen::Index f = 0; f < drivers / 2; ++f) {
    M(n + 2 * f, n + 2 * f + 1) = -h * w[f];
    M(n + 2 * f + 1, n + 2 * f) = h * w[f];
  }
  return expMinusIdentity(M).topRows(n);
}

}  // namespace

ExactPropagator::ExactPropagator(const Eigen::MatrixXd& A, const Eigen::MatrixXd& forcing,
                                 std::vector<double> angular_frequency, double length)
    : size_(static_cast<int>(A.rows())), angular_frequency_(std::move(angular_frequency)), length_(length) {
  const Eigen::Index n = A.rows();
  const Eigen::Index drivers = 2 * static_cast<Eigen::Index>(angular_frequency_.size());
  if (n < 1 || A.cols() != n || forcing.rows() != n || forcing.cols() != drivers) {
    throw std::invalid_argument("exact propagator: A is " + std::to_string(n) + " x " + std::to_string(A.cols()) +
                                ", forcing " + std::to_string(forcing.rows()) + " x " + std::to_string(forcing.cols()) +
                                ", must be n x n and n x " + std::to_string(drivers));
  }
  if (!(length > 0.0 && std::isfinite(length)) || !A.allFinite() || !forcing.allFinite()) {
    throw std::invalid_argument("exact propagator: length = " + std::to_string(length) +
                                " s, must be > 0; length, A and forcing must be finite");
  }
  const Balanced balanced(A);
  Eigen::MatrixXd columns(n, n + drivers);
  Eigen::MatrixXd scaled = balanced.scales.cwiseInverse().asDiagonal() * forcing;
  Eigen::VectorXd restore(drivers);
  for (Eigen::Index f = 0; f < drivers / 2; ++f) {
    restore.segment(2 * f, 2).setConstant(balanced.columnScale(scaled.middleCols(2 * f, 2)));
  }
  scaled = scaled * restore.cwiseInverse().asDiagonal();

  const double* w = angular_frequency_.data();
  const bool together = frequencies() <= kMostAugmented;
  columns.leftCols(together ? n + drivers : n) =
      augmented(balanced.A, together ? scaled : Eigen::MatrixXd(n, 0), w, length);
  exponentials_ = 1;
  for (Eigen::Index f = 0; !together && f < drivers / 2; ++f) {
    using Complex = std::complex<double>;
    // G_c cos + G_s sin = Re[(G_c - i G_s) e^(iws)]: the gains are the real part and minus the imaginary part.
    const Eigen::VectorXcd G = scaled.col(2 * f) - Complex(0.0, 1.0) * scaled.col(2 * f + 1);
    const Eigen::MatrixXcd resolvent =
        Complex(0.0, w[f]) * Eigen::MatrixXcd::Identity(n, n) - balanced.A.cast<Complex>();
    const Eigen::VectorXcd X = resolvent.partialPivLu().solve(G);
    if (w[f] * X.norm() <= kLargestParticular * G.norm()) {
      const double half = std::sin(0.5 * w[f] * length);
      const Complex turn_minus_one(-2.0 * half * half, std::sin(w[f] * length));
      const Eigen::VectorXcd gain = X * turn_minus_one - columns.leftCols(n).cast<Complex>() * X;
      columns.col(n + 2 * f) = gain.real();
      columns.col(n + 2 * f + 1) = -gain.imag();
    } else {
      columns.middleCols(n + 2 * f, 2) =
          augmented(balanced.A, scaled.middleCols(2 * f, 2), w + f, length).rightCols(2);
      ++exponentials_;
    }
  }
  columns = (balanced.scales.asDiagonal() * columns).eval();
  columns.leftCols(n) = (columns.leftCols(n) * balanced.scales.cwiseInverse().asDiagonal()).eval();
  columns.rightCols(drivers) = (columns.rightCols(drivers) * restore.asDiagonal()).eval();

  columns_.assign(columns.data(), columns.data() + columns.size());
  for (const double frequency : angular_frequency_) {
    turn_.push_back(std::cos(frequency * length));
    turn_.push_back(std::sin(frequency * length));
  }
  increment_.resize(static_cast<std::size_t>(n));
  kernel_ = (size_ != 8 && size_ != 4) || frequencies() != 2 ? &ExactPropagator::generalKernel
            : size_ == 8                                     ? &ExactPropagator::kernel<8, 2>
                                                             : &ExactPropagator::kernel<4, 2>;
}

void ExactPropagator::seed(double s, double* oscillators) const {
  for (std::size_t f = 0; f < angular_frequency_.size(); ++f) {
    oscillators[2 * f] = std::cos(angular_frequency_[f] * s);
    oscillators[2 * f + 1] = std::sin(angular_frequency_[f] * s);
  }
}

namespace {

inline void turn(const double* by, int frequencies, double* oscillators) {
  for (int i = 0; i < 2 * frequencies; i += 2) {
    const double cosine = oscillators[i] * by[i] - oscillators[i + 1] * by[i + 1];
    oscillators[i + 1] = oscillators[i + 1] * by[i] + oscillators[i] * by[i + 1];
    oscillators[i] = cosine;
  }
}

}  // namespace

// Sizes known to the compiler: the increments live in registers, two rows each. Two sums, of the even and of the
// odd columns, halve the chain of additions that the next step has to wait for.
template <int N, int F>
void ExactPropagator::kernel(double* x, double* oscillators) {
  const double* column = columns_.data();
  std::array<double, N> even{};
  std::array<double, N> odd{};
  const auto addTwo = [&](double first, double second) {
    for (std::size_t i = 0; i < N; ++i) even[i] += column[i] * first;
    for (std::size_t i = 0; i < N; ++i) odd[i] += column[N + i] * second;
    column += 2 * N;
  };
  for (int j = 0; j < N; j += 2) addTwo(x[j], x[j + 1]);
  for (int j = 0; j < 2 * F; j += 2) addTwo(oscillators[j], oscillators[j + 1]);
  for (std::size_t i = 0; i < N; ++i) x[i] += even[i] + odd[i];
  turn(turn_.data(), F, oscillators);
}

void ExactPropagator::generalKernel(double* x, double* oscillators) {
  const int n = size_;
  const double* column = columns_.data();
  double* increment = increment_.data();
  std::fill_n(increment, n, 0.0);
  const auto add = [&](double by) {
    for (int i = 0; i < n; ++i) increment[i] += column[i] * by;
    column += n;
  };
  for (int j = 0; j < n; ++j) add(x[j]);
  for (int j = 0; j < 2 * frequencies(); ++j) add(oscillators[j]);
  for (int i = 0; i < n; ++i) x[i] += increment[i];
  turn(turn_.data(), frequencies(), oscillators);
}

PolynomialGain::PolynomialGain(const StateSpace& system, double length) : length_(length) {
  constexpr Eigen::Index kPowers = InputSegment::kPolynomial;
  const Eigen::Index n = system.A.rows();
  const Eigen::Index w = system.B.cols() / 2;
  const Balanced balanced(system.A);
  const Eigen::MatrixXd B = balanced.scales.cwiseInverse().asDiagonal() * system.B;
  // Chain d/dt eta^(k) = eta^(k+1), with eta^(k) h^k as variables, so that every entry of h M is of order one.
  const double scale = balanced.columnScale(B);
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n + kPowers * w, n + kPowers * w);
  M.topLeftCorner(n, n) = length * balanced.A;
  M.block(0, n, n, w) = length / scale * B.leftCols(w);
  M.block(0, n + w, n, w) = B.rightCols(w) / scale;
  for (Eigen::Index i = n; i < n + (kPowers - 1) * w; ++i) M(i, i + w) = 1.0;
  gain_ = balanced.scales.asDiagonal() * expMinusIdentity(M).topRightCorner(n, kPowers * w);
  for (Eigen::Index k = 0; k < kPowers; ++k) {
    gain_.middleCols(k * w, w) *= scale * std::pow(length, static_cast<double>(k));
  }
}

void PolynomialGain::add(const InputSegment& segment, double s, double* x) const {
  const Eigen::Index n = gain_.rows();
  const Eigen::Index w = gain_.cols() / InputSegment::kPolynomial;
  for (Eigen::Index j = 0; j < w; ++j) {
    const double* p = segment.polynomial.data() + InputSegment::kPolynomial * j;
    const std::array<double, 4> derivative = {p[0] + s * (p[1] + s * (p[2] + s * p[3])),
                                              p[1] + s * (2.0 * p[2] + s * 3.0 * p[3]), 2.0 * p[2] + s * 6.0 * p[3],
                                              6.0 * p[3]};
    for (Eigen::Index k = 0; k < InputSegment::kPolynomial; ++k) {
      const double value = derivative[static_cast<std::size_t>(k)];
      if (value == 0.0) continue;
      const double* column = gain_.data() + (k * w + j) * n;
      for (Eigen::Index i = 0; i < n; ++i) x[i] += column[i] * value;
    }
  }
}

Eigen::MatrixXd harmonicForcing(const StateSpace& system, const InputSegment& segment) {
  const Eigen::Index w = system.B.cols() / 2;
  const auto F = static_cast<Eigen::Index>(segment.angular_frequency.size());
  Eigen::MatrixXd forcing(system.A.rows(), 2 * F);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> cosine(segment.cosine.data(), w, F);
  const Eigen::Map<const RowMajor> sine(segment.sine.data(), w, F);
  for (Eigen::Index f = 0; f < F; ++f) {
    const double omega = segment.angular_frequency[static_cast<std::size_t>(f)];
    forcing.col(2 * f) = system.B.leftCols(w) * cosine.col(f) + system.B.rightCols(w) * (omega * sine.col(f));
    forcing.col(2 * f + 1) = system.B.leftCols(w) * sine.col(f) - system.B.rightCols(w) * (omega * cosine.col(f));
  }
  return forcing;
}

}  // namespace vehicle
