/* Wavelet noise to JSON and back. The file has a row per axis, weft_wavelet a column. */
#include "wavelet_json.h"
#include "command.h"
#include "json_read.h"
#include "report.h"

#include <string.h>

static const char kind[] = "wavelet";
enum { MOST_BANDS = 16, MOST_CHANNELS = 16, MOST_KNOTS = 32 };

int get_wavelet(const weft_model* model, weft_wavelet* wavelet)
{
    const weft_wavelet start = WEFT_WAVELET_INIT;
    *wavelet = start;
    weft_status status = weft_model_get_wavelet(model, wavelet);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static void write_column(json* out, const char* key, const float table[][16], uint32_t rows, uint32_t column)
{
    json_array(out, key);
    for (uint32_t i = 0; i < rows; i++) json_real(out, NULL, (double)table[i][column]);
    json_end(out);
}

static void write_row(json* out, const char* key, const float* row, uint32_t count)
{
    json_array(out, key);
    for (uint32_t i = 0; i < count; i++) json_real(out, NULL, (double)row[i]);
    json_end(out);
}

void json_wavelet(json* out, const char* key, const weft_wavelet* w)
{
    json_object(out, key);
    json_text(out, "method", kind);
    write_row(out, "mean", w->mean, w->channels);
    json_array(out, "axes");
    for (uint32_t p = 0; p < w->channels; p++) write_row(out, NULL, w->axes[p], w->channels);
    json_end(out);
    json_array(out, "weights");
    for (uint32_t p = 0; p < w->channels; p++) write_column(out, NULL, w->weight, w->bands, p);
    json_end(out);
    json_array(out, "tone");
    for (uint32_t p = 0; p < w->channels && w->knots > 0; p++) {
        json_object(out, NULL);
        write_column(out, "x", w->knot_x, w->knots, p);
        write_column(out, "y", w->knot_y, w->knots, p);
        write_column(out, "slope", w->knot_slope, w->knots, p);
        json_end(out);
    }
    json_end(out);
    json_end(out);
}

/* Lengths that must agree wherever they occur; UINT32_MAX is not known yet. */
typedef struct lengths {
    uint32_t channels, bands, knots;
} lengths;

static int agree(json_reader* in, uint32_t* known, uint32_t length, const char* what)
{
    if (!json_read_fine(in)) return 0;
    if (*known == UINT32_MAX) *known = length;
    return *known == length || json_read_refuse(in, "%u %s here, %u before", length, what, *known);
}

/* Reads an array of numbers, `step` apart in memory. */
static int read_numbers(json_reader* in, float* values, size_t step, uint32_t most, uint32_t* known, const char* what)
{
    uint32_t count = 0;
    if (!json_read_open(in, '[')) return 0;
    for (; json_read_value(in); count++) {
        if (count == most) return json_read_refuse(in, "more than %u %s", most, what);
        if (!json_read_float(in, values + step * count)) return 0;
    }
    return agree(in, known, count, what);
}

/* One axis' tone curve. */
static int read_curve(json_reader* in, weft_wavelet* w, uint32_t p, lengths* known)
{
    char key[JSON_KEY_ROOM];
    static const char* const names[3] = {"x", "y", "slope"};
    float* const tables[3] = {&w->knot_x[0][p], &w->knot_y[0][p], &w->knot_slope[0][p]};
    int seen[3] = {0, 0, 0};
    if (!json_read_open(in, '{')) return 0;
    while (json_read_member(in, key)) {
        int i = 0;
        while (i < 3 && strcmp(key, names[i]) != 0) i++;
        if (i == 3 || seen[i]++) return json_read_refuse(in, "\"%s\" is %s", key, i == 3 ? "unknown" : "here twice");
        if (!read_numbers(in, tables[i], 16, MOST_KNOTS, &known->knots, "knots")) return 0;
    }
    for (int i = 0; i < 3 && json_read_fine(in); i++)
        if (!seen[i]) return json_read_refuse(in, "\"%s\" is missing", names[i]);
    if (json_read_fine(in) && known->knots == 0) return json_read_refuse(in, "a tone curve has no knots");
    return json_read_fine(in);
}

static int read_method(json_reader* in, weft_wavelet* w, lengths* known)
{
    char text[JSON_KEY_ROOM];
    (void)w, (void)known;
    if (!json_read_text(in, text, sizeof text)) return 0;
    return strcmp(text, kind) == 0 || json_read_refuse(in, "the method is \"%s\", not \"%s\"", text, kind);
}

static int read_mean(json_reader* in, weft_wavelet* w, lengths* known)
{
    return read_numbers(in, w->mean, 1, MOST_CHANNELS, &known->channels, "channels");
}

/* An array with a value for every axis. */
static int read_axis_by_axis(json_reader* in, weft_wavelet* w, lengths* known,
                             int (*read)(json_reader* in, weft_wavelet* w, uint32_t p, lengths* known))
{
    uint32_t count = 0;
    if (!json_read_open(in, '[')) return 0;
    for (; json_read_value(in); count++) {
        if (count == MOST_CHANNELS) return json_read_refuse(in, "more than %u axes", count);
        if (!read(in, w, count, known)) return 0;
    }
    if (read == read_curve && count == 0 && json_read_fine(in)) return agree(in, &known->knots, 0, "knots");
    return agree(in, &known->channels, count, "channels");
}

static int read_axis(json_reader* in, weft_wavelet* w, uint32_t p, lengths* known)
{
    return read_numbers(in, w->axes[p], 1, MOST_CHANNELS, &known->channels, "channels");
}

static int read_weight(json_reader* in, weft_wavelet* w, uint32_t p, lengths* known)
{
    return read_numbers(in, &w->weight[0][p], 16, MOST_BANDS, &known->bands, "bands");
}

static int read_axes(json_reader* in, weft_wavelet* w, lengths* known)
{
    return read_axis_by_axis(in, w, known, read_axis);
}

static int read_weights(json_reader* in, weft_wavelet* w, lengths* known)
{
    return read_axis_by_axis(in, w, known, read_weight);
}

static int read_tone(json_reader* in, weft_wavelet* w, lengths* known)
{
    return read_axis_by_axis(in, w, known, read_curve);
}

typedef struct member {
    const char* key;
    int (*read)(json_reader* in, weft_wavelet* w, lengths* known);
} member;

enum { MEMBERS = 5 };
static const member members[MEMBERS] = {
    {"method", read_method}, {"mean", read_mean}, {"axes", read_axes}, {"weights", read_weights}, {"tone", read_tone}};

static int read_members(json_reader* in, weft_wavelet* w, lengths* known)
{
    char key[JSON_KEY_ROOM];
    int seen[MEMBERS] = {0};
    if (!json_read_open(in, '{')) return 0;
    while (json_read_member(in, key)) {
        int i = 0;
        while (i < MEMBERS && strcmp(key, members[i].key) != 0) i++;
        if (i == MEMBERS) return json_read_refuse(in, "\"%s\" is unknown", key);
        if (seen[i]++) return json_read_refuse(in, "\"%s\" is here twice", key);
        if (!members[i].read(in, w, known)) return 0;
    }
    for (int i = 0; i < MEMBERS && json_read_fine(in); i++)
        if (!seen[i]) return json_read_refuse(in, "\"%s\" is missing", members[i].key);
    return json_read_end(in);
}

int read_wavelet(const char* path, const char* text, size_t size, weft_wavelet* wavelet)
{
    const weft_wavelet start = WEFT_WAVELET_INIT;
    lengths known = {UINT32_MAX, UINT32_MAX, UINT32_MAX};
    json_reader in = json_read_begin(text, size);
    *wavelet = start;
    if (!read_members(&in, wavelet, &known)) return failed("%s: line %u: %s", path, in.line, in.error);
    wavelet->channels = known.channels;
    wavelet->bands = known.bands;
    wavelet->knots = known.knots;
    return EXIT_FINE;
}
