/// Symmetric matrices by Jacobi rotations: at most 16 x 16, so that accuracy counts and speed does not.
#include "analysis/matrix.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr int most_sweeps = 60; // ten are enough for 16 x 16; the bound only keeps the loop finite

/// One rotation in the plane (p, q) that makes a[p][q] zero (Golub and Van Loan, section 8.5).
void rotate(Matrix& a, Matrix& vectors, std::uint32_t p, std::uint32_t q) noexcept
{
    const double tau = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = (tau >= 0 ? 1 : -1) / (std::abs(tau) + std::sqrt(1 + tau * tau));
    const double c = 1 / std::sqrt(1 + t * t), s = t * c;
    const auto turn = [c, s](double& x, double& y) {
        const double u = c * x - s * y, v = s * x + c * y;
        x = u, y = v;
    };
    for (std::uint32_t i = 0; i < a.size; ++i) turn(a[i][p], a[i][q]);
    for (std::uint32_t i = 0; i < a.size; ++i) turn(a[p][i], a[q][i]);
    for (std::uint32_t i = 0; i < a.size; ++i) turn(vectors[i][p], vectors[i][q]);
    a[p][q] = a[q][p] = 0;
}

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
    Matrix a = symmetric;
    Eigen eigen;
    eigen.vectors.size = a.size;
    for (std::uint32_t i = 0; i < a.size; ++i) eigen.vectors[i][i] = 1;
    bool rotated = true;
    for (int sweep = 0; sweep < most_sweeps && rotated; ++sweep) {
        rotated = false;
        for (std::uint32_t p = 0; p + 1 < a.size; ++p)
            for (std::uint32_t q = p + 1; q < a.size; ++q) {
                if (std::abs(a[p][q]) <= 1e-17 * std::sqrt(std::abs(a[p][p])) * std::sqrt(std::abs(a[q][q]))) continue;
                rotate(a, eigen.vectors, p, q);
                rotated = true;
            }
    }
    for (std::uint32_t i = 0; i < a.size; ++i) eigen.values[i] = a[i][i];
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
