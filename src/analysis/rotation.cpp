/// Matching by enumeration; powers of a rotation by the eigenvectors of its symmetric half.
#include "analysis/rotation.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t most_enumerated = 6;

Matrix transposed(const Matrix& a) noexcept
{
    Matrix result;
    result.size = a.size;
    for (std::uint32_t i = 0; i < a.size; ++i)
        for (std::uint32_t j = 0; j < a.size; ++j) result[i][j] = a[j][i];
    return result;
}

/// By elimination with pivots: only its sign matters.
double determinant(Matrix a) noexcept
{
    double product = 1;
    for (std::uint32_t i = 0; i < a.size; ++i) {
        std::uint32_t pivot = i;
        for (std::uint32_t k = i + 1; k < a.size; ++k)
            if (std::abs(a[k][i]) > std::abs(a[pivot][i])) pivot = k;
        if (a[pivot][i] == 0) return 0;
        if (pivot != i) {
            std::swap_ranges(a[i], a[i] + a.size, a[pivot]);
            product = -product;
        }
        product *= a[i][i];
        for (std::uint32_t k = i + 1; k < a.size; ++k) {
            const double factor = a[k][i] / a[i][i];
            for (std::uint32_t j = i; j < a.size; ++j) a[k][j] -= factor * a[i][j];
        }
    }
    return product;
}

Matrix reordered(const Matrix& to, const Axis_match& match) noexcept
{
    Matrix result;
    result.size = to.size;
    for (std::uint32_t p = 0; p < to.size; ++p)
        for (std::uint32_t c = 0; c < to.size; ++c) result[p][c] = match.sign[p] * to[match.order[p]][c];
    return result;
}

/// Signs for an order: every cosine positive, but for the smallest if the frames' orientations differ. Returns their
/// sum.
double choose_signs(const Matrix& from, const Matrix& to, const Matrix& cosines, Axis_match& match) noexcept
{
    std::uint32_t weakest = 0;
    double sum = 0, least = 2;
    for (std::uint32_t p = 0; p < from.size; ++p) {
        const double cosine = cosines[p][match.order[p]];
        match.sign[p] = cosine < 0 ? -1 : 1;
        sum += std::abs(cosine);
        if (std::abs(cosine) <= least) least = std::abs(cosine), weakest = p;
    }
    if ((determinant(reordered(to, match)) < 0) == (determinant(from) < 0)) return sum;
    match.sign[weakest] = -match.sign[weakest];
    return sum - 2 * least;
}

void order_greedily(const Matrix& cosines, Axis_match& match) noexcept
{
    bool row_taken[most_channels] = {}, column_taken[most_channels] = {};
    for (std::uint32_t step = 0; step < cosines.size; ++step) {
        double best = -1;
        std::uint32_t row = 0, column = 0;
        for (std::uint32_t p = 0; p < cosines.size; ++p)
            for (std::uint32_t q = 0; q < cosines.size; ++q)
                if (!row_taken[p] && !column_taken[q] && std::abs(cosines[p][q]) > best)
                    best = std::abs(cosines[p][q]), row = p, column = q;
        row_taken[row] = column_taken[column] = true;
        match.order[row] = column;
    }
}

/// The nearest orthogonal matrix.
Matrix orthogonal(const Matrix& a) noexcept { return inverse_square_root(a * transposed(a), 0) * a; }

/// result += factor * u * transposed v.
void add_product(Matrix& result, double factor, const double* u, const double* v) noexcept
{
    for (std::uint32_t i = 0; i < result.size; ++i)
        for (std::uint32_t j = 0; j < result.size; ++j) result[i][j] += factor * u[i] * v[j];
}

/// rotation^t. Where its symmetric half has the eigenvalue cos(theta), its other half K turns by a right angle and
/// scales by sin(theta), so that rotation^t is cos(t theta) + sin(t theta) / sin(theta) K there.
Matrix power_of_rotation(const Matrix& rotation, double t) noexcept
{
    const std::uint32_t n = rotation.size;
    Matrix even = rotation, odd = rotation, result;
    even.size = odd.size = result.size = n;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            even[i][j] = 0.5 * (rotation[i][j] + rotation[j][i]);
            odd[i][j] = 0.5 * (rotation[i][j] - rotation[j][i]);
        }
    const Matrix vectors = transposed(eigen_of(even).vectors);
    const double* unpaired = nullptr;
    for (std::uint32_t k = 0; k < n; ++k) {
        const double* v = vectors[k];
        double turned[most_channels], cosine = 0, square = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            double sum = turned[i] = 0;
            for (std::uint32_t j = 0; j < n; ++j) turned[i] += odd[i][j] * v[j], sum += even[i][j] * v[j];
            cosine += v[i] * sum;
            square += turned[i] * turned[i];
        }
        const double sine = std::sqrt(square), angle = std::atan2(sine, cosine);
        add_product(result, std::cos(t * angle), v, v);
        if (sine > 1e-7) {
            add_product(result, std::sin(t * angle) / sine, turned, v);
        } else if (cosine > 0) {
            add_product(result, t, turned, v);
        } else if (unpaired) { // half a turn, in any plane: of this vector and another such
            add_product(result, std::sin(t * angle), v, unpaired);
            add_product(result, -std::sin(t * angle), unpaired, v);
            unpaired = nullptr;
        } else {
            unpaired = v;
        }
    }
    return result;
}

} // namespace

Axis_match match_axes(const Matrix& from, const Matrix& to) noexcept
{
    const Matrix cosines = from * transposed(to);
    Axis_match match{};
    for (std::uint32_t p = 0; p < from.size; ++p) match.order[p] = p;
    if (from.size > most_enumerated) {
        order_greedily(cosines, match);
        choose_signs(from, to, cosines, match);
        return match;
    }
    Axis_match best = match;
    double greatest = -2.0 * most_channels;
    do {
        const double sum = choose_signs(from, to, cosines, match);
        if (sum > greatest + 1e-9) greatest = sum, best = match;
    } while (std::next_permutation(match.order, match.order + from.size));
    return best;
}

Matrix rotate_frame(const Matrix& from, const Matrix& to, double t) noexcept
{
    const Matrix begin = orthogonal(from);
    const Matrix rotation = orthogonal(transposed(to) * from); // takes each axis of `from` to that of `to`
    return begin * transposed(power_of_rotation(rotation, t));
}

} // namespace weft
