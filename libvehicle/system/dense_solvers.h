#pragma once

#include <complex>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

// Eigen's solvers of dense matrices, compiled once, in dense_solvers.cc: eigenvalues take the compiler 15 s, under
// sanitizers half a minute, in every file that asks for them. A file that includes this instead of <Eigen/Eigenvalues>
// or <Eigen/LU> calls those; the results have the same bits.
namespace Eigen {

extern template EigenSolver<MatrixXd>& EigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
extern template RealSchur<MatrixXd>& RealSchur<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
extern template void PartialPivLU<MatrixXd>::compute();
extern template void PartialPivLU<MatrixXcd>::compute();

namespace internal {
// The two halves of PartialPivLU::solve(): L with ones on its diagonal, U as it is.
extern template struct triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false, ColMajor, ColMajor, 1>;
extern template struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, ColMajor, ColMajor, 1>;
extern template struct triangular_solve_matrix<std::complex<double>, Index, OnTheLeft, UnitLower, false, ColMajor,
                                               ColMajor, 1>;
extern template struct triangular_solve_matrix<std::complex<double>, Index, OnTheLeft, Upper, false, ColMajor, ColMajor,
                                               1>;
}  // namespace internal

}  // namespace Eigen
