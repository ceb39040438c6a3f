/// Small symmetric matrices, up to a channel each way: eigenvectors, roots, pseudo-inverse roots.
#pragma once
#include "model/model.h"

namespace weft {

struct Matrix {
    std::uint32_t size = 0;
    double values[most_channels][most_channels] = {};

    double* operator[](std::uint32_t row) noexcept { return values[row]; }
    const double* operator[](std::uint32_t row) const noexcept { return values[row]; }
};

Matrix operator*(const Matrix& a, const Matrix& b) noexcept;

/// `symmetric` = vectors * diag(values) * transposed vectors.
struct Eigen {
    Matrix vectors;
    double values[most_channels] = {};
};
Eigen eigen_of(const Matrix& symmetric) noexcept;

/// The square root of a positive semi-definite matrix; eigenvalues that are negative by rounding count as 0.
Matrix square_root(const Matrix& symmetric) noexcept;

/// The square root of its pseudo-inverse: eigenvalues below `rank_tolerance` times the largest count as 0.
Matrix inverse_square_root(const Matrix& symmetric, double rank_tolerance) noexcept;

} // namespace weft
