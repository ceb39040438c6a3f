/// The periodogram of the segment at every position once, by short transforms of many segments side by side; then means
/// of nine of them.
#include "analysis/local_spectrum.h"
#include "analysis/spectra.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t lanes = 16;     // segments side by side
constexpr std::uint32_t tile_rows = 32; // whose rows are transformed once

/// cos(pi k / 16): the same on every machine, as masks are decided by spectra.
double cosine(std::uint32_t k) noexcept
{
    static constexpr double quarter[] = {1,
                                         0.98078528040323044913,
                                         0.92387953251128675613,
                                         0.83146961230254523708,
                                         0.70710678118654752440,
                                         0.55557023301960222474,
                                         0.38268343236508977173,
                                         0.19509032201612826785,
                                         0};
    k %= 32;
    if (k > 16) k = 32 - k;
    return k <= 8 ? quarter[k] : -quarter[16 - k];
}
double sine(std::uint32_t k) noexcept { return cosine(k + 24); } // cos(a - pi / 2)

/// Complex transforms of `size` numbers, `lanes` of them side by side.
template <std::uint32_t size> struct Short_transform {
    Short_transform() noexcept
    {
        for (std::uint32_t k = 0; k < size; ++k) {
            turn_re[k] = static_cast<float>(cosine(32 / size * k));
            turn_im[k] = static_cast<float>(-sine(32 / size * k));
            for (std::uint32_t bit = 1; bit < size; bit *= 2) reversed[k] = 2 * reversed[k] + (k & bit ? 1 : 0);
        }
    }

    /// In place; number k is expected in row reversed[k].
    void run(float (&re)[size][lanes], float (&im)[size][lanes]) const noexcept
    {
        for (std::uint32_t half = 1; half < size; half *= 2)
            for (std::uint32_t k = 0; k < half; ++k) {
                const float c = turn_re[size / 2 / half * k], s = turn_im[size / 2 / half * k];
                for (std::uint32_t i = k; i < size; i += 2 * half) {
                    float *a = re[i], *b = im[i], *d = re[i + half], *e = im[i + half];
                    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
                        const float x = k ? c * d[lane] - s * e[lane] : d[lane];
                        const float y = k ? c * e[lane] + s * d[lane] : e[lane];
                        d[lane] = a[lane] - x;
                        e[lane] = b[lane] - y;
                        a[lane] += x;
                        b[lane] += y;
                    }
                }
            }
    }

    float turn_re[size], turn_im[size];
    std::uint32_t reversed[size] = {};
};

template <std::uint32_t window> class Periodograms {
public:
    static constexpr std::uint32_t columns = window / 2 + 1;
    static constexpr std::uint32_t size = 2 * columns + (window / 2 - 1) * window;

    Periodograms(const float* luminance, Local_spectra& spectra) : luminance_(luminance), spectra_(spectra)
    {
        for (std::uint32_t i = 0; i < window; ++i) // Hann's window: its sum is window / 2
            weight_[i] = static_cast<float>((1 - cosine(16 / window * (2 * i + 1))) / window);
    }

    std::uint32_t positions_x() const noexcept { return spectra_.width - window + 1; }
    std::uint32_t positions_y() const noexcept { return spectra_.height - window + 1; }

    /// The periodograms of all segments that begin in rows [first, last), at their beginnings.
    void rows(std::uint32_t first, std::uint32_t last) const
    {
        for (std::uint32_t x = 0; x < positions_x(); x += lanes) tile(std::min(x, positions_x() - lanes), first, last);
    }

private:
    struct Row {
        float re[columns][lanes], im[columns][lanes];
    };

    void tile(std::uint32_t x, std::uint32_t first, std::uint32_t last) const
    {
        Row along_x[tile_rows + window];
        float re[window][lanes], im[window][lanes];
        for (std::uint32_t y = first; y < last + window - 1; ++y) {
            const float* from = luminance_ + std::size_t{y} * spectra_.width + x;
            for (std::uint32_t i = 0; i < window; ++i)
                for (std::uint32_t lane = 0; lane < lanes; ++lane) {
                    re[transform_.reversed[i]][lane] = weight_[i] * from[i + lane];
                    im[transform_.reversed[i]][lane] = 0;
                }
            transform_.run(re, im);
            Row& row = along_x[y - first];
            std::copy_n(&re[0][0], columns * lanes, &row.re[0][0]);
            std::copy_n(&im[0][0], columns * lanes, &row.im[0][0]);
        }
        for (std::uint32_t y = first; y < last; ++y) {
            float* to = spectra_.row(y, 0) + x;
            for (std::uint32_t k = 0; k < columns; ++k) {
                for (std::uint32_t i = 0; i < window; ++i)
                    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
                        re[transform_.reversed[i]][lane] = weight_[i] * along_x[y - first + i].re[k][lane];
                        im[transform_.reversed[i]][lane] = weight_[i] * along_x[y - first + i].im[k][lane];
                    }
                transform_.run(re, im);
                const bool folded = k == 0 || k == window / 2; // whose other half is the conjugate
                for (std::uint32_t l = 0; l < (folded ? columns : window); ++l) {
                    const float times = folded && (l == 0 || l == window / 2) ? 1.0F : 2.0F;
                    for (std::uint32_t lane = 0; lane < lanes; ++lane)
                        to[lane] = times * (re[l][lane] * re[l][lane] + im[l][lane] * im[l][lane]);
                    to += spectra_.width;
                }
            }
        }
    }

    const float* luminance_;
    Local_spectra& spectra_;
    Short_transform<window> transform_;
    float weight_[window];
};

/// Where the three segments around position i of an axis begin.
struct Segments {
    Segments(std::uint32_t i, std::uint32_t window, std::uint32_t positions) noexcept
    {
        for (std::uint32_t j = 0; j < 3; ++j) {
            const std::uint32_t end = i + window / 2 * j;
            begin[j] = end < window ? 0 : std::min(end - window, positions - 1);
        }
    }
    std::uint32_t begin[3];
};

void add_across(Core& core, Local_spectra& spectra, std::uint32_t window, std::uint32_t first, std::uint32_t last)
{
    const std::uint32_t width = spectra.width, positions = width - window + 1;
    for_each_run(core.parallel, (last - first) * spectra.size, [&](std::uint32_t begin, std::uint32_t end) {
        Array<float> sums(&core.memory, width, Array<float>::unset);
        for (std::uint32_t i = begin; i < end; ++i) {
            float* row = spectra.row(first, i);
            const auto add = [&](std::uint32_t x) {
                const Segments at(x, window, positions);
                sums[x] = row[at.begin[0]] + row[at.begin[1]] + row[at.begin[2]];
            };
            for (std::uint32_t x = 0; x < window; ++x) add(x);
            for (std::uint32_t x = window; x < positions; ++x) sums[x] = row[x - window] + row[x - window / 2] + row[x];
            for (std::uint32_t x = std::max(window, positions); x < width; ++x) add(x);
            std::copy_n(sums.data(), width, row);
        }
    });
}

/// From the last row up, in place: a pixel's segments begin at or above it.
void add_down(Core& core, Local_spectra& spectra, std::uint32_t window, std::uint32_t first, std::uint32_t last)
{
    for_each_run(core.parallel, spectra.size, [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t y = last; y-- > first;)
            for (std::uint32_t i = begin; i < end; ++i) {
                const Segments at(y, window, spectra.height - window + 1);
                const float *a = spectra.row(at.begin[0], i), *b = spectra.row(at.begin[1], i),
                            *c = spectra.row(at.begin[2], i);
                float* to = spectra.row(y, i);
                for (std::uint32_t x = 0; x < spectra.width; ++x) to[x] = std::sqrt((a[x] + b[x] + c[x]) * (1.0F / 9));
            }
    });
}

template <std::uint32_t window>
Local_spectra make(Core& core, const float* luminance, std::uint32_t width, std::uint32_t height,
                   const Progress& progress)
{
    Local_spectra spectra;
    spectra.width = width;
    spectra.height = height;
    spectra.size = Periodograms<window>::size;
    spectra.values = Array<float>(&core.memory, std::size_t{width} * height * spectra.size, Array<float>::unset);
    const Periodograms<window> periodograms(luminance, spectra);
    const std::uint32_t positions = periodograms.positions_y();
    const std::size_t work = std::size_t{width} * spectra.size;
    for_each_group((positions + tile_rows - 1) / tile_rows, work * tile_rows * 4, progress.part(0, 0.7),
                   [&](std::uint32_t first, std::uint32_t last) {
                       core.parallel.for_each_index(last - first, [&](std::uint32_t i) {
                           const std::uint32_t begin = (first + i) * tile_rows;
                           periodograms.rows(begin, std::min(begin + tile_rows, positions));
                       });
                   });
    for_each_group(positions, work, progress.part(0.7, 0.85),
                   [&](std::uint32_t first, std::uint32_t last) { add_across(core, spectra, window, first, last); });
    for_each_group(height, work, progress.part(0.85, 1), [&](std::uint32_t first, std::uint32_t last) {
        add_down(core, spectra, window, height - last, height - first);
    });
    return spectra;
}

} // namespace

Local_spectra local_spectra_of(Core& core, const float* luminance, std::uint32_t width, std::uint32_t height,
                               std::uint32_t window, const Progress& progress)
{
    switch (window) {
    case 2:
        return make<2>(core, luminance, width, height, progress);
    case 4:
        return make<4>(core, luminance, width, height, progress);
    case 8:
        return make<8>(core, luminance, width, height, progress);
    default:
        return make<16>(core, luminance, width, height, progress);
    }
}

} // namespace weft
