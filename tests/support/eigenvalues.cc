#include "tests/support/eigenvalues.h"

#include <algorithm>
#include <iterator>

#include <Eigen/Eigenvalues>

namespace vehicle::test {

Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& A) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues();
}

std::vector<std::complex<double>> oscillationsOf(const Eigen::MatrixXd& A) {
  const Eigen::VectorXcd all = eigenvaluesOf(A);
  std::vector<std::complex<double>> upper;
  std::copy_if(all.begin(), all.end(), std::back_inserter(upper), [](const auto& each) { return each.imag() > 0.0; });
  std::sort(upper.begin(), upper.end(), [](const auto& a, const auto& b) { return std::abs(a) < std::abs(b); });
  return upper;
}

Eigen::VectorXd symmetricEigenvaluesOf(const Eigen::MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::VectorXd squaredFrequenciesOf(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, M, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace vehicle::test
