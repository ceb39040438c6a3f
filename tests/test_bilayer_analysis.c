/* The bi-layer analysis: fast forms against plain ones, masks and spectra of composites of known noises, bad input. */
#include "bilayer_reference.h"
#include "covariance.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

static weft_model *analysed(const weft_image *photo, const weft_bilayer_options *options)
{
    weft_model *model = NULL;
    assert_ok(weft_analyze_bilayer(context, photo, options, NULL, NULL, &model));
    return model;
}

/* Whether the model has such a part; if so, it is `part`. */
static int find_part(const weft_model *model, const char *name, weft_image *part)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    for (uint32_t i = 0; i < info.parts; ++i) {
        weft_part_info about = WEFT_PART_INFO_INIT;
        assert_ok(weft_model_part(model, i, &about));
        if (strcmp(about.name, name) != 0) continue;
        *part = part_of(model, i);
        return 1;
    }
    return 0;
}

static weft_image named_part(const weft_model *model, const char *name)
{
    weft_image part = {NULL, 0, 0, 0, 0, 0};
    if (!find_part(model, name, &part)) fail_msg("no part %s", name);
    return part;
}

/* All masks; returns their number. */
static uint32_t read_masks(const weft_model *model, weft_image masks[6])
{
    static const char *const names[] = {"mask 0", "mask 1", "mask 2", "mask 3", "mask 4", "mask 5"};
    uint32_t count = 0;
    while (count < 6 && find_part(model, names[count], &masks[count])) ++count;
    return count;
}

/* Halves of a photo that differ in brightness and grain, as what is to be told apart. */
static weft_image new_halves(uint32_t width, uint32_t height, uint32_t channels, uint64_t seed)
{
    weft_image photo = new_grain(GRAIN_WHITE, width, height, channels, seed),
               other = new_grain(GRAIN_SOFT, width, height, channels, seed + 1);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t c = 0; c < channels; ++c) {
                const size_t i = ((size_t)y * width + x) * channels + c;
                values(&photo)[i] = 2 * x + y > width ? 0.5f * values(&photo)[i] : 0.05f + values(&other)[i];
            }
    free_image(&other);
    return photo;
}

static void assert_close_images(const weft_image *a, const weft_image *b, double tolerance, const char *what)
{
    assert_int_equal(image_bytes(a), image_bytes(b));
    for (size_t i = 0; i < image_bytes(a) / sizeof(float); ++i)
        if (fabs((double)values(a)[i] - (double)values(b)[i]) > tolerance)
            fail_msg("%s: value %zu is %g, expected %g", what, i, (double)values(a)[i], (double)values(b)[i]);
}

/* Weights computed once, half of them, of periodograms computed once: the same as the definition. */
static void structure_is_the_filters(void **state)
{
    (void)state;
    static const struct {
        uint32_t width, height, channels, window, reach, iterations;
        float sigma;
    } cases[] = {{40, 33, 1, 2, 5, 3, 0.05f},
                 {33, 40, 3, 4, 6, 2, 0.03f},
                 {37, 35, 2, 8, 16, 1, 0.02f},
                 {32, 32, 1, 16, 64, 1, 0.02f},
                 {35, 32, 5, 4, 2, 5, 0.04f}};
    for (uint32_t i = 0; i < scaled(5, 3); ++i) {
        weft_image photo = new_halves(cases[i].width, cases[i].height, cases[i].channels, i);
        weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
        options.noises = 1;
        options.support = 8;
        options.window = cases[i].window;
        options.filter_width = cases[i].reach;
        options.filter_iterations = cases[i].iterations;
        options.filter_sigma = cases[i].sigma;
        weft_model *model = analysed(&photo, &options);
        weft_image noise = named_part(model, "noise");
        weft_image expected =
            filtered_noise(&photo, cases[i].window, cases[i].reach, cases[i].iterations, (double)cases[i].sigma);
        assert_close_images(&noise, &expected, 3e-5, "noise");
        free_image(&expected);
        free_image(&noise);
        weft_model_free(model);
        free_image(&photo);
    }
}

/* Structure and noise are the photo, to the rounding of their sum; in the band along borders the noise is 0. */
static void layers_add_up(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4; ++i) {
        weft_image photo = new_halves(64, 56, 3, i);
        for (size_t j = 0; j < image_bytes(&photo) / sizeof(float); ++j) values(&photo)[j] *= i == 3 ? 1000.0f : 1.0f;
        weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
        options.noises = 2;
        options.support = 8;
        options.structure = WEFT_STRUCTURE_WANG;
        options.depth = 1 + i % 2;
        options.border = i == 2 ? 3 : 0;
        weft_model *model = analysed(&photo, &options);
        weft_image structure = named_part(model, "structure"), noise = named_part(model, "noise"), masks[6];
        const uint32_t count = read_masks(model, masks);
        assert_int_equal(count, 2);
        uint32_t bare = 0;
        for (size_t j = 0; j < image_bytes(&photo) / sizeof(float); ++j) {
            const float value = values(&photo)[j], sum = values(&structure)[j] + values(&noise)[j];
            assert_true(fabsf(sum - value) <= 1.2e-7f * fabsf(value));
            const float masked = values(&masks[0])[j / 3] + values(&masks[1])[j / 3];
            assert_true(masked == 1 || (i == 2 && masked == 0));
            if (masked == 0) {
                ++bare;
                assert_true(values(&noise)[j] == 0);
            }
        }
        assert_true(i == 2 ? bare > 0 : bare == 0);
        for (uint32_t k = 0; k < count; ++k) free_image(&masks[k]);
        free_image(&structure);
        free_image(&noise);
        weft_model_free(model);
        free_image(&photo);
    }
}

/* Means of the spectra where each mask is greatest. */
static void find_centres(const double *spectra, uint32_t size, const weft_image *masks, uint32_t count, double *centres)
{
    double members[6] = {0};
    memset(centres, 0, sizeof *centres * count * size);
    for (size_t i = 0; i < (size_t)masks->width * masks->height; ++i) {
        uint32_t best = 0;
        for (uint32_t k = 1; k < count; ++k)
            if (values(&masks[k])[i] > values(&masks[best])[i]) best = k;
        members[best] += 1;
        for (uint32_t j = 0; j < size; ++j) centres[best * size + j] += spectra[i * size + j];
    }
    for (uint32_t k = 0; k < count; ++k)
        for (uint32_t j = 0; j < size; ++j) centres[k * size + j] /= members[k];
}

/* Masks are what distances to the clusters' centres say, and these are the means of their clusters. */
static void masks_follow_distances(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < scaled(6, 3); ++i) {
        const uint32_t window = 2u << i % 3, size = window * window, barycentric = i % 2;
        weft_image photo = new_halves(48, 40, 1, i), masks[6];
        weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
        options.noises = 2 + i / 2;
        options.mask_window = window;
        options.support = 8;
        options.structure = WEFT_STRUCTURE_WANG;
        options.masks = barycentric ? WEFT_MASKS_BARYCENTRIC : WEFT_MASKS_BINARY;
        weft_model *model = analysed(&photo, &options);
        const uint32_t count = read_masks(model, masks);
        assert_int_equal(count, options.noises);
        double *spectra = local_spectra(&photo, window), centres[6 * 64], distance[6];
        find_centres(spectra, size, masks, count, centres);
        for (size_t pixel = 0; pixel < (size_t)photo.width * photo.height; ++pixel) {
            double sum = 0, least = 1e30;
            for (uint32_t k = 0; k < count; ++k) {
                distance[k] = distance_of(spectra + pixel * size, centres + k * size, size);
                sum += 1 / distance[k];
                least = fmin(least, distance[k]);
            }
            for (uint32_t k = 0; k < count; ++k) {
                const double mask = (double)values(&masks[k])[pixel];
                if (barycentric)
                    assert_true(fabs(mask - 1 / distance[k] / sum) < 1e-3);
                else
                    assert_true(mask == 0 || (mask == 1 && distance[k] < least + 1e-5));
            }
        }
        for (uint32_t k = 0; k < count; ++k) free_image(&masks[k]);
        free(spectra);
        weft_model_free(model);
        free_image(&photo);
    }
}

/* The share of pixels that masks tell right. */
static double recovered(const weft_image *photo, const unsigned char *regions, uint32_t window)
{
    weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
    options.noises = 2;
    options.support = 8;
    options.mask_window = window;
    options.structure = WEFT_STRUCTURE_WANG; /* else the masks may be cut to a torus */
    options.filter_width = 2;
    options.filter_iterations = 1;
    weft_model *model = analysed(photo, &options);
    weft_image masks[6];
    const uint32_t count = read_masks(model, masks);
    assert_int_equal(count, 2);
    const size_t pixels = (size_t)photo->width * photo->height;
    size_t right = 0;
    for (size_t i = 0; i < pixels; ++i) right += (values(&masks[0])[i] > 0.5f) == (regions[i] != 0);
    for (uint32_t k = 0; k < count; ++k) free_image(&masks[k]);
    weft_model_free(model);
    return (double)(2 * right > pixels ? right : pixels - right) / (double)pixels;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y ? 1 : 0;
}

enum { most_draws = 20 };

/* Median and least share over draws of pairs of noises, those that overlap too much left out. */
static void recover(double most_overlap, uint32_t window, double *median, double *worst)
{
    const uint32_t side = 256, draws = scaled(most_draws, 5);
    unsigned char *regions = malloc((size_t)side * side);
    double shares[most_draws];
    Random random = {window};
    assert_non_null(regions);
    for (uint32_t i = 0; i < draws; ++i) {
        Waves a, b;
        do {
            draw_waves(&a, &random);
            draw_waves(&b, &random);
        } while (overlap_of(&a, &b) >= most_overlap);
        draw_regions(regions, side, &random);
        weft_image photo = new_composite(&a, &b, regions, side);
        shares[i] = recovered(&photo, regions, window);
        free_image(&photo);
    }
    free(regions);
    qsort(shares, draws, sizeof *shares, ascending);
    *median = 0.5 * (shares[draws / 2] + shares[(draws - 1) / 2]);
    *worst = shares[0];
}

static void masks_are_recovered(void **state)
{
    (void)state;
    double median, worst;
    recover(0.1, 8, &median, &worst);
    print_message("overlap < 0.1, T_loc 8: median %.3f, worst %.3f\n", median, worst);
    assert_true(median >= 0.95 && worst >= 0.75);
    recover(2, 16, &median, &worst);
    print_message("any two noises, T_loc 16: median %.3f, worst %.3f\n", median, worst);
    assert_true(median >= 0.93);
}

/* Relative distance of the first noise's covariance from that of its waves, over lags up to `reach`. */
static double covariance_error(const weft_model *model, const char *name, const Waves *waves)
{
    enum { reach = 8 };
    weft_image texton = named_part(model, name);
    const double variance = noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, 0, 0, 0, 0);
    double wrong = 0, all = 0;
    for (int y = 0; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const double expected = covariance_of_waves(waves, x, y);
            const double found = noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, 0, 0, x, y) / variance;
            wrong += (found - expected) * (found - expected);
            all += expected * expected;
        }
    free_image(&texton);
    return sqrt(wrong / all);
}

/* Each noise of a composite is found nearly as well as from a photo of it alone that has as many pixels. */
static void spectra_are_recovered(void **state)
{
    (void)state;
    enum { draws = 8 };
    const uint32_t side = 256;
    double ratios[draws];
    Random random = {5};
    unsigned char *regions = malloc((size_t)side * side);
    assert_non_null(regions);
    for (uint32_t i = 0; i < draws; ++i) {
        Waves a, b;
        do {
            draw_waves(&a, &random);
            draw_waves(&b, &random);
        } while (overlap_of(&a, &b) >= 0.1);
        draw_regions(regions, side, &random);
        weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
        options.noises = 2;
        options.support = 32;
        options.structure = WEFT_STRUCTURE_NONE;
        weft_image photo = new_composite(&a, &b, regions, side);
        weft_model *model = analysed(&photo, &options);
        const double first = covariance_error(model, "texton 0", &a), second = covariance_error(model, "texton 0", &b);
        const int is_a = first < second;
        weft_model_free(model);
        free_image(&photo);
        memset(regions, 1, (size_t)side * side);
        photo = new_composite(is_a ? &a : &b, &b, regions, side);
        photo.height = side / 2;
        options.noises = 1;
        model = analysed(&photo, &options);
        ratios[i] = (is_a ? first : second) / covariance_error(model, "texton 0", is_a ? &a : &b);
        print_message("covariance error %.3f, %.3f times that without a mask\n", is_a ? first : second, ratios[i]);
        weft_model_free(model);
        photo.height = side;
        free_image(&photo);
    }
    free(regions);
    qsort(ratios, draws, sizeof *ratios, ascending);
    assert_true(ratios[draws / 2] <= 1.15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(structure_is_the_filters), cmocka_unit_test(layers_add_up),
        cmocka_unit_test(masks_follow_distances),   cmocka_unit_test(masks_are_recovered),
        cmocka_unit_test(spectra_are_recovered),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
