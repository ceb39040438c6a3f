/// Wasserstein distances of one-dimensional samples, and the samples that large pictures are represented by.
#pragma once
#include "analysis/white_noise.h"
#include <cstddef>
#include <cstdint>

namespace weft {

/// Sorts fewer than 2^32 finite floats by their digits; `scratch` is as long.
void sort_floats(float* values, float* scratch, std::size_t count) noexcept;

/// The mean |difference| of the quantiles of two sorted samples: exact, whatever their sizes below 2^32.
double wasserstein_distance(const float* a, std::size_t a_count, const float* b, std::size_t b_count) noexcept;

/// At most `most` of `available` things, in order: all of them, or one at random from each of `most` equal stretches.
class Sample {
public:
    Sample(std::uint64_t available, std::uint64_t most, std::uint64_t seed) noexcept
        : available_(available), count_(available < most ? available : most), seed_(mix_bits(seed))
    {
    }

    std::uint64_t size() const noexcept { return count_; }
    std::uint64_t operator[](std::uint64_t i) const noexcept
    {
        const std::uint64_t first = available_ * i / count_, last = available_ * (i + 1) / count_;
        return first + mix_bits(seed_ ^ i) % (last - first);
    }

private:
    std::uint64_t available_, count_, seed_;
};

} // namespace weft
