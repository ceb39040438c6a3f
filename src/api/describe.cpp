/// weft_describe: photo -> which method suits it.
#include "analysis/describe.h"
#include "api/guard.h"
#include "api/handles.h"
#include "api/options.h"
#include "base/image.h"

using namespace weft;

weft_status weft_describe(weft_context* context, const weft_image* photo, weft_progress progress, void* user,
                          weft_description* description) noexcept
{
    constexpr char function[] = "weft_describe";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        check_image(photo, function, "photo");
        const std::uint32_t size = checked_size(description, function, "description");
        weft_description result{};
        result.size = sizeof result;
        describe(*context->core, *photo, Progress(progress, user), result);
        write_info(result, description, size);
    });
}
