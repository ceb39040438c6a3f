/* What `weft bench` found, as a table and as JSON. */
#include "bench.h"
#include "open.h"

#include <stdio.h>
#include <string.h>

static double best_store(const limit_case* c)
{
    double plain = best_rate(&c->store[0]), non_temporal = best_rate(&c->store[1]);
    return plain > non_temporal ? plain : non_temporal;
}

static void write_rate(json* out, const char* key, const measurement* m, double unit)
{
    json_object(out, key);
    json_real(out, "best", best_rate(m) / unit);
    json_real(out, "median", median_rate(m) / unit);
    json_real(out, "per_processor_second", processor_rate(m) / unit);
    json_end(out);
}

static void write_ratio(json* out, const char* key, double value)
{
    if (value > 0)
        json_real(out, key, value);
    else
        json_null(out, key);
}

static void write_limits(json* out, const bench* b)
{
    json_object(out, "machine");
    json_text(out, "multiply_add", b->multiply_add.name);
    json_truth(out, "fused", b->multiply_add.fused);
    json_array(out, "limits");
    for (int i = 0; i < b->limit_count; i++) {
        const limit_case* c = &b->limits[i];
        json_object(out, NULL);
        json_unsigned(out, "threads", c->threads);
        write_rate(out, "giga_multiply_adds_per_second", &c->multiply_add, 1e9);
        write_rate(out, "plain_store_gigabytes_per_second", &c->store[0], 1e9);
        write_rate(out, "non_temporal_store_gigabytes_per_second", &c->store[1], 1e9);
        if (b->has_yardstick) write_rate(out, "yardstick_megapixels_per_second", &c->yardstick, 1e6);
        if (b->octaves > 0) write_rate(out, "yardstick_mega_octaves_of_solids_per_second", &c->solid, 1e6);
        json_end(out);
    }
    json_end(out);
    json_end(out);
}

static void write_ratios(json* out, const char* key, const bench* b, const device_case* d, bench_rate rate)
{
    json_object(out, key);
    write_ratio(out, "of_multiply_add_peak", ratio_of_peak(b, d, rate));
    write_ratio(out, "of_store_bandwidth", ratio_of_store(b, d, rate));
    write_ratio(out, "to_yardstick", ratio_to_yardstick(b, d, rate));
    write_ratio(out, "to_scalar", ratio_to_scalar(b, d, rate));
    write_ratio(out, "to_simd", ratio_to_simd(b, d, rate));
    write_ratio(out, "to_one_thread", ratio_to_one_thread(b, d, rate));
    write_ratio(out, "points_to_scalar", ratio_points_to_scalar(b, d, rate));
    write_ratio(out, "space_to_scalar", ratio_space_to_scalar(b, d, rate));
    write_ratio(out, "space_to_yardstick", ratio_space_to_yardstick(b, d, rate));
    write_ratio(out, "nanoseconds_per_octave_of_solids", octave_time(b, d, rate));
    json_end(out);
}

static void write_device(json* out, const bench* b, const device_case* d)
{
    json_object(out, NULL);
    json_text(out, "device", d->device.name);
    json_truth(out, "exact", d->device.exact != 0);
    json_unsigned(out, "threads", d->threads);
    json_real(out, "first_window_seconds", d->first_seconds);
    write_rate(out, "megapixels_per_second", &d->window, 1e6);
    json_unsigned(out, "points", d->plane.count);
    write_rate(out, "megapoints_per_second", &d->plane.sample, 1e6);
    if (b->has_yardstick) {
        json_unsigned(out, "points_in_space", d->space.count);
        write_rate(out, "megapoints_in_space_per_second", &d->space.sample, 1e6);
    }
    write_ratios(out, "ratios", b, d, best_rate);
    write_ratios(out, "ratios_by_processor_time", b, d, processor_rate);
    json_end(out);
}

void bench_write_json(const bench* b)
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    json_text(&out, "model", b->path);
    json_text(&out, "method", method_name(b->info.method));
    json_unsigned(&out, "channels", b->info.channels);
    json_unsigned(&out, "model_width", b->info.width);
    json_unsigned(&out, "model_height", b->info.height);
    json_real(&out, "impacts", (double)b->impacts);
    json_unsigned(&out, "width", b->size.width);
    json_unsigned(&out, "height", b->size.height);
    json_unsigned(&out, "repetitions", b->repetitions);
    write_limits(&out, b);
    json_array(&out, "devices");
    for (int i = 0; i < b->device_count; i++) write_device(&out, b, &b->devices[i]);
    json_end(&out);
    json_end(&out);
}

static void print_limits(const bench* b)
{
    for (int i = 0; i < b->limit_count; i++) {
        const limit_case* c = &b->limits[i];
        printf("%u thread%s: %.1f G multiply-adds/s (%s), %.1f GB/s of stores", c->threads, c->threads == 1 ? "" : "s",
               best_rate(&c->multiply_add) / 1e9, b->multiply_add.name, best_store(c) / 1e9);
        if (b->has_yardstick)
            printf(", %.2f Mpixel/s by the paper's %s", best_rate(&c->yardstick) / 1e6,
                   b->octaves > 0 ? "rows" : "gather");
        if (b->octaves > 0) printf(", solids in %.1f ns per octave", 1e9 / best_rate(&c->solid));
        putchar('\n');
    }
}

static void print_ratio(double value, double unit, const char* mark, int digits)
{
    char text[32] = "-";
    if (value > 0) snprintf(text, sizeof text, "%.*f%s", digits, value * unit, mark);
    printf(" %9s", text);
}

static void print_device(const bench* b, const device_case* d)
{
    printf("%-14s %7u %9.1f %9.1f", d->device.name, d->threads, best_rate(&d->window) / 1e6,
           median_rate(&d->window) / 1e6);
    print_ratio(ratio_of_peak(b, d, best_rate), 100, " %", 1);
    print_ratio(ratio_of_peak(b, d, processor_rate), 100, " %", 1);
    print_ratio(ratio_of_store(b, d, best_rate), 100, " %", 1);
    print_ratio(ratio_to_yardstick(b, d, best_rate), 1, "", 1);
    print_ratio(ratio_to_scalar(b, d, best_rate), 1, "", 2);
    print_ratio(ratio_to_one_thread(b, d, best_rate), 1, "", 2);
    printf(" %10.3f", best_rate(&d->plane.sample) / 1e6);
    print_ratio(ratio_points_to_scalar(b, d, best_rate), 1, "", 2);
    if (b->has_yardstick) {
        printf(" %10.3f", best_rate(&d->space.sample) / 1e6);
        print_ratio(ratio_space_to_scalar(b, d, best_rate), 1, "", 2);
    }
    if (b->octaves > 0) {
        print_ratio(octave_time(b, d, best_rate), 1, "", 1);
        print_ratio(ratio_space_to_yardstick(b, d, best_rate), 1, "", 2);
    }
    putchar('\n');
}

void bench_write_text(const bench* b)
{
    char size[MODEL_SIZE_ROOM];
    printf("%s: %s%s, channels %u", b->path, method_name(b->info.method), model_size(&b->info, size), b->info.channels);
    if (b->info.method == WEFT_METHOD_TEXTON) printf(", %g impacts", (double)b->impacts);
    printf("; window of %u x %u floats, best of %u\n", b->size.width, b->size.height, b->repetitions);
    print_limits(b);
    printf("\n%-14s %7s %9s %9s %9s %9s %9s %9s %9s %9s %10s %9s", "device", "threads", "Mpixel/s", "median", "of peak",
           "by CPU", "of stores", b->octaves > 0 ? "x direct" : "x gather", "x scalar", "x 1 thr.", "Mpoint/s",
           "x scalar");
    if (b->has_yardstick) printf(" %10s %9s", b->octaves > 0 ? "solid M/s" : "surface M/s", "x scalar");
    if (b->octaves > 0) printf(" %9s %9s", "ns/octave", "x paper");
    putchar('\n');
    for (int i = 0; i < b->device_count; i++) print_device(b, &b->devices[i]);
}
