#include "libvehicle/integrate/matrix_exponential.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "libvehicle/system/dense_solvers.h"

namespace vehicle {
namespace {

// Largest |A|_1 for which the [13/13] approximant is exact to double precision. Higham 2005, table 2.3.
constexpr double kTheta13 = 5.371920351148152;

// Numerator of the approximant, constant term first. Higham 2005, (2.17).
constexpr std::array<double, 14> kPade13 = {
    64764752532480000.0, 32382376266240000.0, 7771770303897600.0, 1187353796428800.0, 129060195264000.0,
    10559470521600.0,    670442572800.0,      33522128640.0,      1323241920.0,       40840800.0,
    960960.0,            16380.0,             182.0,              1.0};

void requireSquareAndFinite(const Eigen::MatrixXd& A) {
  if (A.rows() != A.cols()) {
    throw std::invalid_argument("matrix exponential: A is " + std::to_string(A.rows()) + " x " +
                                std::to_string(A.cols()) + ", must be square");
  }
  if (!A.allFinite()) throw std::invalid_argument("matrix exponential: A has an entry that is not finite");
}

}  // namespace

Eigen::MatrixXd expMinusIdentity(const Eigen::MatrixXd& A) {
  requireSquareAndFinite(A);
  if (A.size() == 0) return A;
  const double norm = A.cwiseAbs().colwise().sum().maxCoeff();
  const int squarings = norm > kTheta13 ? static_cast<int>(std::ceil(std::log2(norm / kTheta13))) : 0;
  const Eigen::MatrixXd A1 = A * std::ldexp(1.0, -squarings);

  const auto& b = kPade13;
  const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(A.rows(), A.cols());
  const Eigen::MatrixXd A2 = A1 * A1;
  const Eigen::MatrixXd A4 = A2 * A2;
  const Eigen::MatrixXd A6 = A4 * A2;
  const Eigen::MatrixXd odd_high = b[13] * A6 + b[11] * A4 + b[9] * A2;
  const Eigen::MatrixXd odd = A6 * odd_high + b[7] * A6 + b[5] * A4 + b[3] * A2 + b[1] * I;
  const Eigen::MatrixXd U = A1 * odd;
  const Eigen::MatrixXd even_high = b[12] * A6 + b[10] * A4 + b[8] * A2;
  const Eigen::MatrixXd V = A6 * even_high + b[6] * A6 + b[4] * A4 + b[2] * A2 + b[0] * I;

  Eigen::MatrixXd E = (V - U).partialPivLu().solve(2.0 * U);
  for (int i = 0; i < squarings; ++i) E = E * E + 2.0 * E;
  return E;
}

Eigen::MatrixXd matrixExponential(const Eigen::MatrixXd& A) {
  return expMinusIdentity(A) + Eigen::MatrixXd::Identity(A.rows(), A.cols());
}

Eigen::VectorXd balancingScales(const Eigen::MatrixXd& A) {
  requireSquareAndFinite(A);
  const Eigen::Index n = A.rows();
  Eigen::VectorXd scales = Eigen::VectorXd::Ones(n);
  Eigen::MatrixXd size = A.cwiseAbs();
  size.diagonal().setZero();
  bool changed = true;
  // Matrices that fall apart into one-way parts have no balance; the limit keeps their scales finite.
  for (int sweep = 0; changed && sweep < 50; ++sweep) {
    changed = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double column = size.col(i).sum();
      const double row = size.row(i).sum();
      if (column == 0.0 || row == 0.0) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      if (!(column * factor + row / factor < 0.95 * (column + row))) continue;
      scales(i) *= factor;
      size.col(i) *= factor;
      size.row(i) /= factor;
      changed = true;
    }
  }
  return scales;
}

}  // namespace vehicle
