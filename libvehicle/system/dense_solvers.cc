#include "libvehicle/system/dense_solvers.h"

#include <complex>

namespace Eigen {

template EigenSolver<MatrixXd>& EigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
template RealSchur<MatrixXd>& RealSchur<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);
template void PartialPivLU<MatrixXd>::compute();
template void PartialPivLU<MatrixXcd>::compute();

namespace internal {

template struct triangular_solve_matrix<double, Index, OnTheLeft, UnitLower, false, ColMajor, ColMajor, 1>;
template struct triangular_solve_matrix<double, Index, OnTheLeft, Upper, false, ColMajor, ColMajor, 1>;
template struct triangular_solve_matrix<std::complex<double>, Index, OnTheLeft, UnitLower, false, ColMajor, ColMajor,
                                        1>;
template struct triangular_solve_matrix<std::complex<double>, Index, OnTheLeft, Upper, false, ColMajor, ColMajor, 1>;
}  // namespace internal

}  // namespace Eigen
