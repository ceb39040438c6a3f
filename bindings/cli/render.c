/* weft render: a window of a model's texture, made and written in bands of rows, so that its size needs no memory. */
#include "clock.h"
#include "command.h"
#include "json.h"
#include "maps.h"
#include "numbers.h"
#include "open.h"
#include "options.h"
#include "progress.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

static const char notes[] =
    "The texture is endless: the same position of the same model and seed is always the same pixel, whatever\n"
    "the window, the device or the number of threads. --at counts pixels of the level. Models of 1, 2, 3 and\n"
    "4 channels give grey, grey and alpha, RGB and RGBA. For more, and to undo what `analyze` has stacked,\n"
    "--maps 3,1,3 says how many channels each map has; the %d in -o OUT-%d.png becomes the map's number.\n"
    "Of a mixed model --mix shows black the first step, white the last; the map, a grey PNG, repeats.\n"
    "--rotation to --noise are of bi-layer models: how their structure may be deformed, and whether their noises\n"
    "never repeat or come from large tiles, which is faster.";

typedef struct render_options {
    const char *output, *maps_text, *mix;
    extent size, period;
    position at;
    uint32_t level, depth, mix_scale, rotation, noise;
    uint32_t groups[16]; /* channels of each map */
    int group_count;
    weft_texture_options texture;
} render_options;

static int check(render_options* o, const arguments* common)
{
    const int64_t farthest = (int64_t)1 << 60;
    if (!o->output) return misused("it needs -o OUT.png");
    if (o->size.width == 0) return misused("it needs --size WxH");
    if (o->at.x > farthest || o->at.x < -farthest || o->at.y > farthest || o->at.y < -farthest)
        return misused("--at takes positions within 2^60 of 0,0");
    if (o->depth != 8 && o->depth != 16) return misused("--depth takes 8 or 16");
    if (o->maps_text && (o->group_count = parse_counts(o->maps_text, o->groups, 16)) == 0)
        return misused("--maps takes N,N,..., not '%s'", o->maps_text);
    for (int i = 0; i < o->group_count; i++)
        if (o->groups[i] > 4) return misused("a map has 1 to 4 channels, not %u", o->groups[i]);
    if (o->group_count > 1 && !strstr(o->output, "%d"))
        return misused("-o needs a %%d for the numbers of several maps");
    if (o->mix_scale && !o->mix) return misused("--mix-scale needs --mix MAP.png");
    return check_stdout(common->json, o->output) ? EXIT_USAGE : -1;
}

static int parse(render_options* o, arguments* common, int count, char** words)
{
    const weft_texture_options defaults = WEFT_TEXTURE_OPTIONS_INIT;
    const option table[] = {
        {"-o", OPTION_TEXT, &o->output, "OUT.png", "where the picture goes", 0, 0},
        {"--size", OPTION_EXTENT, &o->size, "WxH", "of the picture in pixels", 1, 65536},
        {"--at", OPTION_POSITION, &o->at, "X,Y", "position of its first pixel; default 0,0", 0, 0},
        {"--level", OPTION_COUNT, &o->level, "L", "mip level: a pixel covers 2^L a side; default 0", 0, 30},
        {"--seed", OPTION_SEED, &o->texture.seed, "N", "which realisation of the texture; default 0", 0, 0},
        {"--period", OPTION_EXTENT, &o->period, "WxH", "pixels after which it repeats; 0: never", 0, 16777216},
        {"--impacts", OPTION_REAL, &o->texture.impacts, "N", "mean number of impacts of a noise; default 30", 1, 1000},
        {"--depth", OPTION_COUNT, &o->depth, "8|16", "bits of the PNG; default 8", 8, 16},
        {"--maps", OPTION_TEXT, &o->maps_text, "N,N,...", "channels of each map, one file per map", 0, 0},
        {"--mix", OPTION_TEXT, &o->mix, "MAP.png", "which step of a mixed model is where", 0, 0},
        {"--mix-scale", OPTION_COUNT, &o->mix_scale, "S", "pixels per pixel of that map; default 1", 1, 65536},
        {"--rotation", OPTION_CHOICE, &o->rotation, "default|none|all", "of exchanged contents; default what fits", 0,
         0},
        {"--scale-min", OPTION_REAL, &o->texture.scale_min, "S", "least scale of exchanged contents", 0.5, 1},
        {"--turbulence", OPTION_REAL, &o->texture.turbulence, "N", "distortion in pixels; below 0: none", -1, 64},
        {"--noise", OPTION_CHOICE, &o->noise, "texton|tile", "how noises are made; default texton", 0, 0},
    };
    const command_line line = {"render",
                               "MODEL -o OUT.png --size WxH",
                               "Makes pixels of a model's texture.",
                               notes,
                               table,
                               sizeof table / sizeof table[0],
                               1,
                               1};
    memset(o, 0, sizeof *o);
    o->texture = defaults;
    o->depth = 8;
    int code = parse_arguments(&line, count, words, common);
    if (code >= 0) return code;
    o->texture.period_x = o->period.width;
    o->texture.period_y = o->period.height;
    o->texture.mix_scale = (float)o->mix_scale;
    o->texture.rotation = (weft_rotation)o->rotation;
    o->texture.noise = o->noise == 0 ? WEFT_NOISE_DEFAULT : WEFT_NOISE_TILE;
    return check(o, common);
}

/* The model's channels as one map, or as the maps that were asked for. */
static int settle_groups(render_options* o, uint32_t channels)
{
    uint32_t sum = 0;
    if (o->group_count == 0 && channels > 4)
        return misused("the model has %u channels, say with --maps which belong together", channels);
    if (o->group_count == 0) o->groups[o->group_count++] = channels;
    for (int i = 0; i < o->group_count; i++) sum += o->groups[i];
    return sum == channels ? EXIT_FINE : misused("--maps has %u channels together, the model %u", sum, channels);
}

/* Rows that are rendered at once: about 32 MiB, in whole tiles of 64 where the picture has them. */
static uint32_t band_height(const weft_image* whole)
{
    uint64_t rows = ((uint64_t)32 << 20) / (uint64_t)whole->stride;
    rows = rows >= 1024 ? 1024 : rows >= 64 ? rows / 64 * 64 : 64;
    return rows < whole->height ? (uint32_t)rows : whole->height;
}

static int write_bands(const weft_texture* texture, const render_options* o, const weft_image* whole, map_files* maps)
{
    weft_image band = *whole;
    uint32_t rows = band_height(whole);
    int code = EXIT_FINE;
    band.data = malloc((size_t)band.stride * rows);
    if (!band.data) return failed("out of memory");
    for (uint32_t y = 0; y < whole->height && code == EXIT_FINE; y += band.height) {
        band.height = rows < whole->height - y ? rows : whole->height - y;
        progress_span span = {(double)y / whole->height, (double)(y + band.height) / whole->height};
        weft_status status = weft_texture_render(texture, o->at.x, o->at.y + y, o->level, progress_step, &span, &band);
        code = status == WEFT_OK ? maps_rows(maps, &band) : failed_weft(status);
        if (code == EXIT_FINE && interrupted()) code = failed_weft(WEFT_ERROR_CANCELLED);
    }
    progress_clear();
    free(band.data);
    return code;
}

/* The map that --mix names; a texture keeps none of its pixels, but the caller frees map->data. */
static int open_mix(render_options* o, weft_image* map)
{
    if (!o->mix) return EXIT_FINE;
    int code = open_photos(&o->mix, 1, map);
    if (code != EXIT_FINE) return code;
    if (map->channels != 1) return failed("%s has %u channels, which is no grey picture", o->mix, map->channels);
    o->texture.mix = map;
    return EXIT_FINE;
}

static int render(weft_context* context, const weft_model* model, uint32_t channels, const render_options* o)
{
    weft_texture* texture = NULL;
    map_files maps;
    uint32_t value = o->depth / 8;
    weft_image whole = {NULL,     (int64_t)value * channels * o->size.width,        o->size.width, o->size.height,
                        channels, o->depth == 16 ? WEFT_FORMAT_U16 : WEFT_FORMAT_U8};
    weft_status status = weft_texture_create(context, model, &o->texture, &texture);
    if (status != WEFT_OK) return failed_weft(status);
    int code = maps_open(&maps, o->output, o->groups, o->group_count, &whole);
    if (code == EXIT_FINE) code = write_bands(texture, o, &whole, &maps);
    if (code == EXIT_FINE) code = maps_commit(&maps);
    maps_discard(&maps);
    weft_texture_free(texture);
    return code;
}

static void report(const render_options* o, const char* device, double seconds)
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    json_text(&out, "output", o->output);
    json_unsigned(&out, "width", o->size.width);
    json_unsigned(&out, "height", o->size.height);
    json_integer(&out, "x", o->at.x);
    json_integer(&out, "y", o->at.y);
    json_unsigned(&out, "level", o->level);
    json_unsigned(&out, "seed", o->texture.seed);
    json_unsigned(&out, "depth", o->depth);
    json_array(&out, "maps");
    for (int i = 0; i < o->group_count; i++) json_unsigned(&out, NULL, o->groups[i]);
    json_end(&out);
    json_text(&out, "device", device);
    json_real(&out, "seconds", seconds);
    json_end(&out);
}

int command_render(int count, char** words)
{
    render_options o;
    arguments common;
    weft_context* context = NULL;
    weft_model* model = NULL;
    weft_model_info info;
    weft_device_info device = WEFT_DEVICE_INFO_INIT;
    weft_image map = {NULL, 0, 0, 0, 0, 0};
    int code = parse(&o, &common, count, words);
    if (code >= 0) return code;
    progress_begin(common.quiet);
    double begin = wall_seconds();
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_model(context, common.operand[0], &model, &info);
    if (code == EXIT_FINE) code = settle_groups(&o, info.channels);
    if (code == EXIT_FINE) code = open_mix(&o, &map);
    if (code == EXIT_FINE) code = render(context, model, info.channels, &o);
    if (code == EXIT_FINE && common.json && weft_context_device(context, &device) == WEFT_OK)
        report(&o, device.name, wall_seconds() - begin);
    weft_model_free(model);
    weft_context_free(context);
    free(map.data);
    return code;
}
