/// Small symmetric matrices by their eigenvectors.
#include "analysis/matrix.h"
#include "analysis/symmetric_eigen.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

/// vectors * diag(f(values)) * transposed vectors.
template <class Function> Matrix function_of(const Eigen& eigen, const Function& f) noexcept
{
    Matrix result;
    result.size = eigen.vectors.size;
    for (std::uint32_t k = 0; k < result.size; ++k) {
        const double value = f(eigen.values[k]);
        for (std::uint32_t i = 0; i < result.size; ++i)
            for (std::uint32_t j = 0; j < result.size; ++j)
                result[i][j] += value * eigen.vectors[i][k] * eigen.vectors[j][k];
    }
    return result;
}

} // namespace

Matrix operator*(const Matrix& a, const Matrix& b) noexcept
{
    Matrix product;
    product.size = a.size;
    for (std::uint32_t i = 0; i < a.size; ++i)
        for (std::uint32_t k = 0; k < a.size; ++k)
            for (std::uint32_t j = 0; j < a.size; ++j) product[i][j] += a[i][k] * b[k][j];
    return product;
}

Eigen eigen_of(const Matrix& symmetric) noexcept
{
    const std::uint32_t size = symmetric.size;
    double packed[most_channels * most_channels], vectors[most_channels * most_channels];
    for (std::uint32_t i = 0; i < size; ++i) std::copy_n(symmetric[i], size, packed + i * size);
    diagonalise(packed, vectors, size);
    Eigen eigen;
    eigen.vectors.size = size;
    for (std::uint32_t k = 0; k < size; ++k) {
        eigen.values[k] = packed[k * size + k];
        for (std::uint32_t i = 0; i < size; ++i) eigen.vectors[i][k] = vectors[k * size + i];
    }
    return eigen;
}

Matrix square_root(const Matrix& symmetric) noexcept
{
    return function_of(eigen_of(symmetric), [](double value) { return value > 0 ? std::sqrt(value) : 0.0; });
}

Matrix inverse_square_root(const Matrix& symmetric, double rank_tolerance) noexcept
{
    const Eigen eigen = eigen_of(symmetric);
    const double least = rank_tolerance * *std::max_element(eigen.values, eigen.values + symmetric.size);
    return function_of(eigen,
                       [least](double value) { return value > least && value > 0 ? 1 / std::sqrt(value) : 0.0; });
}

} // namespace weft
