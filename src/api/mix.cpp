/// weft_model_mix: between two models of one method.
#include "analysis/mix.h"
#include "analysis/morph.h"
#include "api/guard.h"
#include "api/model.h"

using namespace weft;

namespace {

Model mix(Core& core, const Model& a, const Model& b, float t, std::uint32_t steps, const char* function)
{
    require(a.channels == b.channels, function, ": b has ", b.channels, " channels, a has ", a.channels);
    if (a.method == WEFT_METHOD_WAVELET) {
        require(t >= 0 && t <= 1, function, ": t is ", t, ", not 0..1");
        return morph_wavelets(a, b, t);
    }
    if (a.method != WEFT_METHOD_TEXTON)
        throw Error(WEFT_ERROR_UNSUPPORTED, function, ": pictures and tiles are not mixed");
    if (a.texton.images > 1 || b.texton.images > 1)
        throw Error(WEFT_ERROR_UNSUPPORTED, function, ": a or b is mixed already");
    require(steps >= 2 && steps <= most_images, function, ": steps is ", steps, ", not 2..", most_images);
    return mix_textons(core, a, b, steps);
}

} // namespace

weft_status weft_model_mix(weft_context* context, const weft_model* a, const weft_model* b, float t, uint32_t steps,
                           weft_model** model) noexcept
{
    constexpr char function[] = "weft_model_mix";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(a, function, ": a is NULL");
        require(b, function, ": b is NULL");
        require(model, function, ": model is NULL");
        const Model &first = a->loaded.object->model, &second = b->loaded.object->model;
        require(first.method == second.method, function, ": a is of method ", first.method, ", b of method ",
                second.method);
        *model = make_model(*context, mix(*context->core, first, second, t, steps, function));
    });
}
