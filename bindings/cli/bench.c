/* weft bench: speed of each device on one model, beside the limits of the machine and the papers' own ways, in one run.
 */
#include "bench.h"
#include "command.h"
#include "open.h"
#include "progress.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

static const char notes[] =
    "Each device is measured with one thread and with all (or --threads N). --device NAME measures that one\n"
    "and scalar. Speeds are those of the best of the repetitions, which are taken in turns. Processor time is\n"
    "what the processor gave to all threads: other programs disturb it less. Ratios compare within this run,\n"
    "in JSON by both kinds of time:\n"
    "  of peak    multiply-adds per pixel, channels * 3 * impacts of texton noise and channels * 10 of wavelet\n"
    "             noise, of what the machine does in registers\n"
    "  by CPU     the same in processor time\n"
    "  of stores  bytes of the picture, of what the machine writes to memory\n"
    "  x gather   against the paper's shader, which draws the points anew for every pixel; on 32 rows of the window\n"
    "  x direct   against octaves that are splined one by one, rows first, without tone curves and colours\n"
    "  ns/octave  nanoseconds of a solid point, by octaves and channels\n"
    "  x paper    against the paper's loop over 27 coefficients of a cube of 128 a side\n"
    "Points are incoherent, in a square or cube of 4096 pixels, without filtering; fewer than a million where that\n"
    "takes long. Points in space are solid ones of wavelet noise, and on a surface of texton noise.";

int command_bench(int count, char** words)
{
    static bench b;
    const option table[] = {
        {"--size", OPTION_EXTENT, &b.size, "WxH", "of the window; default 1024x1024", 1, 16384},
        {"--impacts", OPTION_REAL, &b.impacts, "N", "mean number of impacts; default 30", 1, 1000},
        {"--repetitions", OPTION_COUNT, &b.repetitions, "N", "of every measurement; default 5", 1, MOST_REPETITIONS},
    };
    const command_line line = {"bench", "MODEL", "Measures speed beside the machine's limits.",
                               notes,   table,   sizeof table / sizeof table[0],
                               1,       1};
    arguments common;
    weft_context* context = NULL;
    memset(&b, 0, sizeof b);
    b.size.width = b.size.height = 1024;
    b.impacts = 30;
    b.repetitions = 5;
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    progress_begin(common.quiet);
    b.path = common.operand[0];
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_model(context, b.path, &b.model, &b.info);
    if (code == EXIT_FINE) code = bench_prepare(&b, &common);
    if (code == EXIT_FINE) code = bench_measure(&b);
    if (code == EXIT_FINE && common.json)
        bench_write_json(&b);
    else if (code == EXIT_FINE)
        bench_write_text(&b);
    bench_free(&b);
    weft_context_free(context);
    return code;
}
