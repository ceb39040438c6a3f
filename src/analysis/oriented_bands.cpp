/// In the Fourier domain: i cos^3 of the angle, two octaves around 1/4 cycle per pixel.
#include "analysis/oriented_bands.h"
#include "analysis/spectra.h"
#include <cmath>

namespace weft {
namespace {

constexpr double middle = 0.25; // cycles per pixel
constexpr double half_root = 0.7071067811865476;
constexpr double directions[orientations][2] = {{1, 0}, {half_root, half_root}, {0, 1}, {-half_root, half_root}};

double gain(double fx, double fy, std::uint32_t orientation) noexcept
{
    const double radius = std::sqrt(fx * fx + fy * fy);
    if (!(radius > 0)) return 0;
    const double octave = std::log2(radius / middle);
    if (std::abs(octave) >= 1) return 0;
    const double* direction = directions[orientation];
    const double cosine = (fx * direction[0] + fy * direction[1]) / radius;
    return std::cos(1.5707963267948966 * octave) * cosine * cosine * cosine;
}

} // namespace

Planes oriented_bands(Core& core, const float* plane, std::uint32_t width, std::uint32_t height)
{
    const PlaneTransform transform(core, width, height);
    Spectra spectrum(&core.memory, width, height, 1), band(&core.memory, width, height, 1);
    transform.forward(plane, spectrum, 0);
    Planes bands(&core.memory, width, height, orientations, Array<float>::unset);
    for (std::uint32_t o = 0; o < orientations; ++o) {
        for_each_run(core.parallel, spectrum.columns(), [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t x = first; x < last; ++x)
                for (std::uint32_t y = 0; y < height; ++y) {
                    const double fx = static_cast<double>(x) / width;
                    const double fy = (2 * y <= height ? y : y - static_cast<double>(height)) / height;
                    const bool own_opposite = 2 * x == width || 2 * y == height; // an odd filter is 0 there
                    const double factor = own_opposite ? 0 : gain(fx, fy, o) / (static_cast<double>(width) * height);
                    const Complex value = spectrum.at(0, x, y) * static_cast<float>(factor);
                    band.at(0, x, y) = Complex(-value.imag(), value.real());
                }
        });
        transform.backward(band, 0, bands.plane(o));
    }
    return bands;
}

} // namespace weft
