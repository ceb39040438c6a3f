/* Power spectrum, autocovariance and histogram against their definitions in plain loops. */
#include "support.h"
#include <math.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;
static weft_context *context;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 0);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    return 0;
}

static double mean_of(const weft_image *image, uint32_t c)
{
    double sum = 0;
    for (uint32_t i = 0; i < image->width * image->height; ++i) sum += (double)values(image)[i * image->channels + c];
    return sum / (image->width * image->height);
}

static double variance_of(const weft_image *image, uint32_t c)
{
    const double mean = mean_of(image, c);
    double sum = 0;
    for (uint32_t i = 0; i < image->width * image->height; ++i) {
        const double d = (double)values(image)[i * image->channels + c] - mean;
        sum += d * d;
    }
    return sum / (image->width * image->height);
}

static weft_image spectrum_of(const weft_image *image, uint32_t width, uint32_t height)
{
    weft_image spectrum = new_image(width, height, image->channels, WEFT_FORMAT_F32);
    assert_ok(weft_power_spectrum(context, image, &spectrum));
    return spectrum;
}

static void a_spectrum_sums_to_the_variance(void **state)
{
    (void)state;
    const uint32_t sizes[][4] = {{64, 64, 64, 64}, {64, 48, 16, 16}, {61, 37, 15, 8}, {40, 40, 7, 31},
                                 {33, 20, 1, 20},  {16, 16, 2, 2},   {20, 30, 20, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i)
        for (uint32_t channels = 1; channels <= 4; channels += 3) {
            weft_image image = new_grain(i % 2 ? GRAIN_SOFT : GRAIN_WHITE, sizes[i][0], sizes[i][1], channels, i);
            weft_image spectrum = spectrum_of(&image, sizes[i][2], sizes[i][3]);
            for (uint32_t c = 0; c < channels; ++c) {
                double sum = 0;
                for (uint32_t k = 0; k < spectrum.width * spectrum.height; ++k) {
                    assert_true(values(&spectrum)[k * channels + c] >= 0);
                    sum += (double)values(&spectrum)[k * channels + c];
                }
                assert_true(fabs(sum - variance_of(&image, c)) <= 1e-5 * variance_of(&image, c));
            }
            free_image(&spectrum);
            free_image(&image);
        }
}

/* Two sinusoids: peaks at their frequencies and the opposite ones, with the ratio of their powers. */
static void sinusoids_are_peaks(void **state)
{
    (void)state;
    weft_image image = new_image(128, 96, 2, WEFT_FORMAT_F32);
    for (uint32_t y = 0; y < 96; ++y)
        for (uint32_t x = 0; x < 128; ++x) {
            values(&image)[(y * 128 + x) * 2] = (float)(0.5 + 0.2 * cos(2 * pi * (5.0 * x / 32 + 3.0 * y / 32) + 0.3) +
                                                        0.1 * sin(2 * pi * 9.0 * x / 32));
            values(&image)[(y * 128 + x) * 2 + 1] = (float)cos(2 * pi * 4.0 * y / 32);
        }
    weft_image spectrum = spectrum_of(&image, 32, 32);
    const double strong = (double)value_at(&spectrum, 16 + 5, 16 + 3, 0),
                 opposite = (double)value_at(&spectrum, 16 - 5, 16 - 3, 0);
    const double weak = (double)value_at(&spectrum, 16 + 9, 16, 0),
                 mirrored = (double)value_at(&spectrum, 16 + 5, 16 - 3, 0);
    assert_true(fabs(strong - opposite) < 1e-6 * strong);
    assert_true(fabs(strong / weak - 4) < 1e-3);
    assert_true(mirrored < 1e-6 * strong);
    for (uint32_t i = 0; i < 32 * 32; ++i) {
        assert_true((double)values(&spectrum)[2 * i] <= strong * (1 + 1e-6));
        assert_true(values(&spectrum)[2 * i + 1] <= value_at(&spectrum, 16, 16 + 4, 1) * 1.000001f);
    }
    free_image(&spectrum);
    free_image(&image);
}

/* One segment, the whole image: the windowed DFT by its definition. */
static void one_segment_by_definition(void **state)
{
    (void)state;
    enum { W = 13, H = 10 };
    weft_image image = new_grain(GRAIN_SOFT, W, H, 1, 3), spectrum = spectrum_of(&image, W, H);
    double expected[H][W], total = 0;
    const double mean = mean_of(&image, 0);
    for (int v = 0; v < H; ++v)
        for (int u = 0; u < W; ++u) {
            double re = 0, im = 0;
            for (int y = 0; y < H; ++y)
                for (int x = 0; x < W; ++x) {
                    const double window =
                        (0.5 - 0.5 * cos(2 * pi * (x + 0.5) / W)) * (0.5 - 0.5 * cos(2 * pi * (y + 0.5) / H));
                    const double phase = 2 * pi * ((double)(u - W / 2) * x / W + (double)(v - H / 2) * y / H);
                    re += window * ((double)value_at(&image, (uint32_t)x, (uint32_t)y, 0) - mean) * cos(phase);
                    im += window * ((double)value_at(&image, (uint32_t)x, (uint32_t)y, 0) - mean) * sin(phase);
                }
            total += expected[v][u] = re * re + im * im;
        }
    for (int v = 0; v < H; ++v)
        for (int u = 0; u < W; ++u) {
            const double value = expected[v][u] / total * variance_of(&image, 0);
            assert_true(fabs((double)value_at(&spectrum, (uint32_t)u, (uint32_t)v, 0) - value) <=
                        1e-5 * variance_of(&image, 0));
        }
    free_image(&spectrum);
    free_image(&image);
}

static void autocovariance_by_definition(void **state)
{
    (void)state;
    const uint32_t sizes[][4] = {{24, 18, 9, 8}, {24, 18, 24, 18}, {17, 31, 17, 5}, {8, 8, 1, 1}, {16, 9, 2, 9}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        weft_image image = new_grain(GRAIN_STREAKS, sizes[i][0], sizes[i][1], 3, i),
                   result = new_image(sizes[i][2], sizes[i][3], 3, WEFT_FORMAT_F32);
        assert_ok(weft_autocovariance(context, &image, &result));
        const int width = (int)image.width, height = (int)image.height;
        for (uint32_t c = 0; c < 3; ++c) {
            const double mean = mean_of(&image, c), variance = variance_of(&image, c);
            for (uint32_t v = 0; v < result.height; ++v)
                for (uint32_t u = 0; u < result.width; ++u) {
                    const int dx = (int)u - (int)result.width / 2, dy = (int)v - (int)result.height / 2;
                    double sum = 0;
                    int pairs = 0;
                    for (int y = dy < 0 ? -dy : 0; y < height && y + dy < height; ++y)
                        for (int x = dx < 0 ? -dx : 0; x < width && x + dx < width; ++x, ++pairs)
                            sum += ((double)value_at(&image, (uint32_t)x, (uint32_t)y, c) - mean) *
                                   ((double)value_at(&image, (uint32_t)(x + dx), (uint32_t)(y + dy), c) - mean);
                    assert_true(fabs((double)value_at(&result, u, v, c) - sum / pairs) <=
                                2e-5 * variance * width * height / pairs);
                }
            assert_true(fabs((double)value_at(&result, result.width / 2, result.height / 2, c) - variance) <=
                        1e-5 * variance);
        }
        free_image(&result);
        free_image(&image);
    }
}

static void histogram_by_counting(void **state)
{
    (void)state;
    weft_image image = new_grain(GRAIN_WHITE, 37, 23, 3, 5);
    values(&image)[0] = -5;
    values(&image)[1] = 7;
    const uint32_t numbers[] = {1, 2, 7, 100};
    for (int i = 0; i < 4; ++i) {
        const uint32_t bins = numbers[i];
        uint64_t counts[3 * 100], total = 0;
        assert_ok(weft_histogram(context, &image, 0.3f, 0.7f, bins, counts));
        for (uint32_t c = 0; c < 3; ++c) {
            uint64_t below[101];
            for (uint32_t b = 0; b <= bins; ++b) { /* how many values lie below each border */
                const double border = (double)0.3f + ((double)0.7f - (double)0.3f) * b / bins;
                below[b] = 0;
                for (uint32_t k = 0; k < 37 * 23; ++k) below[b] += (double)values(&image)[3 * k + c] < border;
            }
            for (uint32_t b = 0; b < bins; ++b) {
                const uint64_t from = b == 0 ? 0 : below[b], to = b + 1 == bins ? 37 * 23 : below[b + 1];
                assert_int_equal(counts[c * bins + b], to - from);
                total += counts[c * bins + b];
            }
        }
        assert_int_equal(total, 37 * 23 * 3);
    }
    free_image(&image);

    weft_image bytes = new_image(16, 16, 1, WEFT_FORMAT_U8);
    uint64_t counts[256];
    for (int i = 0; i < 256; ++i) ((uint8_t *)bytes.data)[i] = (uint8_t)i;
    assert_ok(weft_histogram(context, &bytes, -0.5f / 255, 255.5f / 255, 256, counts));
    for (int i = 0; i < 256; ++i) assert_int_equal(counts[i], 1);
    free_image(&bytes);
}

static void constant_images(void **state)
{
    (void)state;
    weft_image image = new_image(16, 12, 2, WEFT_FORMAT_F32), out = new_image(8, 8, 2, WEFT_FORMAT_F32);
    for (int i = 0; i < 16 * 12 * 2; ++i) values(&image)[i] = 0.3f;
    assert_ok(weft_power_spectrum(context, &image, &out));
    for (int i = 0; i < 8 * 8 * 2; ++i) assert_true(fabsf(values(&out)[i]) < 1e-12f);
    assert_ok(weft_autocovariance(context, &image, &out));
    for (int i = 0; i < 8 * 8 * 2; ++i) assert_true(fabsf(values(&out)[i]) < 1e-12f);
    free_image(&out);
    free_image(&image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_spectrum_sums_to_the_variance), cmocka_unit_test(sinusoids_are_peaks),
        cmocka_unit_test(one_segment_by_definition),       cmocka_unit_test(autocovariance_by_definition),
        cmocka_unit_test(histogram_by_counting),           cmocka_unit_test(constant_images),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
