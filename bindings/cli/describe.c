/* weft describe: what a photo is like, and which method suits it. */
#include "describe.h"
#include "command.h"
#include "json.h"
#include "open.h"
#include "options.h"
#include "report.h"

#include <stdio.h>
#include <stdlib.h>

static const char notes[] =
    "The most varied principal channel is measured, the middle 512 x 512 pixels at most; 0 is what a Gaussian,\n"
    "isotropic, even texture has.\n"
    "  structure   what correlates beyond the spectrum: edges, things; noise cannot show it\n"
    "    toned     the same once a tone curve has made the values normal\n"
    "  histogram   distance of the values from normal ones, in standard deviations\n"
    "  anisotropy  of the spectrum; 1 is a single direction\n"
    "  unevenness  how much contrast and brightness change from place to place\n"
    "  period      pixels after which it repeats along each axis; 0: it does not\n"
    "`weft analyze --method auto` takes the method that is named here.";

int describe_photo(weft_context* context, const weft_image* photo, progress_span* span, weft_description* description)
{
    const weft_description start = WEFT_DESCRIPTION_INIT;
    *description = start;
    weft_status status = weft_describe(context, photo, progress_step, span, description);
    progress_clear();
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static void write_json(const weft_description* d)
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    json_text(&out, "method", method_name(d->method));
    json_real(&out, "structure", (double)d->structure);
    json_real(&out, "structure_toned", (double)d->structure_toned);
    json_real(&out, "histogram", (double)d->histogram);
    json_real(&out, "anisotropy", (double)d->anisotropy);
    json_real(&out, "unevenness", (double)d->unevenness);
    json_unsigned(&out, "period_x", d->period_x);
    json_unsigned(&out, "period_y", d->period_y);
    json_text(&out, "reasons", d->reasons);
    json_end(&out);
}

static void write_text(const weft_description* d)
{
    printf("%-14s %s\n", "method", method_name(d->method));
    printf("%-14s %.4f\n", "structure", (double)d->structure);
    printf("%-14s %.4f\n", "  toned", (double)d->structure_toned);
    printf("%-14s %.4f\n", "histogram", (double)d->histogram);
    printf("%-14s %.4f\n", "anisotropy", (double)d->anisotropy);
    printf("%-14s %.4f\n", "unevenness", (double)d->unevenness);
    printf("%-14s %u x %u\n", "period", d->period_x, d->period_y);
    printf("%-14s %s\n", "reasons", d->reasons);
}

int command_describe(int count, char** words)
{
    const command_line line = {
        "describe", "PHOTO", "Says what a photo is like and which method suits it.", notes, NULL, 0, 1, 1};
    arguments common;
    weft_context* context = NULL;
    weft_image photo = {NULL, 0, 0, 0, 0, 0};
    weft_description description;
    progress_span whole = {0, 1};
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    progress_begin(common.quiet);
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_photos(common.operand, 1, &photo);
    if (code == EXIT_FINE) code = describe_photo(context, &photo, &whole, &description);
    if (code == EXIT_FINE && common.json)
        write_json(&description);
    else if (code == EXIT_FINE)
        write_text(&description);
    weft_context_free(context);
    free(photo.data);
    return code;
}
