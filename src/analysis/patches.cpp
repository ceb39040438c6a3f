/// Gathers patches straight from the pixels, whatever the level, and whitens them by their principal components.
#include "analysis/patches.h"
#include "analysis/symmetric_eigen.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint64_t most_patches = 1u << 14; // the distance of two such samples of one law is about 0.012
constexpr double least_eigenvalue = 1e-4;
constexpr std::size_t chunk = 256; // patches

void gather(const Planes& planes, std::uint32_t channel, std::uint32_t level, std::uint64_t place,
            float* patch) noexcept
{
    const std::size_t block = std::size_t{1} << level, across = planes.width - patch_side * block + 1;
    const std::size_t left = place % across, top = place / across;
    std::fill_n(patch, patch_size, 0.0f);
    for (std::size_t y = 0; y < patch_side * block; ++y) {
        const float* row = planes.row(channel, top + y) + left;
        float* line = patch + (y >> level) * patch_side;
        for (std::size_t x = 0; x < patch_side * block; ++x) line[x >> level] += row[x];
    }
    float mean = 0;
    for (std::size_t i = 0; i < patch_size; ++i) mean += patch[i] / static_cast<float>(patch_size);
    const float scale = 1 / static_cast<float>(block * block);
    for (std::size_t i = 0; i < patch_size; ++i) patch[i] = (patch[i] - mean) * scale;
}

double mean_of(const float* values, std::size_t count) noexcept
{
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += static_cast<double>(values[i]);
    return sum / static_cast<double>(count);
}

Array<double> covariance_of(Core& core, const Patches& patches, const Progress& progress)
{
    Array<double> means(&core.memory, patch_size), covariance(&core.memory, patch_size * patch_size);
    for (std::size_t i = 0; i < patch_size; ++i) means[i] = mean_of(patches.row(i), patches.count);
    for_each_step(
        core, patch_size, static_cast<double>(patches.count * patch_size / 2), progress, [&](std::uint32_t i) {
            for (std::size_t j = 0; j <= i; ++j) {
                const float *a = patches.row(i), *b = patches.row(j);
                double sums[4] = {};
                for (std::size_t k = 0; k < patches.count; ++k)
                    sums[k % 4] += static_cast<double>(a[k]) * static_cast<double>(b[k]);
                covariance[i * patch_size + j] =
                    (sums[0] + sums[1] + sums[2] + sums[3]) / static_cast<double>(patches.count) - means[i] * means[j];
            }
        });
    for (std::size_t i = 0; i < patch_size; ++i)
        for (std::size_t j = 0; j < i; ++j) covariance[j * patch_size + i] = covariance[i * patch_size + j];
    return covariance;
}

} // namespace

std::uint64_t patches_in(const Planes& planes, std::uint32_t level) noexcept
{
    const std::uint64_t side = patch_side << level;
    return planes.width < side || planes.height < side ? 0 : (planes.width - side + 1) * (planes.height - side + 1);
}

Patches sample_patches(Core& core, const Planes& planes, std::uint32_t channel, std::uint32_t level, std::uint64_t seed,
                       const Progress& progress)
{
    const Sample sample(patches_in(planes, level), most_patches, seed);
    Patches patches;
    patches.count = sample.size();
    patches.values = Array<float>(&core.memory, patches.count * patch_size, Array<float>::unset);
    const auto chunks = static_cast<std::uint32_t>((patches.count + chunk - 1) / chunk);
    const double cost = 4.0 * static_cast<double>(chunk * patch_size << (2 * level));
    for_each_step(core, chunks, cost, progress, [&](std::uint32_t run) {
        for (std::size_t i = run * chunk; i < std::min(patches.count, (run + 1) * chunk); ++i) {
            float patch[patch_size];
            gather(planes, channel, level, sample[i], patch);
            for (std::size_t k = 0; k < patch_size; ++k) patches.values[k * patches.count + i] = patch[k];
        }
    });
    return patches;
}

Array<float> white_directions(Core& core, const Patches& patches, std::uint32_t directions, std::uint64_t seed,
                              const Progress& progress)
{
    Array<double> covariance = covariance_of(core, patches, progress), vectors(&core.memory, patch_size * patch_size);
    diagonalise(covariance.data(), vectors.data(), patch_size);
    double greatest = 0;
    for (std::size_t k = 0; k < patch_size; ++k) greatest = std::max(greatest, covariance[k * (patch_size + 1)]);
    if (greatest <= 0) return {};
    Array<float> result(&core.memory, directions * patch_size);
    for (std::size_t d = 0; d < directions; ++d) {
        double direction[patch_size] = {}, square = 0;
        for (std::size_t k = 0; k < patch_size; ++k) {
            const double eigenvalue = covariance[k * (patch_size + 1)];
            if (eigenvalue < least_eigenvalue * greatest) continue;
            const auto normal = static_cast<double>(normal_pair(seed, d * patch_size + k).real());
            square += normal * normal;
            for (std::size_t i = 0; i < patch_size; ++i)
                direction[i] += normal / std::sqrt(eigenvalue) * vectors[k * patch_size + i];
        }
        for (std::size_t i = 0; i < patch_size; ++i)
            result[d * patch_size + i] = static_cast<float>(direction[i] / std::sqrt(square));
    }
    return result;
}

} // namespace weft
