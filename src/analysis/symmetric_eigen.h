/// Eigenvalues and eigenvectors of symmetric matrices of any size.
#pragma once
#include <cstddef>

namespace weft {

/// `matrix` (size x size, row by row) becomes diagonal, its eigenvalues there; row k of `vectors`, if not NULL, becomes
/// the k-th eigenvector. Cyclic Jacobi rotations (Golub and Van Loan, section 8.5).
void diagonalise(double* matrix, double* vectors, std::size_t size) noexcept;

} // namespace weft
