/// Measures on the most varied principal channel, against Gaussian textures of the same autocovariance.
#include "analysis/describe.h"
#include "analysis/band_moduli.h"
#include "analysis/periodic.h"
#include "analysis/principal_axes.h"
#include "analysis/statistics.h"
#include "analysis/tone_curve.h"
#include "base/error.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace weft {
namespace {

constexpr const char* function = "weft_describe";
constexpr std::uint32_t least_side = 16, most_side_seen = 512, realisations = 4, blocks = 8, least_lag = 4;
constexpr std::uint32_t least_layered_side = 32;             // as weft_analyze_bilayer has it
constexpr double least_peak = 0.15, least_prominence = 0.15; // of an autocovariance, relative to lag 0
constexpr double structured = 0.16, isotropic = 0.085, normal_enough = 0.08, too_uneven = 0.32;

/// The middle of the first principal channel, at most 512 x 512 pixels of it.
Planes middle_of(Core& core, const weft_image& photo)
{
    Planes planes = read_image(photo, &core.memory, core.parallel, function, "photo");
    centre(core, planes);
    const Principal_axes principal = principal_axes_of(core, planes);
    Planes whole(&core.memory, planes.width, planes.height, 1);
    project_on_axis(core, planes, principal.axes, 0, whole.plane(0));
    Planes middle(&core.memory, std::min(planes.width, most_side_seen), std::min(planes.height, most_side_seen), 1);
    const std::size_t left = (planes.width - middle.width) / 2, top = (planes.height - middle.height) / 2;
    for (std::uint32_t y = 0; y < middle.height; ++y)
        std::copy_n(whole.row(0, top + y) + left, middle.width, middle.row(0, y));
    centre(core, middle);
    return middle;
}

/// W1 of the values from normal numbers, in standard deviations.
double distance_from_normal(const Normal_scores& scores, double deviation)
{
    double sum = 0, weight = 0;
    for (int i = -300; i <= 300; ++i) {
        const double z = i * 0.01, density = std::exp(-0.5 * z * z);
        sum += density * std::abs(static_cast<double>(scores.value_at(static_cast<float>(z))) / deviation - z);
        weight += density;
    }
    return sum / weight;
}

/// Power by direction: the second harmonic is 1 if there is one direction, the fourth if there are two at right angles.
/// Octaves count by their power; the coarsest, of which there are few numbers, not at all.
double anisotropy_of(const Spectra& spectrum)
{
    std::complex<double> second = 0, fourth = 0;
    double total = 0;
    for (std::uint32_t x = 0; x < spectrum.columns(); ++x)
        for (std::uint32_t y = 0; y < spectrum.height; ++y) {
            const double k = y <= spectrum.height / 2 ? y : y - static_cast<double>(spectrum.height);
            const double fx = static_cast<double>(x) / spectrum.width, fy = k / spectrum.height,
                         radius = std::sqrt(fx * fx + fy * fy);
            if (radius > 0.5 || radius * std::min(spectrum.width, spectrum.height) < 6) continue;
            const double power =
                static_cast<double>(spectrum.weight(x)) * static_cast<double>(std::norm(spectrum.at(0, x, y)));
            const std::complex<double> direction(fx / radius, fy / radius), square = direction * direction;
            second += power * square;
            fourth += power * square * square;
            total += power;
        }
    return total > 0 ? std::sqrt((std::norm(second) + std::norm(fourth)) / 2) / total : 0;
}

/// Variance of the logarithms of the blocks' deviations, and share of the whole variance that the blocks' means have.
double unevenness_of(const Planes& plane)
{
    double sum = 0, squares = 0, mean_squares = 0, whole = 0;
    const auto bound = [](std::uint32_t size, std::uint32_t i) { return std::size_t{size} * i / blocks; };
    for (std::uint32_t i = 0; i < blocks; ++i)
        for (std::uint32_t j = 0; j < blocks; ++j) {
            double mean = 0, power = 0, count = 0;
            for (std::size_t y = bound(plane.height, i); y < bound(plane.height, i + 1); ++y)
                for (std::size_t x = bound(plane.width, j); x < bound(plane.width, j + 1); ++x) {
                    const double value = static_cast<double>(plane.row(0, y)[x]);
                    mean += value;
                    power += value * value;
                    ++count;
                }
            mean /= count;
            power /= count;
            const double logarithm = 0.5 * std::log(std::max(power - mean * mean, 1e-12));
            sum += logarithm;
            squares += logarithm * logarithm;
            mean_squares += mean * mean;
            whole += power;
        }
    const double number = blocks * blocks;
    return squares / number - sum * sum / (number * number) + (whole > 0 ? mean_squares / whole : 0);
}

/// The lag of the highest peak that stands out along one axis of an autocovariance whose lag 0 is 1; 0: none.
std::uint32_t period_along(const float* covariance, std::size_t step, std::uint32_t size)
{
    double lowest = 1, best = 0;
    std::uint32_t period = 0;
    for (std::uint32_t lag = 1; lag < size / 2; ++lag) {
        const double here = static_cast<double>(covariance[lag * step]);
        lowest = std::min(lowest, here);
        const bool peak = here > static_cast<double>(covariance[(lag - 1) * step]) &&
                          here >= static_cast<double>(covariance[(lag + 1) * step]);
        if (lag < least_lag || !peak || here < least_peak || here - lowest < least_prominence || here <= 1.15 * best)
            continue;
        best = here;
        period = lag;
    }
    return period;
}

struct Measures {
    double structure = 0, toned = 0, histogram = 0, anisotropy = 0, unevenness = 0;
    std::uint32_t period[2] = {};
};

Measures measure(Core& core, const Planes& plane, double deviation, const Progress& progress)
{
    const std::uint32_t width = plane.width, height = plane.height;
    const PlaneTransform transform(core, width, height);
    Spectra spectrum(&core.memory, width, height, 1), other(&core.memory, width, height, 1);
    transform.forward(plane.plane(0), spectrum, 0);
    keep_periodic_component(core, plane, spectrum);
    spectrum.at(0, 0, 0) = 0;
    Measures result;
    const Normal_scores scores(core, plane.plane(0), plane.area());
    result.histogram = distance_from_normal(scores, deviation);
    result.anisotropy = anisotropy_of(spectrum);

    Planes room(&core.memory, width, height, 1);
    for (std::size_t i = 0; i < spectrum.values.size(); ++i) other.values[i] = std::norm(spectrum.values[i]);
    for (const std::uint32_t x : {0u, 1u, 2u}) // the slowest waves are light, not texture
        for (const std::uint32_t y : {0u, 1u, 2u, height - 1, height - 2}) other.at(0, x, y) = 0;
    transform.backward(other, 0, room.plane(0));
    const float power = room.values[0];
    for (float& value : room.values) value /= std::max(power, 1e-30f);
    result.period[0] = period_along(room.plane(0), 1, width);
    result.period[1] = period_along(room.plane(0), width, height);

    const Moduli_correlations own = moduli_correlations(core, transform, spectrum);
    const double own_unevenness = unevenness_of(plane);
    progress.at(0.3);
    Moduli_correlations each[realisations], mean;
    double uneven = 0;
    for (std::uint32_t k = 0; k < realisations; ++k) {
        randomise_phases(core, spectrum, k, other);
        each[k] = moduli_correlations(core, transform, other);
        randomise_phases(core, spectrum, k, other);
        transform.backward(other, 0, room.plane(0));
        uneven += unevenness_of(room) / realisations;
        for (std::uint32_t i = 0; i < moduli_bands; ++i)
            for (std::uint32_t j = 0; j < i; ++j) mean.value[i][j] += each[k].value[i][j] / realisations;
        progress.at(0.3 + 0.5 * (k + 1.0) / realisations);
    }
    double chance = 0; // square of a Gaussian texture's distance from the mean of others
    for (const Moduli_correlations& one : each) chance += std::pow(distance_of(one, mean), 2) / (realisations - 1);
    const auto beyond_chance = [&](const Moduli_correlations& correlations) {
        const double distance = distance_of(correlations, mean);
        return std::sqrt(std::max(distance * distance - chance * (1 + 1.0 / realisations), 0.0));
    };
    result.structure = beyond_chance(own);
    std::copy(plane.values.begin(), plane.values.end(), room.values.begin());
    scores.apply(core, room.plane(0), room.area(), 1);
    transform.forward(room.plane(0), other, 0);
    keep_periodic_component(core, room, other);
    result.toned = beyond_chance(moduli_correlations(core, transform, other));
    result.unevenness = std::sqrt(std::max(own_unevenness - uneven, 0.0));
    return result;
}

float rounded(double value) noexcept { return static_cast<float>(std::round(value * 1000) / 1000); }

/// `layers`: the photo is large enough for a bi-layer texture.
void recommend(const Measures& found, bool layers, weft_description& description)
{
    const float structure = rounded(found.structure), histogram = rounded(found.histogram),
                anisotropy = rounded(found.anisotropy);
    const auto say = [&](weft_method method, const Sentence& sentence) {
        description.method = method;
        std::memcpy(description.reasons, sentence.c_str(), sizeof description.reasons);
    };
    const bool tone_helps =
        found.anisotropy < isotropic && found.histogram > normal_enough && found.toned <= structured;
    if (found.structure > structured && !tone_helps && found.unevenness > too_uneven)
        say(WEFT_METHOD_STATIONARY,
            Sentence("Structure that no Gaussian noise has (", structure, ", above ", rounded(structured),
                     "), and places that differ (", rounded(found.unevenness), ", above ", rounded(too_uneven),
                     "), which would show when it is repeated: a stationary tile evens them out."));
    else if (found.structure > structured && !tone_helps)
        say(layers ? WEFT_METHOD_BILAYER : WEFT_METHOD_PICTURE,
            Sentence("Structure that no Gaussian noise has (", structure, ", above ", rounded(structured), "): ",
                     layers ? "a bi-layer texture rearranges it and makes the noise between anew."
                            : "a picture keeps it, and repeats; noise would keep only its colours and grain."));
    else if (tone_helps)
        say(WEFT_METHOD_WAVELET,
            Sentence("No direction (", anisotropy, ") and values that are not normal (", histogram, ", above ",
                     rounded(normal_enough), "); with a tone curve for them little structure is left (",
                     rounded(found.toned), "): wavelet noise has both."));
    else
        say(WEFT_METHOD_TEXTON,
            Sentence("Little structure (", structure, ", at most ", rounded(structured), "), directions ", anisotropy,
                     ": texton noise has its spectrum in every direction."));
}

} // namespace

void describe(Core& core, const weft_image& photo, const Progress& progress, weft_description& description)
{
    require(photo.width >= least_side && photo.height >= least_side, function, ": photo is ", photo.width, " x ",
            photo.height, " pixels, less than ", least_side, " a side");
    progress.at(0);
    Planes plane = middle_of(core, photo);
    progress.at(0.1);
    double deviation = 0;
    for (const float value : plane.values) deviation += static_cast<double>(value) * static_cast<double>(value);
    deviation = std::sqrt(deviation / static_cast<double>(plane.area()));
    if (!(deviation > 0)) {
        description.method = WEFT_METHOD_TEXTON;
        const Sentence sentence("The photo is one colour.");
        std::memcpy(description.reasons, sentence.c_str(), sizeof description.reasons);
        progress.at(1);
        return;
    }
    const Measures found = measure(core, plane, deviation, progress.part(0.1, 1));
    progress.at(1);
    description.structure = static_cast<float>(found.structure);
    description.structure_toned = static_cast<float>(found.toned);
    description.histogram = static_cast<float>(found.histogram);
    description.anisotropy = static_cast<float>(found.anisotropy);
    description.unevenness = static_cast<float>(found.unevenness);
    description.period_x = found.period[0];
    description.period_y = found.period[1];
    recommend(found, std::min(photo.width, photo.height) >= least_layered_side, description);
}

} // namespace weft
