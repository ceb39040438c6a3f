/* The bi-layer analysis in plain loops, in double, and composites of known noises. */
#include "bilayer_reference.h"
#include <math.h>
#include <stdlib.h>

static const double turn = 6.283185307179586;

static double luminance_at(const weft_image *photo, uint32_t x, uint32_t y)
{
    static const double rgb[] = {0.299, 0.587, 0.114};
    double sum = 0;
    for (uint32_t c = 0; c < photo->channels; ++c)
        sum += (photo->channels == 3 ? rgb[c] : 1.0 / photo->channels) * (double)value_at(photo, x, y, c);
    return sum;
}

/* |DFT|^2 of the segment at (left, top) under a Hann window of unit sum, added to `sums`. */
static void add_periodogram(const weft_image *photo, uint32_t window, uint32_t left, uint32_t top, double *sums)
{
    for (uint32_t l = 0; l < window; ++l)
        for (uint32_t k = 0; k < window; ++k) {
            double re = 0, im = 0;
            for (uint32_t j = 0; j < window; ++j)
                for (uint32_t i = 0; i < window; ++i) {
                    const double weight =
                        (1 - cos(turn * (i + 0.5) / window)) * (1 - cos(turn * (j + 0.5) / window)) / window / window;
                    const double value = weight * luminance_at(photo, left + i, top + j);
                    const double angle = turn * (k * i + l * j) / window;
                    re += value * cos(angle);
                    im -= value * sin(angle);
                }
            sums[l * window + k] += re * re + im * im;
        }
}

static uint32_t begin_of(uint32_t at, uint32_t step, uint32_t window, uint32_t side)
{
    const int begin = (int)at - (int)window + (int)(step * window / 2), last = (int)(side - window);
    return (uint32_t)(begin < 0 ? 0 : begin > last ? last : begin);
}

double *local_spectra(const weft_image *photo, uint32_t window)
{
    const uint32_t width = photo->width, height = photo->height, size = window * window;
    double *once = calloc((size_t)width * height * size, sizeof *once),
           *spectra = calloc((size_t)width * height * size, sizeof *spectra);
    assert_non_null(once);
    assert_non_null(spectra);
    for (uint32_t y = 0; y + window <= height; ++y)
        for (uint32_t x = 0; x + window <= width; ++x)
            add_periodogram(photo, window, x, y, once + ((size_t)y * width + x) * size);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t i = 0; i < size; ++i) {
                double sum = 0;
                for (uint32_t b = 0; b < 3; ++b)
                    for (uint32_t a = 0; a < 3; ++a)
                        sum += once[((size_t)begin_of(y, b, window, height) * width + begin_of(x, a, window, width)) *
                                        size +
                                    i];
                spectra[((size_t)y * width + x) * size + i] = sqrt(sum / 9);
            }
    free(once);
    return spectra;
}

double distance_of(const double *a, const double *b, uint32_t size)
{
    double sum = 0;
    for (uint32_t i = 0; i < size; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum);
}

/* One iteration: every pixel becomes the weighted mean of its neighbourhood. */
static void filter_once(const double *spectra, uint32_t size, int reach, int even, double sigma, const weft_image *from,
                        const weft_image *to)
{
    const int width = (int)from->width, height = (int)from->height;
    const uint32_t channels = from->channels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sums[16] = {0}, weights = 0;
            for (int v = y - reach; v <= y + reach; ++v)
                for (int u = x - reach; u <= x + reach; ++u) {
                    if (u < 0 || v < 0 || u >= width || v >= height) continue;
                    const double d = distance_of(spectra + ((size_t)y * from->width + (size_t)x) * size,
                                                 spectra + ((size_t)v * from->width + (size_t)u) * size, size);
                    double weight = exp(-d * d / (2 * sigma * sigma));
                    if (even && abs(u - x) == reach) weight *= 0.5;
                    if (even && abs(v - y) == reach) weight *= 0.5;
                    weights += weight;
                    for (uint32_t c = 0; c < channels; ++c)
                        sums[c] += weight * (double)value_at(from, (uint32_t)u, (uint32_t)v, c);
                }
            for (uint32_t c = 0; c < channels; ++c)
                values(to)[((size_t)y * from->width + (size_t)x) * channels + c] = (float)(sums[c] / weights);
        }
}

weft_image filtered_noise(const weft_image *photo, uint32_t window, uint32_t width, uint32_t iterations, double sigma)
{
    double *spectra = local_spectra(photo, window);
    weft_image images[2];
    for (int i = 0; i < 2; ++i) images[i] = new_image(photo->width, photo->height, photo->channels, WEFT_FORMAT_F32);
    for (uint32_t i = 0; i < iterations; ++i)
        filter_once(spectra, window * window, (int)(width / 2), width % 2 == 0, sigma, i ? &images[i % 2] : photo,
                    &images[(i + 1) % 2]);
    free(spectra);
    weft_image structure = images[iterations % 2], noise = images[(iterations + 1) % 2];
    for (size_t i = 0; i < (size_t)photo->width * photo->height * photo->channels; ++i)
        values(&noise)[i] = values(photo)[i] - values(&structure)[i];
    free_image(&structure);
    return noise;
}

void draw_waves(Waves *waves, Random *random)
{
    double total = 0;
    waves->peaks = 1 + random_below(random, 3);
    for (uint32_t i = 0; i < waves->peaks; ++i) {
        const double frequency = 0.06 + 0.34 * random_unit(random), angle = turn * random_unit(random);
        waves->peak_x[i] = frequency * cos(angle);
        waves->peak_y[i] = frequency * sin(angle);
        waves->width[i] = 0.02 + 0.06 * random_unit(random);
        total += waves->weight[i] = (0.3 + random_unit(random)) * waves->width[i] * waves->width[i];
    }
    for (uint32_t j = 0; j < WAVES; ++j) {
        double place = total * random_unit(random);
        uint32_t i = 0;
        while (i + 1 < waves->peaks && place >= waves->weight[i]) place -= waves->weight[i++];
        waves->x[j] = waves->peak_x[i] + waves->width[i] * random_normal(random);
        waves->y[j] = waves->peak_y[i] + waves->width[i] * random_normal(random);
        waves->phase[j] = turn * random_unit(random);
    }
}

double covariance_of_waves(const Waves *waves, int dx, int dy)
{
    double sum = 0;
    for (uint32_t j = 0; j < WAVES; ++j) sum += cos(turn * (waves->x[j] * dx + waves->y[j] * dy));
    return sum / WAVES;
}

static double power_at(const Waves *waves, double x, double y)
{
    double sum = 0;
    for (uint32_t i = 0; i < waves->peaks; ++i)
        for (int sign = -1; sign <= 1; sign += 2) {
            const double dx = x - sign * waves->peak_x[i], dy = y - sign * waves->peak_y[i];
            const double square = waves->width[i] * waves->width[i];
            sum += waves->weight[i] / square * exp(-(dx * dx + dy * dy) / (2 * square));
        }
    return sum;
}

double overlap_of(const Waves *a, const Waves *b)
{
    double both = 0, of_a = 0, of_b = 0;
    for (int y = -32; y < 32; ++y)
        for (int x = -32; x < 32; ++x) {
            const double p = power_at(a, x / 64.0, y / 64.0), q = power_at(b, x / 64.0, y / 64.0);
            both += sqrt(p * q);
            of_a += p;
            of_b += q;
        }
    return both / sqrt(of_a * of_b);
}

/* The waves' sum over a square, of unit variance. */
static double *noise_of(const Waves *waves, uint32_t count, uint32_t side)
{
    double *noise = calloc((size_t)side * side, sizeof *noise);
    assert_non_null(noise);
    for (uint32_t j = 0; j < count; ++j) {
        const double c = cos(turn * waves->x[j]), s = sin(turn * waves->x[j]), amplitude = sqrt(2.0 / count);
        for (uint32_t y = 0; y < side; ++y) {
            double re = amplitude * cos(waves->phase[j] + turn * waves->y[j] * y);
            double im = amplitude * sin(waves->phase[j] + turn * waves->y[j] * y);
            for (uint32_t x = 0; x < side; ++x) {
                noise[(size_t)y * side + x] += re;
                const double next = re * c - im * s;
                im = re * s + im * c;
                re = next;
            }
        }
    }
    return noise;
}

weft_image new_composite(const Waves *a, const Waves *b, const unsigned char *regions, uint32_t side)
{
    weft_image photo = new_image(side, side, 1, WEFT_FORMAT_F32);
    double *of_a = noise_of(a, WAVES, side), *of_b = noise_of(b, WAVES, side);
    for (size_t i = 0; i < (size_t)side * side; ++i)
        values(&photo)[i] = (float)(0.5 + 0.15 * (regions[i] ? of_a[i] : of_b[i]));
    free(of_a);
    free(of_b);
    return photo;
}

void draw_regions(unsigned char *regions, uint32_t side, Random *random)
{
    Waves waves;
    enum { few = 64 };
    for (uint32_t j = 0; j < few; ++j) {
        waves.x[j] = random_normal(random) / 140;
        waves.y[j] = random_normal(random) / 140;
        waves.phase[j] = turn * random_unit(random);
    }
    double *noise = noise_of(&waves, few, side);
    for (size_t i = 0; i < (size_t)side * side; ++i) regions[i] = noise[i] > 0;
    free(noise);
}
