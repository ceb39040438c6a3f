/* Pixels of the golden models never change: the same checksums on every exact device, from every compiler. */
#include "golden.h"
#include <string.h>

static void golden_pixels(void **state)
{
    (void)state;
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 1);
    size_t size = 0;
    char *text = read_file(WEFT_TEST_DATA "/golden.txt", &size);
    assert_non_null(text);
    text[size] = 0;
    for (uint32_t d = 0; d < count; ++d) {
        weft_context *context = new_context(names[d], 2);
        const char *line = text;
        for (size_t m = 0; m < GOLDEN_MODELS; ++m) {
            weft_model *model = golden_model(context, WEFT_TEST_DATA, golden_models[m]);
            for (size_t v = 0; v < GOLDEN_VIEWS; ++v) {
                char expected[128];
                const uint64_t sum = golden_checksum(context, model, &golden_views[v]);
                snprintf(expected, sizeof expected, "%s %zu %016llx\n", golden_models[m], v, (unsigned long long)sum);
                if (strncmp(line, expected, strlen(expected)) != 0) {
                    print_error("%s: is  %s  should be %.*s\n", names[d], expected, (int)(strchr(line, '\n') - line),
                                line);
                    fail();
                }
                line += strlen(expected);
            }
            weft_model_free(model);
        }
        assert_int_equal(*line, 0);
        weft_context_free(context);
    }
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(golden_pixels)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
