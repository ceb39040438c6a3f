/* Untrusted model files: refused with a status and a sentence, or loaded; what is loaded saves to canonical bytes. */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    weft_context* context = fuzz_context("scalar");
    weft_model* model = NULL;
    const weft_status status = weft_model_load(context, bytes, size, &model);
    if (status != WEFT_OK) {
        fuzz_check_error(status);
        FUZZ_CHECK(model == NULL);
        return 0;
    }
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    FUZZ_CHECK(weft_model_get(model, &info) == WEFT_OK);
    /* Only chunks that may be ignored make a file longer than its canonical form. */
    FUZZ_CHECK(info.bytes <= size);
    if (info.bytes == size) {
        uint8_t* saved = malloc(size);
        FUZZ_CHECK(saved && weft_model_save(model, saved, size) == WEFT_OK);
        FUZZ_CHECK(memcmp(saved, bytes, size) == 0);
        free(saved);
    }
    fuzz_check_model(context, model);
    weft_model_free(model);
    return 0;
}
