/* weft apply: another map of a tiled surface -> its tile. */
#include "apply.h"
#include "command.h"
#include "file.h"
#include "json.h"
#include "maps.h"
#include "open.h"
#include "options.h"
#include "report.h"

#include <stdlib.h>

static const char notes[] =
    "MODEL is that of a stationary tile, from `weft tile --model` or `weft analyze --method stationary`. MAP.png is\n"
    "a picture of the same surface and size as the photo it was made of, of any colours and depth: height,\n"
    "roughness, a photo of more bits. Its tile fits the other one pixel by pixel.";

int apply_model(const weft_model* model, const weft_image* map, weft_image* tile)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    size_t value = map->format == WEFT_FORMAT_U16 ? 2 : 1;
    weft_status status = weft_model_get(model, &info);
    if (status != WEFT_OK) return failed_weft(status);
    *tile = *map;
    tile->width = info.width;
    tile->height = info.height;
    tile->stride = (int64_t)(value * map->channels * info.width);
    tile->data = malloc((size_t)tile->stride * info.height);
    if (!tile->data) return failed("out of memory");
    status = weft_model_apply(model, map, tile);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static void report(const char* output, const weft_image* tile)
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    json_text(&out, "output", output);
    json_unsigned(&out, "width", tile->width);
    json_unsigned(&out, "height", tile->height);
    json_unsigned(&out, "channels", tile->channels);
    json_unsigned(&out, "depth", tile->format == WEFT_FORMAT_U16 ? 16 : 8);
    json_end(&out);
}

int command_apply(int count, char** words)
{
    const char* output = NULL;
    const option table[] = {{"-o", OPTION_TEXT, &output, "OUT.png", "where the map's tile goes", 0, 0}};
    const command_line line = {
        "apply", "MODEL MAP.png -o OUT.png", "Makes the tile of another map of a surface.", notes, table, 1, 2, 2};
    arguments common;
    weft_context* context = NULL;
    weft_model* model = NULL;
    weft_model_info info;
    weft_image map = {NULL, 0, 0, 0, 0, 0}, tile = {NULL, 0, 0, 0, 0, 0};
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    if (!output) return misused("it needs -o OUT.png");
    if (check_stdout(common.json, output)) return EXIT_USAGE;
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_model(context, common.operand[0], &model, &info);
    if (code == EXIT_FINE) code = open_photos(&common.operand[1], 1, &map);
    if (code == EXIT_FINE) code = apply_model(model, &map, &tile);
    if (code == EXIT_FINE) code = maps_write(output, &tile, &tile.channels, 1);
    if (code == EXIT_FINE && common.json) report(output, &tile);
    weft_model_free(model);
    weft_context_free(context);
    free(tile.data);
    free(map.data);
    return code;
}
