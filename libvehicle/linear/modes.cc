#include "libvehicle/linear/modes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/QR>

#include "libvehicle/linear/complex_svd.h"
#include "libvehicle/linear/mode_names.h"
#include "libvehicle/linear/state_scaling.h"
#include "libvehicle/system/dense_solvers.h"

namespace vehicle {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

struct Eigenpairs {
  Eigen::VectorXcd value;   // (n)
  Eigen::MatrixXcd right;   // (n x n) columns
  Eigen::MatrixXcd left;    // (n x n) rows: right^-1, may be huge or infinite near a defective value
  Eigen::VectorXd bound;    // (n) how far rounding may have moved each value
  double rounding = 0.0;    // the same for a well conditioned value
};

Eigenpairs eigenpairsOf(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) throw std::runtime_error("modes: the eigenvalue iteration did not converge");
  Eigenpairs pairs;
  pairs.value = solver.eigenvalues();
  pairs.right = solver.eigenvectors();
  pairs.left = pairs.right.partialPivLu().inverse();
  const Index n = A.rows();
  pairs.rounding = 8.0 * static_cast<double>(n) * kEpsilon * A.norm();
  // A double defective value splits by the square root of the rounding, not more.
  const double most = 30.0 * std::sqrt(kEpsilon) * A.norm();
  pairs.bound.resize(n);
  for (Index i = 0; i < n; ++i) {
    const double condition = pairs.left.row(i).norm() * pairs.right.col(i).norm();
    pairs.bound(i) = std::isfinite(condition) ? std::min(most, pairs.rounding * condition) : most;
  }
  return pairs;
}

// Eigenvalues that are one within rounding.
struct Cluster {
  Complex centre;
  std::vector<Index> members;
};

std::vector<Cluster> clustersOf(const Eigenpairs& pairs) {
  const Index n = pairs.value.size();
  std::vector<Index> label(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) label[static_cast<std::size_t>(i)] = i;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < i; ++j) {
      if (std::abs(pairs.value(i) - pairs.value(j)) > pairs.bound(i) + pairs.bound(j)) continue;
      std::replace(label.begin(), label.end(), Index{label[static_cast<std::size_t>(i)]},
                   Index{label[static_cast<std::size_t>(j)]});
    }
  }
  std::vector<Cluster> clusters;
  for (Index root = 0; root < n; ++root) {
    Cluster cluster;
    for (Index i = 0; i < n; ++i) {
      if (label[static_cast<std::size_t>(i)] == root) cluster.members.push_back(i);
    }
    if (cluster.members.empty()) continue;
    for (const Index i : cluster.members) cluster.centre += pairs.value(i);
    // The mean of a cluster is well conditioned even where its members are not.
    cluster.centre /= static_cast<double>(cluster.members.size());
    const double zero = cluster.members.size() == 1 ? pairs.bound(cluster.members.front()) : pairs.rounding;
    if (std::abs(cluster.centre.real()) <= zero) cluster.centre.real(0.0);
    if (std::abs(cluster.centre.imag()) <= zero) cluster.centre.imag(0.0);
    if (cluster.centre.imag() >= 0.0) clusters.push_back(std::move(cluster));
  }
  return clusters;
}

// Shapes (q half of right vectors, columns) and weights (velocity half of left vectors, columns) of one cluster.
struct Vectors {
  Eigen::MatrixXcd shape;   // (N x g)
  Eigen::MatrixXcd weight;  // (N x g)
};

Vectors vectorsOf(const Cluster& cluster, const Eigenpairs& pairs, const Eigen::MatrixXd& A) {
  const Index n = A.rows();
  const Index N = n / 2;
  const auto m = static_cast<Index>(cluster.members.size());
  if (m == 1) {
    const Index i = cluster.members.front();
    return {pairs.right.col(i).head(N), pairs.left.row(i).tail(N).adjoint()};
  }
  double spread = 0.0;
  for (const Index i : cluster.members) spread = std::max(spread, std::abs(pairs.value(i) - cluster.centre));
  const Eigen::MatrixXcd shifted = A.cast<Complex>() - cluster.centre * Eigen::MatrixXcd::Identity(n, n);
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(shifted, Eigen::ComputeFullU | Eigen::ComputeFullV);
  // Members that are distinct only by rounding leave singular values of that size; a defective value spreads by the
  // square root, but its singular values of true vectors stay at rounding.
  const double zero = std::max(100.0 * pairs.rounding, std::min(spread, 1e-10 * A.norm()));
  Index g = 1;
  while (g < m && svd.singularValues()(n - 1 - g) <= zero) ++g;
  const Eigen::MatrixXcd right = svd.matrixV().rightCols(g);
  const Eigen::MatrixXcd left = svd.matrixU().rightCols(g);

  // Any mixture of the columns is as good. Taken is the one in which each shape has a coordinate that the others
  // lack: two equal bogies then pitch one by one. Rows are weighted so that units do not choose the coordinates.
  Eigen::MatrixXcd rows = right.topRows(N);
  for (Index i = 0; i < N; ++i) {
    const double norm = rows.row(i).norm();
    if (norm > 0.0) rows.row(i) *= std::sqrt(left.row(N + i).norm() / norm);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> pivoted(rows.transpose());
  std::vector<Index> own;
  for (Index k = 0; k < g; ++k) own.push_back(pivoted.colsPermutation().indices()(k));
  std::sort(own.begin(), own.end());
  Eigen::MatrixXcd at_own(g, g);
  for (Index k = 0; k < g; ++k) at_own.row(k) = right.row(own[static_cast<std::size_t>(k)]);
  const Eigen::MatrixXcd mixed = right * at_own.inverse();
  if (g == m) {
    const Eigen::MatrixXcd dual = left * (mixed.adjoint() * left).inverse();
    return {mixed.topRows(N), dual.bottomRows(N)};
  }
  // No left vector belongs to one shape here: all of them together weigh the coordinates.
  return {mixed.topRows(N), left.bottomRows(N).rowwise().norm().cast<Complex>().replicate(1, g)};
}

Mode modeOf(const Cluster& cluster, const Eigen::VectorXcd& shape, const Eigen::VectorXcd& weight) {
  Mode mode;
  mode.eigenvalue = cluster.centre;
  const double size = std::abs(mode.eigenvalue);
  mode.frequency = size / (2.0 * std::numbers::pi);
  mode.damping_ratio = size > 0.0 ? -mode.eigenvalue.real() / size : 0.0;
  mode.multiplicity = static_cast<int>(cluster.members.size());
  Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  mode.shape = shape / shape(largest);
  mode.participation = shape.cwiseProduct(weight.conjugate()).cwiseAbs();
  const double sum = mode.participation.sum();
  if (sum > 0.0 && std::isfinite(sum)) {
    mode.participation /= sum;
  } else {
    mode.participation = mode.shape.cwiseAbs2() / mode.shape.squaredNorm();
  }
  return mode;
}

void check(const Eigen::MatrixXd& A, const std::vector<Channel>& states) {
  if (A.rows() != A.cols() || A.rows() < 2 || A.rows() % 2 != 0 || A.rows() != static_cast<Index>(states.size())) {
    throw std::invalid_argument("modes: A is " + std::to_string(A.rows()) + " x " + std::to_string(A.cols()) +
                                " for " + std::to_string(states.size()) + " states, must be 2N x 2N for 2N states");
  }
  if (!A.allFinite()) throw std::invalid_argument("modes: A has an entry that is not finite");
}

}  // namespace

std::vector<Mode> modesOf(const Eigen::MatrixXd& A, const std::vector<Channel>& states) {
  check(A, states);
  const Eigen::MatrixXd scaled = inUnits(A, stateUnits(A));
  const Eigenpairs pairs = eigenpairsOf(scaled);
  std::vector<Mode> modes;
  for (const Cluster& cluster : clustersOf(pairs)) {
    const Vectors vectors = vectorsOf(cluster, pairs, scaled);
    for (Index k = 0; k < vectors.shape.cols(); ++k) {
      modes.push_back(modeOf(cluster, vectors.shape.col(k), vectors.weight.col(k)));
    }
  }
  std::stable_sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) {
    return std::abs(a.eigenvalue) < std::abs(b.eigenvalue);
  });
  nameModes(modes, states);
  return modes;
}

std::vector<Mode> modesOf(const System& system) {
  const std::optional<StateSpace> matrices = system.linear();
  if (!matrices) {
    throw std::invalid_argument(
        "modes: the system is nonlinear (it has no matrices); linearise it about a state with differencedStateSpace()");
  }
  return modesOf(matrices->A, system.states());
}

}  // namespace vehicle
