/* Wavelet noise before it is normalised, as a plug-in sees it: the variance that the paper states. */
#include "estimate.h"
#include "wavelets.h"

/* Lagae et al. 2010, section 3: the variance of two-dimensional wavelet noise made of white noise of variance 1, over
 * all positions, is 0.265 (measured). Normalised, the band has the weight's square. */
static void variance_before_normalisation(void **state)
{
    (void)state;
    enum { COARSE = 8 };
    const float weight = 0.3f;
    weft_wavelet wavelet = plain_wavelet(2, COARSE);
    Estimate bare = {0, 0, 0}, normalised = {0, 0, 0};
    assert_ok(weft_backend_load(WEFT_TEST_STUBS "/weft_backend_lattice.so"));
    weft_context *context = new_context("lattice", 1);
    wavelet.weight[COARSE - 1][0] = weight;
    weft_model *model = new_wavelet(context, &wavelet);
    for (uint32_t i = 0; i < 24; ++i) {
        weft_texture *texture = new_texture(context, model, 0, i, 0);
        weft_image image = rendered(texture, 0, 0, 0, 1, 1, 2);
        add(&bare, (double)value_at(&image, 0, 0, 0));
        add(&normalised, (double)value_at(&image, 0, 0, 1));
        free_image(&image);
        weft_texture_free(texture);
    }
    const double variance = mean_of(&bare);
    if (!(fabs(variance - 0.265) <= 0.01)) print_error("the variance is %g +- %g\n", variance, error_of(&bare));
    assert_true(fabs(variance - 0.265) <= 0.01);
    assert_expected(&normalised, (double)weight * (double)weight, 0.001, "variance of band", COARSE);
    weft_model_free(model);
    weft_context_free(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(variance_before_normalisation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
