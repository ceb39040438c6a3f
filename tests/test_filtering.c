/* Filtering against the ideal, as in Figure 3 of the paper: a filtered sample against the mean of 20 x 20 samples of
 * its pixel.
 *
 * The filter is a mip chain of the texton with probes along the major axis, no exact integral, so there is an error.
 * The bounds are of two kinds: against the ideal's own deviation, and, where a bare sample is further off than the mean
 * colour would be, against that sample. White noise is the worst case there is: no two neighbours of the texton are
 * alike. What remains is blur: texels of a level are averages, and are interpolated linearly on top of that. */
#include "support.h"
#include <math.h>
#include <stdlib.h>

#define SAMPLES 20

static weft_context *context;
static weft_model *soft, *white;

static weft_model *model_of(Grain grain)
{
    weft_image photo = new_grain(grain, 64, 64, 1, 3);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *model = NULL;
    options.support = 32;
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

static int begin(void **state)
{
    (void)state;
    context = new_context(NULL, 0);
    soft = model_of(GRAIN_STREAKS);
    white = model_of(GRAIN_WHITE);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_model_free(soft);
    weft_model_free(white);
    weft_context_free(context);
    return 0;
}

/* Root mean squares over many pixels: of the ideal around its mean, of filtered - ideal, of unfiltered - ideal, of
 * filtered. */
typedef struct Figures {
    double ideal, filtered_error, unfiltered_error, filtered;
} Figures;

static Figures figures_of(const weft_texture *texture, double mean, const float dx[2], const float dy[2],
                          uint32_t pixels)
{
    static weft_point points[SAMPLES * SAMPLES];
    static float samples[SAMPLES * SAMPLES];
    Figures f = {0, 0, 0, 0};
    Random random = {99};
    for (uint32_t i = 0; i < pixels; ++i) {
        const weft_point pixel = {
            4000 * random_unit(&random), 4000 * random_unit(&random), {dx[0], dx[1]}, {dy[0], dy[1]}};
        const weft_point bare = {pixel.x, pixel.y, {0, 0}, {0, 0}};
        float filtered, unfiltered;
        for (int k = 0; k < SAMPLES * SAMPLES; ++k) {
            const double right = (k % SAMPLES + 0.5) / SAMPLES - 0.5,
                         down = (double)(k / SAMPLES + 0.5) / SAMPLES - 0.5;
            points[k] = bare;
            points[k].x += (double)dx[0] * right + (double)dx[1] * down;
            points[k].y += (double)dy[0] * right + (double)dy[1] * down;
        }
        assert_ok(weft_texture_sample(texture, 1, &pixel, &filtered));
        assert_ok(weft_texture_sample(texture, 1, &bare, &unfiltered));
        assert_ok(weft_texture_sample(texture, SAMPLES * SAMPLES, points, samples));
        double ideal = 0;
        for (int k = 0; k < SAMPLES * SAMPLES; ++k) ideal += (double)samples[k] / (SAMPLES * SAMPLES);
        f.ideal += (ideal - mean) * (ideal - mean) / pixels;
        f.filtered += ((double)filtered - mean) * ((double)filtered - mean) / pixels;
        f.filtered_error += ((double)filtered - ideal) * ((double)filtered - ideal) / pixels;
        f.unfiltered_error += ((double)unfiltered - ideal) * ((double)unfiltered - ideal) / pixels;
    }
    const Figures roots = {sqrt(f.ideal), sqrt(f.filtered_error), sqrt(f.unfiltered_error), sqrt(f.filtered)};
    return roots;
}

typedef struct Footprint {
    const char *name;
    float dx[2], dy[2];
} Footprint;

static const Footprint footprints[] = {
    {"2 x 2", {2, 0}, {0, 2}},
    {"4 x 4", {4, 0}, {0, 4}},
    {"8 x 8", {8, 0}, {0, 8}},
    {"3 x 3, turned by 30 degrees", {2.598f, -1.5f}, {1.5f, 2.598f}},
    {"8 x 2 along x", {8, 0}, {0, 2}},
    {"8 x 2 along y", {2, 0}, {0, 8}},
    {"9 x 3, turned by 45 degrees", {6.364f, -2.121f}, {6.364f, 2.121f}},
    {"12 x 1, the screen's axes exchanged", {0, 12}, {1, 0}},
    {"sheared", {5, 3}, {0, 2}},
};
#define FOOTPRINTS (sizeof footprints / sizeof *footprints)

/* Where one sample without filtering is far from the ideal, filtering must bring it much nearer. */
static void against_supersampling(const weft_model *model, double most_of_ideal, double most_of_unfiltered)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    int wrong = 0;
    assert_ok(weft_model_get(model, &info));
    weft_texture *texture = new_texture(context, model, 30, 5, 0);
    for (size_t i = 0; i < FOOTPRINTS; ++i) {
        const Footprint *footprint = &footprints[i];
        const Figures f = figures_of(texture, (double)info.mean[0], footprint->dx, footprint->dy, scaled(500, 100));
        const int needs_filtering = f.unfiltered_error > f.ideal;
        const int good = f.filtered_error <= most_of_ideal * f.ideal &&
                         (!needs_filtering || f.filtered_error <= most_of_unfiltered * f.unfiltered_error);
        wrong += !good;
        if (!good || getenv("WEFT_TEST_FIGURES"))
            print_message("%-36s error %.3f of the ideal's deviation, %.3f of the unfiltered error; deviation %.3f of "
                          "the ideal's\n",
                          footprint->name, f.filtered_error / f.ideal, f.filtered_error / f.unfiltered_error,
                          f.filtered / f.ideal);
    }
    assert_int_equal(wrong, 0);
    weft_texture_free(texture);
}

static void streaks_against_supersampling(void **state)
{
    (void)state;
    against_supersampling(soft, 0.38, 0.5);
}

static void white_noise_against_supersampling(void **state)
{
    (void)state;
    against_supersampling(white, 0.68, 0.5);
}

/* A footprint smaller than a texel filters nothing; a rotation of the screen changes little. */
static void small_footprints_are_no_footprints(void **state)
{
    (void)state;
    weft_texture *texture = new_texture(context, soft, 30, 5, 0);
    Random random = {3};
    for (int i = 0; i < 200; ++i) {
        const double x = 1000 * random_unit(&random), y = 1000 * random_unit(&random);
        const weft_point bare = {x, y, {0, 0}, {0, 0}}, half = {x, y, {0.5f, 0}, {0, 0.5f}},
                         one = {x, y, {1, 0}, {0, 1}}, turned = {x, y, {0, 1}, {-1, 0}};
        float a, b, c, d;
        assert_ok(weft_texture_sample(texture, 1, &bare, &a));
        assert_ok(weft_texture_sample(texture, 1, &half, &b));
        assert_ok(weft_texture_sample(texture, 1, &one, &c));
        assert_ok(weft_texture_sample(texture, 1, &turned, &d));
        assert_true(a == b && a == c && a == d);
    }
    weft_texture_free(texture);
}

/* Mip levels of windows against the mean of the pixels they cover, for a noise and for a picture. */
static double level_error(const weft_texture *texture, uint32_t level, double *ideal_deviation)
{
    const uint32_t side = 48, cover = 1u << level;
    weft_image coarse = rendered(texture, 3, -2, level, side, side, 1);
    weft_image fine = rendered(texture, (int64_t)3 << level, -((int64_t)2 << level), 0, side * cover, side * cover, 1);
    double sum = 0, squares = 0, errors = 0;
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            double mean = 0;
            for (uint32_t k = 0; k < cover * cover; ++k)
                mean += (double)value_at(&fine, x * cover + k % cover, y * cover + k / cover, 0) / (cover * cover);
            const double error = (double)value_at(&coarse, x, y, 0) - mean;
            sum += mean / (side * side);
            squares += mean * mean / (side * side);
            errors += error * error / (side * side);
        }
    free_image(&coarse);
    free_image(&fine);
    *ideal_deviation = sqrt(squares - sum * sum);
    return sqrt(errors);
}

static void levels_of_noise(void **state)
{
    (void)state;
    weft_texture *texture = new_texture(context, soft, 30, 5, 0);
    for (uint32_t level = 1; level <= 4; ++level) {
        double deviation = 0;
        const double error = level_error(texture, level, &deviation);
        if (getenv("WEFT_TEST_FIGURES"))
            print_message("level %u: error %.3f of the mean's deviation\n", level, error / deviation);
        assert_true(error < 0.42 * deviation);
    }
    weft_texture_free(texture);
}

/* Where levels divide a picture, its mip pixels are the means of the pixels they cover. */
static void levels_of_a_picture(void **state)
{
    (void)state;
    weft_model *model = new_picture(context, 32, 16, 1, 4);
    weft_texture *texture = new_texture(context, model, 0, 0, 0);
    for (uint32_t level = 1; level <= 3; ++level) {
        double deviation = 0;
        const double error = level_error(texture, level, &deviation);
        assert_true(deviation > 0.003);
        assert_true(error < 1e-6);
    }
    weft_texture_free(texture);
    weft_model_free(model);
}

/* Filtered away, what remains is the mean. */
static void far_levels_are_the_mean(void **state)
{
    (void)state;
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(soft, &info));
    weft_texture *texture = new_texture(context, soft, 30, 5, 0);
    weft_image image = rendered(texture, 0, 0, 20, 8, 8, 1);
    for (uint32_t i = 0; i < 64; ++i) assert_true(fabsf(values(&image)[i] - info.mean[0]) < 1e-3f);
    free_image(&image);
    const weft_point far = {5, 5, {1e9f, 0}, {0, 1e9f}};
    float value;
    assert_ok(weft_texture_sample(texture, 1, &far, &value));
    assert_true(fabsf(value - info.mean[0]) < 1e-3f);
    weft_texture_free(texture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(streaks_against_supersampling),
        cmocka_unit_test(white_noise_against_supersampling),
        cmocka_unit_test(small_footprints_are_no_footprints),
        cmocka_unit_test(levels_of_noise),
        cmocka_unit_test(levels_of_a_picture),
        cmocka_unit_test(far_levels_are_the_mean),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
