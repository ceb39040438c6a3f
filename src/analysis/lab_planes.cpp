/// Row by row, in place of the colours.
#include "analysis/lab_planes.h"
#include "analysis/lab.h"
#include "base/image.h"

namespace weft {

Planes lab_planes(Core& core, const weft_image& image, const char* function, const char* argument)
{
    const Planes values = read_image(image, &core.memory, core.parallel, function, argument);
    const Lab_curves curves(&core.memory);
    const bool colour = values.count >= 3;
    Planes lab(&core.memory, values.width, values.height, colour ? 3 : 1, Array<float>::unset);
    core.parallel.for_each_index(values.height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < values.width; ++x) {
            if (!colour) {
                lab.row(0, y)[x] = curves.lightness(values.row(0, y)[x]);
                continue;
            }
            const Lab point = curves.of(values.row(0, y)[x], values.row(1, y)[x], values.row(2, y)[x]);
            lab.row(0, y)[x] = point.l;
            lab.row(1, y)[x] = point.a;
            lab.row(2, y)[x] = point.b;
        }
    });
    return lab;
}

} // namespace weft
