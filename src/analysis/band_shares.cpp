/// The spectrum of wavelet noise in closed form, and the system that its bands' overlap makes.
#include "analysis/band_power.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double pi = 3.141592653589793;
constexpr std::uint32_t points = 48; ///< of the midpoint rule, from frequency 0 to an octave's end

/// Fourier transform of the quadratic B-spline's products with its neighbours.
double products(double f) noexcept { return (66 + 52 * std::cos(2 * pi * f) + 2 * std::cos(4 * pi * f)) / 120; }

double sixth_power(double x) noexcept { return x * x * x * (x * x * x); }

/// What is left of white noise R in R - R down-up (Cook and DeRose 2005): along each axis, a frequency keeps `same` of
/// its own amplitude in R down-up, an orthogonal projection on coarser splines, and `power` of power is there, its own
/// and its alias's.
struct Lattice_axis {
    explicit Lattice_axis(double f) noexcept
    {
        const double own = sixth_power(std::cos(pi * f)), alias = sixth_power(std::sin(pi * f));
        const double b = products(f), c = products(f + 0.5), total = own * b + alias * c;
        same = own * b / total;
        power = own * (own * b * b + alias * c * c) / (total * total);
    }
    double same, power;
};

/// One axis of a band's spectrum at the centres of pixels.
struct Band_axis {
    Band_axis(double f, std::uint32_t band) noexcept : lattice(std::ldexp(f, static_cast<int>(band)))
    {
        const double spline = 0.75 + 0.25 * std::cos(2 * pi * f); // 1/8, 3/4, 1/8
        gain = spline * spline;
        for (std::uint32_t i = 0; i < band; ++i)
            gain *= sixth_power(std::cos(pi * std::ldexp(f, static_cast<int>(i)))); // refinements
    }
    Lattice_axis lattice;
    double gain;
};

/// Power of the band with max(fx, fy) between half of `end` and `end`, or all below `end`, up to a factor of the
/// band's.
double power_below(double end, std::uint32_t band, bool all) noexcept
{
    double gain[points], same[points], power[points], sum = 0;
    for (std::uint32_t i = 0; i < points; ++i) {
        const Band_axis axis((i + 0.5) / points * end, band);
        gain[i] = axis.gain;
        same[i] = axis.lattice.same;
        power[i] = axis.lattice.power;
    }
    for (std::uint32_t i = 0; i < points; ++i)
        for (std::uint32_t j = 0; j < points; ++j)
            if (all || std::max(i, j) >= points / 2)
                sum += gain[i] * gain[j] * (1 - 2 * same[i] * same[j] + power[i] * power[j]);
    return sum * end * end;
}

/// `x` of the bands that are not `fixed` at 0, by least squares; rows count by the inverse of the octave's power.
void solve_free(const Band_shares& shares, const Octaves& octaves, const bool* fixed, double* x) noexcept
{
    const std::uint32_t n = shares.count;
    double total = 0, a[most_bands][most_bands + 1] = {};
    for (std::uint32_t k = 0; k < n; ++k) total += octaves.power[k];
    for (std::uint32_t k = 0; k < n; ++k) {
        const double unit = 1 / std::max(octaves.power[k], 1e-9 * total), weight = unit * unit;
        for (std::uint32_t i = 0; i < n; ++i) {
            for (std::uint32_t j = 0; j < n; ++j) a[i][j] += weight * shares.share[k][i] * shares.share[k][j];
            a[i][n] += weight * shares.share[k][i] * octaves.power[k];
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) { // Gauss and Jordan; a free diagonal is positive
        if (fixed[i]) continue;
        for (std::uint32_t k = 0; k < n; ++k) {
            if (k == i || fixed[k]) continue;
            const double factor = a[k][i] / a[i][i];
            for (std::uint32_t j = 0; j <= n; ++j) a[k][j] -= factor * a[i][j];
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) x[i] = fixed[i] ? 0 : a[i][n] / a[i][i];
}

} // namespace

Band_shares band_shares(std::uint32_t count) noexcept
{
    Band_shares shares;
    shares.count = count;
    for (std::uint32_t b = 0; b < count; ++b) {
        double total = 0;
        for (std::uint32_t a = 0; a < count; ++a) {
            shares.share[a][b] = power_below(std::ldexp(0.5, -static_cast<int>(a)), b, a + 1 == count);
            total += shares.share[a][b];
        }
        for (std::uint32_t a = 0; a < count; ++a) shares.share[a][b] /= total;
    }
    return shares;
}

void solve_bands(const Band_shares& shares, const Octaves& octaves, double (&power)[most_bands]) noexcept
{
    std::fill(power, power + most_bands, 0.0);
    bool fixed[most_bands] = {};
    double wanted = 0, sum = 0;
    for (std::uint32_t a = 0; a < shares.count; ++a) wanted += octaves.power[a];
    if (!(wanted > 0)) return;
    for (std::uint32_t step = 0; step < shares.count;
         ++step) { // the most negative band is given up until there is none
        solve_free(shares, octaves, fixed, power);
        const std::uint32_t least = static_cast<std::uint32_t>(std::min_element(power, power + shares.count) - power);
        if (power[least] >= 0) break;
        fixed[least] = true;
        power[least] = 0;
    }
    for (std::uint32_t b = 0; b < shares.count; ++b) sum += power[b] = std::max(power[b], 0.0);
    for (std::uint32_t b = 0; b < shares.count; ++b) power[b] = sum > 0 ? power[b] * (wanted / sum) : octaves.power[b];
}

} // namespace weft
