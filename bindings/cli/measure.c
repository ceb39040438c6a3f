/* Repetitions in turns, best and median. */
#include "measure.h"
#include "clock.h"
#include "command.h"
#include "progress.h"
#include "report.h"

#include <stdlib.h>
#include <weft/weft.h>

static const double enough_seconds = 0.05;

static int ascending(const void* left, const void* right)
{
    double a = *(const double*)left, b = *(const double*)right;
    return (a > b) - (a < b);
}

static int run_once(measurement* m)
{
    double wall = wall_seconds(), processor = processor_seconds();
    int code = m->run(m->state);
    m->wall[m->count] = wall_seconds() - wall;
    m->processor[m->count++] = processor_seconds() - processor;
    return code;
}

/* Several short runs find a moment of quiet where a long one finds none. */
static int run_in_a_row(measurement* m)
{
    double spent = 0;
    int code = EXIT_FINE;
    for (int i = 0; i < MOST_IN_A_ROW && spent < enough_seconds && code == EXIT_FINE; i++) {
        code = run_once(m);
        spent += m->wall[m->count - 1];
    }
    return code;
}

int measure(measurement* const* list, int count, int repetitions)
{
    progress_span whole = {0, 1};
    for (int i = 0; i < repetitions * count; i++) {
        if (progress_step(&whole, (float)i / (float)(repetitions * count))) return failed_weft(WEFT_ERROR_CANCELLED);
        int code = run_in_a_row(list[i % count]);
        if (code != EXIT_FINE) return code;
    }
    for (int i = 0; i < count; i++) {
        qsort(list[i]->wall, (size_t)list[i]->count, sizeof(double), ascending);
        qsort(list[i]->processor, (size_t)list[i]->count, sizeof(double), ascending);
    }
    progress_clear();
    return EXIT_FINE;
}

static double rate(const measurement* m, const double* seconds, int which)
{
    return m->count > which && seconds[which] > 0 ? m->amount / seconds[which] : 0;
}

double best_rate(const measurement* m) { return rate(m, m->wall, 0); }

double median_rate(const measurement* m) { return rate(m, m->wall, m->count / 2); }

double processor_rate(const measurement* m) { return rate(m, m->processor, 0); }
