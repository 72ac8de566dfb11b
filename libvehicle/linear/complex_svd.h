#pragma once

#include <Eigen/SVD>

// Singular values of complex matrices, compiled once, in complex_svd.cc, as in system/dense_solvers.h.
namespace Eigen {

extern template JacobiSVD<MatrixXcd>& JacobiSVD<MatrixXcd>::compute(const MatrixXcd&, unsigned int);

}  // namespace Eigen
