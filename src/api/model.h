/// A model becomes a handle.
#pragma once
#include "api/handles.h"

namespace weft {

inline weft_model* make_model(const weft_context& context, Model&& model)
{
    Core& core = *context.core;
    const Statistics statistics = statistics_of(model, &core.memory, core.parallel);
    auto loaded = make_in<Loaded_model>(context.core, Loaded_model{std::move(model), statistics});
    return make_handle<weft_model>(context.core, In_core<const Loaded_model>{loaded.core, loaded.object});
}

} // namespace weft
