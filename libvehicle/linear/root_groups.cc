#include "libvehicle/linear/root_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "libvehicle/system/dense_solvers.h"

namespace vehicle {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// A triangle whose eigenvalues can be put into another order: A = U T U^H throughout.
struct Triangle {
  Eigen::MatrixXcd T;
  Eigen::MatrixXcd U;

  /// From the real Schur form, which is several times cheaper: each block of two is rotated into a triangle.
  explicit Triangle(const Eigen::RealSchur<Eigen::MatrixXd>& real)
      : T(real.matrixT().cast<Complex>()), U(real.matrixU().cast<Complex>()) {
    for (Index k = T.rows() - 2; k >= 0; --k) {
      if (T(k + 1, k) == 0.0) continue;
      const Complex half = 0.5 * (T(k, k) - T(k + 1, k + 1));
      const Complex root = std::sqrt(half * half + T(k, k + 1) * T(k + 1, k));
      rotate(k, half + (std::real(half) < 0.0 ? -root : root), T(k + 1, k));
      T(k + 1, k) = 0.0;
    }
  }

  /// Exchanges the eigenvalues k and k + 1 of the diagonal.
  void swap(Index k) { rotate(k, T(k, k + 1), T(k + 1, k + 1) - T(k, k)); }

 private:
  /// Makes (a, b) the direction of the first of the two columns k and k + 1.
  void rotate(Index k, Complex a, Complex b) {
    Eigen::JacobiRotation<Complex> rotation;
    rotation.makeGivens(a, b);
    T.rightCols(T.cols() - k).applyOnTheLeft(k, k + 1, rotation.adjoint());
    T.topRows(k + 2).applyOnTheRight(k, k + 1, rotation);
    U.applyOnTheRight(k, k + 1, rotation);
  }
};

/// @param members  places on the diagonal, ascending
Eigen::MatrixXcd rightBasis(Triangle triangle, const std::vector<Index>& members) {
  Index to = 0;
  for (const Index from : members) {
    for (Index k = from; k > to; --k) triangle.swap(k - 1);
    ++to;
  }
  return triangle.U.leftCols(to);
}

Eigen::MatrixXcd leftBasis(Triangle triangle, const std::vector<Index>& members) {
  Index to = triangle.T.rows();
  for (auto from = members.rbegin(); from != members.rend(); ++from) {
    --to;
    for (Index k = *from; k < to; ++k) triangle.swap(k);
  }
  return triangle.U.rightCols(triangle.T.rows() - to);
}

/// Places of the diagonal by groups.
std::vector<std::vector<Index>> membersOf(const Eigen::VectorXcd& roots, double norm) {
  const Index n = roots.size();
  // A double root at zero (a free motion) splits by the square root of the rounding.
  const double zero = 30.0 * std::sqrt(std::numeric_limits<double>::epsilon()) * norm;
  const auto same = [&](Complex a, Complex b) {
    const double size = std::max(std::abs(a), std::abs(b));
    return std::min(std::abs(a - b), std::abs(a - std::conj(b))) <=
           std::max(kSameRoot * size, size <= zero ? zero : 0.0);
  };
  std::vector<std::vector<Index>> groups;
  for (Index i = 0; i < n; ++i) {
    std::vector<Index> own = {i};
    for (auto group = groups.begin(); group != groups.end();) {
      const bool joins = std::any_of(group->begin(), group->end(), [&](Index j) { return same(roots(i), roots(j)); });
      if (joins) own.insert(own.end(), group->begin(), group->end());
      group = joins ? groups.erase(group) : group + 1;
    }
    std::sort(own.begin(), own.end());
    groups.push_back(std::move(own));
  }
  return groups;
}

/// Of the roots with Im >= 0 the mean; the last digit of a real root's imaginary part is nothing.
Complex valueOf(const Eigen::VectorXcd& roots, const std::vector<Index>& members) {
  Complex sum = 0.0;
  for (const Index i : members) sum += Complex(roots(i).real(), std::abs(roots(i).imag()));
  sum /= static_cast<double>(members.size());
  return members.size() == 1 ? Complex(sum.real(), 0.0) : sum;
}

}  // namespace

std::vector<RootGroup> rootGroupsOf(const Eigen::MatrixXd& A) {
  const Eigen::RealSchur<Eigen::MatrixXd> schur(A);
  if (schur.info() != Eigen::Success) {
    throw std::runtime_error("mode following: the eigenvalue iteration did not converge");
  }
  const Triangle triangle(schur);
  const Eigen::VectorXcd roots = triangle.T.diagonal();
  std::vector<RootGroup> groups;
  for (const std::vector<Index>& members : membersOf(roots, A.norm())) {
    RootGroup group{valueOf(roots, members), rightBasis(triangle, members), {}};
    const Eigen::MatrixXcd left = leftBasis(triangle, members);
    group.left = (left.adjoint() * group.right).partialPivLu().solve(left.adjoint());
    groups.push_back(std::move(group));
  }
  std::sort(groups.begin(), groups.end(), [](const RootGroup& a, const RootGroup& b) {
    const double sizes = std::abs(a.value) - std::abs(b.value);
    return sizes != 0.0 ? sizes < 0.0 : a.value.real() < b.value.real();
  });
  return groups;
}

}  // namespace vehicle
