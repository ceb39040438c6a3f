/* Threads: one texture from many of them, any executor, fork; always the same bytes, and never a thread that was not
 * allowed. */
#include "executors.h"
#include "support.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#if defined(__SANITIZE_THREAD__)
#define UNDER_TSAN 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define UNDER_TSAN 1
#endif
#endif

#define WIDTH 200
#define HEIGHT 120

static weft_context *over(const weft_executor *executor, uint32_t threads, const char *device)
{
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *context = NULL;
    options.executor = executor;
    options.threads = threads;
    options.device = device;
    assert_ok(weft_context_create(&options, &context));
    return context;
}

/* The saved model and the pixels that a context makes of a photo, as one checksum each. */
typedef struct Result {
    uint64_t model, pixels, comparison;
} Result;

static Result result_of(weft_context *context)
{
    weft_image photo = new_grain(GRAIN_SOFT, 64, 48, 3, 1);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *model = NULL;
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    Result result;
    size_t size = 0;
    options.support = 16;
    options.iterations = 10;
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model));
    void *bytes = saved(model, &size);
    weft_texture *texture = new_texture(context, model, 0, 7, 0);
    weft_image pixels = rendered(texture, -50, 33, 0, WIDTH, HEIGHT, 3);
    weft_image compared = pixels; /* sanitizers make comparing the slowest part by far */
    compared.stride = (int64_t)WIDTH * 3 * (int64_t)sizeof(float);
    compared.width = scaled(WIDTH, 40);
    compared.height = scaled(HEIGHT, 32);
    assert_ok(weft_compare(context, &photo, &compared, NULL, NULL, NULL, &comparison));
    result.model = checksum(bytes, size);
    result.pixels = checksum(pixels.data, image_bytes(&pixels));
    result.comparison = checksum(&comparison, sizeof comparison);
    free_image(&pixels);
    free_image(&photo);
    free(bytes);
    weft_texture_free(texture);
    weft_model_free(model);
    weft_context_free(context);
    return result;
}

static void any_executor_gives_the_same_bytes(void **state)
{
    (void)state;
    const char *const device[] = {"scalar", NULL};
    Result expected[2];
    for (int d = 0; d < 2; ++d) {
        expected[d] = result_of(over(NULL, 1, device[d]));
        const weft_executor *const executor[] = {
            NULL, NULL, NULL, &serial_executor, &reversed_executor, &threads_executor};
        const uint32_t threads[] = {2, 5, 0, 1, 1, 4};
        const int step =
            d == 0 ? (int)scaled(1, 5) : (int)scaled(2, 4); /* the best device: its pool, the machine's, reversed */
        for (int i = 0; i < 6; i += step) {
            const Result result = result_of(over(executor[i], threads[i], device[d]));
            assert_int_equal(result.model, expected[d].model);
            assert_int_equal(result.pixels, expected[d].pixels);
            assert_int_equal(result.comparison, expected[d].comparison);
        }
    }
    assert_int_equal(expected[0].model, expected[1].model);
    assert_int_equal(expected[0].pixels, expected[1].pixels);
}

/* What many threads do with one texture: windows, points, information, errors of their own. */
typedef struct Visitor {
    pthread_t thread;
    const weft_context *context;
    const weft_model *model;
    const weft_texture *texture;
    const weft_image *expected;
    uint32_t number;
    int wrong;
} Visitor;

static void visit(Visitor *visitor)
{
    const weft_image *expected = visitor->expected;
    for (uint32_t round = 0; round < scaled(6, 2); ++round) {
        Random random = {visitor->number * 1000 + round};
        const uint32_t x = random_below(&random, WIDTH - 41), y = random_below(&random, HEIGHT - 37);
        float window[41 * 37 * 3], sample[3];
        const weft_image image = {window, 0, 41, 37, 3, WEFT_FORMAT_F32};
        if (weft_texture_render(visitor->texture, x, y, 0, NULL, NULL, &image) != WEFT_OK) visitor->wrong |= 1;
        for (uint32_t row = 0; row < 37; ++row)
            if (memcmp(window + (size_t)row * 41 * 3, values(expected) + ((size_t)(y + row) * WIDTH + x) * 3,
                       41 * 3 * sizeof *window) != 0)
                visitor->wrong |= 2;
        const weft_point point = {x + 0.5, y + 0.5, {0, 0}, {0, 0}};
        if (weft_texture_sample(visitor->texture, 1, &point, sample) != WEFT_OK) visitor->wrong |= 4;
        if (memcmp(sample, window, sizeof sample) != 0) visitor->wrong |= 8;
        weft_model_info info = WEFT_MODEL_INFO_INIT;
        if (weft_model_get(visitor->model, &info) != WEFT_OK || info.channels != 3) visitor->wrong |= 16;
        if (weft_texture_render(visitor->texture, 0, 0, 100 + visitor->number, NULL, NULL, &image) !=
            WEFT_ERROR_ARGUMENT)
            visitor->wrong |= 32;
        char level[16] = "";
        for (uint32_t n = 100 + visitor->number, at = 3; at-- > 0; n /= 10) level[at] = (char)('0' + n % 10);
        if (!strstr(weft_error_message(), level)) visitor->wrong |= 64; /* the sentence of another thread */
    }
}

static void *visit_on_thread(void *visitor)
{
    visit(visitor);
    return NULL;
}

static void one_texture_from_many_threads(void **state)
{
    (void)state;
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 1);
    for (uint32_t d = 0; d < count; ++d) {
        weft_context *context = new_context(names[d], 2);
        weft_model *model = new_texton(context, 32, 3, 16, WEFT_INTERPOLATION_LINEAR, 2);
        weft_texture *texture = new_texture(context, model, 0, 5, 0);
        weft_image expected = rendered(texture, 0, 0, 0, WIDTH, HEIGHT, 3);
        Visitor visitor[6];
        for (uint32_t i = 0; i < 6; ++i) {
            const Visitor fresh = {0, context, model, texture, &expected, i, 0};
            visitor[i] = fresh;
            assert_int_equal(pthread_create(&visitor[i].thread, NULL, visit_on_thread, &visitor[i]), 0);
        }
        for (uint32_t i = 0; i < 6; ++i) {
            pthread_join(visitor[i].thread, NULL);
            if (visitor[i].wrong) print_error("%s, thread %u: %d\n", names[d], i, visitor[i].wrong);
            assert_int_equal(visitor[i].wrong, 0);
        }
        free_image(&expected);
        weft_texture_free(texture);
        weft_model_free(model);
        weft_context_free(context);
    }
}

static int tasks_in_progress;
static int32_t count_threads(void *user, float done)
{
    (void)done;
    const int now = thread_count();
    if (now > *(int *)user) *(int *)user = now;
    ++tasks_in_progress;
    return 0;
}

/* The whole way with one thread, or with an executor of one thread: no thread is ever created. */
static void no_thread_without_permission(void **state)
{
    (void)state;
    const weft_executor *const executor[] = {NULL, &serial_executor, &reversed_executor};
    for (int i = 0; i < 3; ++i) {
        weft_context *context = over(executor[i], i == 0 ? 1 : 0, NULL);
        const int before = thread_count();
        int most = before;
        weft_image photo = new_grain(GRAIN_SOFT, 64, 64, 3, 1), pixels = new_image(300, 300, 3, WEFT_FORMAT_U8);
        weft_model *model = NULL;
        assert_ok(weft_analyze_texton(context, &photo, NULL, count_threads, &most, &model));
        weft_texture *texture = new_texture(context, model, 0, 0, 0);
        assert_ok(weft_texture_render(texture, 0, 0, 0, count_threads, &most, &pixels));
        assert_true(tasks_in_progress > 0);
        assert_int_equal(most, before);
        assert_int_equal(thread_count(), before);
        weft_texture_free(texture);
        weft_model_free(model);
        weft_context_free(context);
        free_image(&photo);
        free_image(&pixels);
    }
}

static void threads_end_with_their_context(void **state)
{
    (void)state;
#ifdef UNDER_TSAN
    result_of(over(NULL, 2, NULL)); /* the sanitizer starts a thread of its own beside the first */
#endif
    const int before = thread_count();
    for (int i = 0; i < 3; ++i) result_of(over(NULL, 4, NULL));
    /* A thread that was joined leaves the system's list a moment later. */
    const struct timespec moment = {0, 10000000};
    for (int i = 0; i < 500 && thread_count() != before; ++i) nanosleep(&moment, NULL);
    assert_int_equal(thread_count(), before);
}

/* The pool's threads do not survive a fork; the child must get the same pixels all the same, and so must the parent. */
static void fork_keeps_working(void **state)
{
    (void)state;
#ifdef UNDER_TSAN
    skip(); /* starting threads after a fork of a process with threads is not supported there */
#else
    weft_context *context = over(NULL, 3, NULL);
    weft_model *model = new_texton(context, 32, 3, 16, WEFT_INTERPOLATION_LINEAR, 2);
    weft_texture *texture = new_texture(context, model, 0, 5, 0);
    weft_image expected = rendered(texture, 0, 0, 0, 400, 300, 3), pixels = new_image(400, 300, 3, WEFT_FORMAT_F32);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        alarm(60); /* a pool that waits for threads which are not there would wait for ever */
        const weft_status status = weft_texture_render(texture, 0, 0, 0, NULL, NULL, &pixels);
        _exit(status != WEFT_OK ? 2 : same_pixels(&pixels, &expected) ? 0 : 1);
    }
    int answer = -1;
    assert_int_equal(waitpid(child, &answer, 0), child);
    assert_true(WIFEXITED(answer));
    assert_int_equal(WEXITSTATUS(answer), 0);
    assert_ok(weft_texture_render(texture, 0, 0, 0, NULL, NULL, &pixels));
    assert_same_pixels(&pixels, &expected, "the parent after fork");
    free_image(&pixels);
    free_image(&expected);
    weft_texture_free(texture);
    weft_model_free(model);
    weft_context_free(context);
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_thread_without_permission), /* first: OpenCL's own threads come later */
        cmocka_unit_test(threads_end_with_their_context),    cmocka_unit_test(fork_keeps_working),
        cmocka_unit_test(any_executor_gives_the_same_bytes), cmocka_unit_test(one_texture_from_many_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
