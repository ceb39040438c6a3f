/// Jacobi rotations of rows, the matrix kept whole so that both halves are walked along memory.
#include "analysis/symmetric_eigen.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr int most_sweeps = 40; // ten are enough for a hundred rows; the bound only keeps the loop finite

void turn_rows(double* p, double* q, double c, double s, std::size_t size) noexcept
{
    for (std::size_t i = 0; i < size; ++i) {
        const double u = p[i], v = q[i];
        p[i] = c * u - s * v;
        q[i] = s * u + c * v;
    }
}

void rotate(double* a, double* vectors, std::size_t size, std::size_t p, std::size_t q) noexcept
{
    const double app = a[p * size + p], aqq = a[q * size + q], apq = a[p * size + q];
    const double tau = (aqq - app) / (2 * apq);
    const double t = (tau >= 0 ? 1 : -1) / (std::abs(tau) + std::sqrt(1 + tau * tau));
    const double c = 1 / std::sqrt(1 + t * t), s = t * c;
    turn_rows(a + p * size, a + q * size, c, s, size);
    for (std::size_t i = 0; i < size; ++i) a[i * size + p] = a[p * size + i], a[i * size + q] = a[q * size + i];
    a[p * size + p] = app - t * apq;
    a[q * size + q] = aqq + t * apq;
    a[p * size + q] = a[q * size + p] = 0;
    if (vectors) turn_rows(vectors + p * size, vectors + q * size, c, s, size);
}

} // namespace

void diagonalise(double* matrix, double* vectors, std::size_t size) noexcept
{
    for (std::size_t i = 0; vectors && i < size * size; ++i) vectors[i] = i % (size + 1) == 0 ? 1 : 0;
    double trace = 0;
    for (std::size_t i = 0; i < size; ++i) trace += std::abs(matrix[i * size + i]);
    bool rotated = true;
    for (int sweep = 0; sweep < most_sweeps && rotated; ++sweep) {
        rotated = false;
        for (std::size_t p = 0; p + 1 < size; ++p)
            for (std::size_t q = p + 1; q < size; ++q) {
                if (std::abs(matrix[p * size + q]) <= 1e-16 * trace) continue;
                rotate(matrix, vectors, size, p, q);
                rotated = true;
            }
    }
}

} // namespace weft
