#include "libvehicle/linear/column_derivatives.h"

#include <cmath>
#include <stdexcept>

namespace vehicle {

namespace {

std::span<double> spanOf(Eigen::VectorXd& vector) { return {vector.data(), static_cast<std::size_t>(vector.size())}; }

}  // namespace

ColumnDerivatives::ColumnDerivatives(const System& system) : channels_(system.channels()) {
  std::optional<StateSpace> matrices = system.linear();
  if (!matrices) throw std::invalid_argument("column derivatives: the system is nonlinear, it has no matrices");
  matrices_ = std::move(*matrices);
  const auto columns = static_cast<Eigen::Index>(system.outputs().size());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.size());
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3 * channels_);
  Eigen::VectorXd y(columns);
  at_rest_.resize(columns);
  C_.resize(columns, x.size());
  D_.resize(columns, u.size());
  system.output(spanOf(x), spanOf(u), spanOf(at_rest_));
  // Columns are affine in state and rail: what a one in each place adds.
  const auto probe = [&](Eigen::VectorXd& variable, Eigen::MatrixXd& matrix) {
    for (Eigen::Index j = 0; j < variable.size(); ++j) {
      variable(j) = 1.0;
      system.output(spanOf(x), spanOf(u), spanOf(y));
      matrix.col(j) = y - at_rest_;
      variable(j) = 0.0;
    }
  };
  probe(x, C_);
  probe(u, D_);
}

void ColumnDerivatives::fillRail(const InputSegment& segment, double t, int order) {
  const double s = t - segment.begin;
  const auto harmonics = static_cast<Eigen::Index>(segment.angular_frequency.size());
  rail_.setZero(channels_, order + 3);
  for (Eigen::Index j = 0; j < channels_; ++j) {
    const double* p = segment.polynomial.data() + InputSegment::kPolynomial * j;
    rail_(j, 0) = p[0] + s * (p[1] + s * (p[2] + s * p[3]));
    rail_(j, 1) = p[1] + s * (2.0 * p[2] + 3.0 * s * p[3]);
    rail_(j, 2) = 2.0 * p[2] + 6.0 * s * p[3];
    if (order >= 1) rail_(j, 3) = 6.0 * p[3];
  }
  for (Eigen::Index f = 0; f < harmonics; ++f) {
    const double w = segment.angular_frequency[static_cast<std::size_t>(f)];
    const double cosine = std::cos(w * s), sine = std::sin(w * s);
    for (Eigen::Index j = 0; j < channels_; ++j) {
      const auto at = static_cast<std::size_t>(j * harmonics + f);
      // a cos + b sin and its derivative turn into each other: every second one is -w^2 times the one before.
      double even = segment.cosine[at] * cosine + segment.sine[at] * sine;
      double odd = w * (segment.sine[at] * cosine - segment.cosine[at] * sine);
      for (Eigen::Index k = 0; k < rail_.cols(); k += 2) {
        rail_(j, k) += even;
        if (k + 1 < rail_.cols()) rail_(j, k + 1) += odd;
        even *= -w * w;
        odd *= -w * w;
      }
    }
  }
}

const Eigen::MatrixXd& ColumnDerivatives::at(const InputSegment& segment, double t, std::span<const double> x,
                                             int order) {
  fillRail(segment, t, order);
  x_ = Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  u_.resize(3 * channels_);
  y_.resize(C_.rows(), order + 1);
  for (Eigen::Index k = 0; k <= order; ++k) {
    for (Eigen::Index derivative = 0; derivative < 3; ++derivative) {
      u_.segment(derivative * channels_, channels_) = rail_.col(k + derivative);
    }
    y_.col(k).noalias() = C_ * x_;
    y_.col(k).noalias() += D_ * u_;
    if (k == 0) y_.col(0) += at_rest_;
    if (k == order) break;
    next_.noalias() = matrices_.A * x_;
    next_.noalias() += matrices_.B * u_.head(2 * channels_);
    x_.swap(next_);
  }
  return y_;
}

}  // namespace vehicle
