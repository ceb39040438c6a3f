/* Untrusted `.texton` text: refused, or loaded; what is loaded writes a text that reads back as the same text. */
#include "fuzz.h"

static char* write_text(const weft_model* model, size_t* length)
{
    FUZZ_CHECK(weft_model_save_texton(model, NULL, 0, length) == WEFT_OK);
    char* text = malloc(*length);
    size_t written = 0;
    FUZZ_CHECK(text && weft_model_save_texton(model, text, *length, &written) == WEFT_OK && written == *length);
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    weft_context* context = fuzz_context("scalar");
    weft_model *model = NULL, *again = NULL;
    const weft_status status = weft_model_load_texton(context, (const char*)bytes, size, &model);
    if (status != WEFT_OK) {
        fuzz_check_error(status);
        FUZZ_CHECK(model == NULL);
        return 0;
    }
    fuzz_check_model(context, model);
    size_t length = 0, length_again = 0;
    char* text = write_text(model, &length);
    FUZZ_CHECK(weft_model_load_texton(context, text, length, &again) == WEFT_OK);
    char* text_again = write_text(again, &length_again);
    FUZZ_CHECK(length == length_again && memcmp(text, text_again, length) == 0);
    free(text);
    free(text_again);
    weft_model_free(model);
    weft_model_free(again);
    return 0;
}
