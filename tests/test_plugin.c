/* Plug-ins: each wrong one is refused with its sentence and still listed; the right ones are used; where they are
 * found. */
#include "support.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#define STUBS WEFT_TEST_STUBS "/"

/* The entry of a device list with that name, or an info whose name is empty. */
static weft_device_info listed(const char *name)
{
    uint32_t count = 0;
    weft_device_info info = WEFT_DEVICE_INFO_INIT;
    assert_ok(weft_device_count(&count));
    for (uint32_t i = 0; i < count; ++i) {
        assert_ok(weft_device_get(i, &info));
        if (strcmp(info.name, name) == 0) return info;
    }
    info.name[0] = 0;
    return info;
}

/* A file, and what is said about it; NULL: it is accepted. */
typedef struct Specimen {
    const char *file, *name, *sentence;
    weft_status status;
} Specimen;

static const Specimen specimens[] = {
    {"weft_backend_good.so", "good", NULL, WEFT_OK},
    {"weft_backend_minor.so", "minor", NULL, WEFT_OK},
    {"weft_backend_longer.so", "longer", NULL, WEFT_OK},
    {"weft_backend_picky.so", "picky", NULL, WEFT_OK},
    {"weft_backend_fails.so", "fails", NULL, WEFT_OK},
    {"weft_backend_magic.so", "magic", "its table does not begin with the magic number", WEFT_ERROR_DEVICE},
    {"weft_backend_short.so", "short", "its table is 40 bytes", WEFT_ERROR_DEVICE},
    {"weft_backend_major.so", "major", "it speaks ABI 2, this libweft speaks 0", WEFT_ERROR_UNSUPPORTED},
    {"weft_backend_hole.so", "hole", "its table has a hole", WEFT_ERROR_DEVICE},
    {"weft_backend_alias.so", "alias", "its name is not that of its file", WEFT_ERROR_DEVICE},
    {"weft_backend_nameless.so", "nameless", "its name is not that of its file", WEFT_ERROR_DEVICE},
    {"weft_backend_symbol.so", "symbol", "it exports no weft_backend_v0", WEFT_ERROR_DEVICE},
    {"weft_backend_empty.so", "empty", "", WEFT_ERROR_DEVICE},   /* the dynamic linker's own words */
    {"weft_backend_text.so", "text", "", WEFT_ERROR_DEVICE},     /* no shared object */
    {"weft_backend_absent.so", "absent", "", WEFT_ERROR_DEVICE}, /* not there */
    {"libgood.so", "libgood.so", "its file is not called weft_backend_<name>.so", WEFT_ERROR_DEVICE},
    {"weft_backend_Upper.so", "weft_backend_Upper.so", "its file is not called weft_backend_<name>.so",
     WEFT_ERROR_DEVICE},
};
#define SPECIMENS (sizeof specimens / sizeof *specimens)

static void each_is_judged(void **state)
{
    (void)state;
    for (size_t i = 0; i < SPECIMENS; ++i) {
        const Specimen *specimen = &specimens[i];
        char path[1024];
        snprintf(path, sizeof path, "%s%s", STUBS, specimen->file);
        assert_string_equal(listed(specimen->name).name, "");
        if (specimen->sentence) {
            assert_refused(weft_backend_load(path), specimen->status, "weft_backend_load", specimen->sentence);
            assert_non_null(strstr(weft_error_message(), specimen->file));
        } else {
            assert_ok(weft_backend_load(path));
        }
        const weft_device_info info = listed(specimen->name);
        assert_string_equal(info.name, specimen->name);
        assert_int_equal(info.status, specimen->status);
        if (specimen->sentence) {
            assert_non_null(strstr(info.description, specimen->sentence));
            assert_true(strlen(info.description) > 10);
            weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
            weft_context *context = NULL;
            options.device = specimen->name;
            assert_refused(weft_context_create(&options, &context), WEFT_ERROR_DEVICE, "weft_context_create",
                           specimen->name);
            assert_null(context);
        } else {
            assert_string_equal(info.description, "paints the mean");
        }
    }
}

static void paths_must_be_absolute(void **state)
{
    (void)state;
    uint32_t before = 0, after = 0;
    assert_ok(weft_device_count(&before));
    assert_int_equal(chdir(WEFT_TEST_STUBS), 0);
    const char *const paths[] = {"weft_backend_good.so", "./weft_backend_good.so", "", "../stubs/weft_backend_good.so"};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; ++i)
        assert_refused(weft_backend_load(paths[i]), WEFT_ERROR_ARGUMENT, "weft_backend_load", "absolute");
    assert_ok(weft_device_count(&after));
    assert_int_equal(before, after);
}

static void loading_twice_lists_once(void **state)
{
    (void)state;
    uint32_t before = 0, after = 0;
    assert_ok(weft_backend_load(STUBS "weft_backend_good.so"));
    assert_ok(weft_device_count(&before));
    assert_ok(weft_backend_load(STUBS "weft_backend_good.so"));
    assert_int_equal(weft_backend_load(STUBS "weft_backend_magic.so"), WEFT_ERROR_DEVICE);
    assert_int_equal(weft_backend_load(STUBS "weft_backend_magic.so"), WEFT_ERROR_DEVICE);
    assert_ok(weft_device_count(&after));
    assert_int_equal(before, after);
    /* another file may not take the name of a backend that is there */
    assert_refused(weft_backend_load(WEFT_TEST_STUBS "/elsewhere/weft_backend_good.so"), WEFT_ERROR_DEVICE,
                   "weft_backend_load", "good");
    assert_int_equal(listed("good").status, WEFT_OK);
}

static void no_devices_and_sick_ones(void **state)
{
    (void)state;
    uint32_t before = 0, after = 0;
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *context = NULL;
    assert_ok(weft_device_count(&before));
    assert_ok(weft_backend_load(STUBS "weft_backend_none.so"));
    assert_ok(weft_device_count(&after));
    assert_int_equal(before, after);
    options.device = "none";
    assert_refused(weft_context_create(&options, &context), WEFT_ERROR_DEVICE, "weft_context_create", "none");

    assert_ok(weft_backend_load(STUBS "weft_backend_sick.so"));
    const weft_device_info info = listed("sick");
    assert_int_equal(info.status, WEFT_ERROR_DEVICE);
    assert_string_equal(info.description, "this device has a cold");
    options.device = "sick";
    assert_refused(weft_context_create(&options, &context), WEFT_ERROR_DEVICE, "weft_context_create",
                   "this device has a cold");
}

/* Pixels of a small texton on the named device: every value. */
static weft_image painted(const char *device, weft_model_info *info)
{
    weft_context *context = new_context(device, 2);
    weft_model *model = new_texton(context, 16, 3, 8, WEFT_INTERPOLATION_LINEAR, 1);
    weft_texture *texture = new_texture(context, model, 0, 1, 0);
    weft_image image = rendered(texture, -5, 9, 0, 130, 75, 3);
    assert_ok(weft_model_get(model, info));
    const weft_point point = {3.5, 3.5, {0, 0}, {0, 0}};
    float sample[3];
    assert_ok(weft_texture_sample(texture, 1, &point, sample));
    if (strcmp(device, "good") == 0)
        for (int c = 0; c < 3; ++c) assert_true(sample[c] == info->mean[c]);
    weft_texture_free(texture);
    weft_model_free(model);
    weft_context_free(context);
    return image;
}

/* A plug-in made from backend.h alone gets the windows; one that does not know the program leaves it to "scalar". */
static void accepted_ones_are_used(void **state)
{
    (void)state;
    const char *const names[] = {"good", "minor", "longer"};
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    for (int i = 0; i < 3; ++i) {
        weft_image image = painted(names[i], &info);
        for (uint32_t k = 0; k < 130 * 75; ++k)
            for (uint32_t c = 0; c < 3; ++c) assert_true(values(&image)[k * 3 + c] == info.mean[c]);
        free_image(&image);
    }
    weft_image picky = painted("picky", &info), scalar = painted("scalar", &info);
    assert_same_pixels(&picky, &scalar, "the device that refuses and scalar");
    free_image(&picky);
    free_image(&scalar);
}

static void what_a_plug_in_says_is_passed_on(void **state)
{
    (void)state;
    weft_context *context = new_context("fails", 1);
    weft_model *model = new_texton(context, 16, 1, 8, WEFT_INTERPOLATION_LINEAR, 1);
    weft_texture *texture = new_texture(context, model, 0, 1, 0);
    weft_image image = new_image(20, 20, 1, WEFT_FORMAT_F32);
    assert_refused(weft_texture_render(texture, 0, 0, 0, NULL, NULL, &image), WEFT_ERROR_DEVICE, "weft_texture_render",
                   "the brush is broken");
    free_image(&image);
    weft_texture_free(texture);
    weft_model_free(model);
    weft_context_free(context);
}

/* This program again, in a process of its own with another environment, as a list of devices: "name status
 * description". */
static void list_in_child(const char *path, char *out, size_t size)
{
    int ends[2];
    size_t length = 0;
    assert_int_equal(pipe(ends), 0);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        dup2(ends[1], 1);
        close(ends[0]);
        if (path) setenv("WEFT_BACKEND_PATH", path, 1);
        execl("/proc/self/exe", "test_plugin", "list", (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    for (ssize_t n; (n = read(ends[0], out + length, size - 1 - length)) > 0;) length += (size_t)n;
    out[length] = 0;
    close(ends[0]);
    int answer = -1;
    assert_int_equal(waitpid(child, &answer, 0), child);
    assert_true(WIFEXITED(answer) && WEXITSTATUS(answer) == 0);
}

static int list(void)
{
    uint32_t count = 0;
    weft_device_info info = WEFT_DEVICE_INFO_INIT;
    if (weft_device_count(&count) != WEFT_OK) return 1;
    for (uint32_t i = 0; i < count; ++i) {
        if (weft_device_get(i, &info) != WEFT_OK) return 2;
        printf("%s %d %s\n", info.name, info.status, info.description);
    }
    return 0;
}

static void the_path_of_the_environment(void **state)
{
    (void)state;
    char out[16384];
    list_in_child(NULL, out, sizeof out); /* beside the library */
    assert_int_equal(strncmp(out, "scalar 0 ", 9), 0);
    assert_non_null(strstr(out, "\nsimd"));
    assert_null(strstr(out, "\ngood "));

    list_in_child(WEFT_TEST_STUBS, out, sizeof out); /* instead of that, everything in it, in the order of the names */
    assert_int_equal(strncmp(out, "scalar 0 ", 9), 0);
    assert_null(strstr(out, "\nsimd"));
    const char *last = out;
    const char *const in_order[] = {"\nweft_backend_Upper.so -6 ",
                                    "\nalias -6 ",
                                    "\nempty -6 ",
                                    "\nfails 0 ",
                                    "\ngood 0 ",
                                    "\nhole -6 ",
                                    "\nlonger 0 ",
                                    "\nmagic -6 ",
                                    "\nmajor -5 ",
                                    "\nminor 0 ",
                                    "\nshort -6 ",
                                    "\nsymbol -6 "};
    for (size_t i = 0; i < sizeof in_order / sizeof *in_order; ++i) {
        const char *found = strstr(out, in_order[i]);
        if (!found) print_error("no '%s' in:\n%s", in_order[i] + 1, out);
        assert_non_null(found);
        assert_true(found >= last);
        last = found;
    }
    assert_null(strstr(out, "libgood"));

    list_in_child("", out, sizeof out); /* nothing */
    assert_int_equal(strncmp(out, "scalar 0 ", 9), 0);
    assert_null(strchr(strchr(out, '\n') + 1, '\n'));

    list_in_child("/nowhere:" WEFT_TEST_STUBS "/elsewhere", out, sizeof out); /* several */
    assert_non_null(strstr(out, "\ngood 0 "));
    assert_null(strstr(out, "\nhole "));

    assert_int_equal(chdir(WEFT_TEST_STUBS), 0);
    list_in_child("elsewhere", out, sizeof out); /* relative: refused, and said so */
    assert_null(strstr(out, "\ngood 0 "));
    assert_non_null(strstr(out, "not absolute"));
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "list") == 0) return list();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_is_judged),
        cmocka_unit_test(paths_must_be_absolute),
        cmocka_unit_test(loading_twice_lists_once),
        cmocka_unit_test(no_devices_and_sick_ones),
        cmocka_unit_test(accepted_ones_are_used),
        cmocka_unit_test(what_a_plug_in_says_is_passed_on),
        cmocka_unit_test(the_path_of_the_environment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
