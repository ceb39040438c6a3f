/* Timing of several pieces of work in one run, taken in turns so that a busy machine disturbs them alike. */
#ifndef WEFT_CLI_MEASURE_H
#define WEFT_CLI_MEASURE_H

enum { MOST_REPETITIONS = 100, MOST_IN_A_ROW = 8 };

typedef struct measurement {
    int (*run)(void* state); /* does the work once; an exit code */
    void* state;
    double amount; /* of work in one run: pixels, points, multiply-adds, bytes */
    int count;
    double wall[MOST_REPETITIONS * MOST_IN_A_ROW],
        processor[MOST_REPETITIONS * MOST_IN_A_ROW]; /* seconds, in ascending order once measured */
} measurement;

/* Runs each measurement once per repetition, in turns, and what takes little time a few times in a row. Answers with an
 * exit code. */
int measure(measurement* const* list, int count, int repetitions);

double best_rate(const measurement* m);      /* amount per second of the fastest run */
double median_rate(const measurement* m);    /* of the run in the middle */
double processor_rate(const measurement* m); /* amount per second of processor time, all threads together; the best */

#endif
