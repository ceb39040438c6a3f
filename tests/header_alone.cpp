// A public header by itself in C++: it needs nothing before it, and its _INIT values initialise.
#include WEFT_HEADER

weft_status first_lines(weft_context **context);
weft_status first_lines(weft_context **context)
{
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_texton_options texton = WEFT_TEXTON_OPTIONS_INIT;
    weft_texture_options texture = WEFT_TEXTURE_OPTIONS_INIT;
    weft_compare_options compare = WEFT_COMPARE_OPTIONS_INIT;
    weft_device_info device = WEFT_DEVICE_INFO_INIT;
    weft_model_info model = WEFT_MODEL_INFO_INIT;
    weft_part_info part = WEFT_PART_INFO_INIT;
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    if (texton.size && texture.size && compare.size && device.size && model.size && part.size && comparison.size)
        return weft_context_create(&options, context);
    return WEFT_ERROR_ARGUMENT;
}
