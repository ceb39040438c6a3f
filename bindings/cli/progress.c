/* The progress bar and the interrupt that the progress callback reads. */
#include "progress.h"
#include "clock.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static volatile sig_atomic_t stop = 0;
static int shown = 0;     /* bars are wanted */
static int on_screen = 0; /* one is there */
static double begin_time = 0;
static double last_time = 0;
static char note[96] = ""; /* that follows the bar */

static void on_signal(int number)
{
    (void)number;
    stop = 1;
}

/* What was ignored when the program began stays ignored, as nohup and shells mean it. */
static void listen_to(int number)
{
    struct sigaction action;
    if (sigaction(number, NULL, &action) != 0 || action.sa_handler == SIG_IGN) return;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    action.sa_flags = (int)SA_RESETHAND; /* and no SA_RESTART: a read from a pipe ends too */
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, NULL);
}

void progress_listen(void)
{
    listen_to(SIGINT);
    listen_to(SIGTERM);
    listen_to(SIGHUP);
}

int interrupted(void) { return stop != 0; }

void progress_begin(int quiet)
{
    shown = !quiet && isatty(STDERR_FILENO);
    begin_time = last_time = wall_seconds();
}

void progress_note(const char* text)
{
    size_t length = strlen(text);
    length = length < sizeof note ? length : sizeof note - 1;
    memcpy(note, text, length);
    note[length] = '\0';
}

static void draw(double done, double now)
{
    enum { width = 40 };
    char bar[width + 1];
    int full = (int)(done * width);
    memset(bar, '.', width);
    memset(bar, '#', (size_t)full);
    bar[width] = '\0';
    fprintf(stderr, "\r[%s] %3d %%", bar, (int)(done * 100));
    double left = done > 0.02 ? (now - begin_time) * (1 - done) / done : 0;
    if (left >= 1) fprintf(stderr, ", %.0f s left", left);
    if (*note) fprintf(stderr, "  %s", note);
    fputs("\033[K", stderr);
    fflush(stderr);
    on_screen = 1;
}

int32_t progress_step(void* span, float done)
{
    const progress_span* part = span;
    double now = shown ? wall_seconds() : 0;
    if (shown && now - last_time >= 0.1) {
        double whole = part->from + (part->to - part->from) * (double)done;
        draw(whole < 0 ? 0 : whole > 1 ? 1 : whole, now);
        last_time = now;
    }
    return stop;
}

void progress_clear(void)
{
    *note = '\0';
    if (!on_screen) return;
    fputs("\r\033[K", stderr);
    fflush(stderr);
    on_screen = 0;
}
