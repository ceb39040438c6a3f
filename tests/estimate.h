/* Means of independent estimates and the interval that chance explains (Student's t). */
#ifndef WEFT_TESTS_ESTIMATE_H
#define WEFT_TESTS_ESTIMATE_H

#include "support.h"
#include <math.h>

typedef struct Estimate {
    double sum, squares;
    uint32_t count;
} Estimate;

static inline void add(Estimate *estimate, double value)
{
    estimate->sum += value;
    estimate->squares += value * value;
    ++estimate->count;
}

static inline double mean_of(const Estimate *e) { return e->sum / e->count; }
static inline double error_of(const Estimate *e)
{
    const double mean = mean_of(e), variance = (e->squares - e->count * mean * mean) / (e->count - 1);
    return sqrt((variance > 0 ? variance : 0) / e->count);
}

/* |t| that is exceeded with a probability of 1e-9: by 23 degrees of freedom, and by 59. */
static inline double bound_of(const Estimate *e) { return e->count < 60 ? 9.9 : 7.2; }

/* Half of the interval that chance explains. */
static inline double half_of(const Estimate *e) { return bound_of(e) * error_of(e); }

/* Within the interval, and the interval narrow enough that it says something: half of it below `narrow`. */
static inline void assert_expected(const Estimate *estimate, double expected, double narrow, const char *what,
                                   int index)
{
    const double mean = mean_of(estimate), half = half_of(estimate);
    assert_true(estimate->count >= 24);
    if (fabs(mean - expected) <= half && half <= narrow) return;
    print_error("%s %d: %g, expected %g, half interval %g, to be below %g\n", what, index, mean, expected, half,
                narrow);
    fail();
}

#endif
