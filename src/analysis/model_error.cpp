/// Relative model error: the optimal transport distance of the Gaussian textures with the two pictures' spectra.
#include "analysis/compare_metrics.h"
#include "analysis/cross_spectrum.h"
#include "analysis/symmetric_eigen.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t largest_segment = 64;
constexpr double rank_tolerance = 1e-14;

struct Hermitian {
    std::uint32_t size;
    std::complex<double> values[most_channels][most_channels];

    explicit Hermitian(const CrossSpectrum& spectrum, std::size_t frequency) noexcept : size(spectrum.channels)
    {
        const std::complex<double>* lower = spectrum.at(frequency);
        for (std::uint32_t c = 0; c < size; ++c)
            for (std::uint32_t d = 0; d <= c; ++d, ++lower) values[c][d] = *lower, values[d][c] = std::conj(*lower);
    }
    double trace() const noexcept
    {
        double sum = 0;
        for (std::uint32_t c = 0; c < size; ++c) sum += values[c][c].real();
        return sum;
    }
};

/// Without the standard operator's care for infinities, which costs a call.
std::complex<double> times(std::complex<double> a, std::complex<double> b) noexcept
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// The lower triangle L of a positive semi-definite matrix L L*; a column whose pivot is rounding becomes zero.
void factorise(Hermitian& a) noexcept
{
    double greatest = 0;
    for (std::uint32_t k = 0; k < a.size; ++k) greatest = std::max(greatest, a.values[k][k].real());
    for (std::uint32_t k = 0; k < a.size; ++k) {
        const double pivot = a.values[k][k].real();
        const double inverse_root = pivot > rank_tolerance * greatest ? 1 / std::sqrt(pivot) : 0;
        for (std::uint32_t i = k; i < a.size; ++i) a.values[i][k] *= inverse_root;
        for (std::uint32_t i = k + 1; i < a.size; ++i)
            for (std::uint32_t j = k + 1; j <= i; ++j)
                a.values[i][j] -= times(a.values[i][k], std::conj(a.values[j][k]));
        for (std::uint32_t i = 0; i < k; ++i) a.values[i][k] = 0;
    }
}

/// tr((A^1/2 B A^1/2)^1/2): the sum of the roots of the eigenvalues of L* B L, A = L L*.
double fidelity(Hermitian a, const Hermitian& b) noexcept
{
    const std::uint32_t n = a.size;
    if (n == 1) return std::sqrt(std::max(0.0, a.values[0][0].real() * b.values[0][0].real()));
    factorise(a);
    std::complex<double> product[most_channels][most_channels] = {};
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t k = j; k < n; ++k) product[i][j] += times(b.values[i][k], a.values[k][j]);
    // A Hermitian matrix X + iY has the eigenvalues of the symmetric [X -Y; Y X], which has each of them twice.
    double real[4 * most_channels * most_channels];
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            std::complex<double> sum = 0;
            for (std::uint32_t k = i; k < n; ++k) sum += times(std::conj(a.values[k][i]), product[k][j]);
            real[i * 2 * n + j] = real[(i + n) * 2 * n + j + n] = sum.real();
            real[(i + n) * 2 * n + j] = sum.imag();
            real[i * 2 * n + j + n] = -sum.imag();
        }
    diagonalise(real, nullptr, std::size_t{2} * n);
    double roots = 0;
    for (std::uint32_t i = 0; i < 2 * n; ++i) roots += std::sqrt(std::max(0.0, real[i * (2 * n + 1)])) / 2;
    return roots;
}

std::uint32_t segment_of(const Pair& pair) noexcept
{
    const std::uint32_t side =
        std::min({pair.exemplar.width, pair.exemplar.height, pair.output.width, pair.output.height});
    std::uint32_t edge = largest_segment;
    while (edge > side) edge /= 2;
    return edge;
}

} // namespace

double model_error(Core& core, const Pair& pair, const Progress& progress)
{
    if (!pair.exemplar_varies) return undefined;
    const TileTransform transform(core, segment_of(pair));
    const double zero[most_channels] = {}; // the exemplar's mean in a pair
    const CrossSpectrum exemplar = cross_spectrum_of(core, pair.exemplar, zero, transform, progress.part(0, 0.3));
    const CrossSpectrum output =
        cross_spectrum_of(core, pair.output, pair.output_mean, transform, progress.part(0.3, 0.7));

    struct Sums {
        double distance = 0, power = 0;
    };
    const auto runs = static_cast<std::uint32_t>(transform.frequencies() / fft_lanes);
    Array<Sums> sums(&core.memory, runs);
    const double n = pair.channels();
    for_each_step(core, runs, fft_lanes * 300 * n * n * n, progress.part(0.7, 1), [&](std::uint32_t run) {
        for (std::size_t i = run * fft_lanes; i < (run + 1) * fft_lanes; ++i) {
            const double weight = transform.weight(i);
            if (weight <= 0) continue;
            const Hermitian a(exemplar, i), b(output, i);
            sums[run].power += weight * a.trace();
            sums[run].distance += weight * (a.trace() + b.trace() - 2 * fidelity(a, b));
        }
    });
    double distance = 0, power = 0;
    for (const Sums& each : sums) distance += each.distance, power += each.power;
    for (std::uint32_t c = 0; c < pair.channels(); ++c) distance += pair.output_mean[c] * pair.output_mean[c];
    return power > 0 ? std::sqrt(std::max(distance, 0.0) / power) : undefined;
}

} // namespace weft
