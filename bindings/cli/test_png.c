/* The program's PNG reading and writing: every colour type, depth and interlacing against its own arithmetic, and files
 * that are cut or damaged. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>

#include "png.h"

enum { WIDTH = 13, HEIGHT = 11, COLOURS = 16, SAMPLES = WIDTH * HEIGHT * 4 };

/* A PNG as it is to be written, and the samples that it holds. */
typedef struct sketch {
    int type, depth, interlaced, transparent;
    int channels;              /* of the file */
    uint16_t samples[SAMPLES]; /* interleaved */
} sketch;

static uint32_t random_state = 1;

static uint32_t draw(uint32_t below)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)(random_state >> 4) * below >> 28);
}

static png_color colour_of(int index)
{
    const png_color colour = {(png_byte)(index * 3 + 1), (png_byte)(200 - index * 5), (png_byte)(index * index)};
    return colour;
}

static png_byte alpha_of(int index) { return (png_byte)(index * 16); }

static void fill(sketch* s)
{
    static const int channels[7] = {1, 0, 3, 1, 2, 0, 4};
    s->channels = channels[s->type];
    for (int i = 0; i < WIDTH * HEIGHT * s->channels; i++)
        s->samples[i] = (uint16_t)draw(1u << (s->depth < 16 ? s->depth : 16));
    if (s->type == PNG_COLOR_TYPE_PALETTE)
        for (int i = 0; i < WIDTH * HEIGHT; i++) s->samples[i] %= COLOURS;
}

/* The samples of a row as the file packs them. */
static void pack_row(const sketch* s, int y, png_byte* row)
{
    int count = WIDTH * s->channels;
    memset(row, 0, (size_t)count * 2);
    for (int i = 0; i < count; i++) {
        unsigned value = s->samples[y * count + i];
        if (s->depth == 16) {
            row[2 * i] = (png_byte)(value >> 8);
            row[2 * i + 1] = (png_byte)value;
        } else {
            int bit = i * s->depth;
            row[bit / 8] = (png_byte)(row[bit / 8] | value << (8 - s->depth - bit % 8));
        }
    }
}

static void set_colours(const sketch* s, png_structp png, png_infop info)
{
    png_color palette[COLOURS];
    png_byte alpha[COLOURS];
    int colours = s->depth < 4 ? 1 << s->depth : COLOURS;
    for (int i = 0; i < colours; i++) {
        palette[i] = colour_of(i);
        alpha[i] = alpha_of(i);
    }
    png_color_16 single = {0, s->samples[0], s->samples[1], s->samples[2], s->samples[0]};
    int indexed = s->type == PNG_COLOR_TYPE_PALETTE;
    if (indexed) png_set_PLTE(png, info, palette, colours);
    if (s->transparent)
        png_set_tRNS(png, info, indexed ? alpha : NULL, indexed ? colours : 0, indexed ? NULL : &single);
}

static FILE* write_sketch(const sketch* s)
{
    png_byte rows[HEIGHT][WIDTH * 8];
    png_bytep pointers[HEIGHT];
    FILE* file = tmpfile();
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, WIDTH, HEIGHT, s->depth, s->type, s->interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    set_colours(s, png, info);
    png_write_info(png, info);
    for (int y = 0; y < HEIGHT; y++) {
        pack_row(s, y, rows[y]);
        pointers[y] = rows[y];
    }
    png_write_image(png, pointers);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    rewind(file);
    return file;
}

/* What pixel `i` is to be read as; returns the number of channels. */
static int expected_pixel(const sketch* s, int i, unsigned value[4])
{
    const uint16_t* in = s->samples + i * s->channels;
    unsigned full = s->depth == 16 ? 65535 : 255;
    int n = s->channels, same = 1;
    if (s->type == PNG_COLOR_TYPE_PALETTE) {
        png_color colour = colour_of(in[0]);
        value[0] = colour.red;
        value[1] = colour.green;
        value[2] = colour.blue;
        value[3] = alpha_of(in[0]);
        return s->transparent ? 4 : 3;
    }
    for (int c = 0; c < n; c++) {
        value[c] = s->depth == 16 ? in[c] : in[c] * 255u / ((1u << s->depth) - 1);
        same &= in[c] == s->samples[c];
    }
    if (s->transparent) value[n++] = same ? 0 : full;
    return n;
}

static unsigned value_at(const weft_image* image, int i, int c)
{
    size_t index = (size_t)i * image->channels + (size_t)c;
    if (image->format == WEFT_FORMAT_U8) return ((const unsigned char*)image->data)[index];
    uint16_t value;
    memcpy(&value, (const char*)image->data + 2 * index, 2);
    return value;
}

static void check_sketch(sketch* s)
{
    pngfile_reason why;
    weft_image image;
    fill(s);
    FILE* file = write_sketch(s);
    assert_int_equal(pngfile_read(file, &image, &why), 0);
    fclose(file);
    assert_int_equal(image.width, WIDTH);
    assert_int_equal(image.height, HEIGHT);
    assert_int_equal(image.format, s->depth == 16 ? WEFT_FORMAT_U16 : WEFT_FORMAT_U8);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        unsigned value[4];
        assert_int_equal(image.channels, expected_pixel(s, i, value));
        for (int c = 0; c < (int)image.channels; c++) assert_int_equal(value_at(&image, i, c), value[c]);
    }
    free(image.data);
}

static void test_every_kind(void** state)
{
    static const struct kind {
        int type, depth;
    } kinds[15] = {{0, 1}, {0, 2}, {0, 4}, {0, 8}, {0, 16}, {2, 8}, {2, 16}, {3, 1},
                   {3, 2}, {3, 4}, {3, 8}, {4, 8}, {4, 16}, {6, 8}, {6, 16}};
    (void)state;
    for (int k = 0; k < 15; k++)
        for (int variant = 0; variant < 4; variant++) {
            sketch s = {kinds[k].type, kinds[k].depth, variant & 1, variant >> 1, 0, {0}};
            if (s.transparent && (s.type & PNG_COLOR_MASK_ALPHA)) continue; /* the format forbids it */
            check_sketch(&s);
        }
}

static void test_opaque_alpha_is_left_out(void** state)
{
    (void)state;
    for (int depth = 8; depth <= 16; depth += 8)
        for (int type = 4; type <= 6; type += 2) {
            sketch s = {type, depth, 0, 0, 0, {0}};
            weft_image image;
            pngfile_reason why;
            fill(&s);
            for (int i = 0; i < WIDTH * HEIGHT; i++)
                s.samples[(i + 1) * s.channels - 1] = (uint16_t)(depth == 16 ? 65535 : 255);
            FILE* file = write_sketch(&s);
            assert_int_equal(pngfile_read(file, &image, &why), 0);
            fclose(file);
            assert_int_equal(image.channels, s.channels - 1);
            for (int i = 0; i < WIDTH * HEIGHT; i++)
                for (int c = 0; c < (int)image.channels; c++)
                    assert_int_equal(value_at(&image, i, c), s.samples[i * s.channels + c]);
            free(image.data);
        }
}

static size_t slurp(FILE* file, unsigned char* bytes, size_t room)
{
    size_t size = fread(bytes, 1, room, file);
    assert_true(size < room);
    fclose(file);
    return size;
}

/* Reads a file of these bytes. */
static int read_bytes(const unsigned char* bytes, size_t size, weft_image* image, pngfile_reason* why)
{
    FILE* file = tmpfile();
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    rewind(file);
    int answer = pngfile_read(file, image, why);
    fclose(file);
    return answer;
}

static void test_cut_and_damaged(void** state)
{
    unsigned char bytes[8192];
    weft_image image = {NULL, 0, 0, 0, 0, 0};
    pngfile_reason why;
    sketch s = {PNG_COLOR_TYPE_PALETTE, 4, 1, 1, 0, {0}};
    (void)state;
    fill(&s);
    size_t size = slurp(write_sketch(&s), bytes, sizeof bytes);
    for (size_t cut = 0; cut < size; cut++) {
        assert_int_not_equal(read_bytes(bytes, cut, &image, &why), 0);
        assert_true(why.text[0] != '\0');
        assert_null(image.data);
    }
    for (size_t bit = 0; bit < size * 8; bit++) {
        bytes[bit / 8] = (unsigned char)(bytes[bit / 8] ^ 1u << bit % 8);
        int bad = read_bytes(bytes, size, &image, &why);
        if (bad)
            assert_true(why.text[0] != '\0' && image.data == NULL);
        else
            assert_true(image.width == WIDTH && image.height == HEIGHT && image.data != NULL);
        free(image.data);
        image.data = NULL;
        bytes[bit / 8] = (unsigned char)(bytes[bit / 8] ^ 1u << bit % 8);
    }
}

static void write_and_read(uint32_t channels, weft_format format)
{
    uint16_t pixels[SAMPLES];
    size_t value = format == WEFT_FORMAT_U16 ? 2 : 1, stride = WIDTH * channels * value;
    pngfile_writer* writer = NULL;
    pngfile_reason why;
    weft_image image;
    FILE* file = tmpfile();
    for (int i = 0; i < SAMPLES; i++) pixels[i] = (uint16_t)draw(65536);
    assert_int_equal(pngfile_begin(file, WIDTH, HEIGHT, channels, format, &writer, &why), 0);
    assert_int_equal(pngfile_rows(writer, pixels, stride, 5, &why), 0);
    assert_int_equal(pngfile_rows(writer, (const char*)pixels + 5 * stride, stride, HEIGHT - 5, &why), 0);
    assert_int_not_equal(pngfile_rows(writer, pixels, stride, 1, &why), 0);
    assert_int_equal(pngfile_end(writer, &why), 0);
    rewind(file);
    assert_int_equal(pngfile_read(file, &image, &why), 0);
    fclose(file);
    assert_int_equal(image.channels, channels);
    assert_int_equal(image.format, format);
    assert_memory_equal(image.data, pixels, stride * HEIGHT);
    free(image.data);
}

static void test_written_is_read(void** state)
{
    (void)state;
    for (uint32_t channels = 1; channels <= 4; channels++) {
        write_and_read(channels, WEFT_FORMAT_U8);
        write_and_read(channels, WEFT_FORMAT_U16);
    }
}

static void test_writing_refuses(void** state)
{
    static const unsigned char pixels[200000];
    pngfile_writer* writer = NULL;
    pngfile_reason why;
    (void)state;
    FILE* file = tmpfile();
    assert_int_not_equal(pngfile_begin(file, 4, 4, 5, WEFT_FORMAT_U8, &writer, &why), 0);
    assert_int_not_equal(pngfile_begin(file, 4, 4, 3, WEFT_FORMAT_F32, &writer, &why), 0);
    assert_int_not_equal(pngfile_begin(file, 0, 4, 3, WEFT_FORMAT_U8, &writer, &why), 0);
    assert_int_not_equal(pngfile_begin(file, 70000, 4, 3, WEFT_FORMAT_U8, &writer, &why), 0);
    assert_null(writer);
    assert_int_equal(pngfile_begin(file, 4, 4, 3, WEFT_FORMAT_U8, &writer, &why), 0);
    assert_int_equal(pngfile_rows(writer, pixels, 12, 3, &why), 0);
    assert_int_not_equal(pngfile_end(writer, &why), 0); /* a row is missing */
    fclose(file);
    file = fopen("/dev/null", "rb"); /* every write to it fails */
    assert_non_null(file);
    setvbuf(file, NULL, _IONBF, 0);
    assert_int_not_equal(pngfile_begin(file, 4, 4, 3, WEFT_FORMAT_U8, &writer, &why), 0);
    assert_true(why.text[0] != '\0');
    fclose(file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_kind),      cmocka_unit_test(test_opaque_alpha_is_left_out),
        cmocka_unit_test(test_cut_and_damaged), cmocka_unit_test(test_written_is_read),
        cmocka_unit_test(test_writing_refuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
