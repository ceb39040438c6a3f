/* Noise on surfaces: mean and variance on plane, sphere and torus (Galerne et al. 2017, Proposition 3), frames,
 * refusals. */
#include "estimate.h"
#include "refusals.h"
#include "wavelets.h"
#include <string.h>

#define COUNT 250
#define CHANNELS 3

static weft_context *context;
static weft_model *model;
static weft_model_info info;

static int begin(void **state)
{
    (void)state;
    const weft_model_info fresh = WEFT_MODEL_INFO_INIT;
    context = new_context(NULL, 0);
    model = new_texton(context, 48, CHANNELS, 12, WEFT_INTERPOLATION_LINEAR, 5);
    info = fresh;
    assert_ok(weft_model_get(model, &info));
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_model_free(model);
    weft_context_free(context);
    return 0;
}

typedef enum Surface { PLANE, SPHERE, TORUS } Surface;

/* At the angles u, v (or, in the plane, that far): position and frame along the lines of u and v. */
static weft_surface_point point_on(Surface surface, double u, double v)
{
    const double cu = cos(u), su = sin(u), cv = cos(v), sv = sin(v), radius = 90, tube = 40;
    const float along[3] = {(float)-su, (float)cu, 0}, across[3] = {(float)(-sv * cu), (float)(-sv * su), (float)cv};
    weft_surface_point point;
    memset(&point, 0, sizeof point);
    memcpy(point.tangent, along, sizeof along);
    memcpy(point.bitangent, across, sizeof across);
    const double ring = surface == SPHERE ? 200 * cv : radius + tube * cv;
    point.position[0] = ring * cu;
    point.position[1] = ring * su;
    point.position[2] = (surface == SPHERE ? 200 : tube) * sv;
    if (surface != PLANE) return point;
    const float tangent[3] = {0.8f, 0, 0.6f}, bitangent[3] = {0.36f, 0.8f, -0.48f};
    memcpy(point.tangent, tangent, sizeof tangent);
    memcpy(point.bitangent, bitangent, sizeof bitangent);
    for (int axis = 0; axis < 3; ++axis)
        point.position[axis] = 100 * (u * (double)tangent[axis] + v * (double)bitangent[axis]) - 50;
    return point;
}

static weft_surface_point random_point(Surface surface, Random *random)
{
    const double u = 6.283185307179586 * random_unit(random), v = 3 * random_unit(random) - 1.5;
    return point_on(surface, u, surface == TORUS ? 2 * v : v);
}

static void mean_and_variance(void **state)
{
    (void)state;
    static const char *const mean_name[] = {"mean on the plane", "mean on the sphere", "mean on the torus"};
    static const char *const variance_name[] = {"variance on the plane", "variance on the sphere",
                                                "variance on the torus"};
    for (int surface = PLANE; surface <= TORUS; ++surface) {
        Random random = {(uint64_t)surface};
        Estimate mean[CHANNELS] = {{0, 0, 0}}, variance[CHANNELS] = {{0, 0, 0}};
        for (uint32_t i = 0; i < scaled(60, 30); ++i) {
            weft_texture *texture = new_texture(context, model, 0, 40 + i, 0);
            weft_surface_point points[COUNT];
            float out[COUNT * CHANNELS];
            for (int k = 0; k < COUNT; ++k) points[k] = random_point((Surface)surface, &random);
            assert_ok(weft_texture_sample_surface(texture, COUNT, points, out));
            for (int c = 0; c < CHANNELS; ++c) {
                double sum = 0, squares = 0;
                for (int k = 0; k < COUNT; ++k) {
                    const double value = (double)out[k * CHANNELS + c] - (double)info.mean[c];
                    sum += value;
                    squares += value * value;
                }
                add(&mean[c], sum / COUNT);
                add(&variance[c], squares / COUNT);
            }
            weft_texture_free(texture);
        }
        for (int c = 0; c < CHANNELS; ++c) {
            const double deviation = (double)info.deviation[c];
            assert_expected(&mean[c], 0, 0.2 * deviation, mean_name[surface], c);
            assert_expected(&variance[c], deviation * deviation, 0.3 * deviation * deviation, variance_name[surface],
                            c);
        }
    }
}

/* A frame that turns a little about the normal, or leans, changes little; there is no place where it jumps. */
static void continuous_in_frame_and_place(void **state)
{
    (void)state;
    weft_texture *texture = new_texture(context, model, 0, 8, 0);
    Random random = {6};
    for (int i = 0; i < 200; ++i) {
        weft_surface_point points[3];
        float out[3 * CHANNELS];
        const double u = 6.28 * random_unit(&random), v = 2 * random_unit(&random) - 1, turn = 1e-4;
        points[0] = points[1] = point_on(SPHERE, u, v);
        for (int axis = 0; axis < 3; ++axis) {
            points[1].tangent[axis] =
                (float)(cos(turn) * (double)points[0].tangent[axis] + sin(turn) * (double)points[0].bitangent[axis]);
            points[1].bitangent[axis] =
                (float)(cos(turn) * (double)points[0].bitangent[axis] - sin(turn) * (double)points[0].tangent[axis]);
        }
        points[2] = point_on(SPHERE, u, v + turn / 10);
        assert_ok(weft_texture_sample_surface(texture, 3, points, out));
        for (int c = 0; c < CHANNELS; ++c) {
            assert_true(fabs((double)out[CHANNELS + c] - (double)out[c]) < 0.02 * (double)info.deviation[c]);
            assert_true(fabs((double)out[2 * CHANNELS + c] - (double)out[c]) < 0.02 * (double)info.deviation[c]);
        }
    }
    weft_texture_free(texture);
}

/* Bit for bit on every exact device, in batches of any size, near and far. */
static void devices_agree(void **state)
{
    (void)state;
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 1);
    const weft_interpolation interpolations[] = {WEFT_INTERPOLATION_LINEAR, WEFT_INTERPOLATION_NEAREST,
                                                 WEFT_INTERPOLATION_CUBIC, WEFT_INTERPOLATION_QUINTIC};
    static weft_surface_point points[COUNT];
    static float expected[COUNT * 16], out[COUNT * 16];
    for (uint32_t i = 0; i < 5; ++i) {
        const uint32_t channels = i == 4 ? 16 : 1 + i;
        Random random = {i};
        weft_model *other = new_texton(context, 24, channels, 9, interpolations[i % 4], i);
        for (int k = 0; k < COUNT; ++k) {
            points[k] = random_point((Surface)(k % 3), &random);
            if (k % 4 == 0) points[k].position[k % 3] += k % 8 ? 0x1p40 : -0x1p40;
        }
        for (uint32_t d = 0; d < count; ++d) {
            weft_context *there = new_context(names[d], 1);
            weft_texture *texture = new_texture(there, other, i == 1 ? 7.5f : 0, i, 0);
            memset(out, 0xff, sizeof out);
            assert_ok(weft_texture_sample_surface(texture, COUNT, points, out));
            if (d == 0) memcpy(expected, out, sizeof out);
            if (memcmp(out, expected, sizeof *out * COUNT * channels) != 0)
                print_error("%s, %u channels\n", names[d], channels);
            assert_memory_equal(out, expected, sizeof *out * COUNT * channels);
            for (int k = 0; k < COUNT; k += 7)
                assert_ok(weft_texture_sample_surface(texture, 1, points + k, out + (size_t)k * channels));
            assert_memory_equal(out, expected, sizeof *out * COUNT * channels);
            weft_texture_free(texture);
            weft_context_free(there);
        }
        weft_model_free(other);
    }
}

static const char *spoil(weft_surface_point *point, int i)
{
    switch (i) {
    case 0: point->position[0] = (double)NAN; return "position[0]";
    case 1: point->position[1] = (double)INFINITY; return "position[1]";
    case 2: point->position[2] = -0x1p52; return "position[2]";
    case 3: memset(point->tangent, 0, sizeof point->tangent); return "tangent";
    case 4: point->tangent[1] = NAN; return "tangent";
    case 5: point->bitangent[2] = NAN; return "bitangent";
    case 6: point->bitangent[0] += 0.1f; return "bitangent";
    case 7: memcpy(point->bitangent, point->tangent, sizeof point->tangent); return "orthogonal";
    case 8:
        for (int axis = 0; axis < 3; ++axis) point->tangent[axis] *= 2;
        return "tangent";
    case 9: point->tangent[0] = INFINITY; return "tangent";
    default: return NULL;
    }
}

static void wrong_points(void **state)
{
    (void)state;
    const char *function = "weft_texture_sample_surface", *word;
    weft_texture *texture = new_texture(context, model, 0, 8, 0);
    weft_surface_point points[5];
    float out[5 * CHANNELS];
    memset(out, 0xa5, sizeof out);
    for (int i = 0;; ++i) {
        Random random = {1};
        for (int k = 0; k < 5; ++k) points[k] = random_point(TORUS, &random);
        if ((word = spoil(&points[3], i)) == NULL) break;
        REFUSED(weft_texture_sample_surface(texture, 5, points, out), function, word);
        assert_non_null(strstr(weft_error_message(), "points[3]"));
    }
    REFUSED(weft_texture_sample_surface(NULL, 5, points, out), function, "texture");
    REFUSED(weft_texture_sample_surface(texture, 5, NULL, out), function, "points");
    REFUSED(weft_texture_sample_surface(texture, 5, points, NULL), function, "out");
    for (size_t k = 0; k < sizeof out; ++k) assert_int_equal(((unsigned char *)out)[k], 0xa5);
    assert_ok(weft_texture_sample_surface(texture, 0, NULL, NULL));
    weft_texture_free(texture);
}

static void wrong_solid_points(void **state)
{
    (void)state;
    const char *function = "weft_texture_sample_solid";
    const weft_wavelet wavelet = random_wavelet(1, 3, 0, 1);
    weft_model *noise = new_wavelet(context, &wavelet);
    weft_texture *texture = new_texture(context, noise, 0, 0, 0);
    float out[2] = {7, 7};
    const weft_solid_point good = {{1, 2, 3}, 1, 0};
    for (int i = 0; i < 6; ++i) {
        weft_solid_point points[2] = {good, good};
        const char *word = "";
        switch (i) {
        case 0: points[1].position[0] = (double)NAN, word = "points[1].position[0]"; break;
        case 1: points[1].position[1] = 0x1p52, word = "points[1].position[1]"; break;
        case 2: points[1].position[2] = -(double)INFINITY, word = "points[1].position[2]"; break;
        case 3: points[1].footprint = -1, word = "points[1].footprint"; break;
        case 4: points[1].footprint = NAN, word = "points[1].footprint"; break;
        default: points[1].footprint = INFINITY, word = "points[1].footprint"; break;
        }
        REFUSED(weft_texture_sample_solid(texture, 2, points, out), function, word);
    }
    weft_solid_point newer = good;
    newer.zero = 1;
    assert_refused(weft_texture_sample_solid(texture, 1, &newer, out), WEFT_ERROR_UNSUPPORTED, function,
                   "points[0].zero");
    REFUSED(weft_texture_sample_solid(NULL, 1, &good, out), function, "texture");
    REFUSED(weft_texture_sample_solid(texture, 1, NULL, out), function, "points");
    REFUSED(weft_texture_sample_solid(texture, 1, &good, NULL), function, "out");
    assert_true(out[0] == 7 && out[1] == 7);
    weft_texture_free(texture);
    weft_model_free(noise);
}

/* Surfaces are of textons, solids of wavelets, neither has a period. */
static void wrong_textures(void **state)
{
    (void)state;
    const weft_wavelet wavelet = random_wavelet(CHANNELS, 3, 0, 1);
    weft_model *noise = new_wavelet(context, &wavelet), *picture = new_picture(context, 8, 8, CHANNELS, 1);
    weft_texture *of_texton = new_texture(context, model, 0, 0, 0), *of_noise = new_texture(context, noise, 0, 0, 0);
    weft_texture *of_picture = new_texture(context, picture, 0, 0, 0);
    weft_texture *texton_period = new_texture(context, model, 0, 0, 64),
                 *noise_period = new_texture(context, noise, 0, 0, 64);
    const weft_surface_point point = point_on(SPHERE, 1, 1);
    const weft_solid_point solid = {{1, 2, 3}, 1, 0};
    float out[CHANNELS] = {7, 7, 7};
    const char *surfaces = "weft_texture_sample_surface", *solids = "weft_texture_sample_solid";
    assert_refused(weft_texture_sample_surface(of_noise, 1, &point, out), WEFT_ERROR_UNSUPPORTED, surfaces, "texton");
    assert_refused(weft_texture_sample_surface(of_picture, 1, &point, out), WEFT_ERROR_UNSUPPORTED, surfaces, "texton");
    assert_refused(weft_texture_sample_solid(of_texton, 1, &solid, out), WEFT_ERROR_UNSUPPORTED, solids, "wavelet");
    assert_refused(weft_texture_sample_solid(of_picture, 1, &solid, out), WEFT_ERROR_UNSUPPORTED, solids, "wavelet");
    REFUSED(weft_texture_sample_surface(texton_period, 1, &point, out), surfaces, "period");
    REFUSED(weft_texture_sample_solid(noise_period, 1, &solid, out), solids, "period");
    for (int c = 0; c < CHANNELS; ++c) assert_true(out[c] == 7);

    const float impacts[] = {0.5f, 1001, -60, NAN};
    for (int i = 0; i < 4; ++i) {
        weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
        weft_texture *texture;
        options.impacts = impacts[i];
        REFUSED_HANDLE(weft_texture_create(context, model, &options, &texture), texture, WEFT_ERROR_ARGUMENT,
                       "weft_texture_create", "impacts");
    }
    weft_texture_free(of_texton);
    weft_texture_free(of_noise);
    weft_texture_free(of_picture);
    weft_texture_free(texton_period);
    weft_texture_free(noise_period);
    weft_model_free(noise);
    weft_model_free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mean_and_variance),  cmocka_unit_test(continuous_in_frame_and_place),
        cmocka_unit_test(devices_agree),      cmocka_unit_test(wrong_points),
        cmocka_unit_test(wrong_solid_points), cmocka_unit_test(wrong_textures),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
