#include "libvehicle/linear/complex_svd.h"

namespace Eigen {

template JacobiSVD<MatrixXcd>& JacobiSVD<MatrixXcd>::compute(const MatrixXcd&, unsigned int);

}  // namespace Eigen
