/* weft_compare: nothing for the same image, little for another realisation, and known-bad outputs on the bad side.
 *
 * No measure is judged by an absolute number: what a good output gets is the floor, and a bad one must lie clearly
 * above. */
#include "support.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIDE 128

static weft_context *context;
static weft_image exemplar, good, tile; /* RGB noise; another realisation of it; one that repeats after its size */
static weft_model *model;
static weft_comparison floor_of_good; /* what the other realisation gets */

static weft_image noise(uint64_t seed, uint32_t period, uint32_t side)
{
    weft_texture *texture = new_texture(context, model, 50, seed, period);
    weft_image image = rendered(texture, 0, 0, 0, side, side, 3);
    weft_texture_free(texture);
    return image;
}

static weft_comparison compared(const weft_image *a, const weft_image *b)
{
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    assert_ok(weft_compare(context, a, b, NULL, NULL, NULL, &comparison));
    if (getenv("WEFT_TEST_FIGURES"))
        print_message("model %.3f histogram %.3f autocovariance %.3f patches %.3f (%.3f %.3f %.3f) repetition %.3f "
                      "copy %.3f seam %.3f\n",
                      (double)comparison.model_error, (double)comparison.histogram_distance,
                      (double)comparison.autocovariance_error, (double)comparison.patch_distance,
                      (double)comparison.patch_distance_level[0], (double)comparison.patch_distance_level[1],
                      (double)comparison.patch_distance_level[2], (double)comparison.repetition,
                      (double)comparison.verbatim_copy, (double)comparison.seam_score);
    return comparison;
}

static int begin(void **state)
{
    (void)state;
    context = new_context(NULL, 0);
    model = new_texton(context, 64, 3, 12, WEFT_INTERPOLATION_LINEAR, 3);
    exemplar = noise(1, 0, SIDE);
    good = noise(2, 0, SIDE);
    tile = noise(3, SIDE, SIDE);
    floor_of_good = compared(&exemplar, &good);
    return 0;
}

static int end(void **state)
{
    (void)state;
    free_image(&exemplar);
    free_image(&good);
    free_image(&tile);
    weft_model_free(model);
    weft_context_free(context);
    return 0;
}

static weft_image copy_of(const weft_image *image)
{
    weft_image copy = new_image(image->width, image->height, image->channels, WEFT_FORMAT_F32);
    memcpy(copy.data, image->data, image_bytes(image));
    return copy;
}

static void the_same_image(void **state)
{
    (void)state;
    const weft_comparison same = compared(&exemplar, &exemplar);
    assert_true(fabsf(same.model_error) < 1e-3f);
    assert_true(fabsf(same.histogram_distance) < 1e-5f);
    assert_true(fabsf(same.autocovariance_error) < 1e-5f);
    assert_true(fabsf(same.patch_distance) < 0.05f); /* patches are drawn at random */
    assert_true(same.verbatim_copy > 0.95f);
}

static void another_realisation(void **state)
{
    (void)state;
    const weft_comparison other = floor_of_good, same = compared(&exemplar, &exemplar);
    assert_true(other.model_error > same.model_error && other.model_error < 0.5f);
    assert_true(other.histogram_distance > 0 && other.histogram_distance < 0.2f);
    assert_true(other.autocovariance_error > 0 && other.autocovariance_error < 0.6f);
    assert_true(other.patch_distance >= 0 && other.patch_distance < 0.3f);
    assert_true(other.verbatim_copy < 0.5f);
}

/* Every pixel at random from the exemplar: the same histogram, nothing else. */
static void shuffled_pixels(void **state)
{
    (void)state;
    weft_image shuffled = copy_of(&exemplar);
    Random random = {4};
    for (uint32_t i = SIDE * SIDE - 1; i > 0; --i)
        for (uint32_t c = 0, k = random_below(&random, i + 1); c < 3; ++c) {
            const float value = values(&shuffled)[3 * i + c];
            values(&shuffled)[3 * i + c] = values(&shuffled)[3 * k + c];
            values(&shuffled)[3 * k + c] = value;
        }
    const weft_comparison bad = compared(&exemplar, &shuffled), floor = floor_of_good;
    assert_true(bad.histogram_distance < 1e-5f);
    assert_true(bad.model_error > 2 * floor.model_error);
    assert_true(bad.autocovariance_error > 1.5f * floor.autocovariance_error);
    assert_true(bad.patch_distance > 2 * floor.patch_distance);
    free_image(&shuffled);
}

static void blurred(void **state)
{
    (void)state;
    weft_image soft = copy_of(&good);
    for (uint32_t y = 0; y < SIDE; ++y)
        for (uint32_t x = 0; x < SIDE; ++x)
            for (uint32_t c = 0; c < 3; ++c) {
                float sum = 0;
                for (uint32_t k = 0; k < 9; ++k)
                    sum += value_at(&good, (x + k % 3 + SIDE - 1) % SIDE, (y + k / 3 + SIDE - 1) % SIDE, c);
                values(&soft)[(y * SIDE + x) * 3 + c] = sum / 9;
            }
    const weft_comparison bad = compared(&exemplar, &soft), floor = floor_of_good;
    assert_true(bad.patch_distance > 1.5f * floor.patch_distance);
    assert_true(bad.histogram_distance > floor.histogram_distance);
    free_image(&soft);
}

static void brighter(void **state)
{
    (void)state;
    weft_image bright = copy_of(&good);
    for (uint32_t i = 0; i < SIDE * SIDE * 3; ++i) values(&bright)[i] += 0.2f;
    const weft_comparison bad = compared(&exemplar, &bright), floor = floor_of_good;
    assert_true(bad.histogram_distance > 3 * floor.histogram_distance);
    assert_true(bad.model_error > floor.model_error);
    assert_true(fabsf(bad.autocovariance_error - floor.autocovariance_error) < 0.01f);
    free_image(&bright);
}

/* A quarter of the exemplar, four times: it repeats, and it is a copy. */
static void plain_repetition(void **state)
{
    (void)state;
    weft_image repeated = new_image(2 * SIDE, 2 * SIDE, 3, WEFT_FORMAT_F32), endless = noise(9, 0, 2 * SIDE);
    for (uint32_t i = 0; i < 4 * SIDE * SIDE; ++i)
        for (uint32_t c = 0; c < 3; ++c)
            values(&repeated)[3 * i + c] = value_at(&exemplar, i % (2 * SIDE) % SIDE, i / (2 * SIDE) % SIDE, c);
    const weft_comparison bad = compared(&exemplar, &repeated), floor = compared(&exemplar, &endless);
    assert_true(bad.repetition > 1.6f);
    assert_true(floor.repetition > 0 && floor.repetition < 1.6f);
    assert_true(bad.verbatim_copy > 0.9f);
    assert_true(floor.verbatim_copy < 0.5f);
    free_image(&repeated);
    free_image(&endless);
}

/* An output that tiles has no seam; a cut-out has one. */
static void seams(void **state)
{
    (void)state;
    const weft_comparison tiles = compared(&exemplar, &tile), cut = floor_of_good;
    assert_true(fabsf(tiles.seam_score) < 3);
    assert_true(cut.seam_score > 6 && cut.seam_score > 2 * fabsf(tiles.seam_score));
}

static void deterministic(void **state)
{
    (void)state;
    const weft_comparison first = floor_of_good;
    weft_compare_options options = WEFT_COMPARE_OPTIONS_INIT;
    weft_comparison second = WEFT_COMPARISON_INIT;
    assert_ok(weft_compare(context, &exemplar, &good, &options, NULL, NULL, &second));
    assert_memory_equal(&first, &second, sizeof first);
    weft_context *other = new_context("scalar", 3);
    assert_ok(weft_compare(other, &exemplar, &good, &options, NULL, NULL, &second));
    assert_memory_equal(&first, &second, sizeof first);
    weft_context_free(other);
}

/* Small and constant images: a number or -1 ("not defined"), never anything else. */
static void small_and_constant(void **state)
{
    (void)state;
    const uint32_t sizes[] = {16, 17, 24, 40, 65};
    for (int i = 0; i < 5; ++i)
        for (uint32_t channels = 1; channels <= (i < 2 ? 16 : 2); channels += i < 2 ? 15 : 1)
            for (int constant = 0; constant < 4; ++constant) {
                weft_image a = new_grain(GRAIN_SOFT, sizes[i], sizes[4 - i], channels, 1),
                           b = new_grain(GRAIN_SOFT, sizes[i], sizes[i], channels, 2);
                if (constant & 1)
                    for (size_t k = 0; k < image_bytes(&a) / 4; ++k) values(&a)[k] = 0.5f;
                if (constant & 2)
                    for (size_t k = 0; k < image_bytes(&b) / 4; ++k) values(&b)[k] = 0.5f;
                const weft_comparison c = compared(&a, &b);
                const float all[] = {c.model_error,
                                     c.histogram_distance,
                                     c.autocovariance_error,
                                     c.patch_distance,
                                     c.patch_distance_level[0],
                                     c.patch_distance_level[1],
                                     c.patch_distance_level[2],
                                     c.repetition,
                                     c.verbatim_copy};
                for (int k = 0; k < 9; ++k) assert_true(isfinite(all[k]) && (all[k] >= 0 || all[k] == -1));
                assert_true(isfinite(c.seam_score));
                free_image(&a);
                free_image(&b);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_image),
        cmocka_unit_test(another_realisation),
        cmocka_unit_test(shuffled_pixels),
        cmocka_unit_test(blurred),
        cmocka_unit_test(brighter),
        cmocka_unit_test(plain_repetition),
        cmocka_unit_test(seams),
        cmocka_unit_test(deterministic),
        cmocka_unit_test(small_and_constant),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
