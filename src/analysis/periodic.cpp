/// The periodic component in closed form: the smooth component's spectrum needs two one-dimensional transforms only.
#include "analysis/periodic.h"
#include <cmath>

namespace weft {
namespace {

using Wide = std::complex<double>;
constexpr double pi = 3.141592653589793;

/// DFT, all of it, of the jump from the last to the first value across one border.
Array<Wide> jump_spectrum(Core& core, const float* first, const float* last, std::uint32_t length, std::size_t step)
{
    Array<float> jump(&core.memory, length);
    Array<Complex> half(&core.memory, length / 2 + 1);
    for (std::uint32_t i = 0; i < length; ++i) jump[i] = last[i * step] - first[i * step];
    RowTransform(&core.memory, length).forward(jump.data(), half.data());
    Array<Wide> whole(&core.memory, length);
    for (std::uint32_t i = 0; i < length; ++i)
        whole[i] = i < half.size() ? Wide(half[i]) : std::conj(Wide(half[length - i]));
    return whole;
}

/// One axis: 4 sin^2(theta / 2), the Laplacian's share, and 1 - e^(i theta), the DFT of +1 at the first and -1 at the
/// last pixel, for theta = 2 pi k / length. Both by sin(theta / 2), which keeps their digits at low frequencies.
struct Axis {
    Axis(std::pmr::memory_resource* memory, std::uint32_t length) : laplacian(memory, length), border(memory, length)
    {
        for (std::uint32_t k = 0; k < length; ++k) {
            const double half_angle = pi * k / length, sine = std::sin(half_angle);
            laplacian[k] = 4 * sine * sine;
            border[k] = Wide(2 * sine * sine, -2 * sine * std::cos(half_angle));
        }
    }
    Array<double> laplacian;
    Array<Wide> border;
};

Wide product(Wide a, Wide b) noexcept
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

} // namespace

void keep_periodic_component(Core& core, const Planes& planes, Spectra& spectra)
{
    const std::uint32_t width = planes.width, height = planes.height;
    const Axis along_x(&core.memory, width), along_y(&core.memory, height);
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        const float* plane = planes.plane(c);
        const Array<Wide> jump_y = jump_spectrum(core, plane, planes.row(c, height - 1), width, 1);
        const Array<Wide> jump_x = jump_spectrum(core, plane, plane + width - 1, height, width);
        for_each_run(core.parallel, spectra.blocks(), [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t x = first * fft_lanes; x < last * fft_lanes && x < spectra.columns(); ++x)
                for (std::uint32_t y = 0; y < height; ++y) {
                    if (x == 0 && y == 0) continue; // the smooth component has mean 0
                    const Wide border = product(jump_y[x], along_y.border[y]) + product(jump_x[y], along_x.border[x]);
                    spectra.at(c, x, y) += Complex(border / (along_x.laplacian[x] + along_y.laplacian[y]));
                }
        });
    }
}

} // namespace weft
