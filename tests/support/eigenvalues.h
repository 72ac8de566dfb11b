#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

// Eigen's solvers take the compiler seconds, under sanitizers half a minute: compiled once a program, in
// eigenvalues.cc.
namespace vehicle::test {

Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& A);

/// Of each conjugate pair the one with positive imaginary part, sorted by size.
std::vector<std::complex<double>> oscillationsOf(const Eigen::MatrixXd& A);

/// Of a symmetric matrix, ascending.
Eigen::VectorXd symmetricEigenvaluesOf(const Eigen::MatrixXd& A);

/// w^2 of K v = w^2 M v with symmetric K and positive definite M, ascending.
Eigen::VectorXd squaredFrequenciesOf(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M);

}  // namespace vehicle::test
