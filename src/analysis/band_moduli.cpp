/// One-sided filters in the Fourier domain: real and imaginary parts by two real transforms.
#include "analysis/band_moduli.h"
#include "analysis/white_noise.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double finest = 0.3; // cycles per pixel, the middle of the finest band

/// Of the filter at a frequency: positive along its direction, negative against it, an octave wide to both sides.
double gain(double fx, double fy, std::uint32_t band) noexcept
{
    const double radius = std::sqrt(fx * fx + fy * fy);
    if (radius == 0) return 0;
    const double octave = std::log2(radius / finest) + band / moduli_orientations;
    if (std::abs(octave) >= 1) return 0;
    const double angle = std::atan2(fy, fx) - pi * (band % moduli_orientations) / moduli_orientations,
                 cosine = std::cos(angle);
    return std::cos(0.5 * pi * octave) * cosine * cosine * cosine;
}

/// Both Hermitian parts of a band: the even one, and the odd one times -i.
void filter(Core& core, const Spectra& spectrum, std::uint32_t band, Spectra& parts)
{
    for_each_run(core.parallel, spectrum.blocks(), [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t x = first * fft_lanes; x < last * fft_lanes && x < spectrum.columns(); ++x)
            for (std::uint32_t y = 0; y < spectrum.height; ++y) {
                const double fy =
                    (y <= spectrum.height / 2 ? y : y - static_cast<double>(spectrum.height)) / spectrum.height;
                const bool ambiguous =
                    2 * x == spectrum.width || 2 * y == spectrum.height; // its own opposite on an axis
                const float g =
                    ambiguous ? 0.0f : static_cast<float>(gain(static_cast<double>(x) / spectrum.width, fy, band));
                const Complex value = spectrum.at(0, x, y);
                parts.at(0, x, y) = std::abs(g) * value;
                parts.at(1, x, y) = g * Complex(value.imag(), -value.real());
            }
    });
}

} // namespace

Moduli_correlations moduli_correlations(Core& core, const PlaneTransform& transform, const Spectra& spectrum)
{
    const std::uint32_t width = spectrum.width, height = spectrum.height;
    Planes moduli(&core.memory, width, height, moduli_bands), imaginary(&core.memory, width, height, 1);
    Spectra parts(&core.memory, width, height, 2);
    double deviation[moduli_bands];
    for (std::uint32_t band = 0; band < moduli_bands; ++band) {
        filter(core, spectrum, band, parts);
        transform.backward(parts, 0, moduli.plane(band));
        transform.backward(parts, 1, imaginary.plane(0));
        float* plane = moduli.plane(band);
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < moduli.area(); ++i) {
            plane[i] = std::sqrt(plane[i] * plane[i] + imaginary.values[i] * imaginary.values[i]);
            sum += static_cast<double>(plane[i]);
        }
        const double mean = sum / static_cast<double>(moduli.area());
        for (std::size_t i = 0; i < moduli.area(); ++i) {
            plane[i] -= static_cast<float>(mean);
            squares += static_cast<double>(plane[i]) * static_cast<double>(plane[i]);
        }
        deviation[band] = std::sqrt(squares);
    }
    Moduli_correlations result;
    core.parallel.for_each_index(moduli_bands, [&](std::uint32_t i) {
        for (std::uint32_t j = 0; j < i; ++j) {
            const float *a = moduli.plane(i), *b = moduli.plane(j);
            double sums[4] = {};
            for (std::size_t k = 0; k < moduli.area(); ++k) sums[k % 4] += static_cast<double>(a[k] * b[k]);
            const double product = deviation[i] * deviation[j];
            result.value[i][j] = product > 0 ? ((sums[0] + sums[1]) + (sums[2] + sums[3])) / product : 0;
        }
    });
    return result;
}

double distance_of(const Moduli_correlations& a, const Moduli_correlations& b) noexcept
{
    double sum = 0;
    for (std::uint32_t i = 0; i < moduli_bands; ++i)
        for (std::uint32_t j = 0; j < i; ++j) sum += std::pow(a.value[i][j] - b.value[i][j], 2);
    return std::sqrt(sum / (moduli_bands * (moduli_bands - 1) / 2));
}

void randomise_phases(Core& core, const Spectra& spectrum, std::uint64_t seed, Spectra& result)
{
    for_each_run(core.parallel, spectrum.blocks(), [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t x = first * fft_lanes; x < last * fft_lanes && x < spectrum.columns(); ++x)
            for (std::uint32_t y = 0; y < spectrum.height; ++y) {
                const bool folded = x == 0 || 2 * x == spectrum.width; // columns that hold their own conjugates
                const std::uint32_t opposite = y ? spectrum.height - y : 0, from = folded ? std::min(y, opposite) : y;
                const Complex normal = normal_pair(seed, std::uint64_t{x} << 32 | from);
                const float modulus = std::abs(normal), power = std::abs(spectrum.at(0, x, y));
                const Complex phase =
                    folded && y == opposite ? Complex(normal.real() < 0 ? -1.0f : 1.0f) : normal / modulus;
                result.at(0, x, y) = power * (folded && y > opposite ? std::conj(phase) : phase);
            }
    });
}

} // namespace weft
