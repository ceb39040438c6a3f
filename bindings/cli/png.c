/* PNG reading and writing. Every call into libpng that may fail lies under a setjmp in the same function; what must
 * survive the jump lives in a struct, never in a local variable. */
#include "png.h"

#include <png.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SIDE = 65536 };

static void on_error(png_structp png, png_const_charp sentence)
{
    pngfile_reason* why = png_get_error_ptr(png);
    snprintf(why->text, sizeof why->text, "%s", sentence);
    png_longjmp(png, 1);
}

/* Warnings concern chunks that are not used here. */
static void on_warning(png_structp png, png_const_charp sentence)
{
    (void)png;
    (void)sentence;
}

static int refuse(pngfile_reason* why, const char* sentence)
{
    snprintf(why->text, sizeof why->text, "%s", sentence);
    return -1;
}

static int is_little_endian(void)
{
    const uint16_t one = 1;
    unsigned char first;
    memcpy(&first, &one, 1);
    return first == 1;
}

typedef struct reading {
    png_structp png;
    png_infop info;
    unsigned char* pixels;
    png_bytep* rows;
} reading;

/* Asks libpng for grey, grey + alpha, RGB or RGBA of 8 or 16 bits, whatever the file holds. */
static void set_transformations(reading* r)
{
    png_byte type = png_get_color_type(r->png, r->info);
    if (type == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(r->png);
    if (type == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(r->png);
    if (png_get_valid(r->png, r->info, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(r->png);
    if (png_get_bit_depth(r->png, r->info) == 16 && is_little_endian()) png_set_swap(r->png);
    png_set_interlace_handling(r->png);
    png_read_update_info(r->png, r->info);
}

static int allocate(reading* r, weft_image* image, pngfile_reason* why)
{
    image->width = png_get_image_width(r->png, r->info);
    image->height = png_get_image_height(r->png, r->info);
    image->channels = png_get_channels(r->png, r->info);
    image->format = png_get_bit_depth(r->png, r->info) == 16 ? WEFT_FORMAT_U16 : WEFT_FORMAT_U8;
    size_t row = png_get_rowbytes(r->png, r->info);
    if (row > SIZE_MAX / image->height) return refuse(why, "the image is too large for this machine");
    r->pixels = malloc(row * image->height);
    r->rows = malloc(sizeof *r->rows * image->height);
    if (!r->pixels || !r->rows) return refuse(why, "out of memory");
    for (uint32_t y = 0; y < image->height; y++) r->rows[y] = r->pixels + row * y;
    image->stride = (int64_t)row;
    image->data = r->pixels;
    return 0;
}

/* The part that libpng may leave by a jump. */
static int read_pixels(reading* r, FILE* file, weft_image* image, pngfile_reason* why)
{
    if (setjmp(png_jmpbuf(r->png))) return -1;
    png_set_user_limits(r->png, MOST_SIDE, MOST_SIDE);
    png_set_chunk_malloc_max(r->png, 1 << 24);
    png_init_io(r->png, file);
    png_read_info(r->png, r->info);
    set_transformations(r);
    if (allocate(r, image, why) != 0) return -1;
    png_read_image(r->png, r->rows);
    png_read_end(r->png, NULL);
    return 0;
}

static int is_opaque(const weft_image* image)
{
    size_t value = image->format == WEFT_FORMAT_U16 ? 2 : 1;
    size_t pixel = value * image->channels;
    for (uint32_t y = 0; y < image->height; y++) {
        const unsigned char* alpha = (const unsigned char*)image->data + (size_t)image->stride * y + pixel - value;
        for (uint32_t x = 0; x < image->width; x++, alpha += pixel)
            if (alpha[0] != 0xff || alpha[value - 1] != 0xff) return 0;
    }
    return 1;
}

/* Closes up the pixels over their last channel. */
static void drop_last_channel(weft_image* image)
{
    size_t value = image->format == WEFT_FORMAT_U16 ? 2 : 1;
    size_t from = value * image->channels, to = from - value;
    unsigned char* target = image->data;
    for (uint32_t y = 0; y < image->height; y++) {
        const unsigned char* source = (const unsigned char*)image->data + (size_t)image->stride * y;
        for (uint32_t x = 0; x < image->width; x++, source += from, target += to) memmove(target, source, to);
    }
    image->channels--;
    image->stride = (int64_t)(to * image->width);
}

int pngfile_read(FILE* file, weft_image* image, pngfile_reason* why)
{
    reading r = {NULL, NULL, NULL, NULL};
    weft_image result = {NULL, 0, 0, 0, 0, 0};
    why->text[0] = '\0';
    r.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, why, on_error, on_warning);
    if (r.png) r.info = png_create_info_struct(r.png);
    int bad = r.info ? read_pixels(&r, file, &result, why) : refuse(why, "out of memory");
    if (bad && feof(file)) refuse(why, "the file ends before the image does");
    png_destroy_read_struct(&r.png, &r.info, NULL);
    free(r.rows);
    if (bad) {
        free(r.pixels);
        return -1;
    }
    if (result.channels % 2 == 0 && is_opaque(&result)) drop_last_channel(&result);
    *image = result;
    return 0;
}

struct pngfile_writer {
    png_structp png;
    png_infop info;
    uint32_t rows_left;
    pngfile_reason reason;
};

static int write_header(pngfile_writer* w, FILE* file, uint32_t width, uint32_t height, uint32_t channels,
                        weft_format format)
{
    static const int types[4] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                 PNG_COLOR_TYPE_RGB_ALPHA};
    int depth = format == WEFT_FORMAT_U16 ? 16 : 8;
    if (setjmp(png_jmpbuf(w->png))) return -1;
    png_set_user_limits(w->png, MOST_SIDE, MOST_SIDE);
    png_init_io(w->png, file);
    png_set_IHDR(w->png, w->info, width, height, depth, types[channels - 1], PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(w->png, 1); /* noise gains nothing from more, and takes twice as long */
    png_set_filter(w->png, PNG_FILTER_TYPE_DEFAULT, PNG_FILTER_SUB | PNG_FILTER_UP);
    png_write_info(w->png, w->info);
    if (depth == 16 && is_little_endian()) png_set_swap(w->png);
    return 0;
}

int pngfile_begin(FILE* file, uint32_t width, uint32_t height, uint32_t channels, weft_format format,
                  pngfile_writer** writer, pngfile_reason* why)
{
    if (channels < 1 || channels > 4) return refuse(why, "a PNG has 1 to 4 channels");
    if (format != WEFT_FORMAT_U8 && format != WEFT_FORMAT_U16) return refuse(why, "a PNG has 8 or 16 bits");
    pngfile_writer* w = calloc(1, sizeof *w);
    if (!w) return refuse(why, "out of memory");
    w->rows_left = height;
    w->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &w->reason, on_error, on_warning);
    if (w->png) w->info = png_create_info_struct(w->png);
    int bad = w->info ? write_header(w, file, width, height, channels, format) : refuse(&w->reason, "out of memory");
    if (bad) {
        pngfile_reason incomplete;
        *why = w->reason;
        w->rows_left = 1; /* nothing to complete */
        pngfile_end(w, &incomplete);
        return -1;
    }
    *writer = w;
    return 0;
}

static int write_rows(pngfile_writer* w, const unsigned char* rows, size_t stride, uint32_t count)
{
    if (setjmp(png_jmpbuf(w->png))) return -1;
    for (uint32_t y = 0; y < count; y++) png_write_row(w->png, rows + stride * y);
    return 0;
}

int pngfile_rows(pngfile_writer* writer, const void* rows, size_t stride, uint32_t count, pngfile_reason* why)
{
    if (count > writer->rows_left) return refuse(why, "more rows than the PNG has");
    if (write_rows(writer, rows, stride, count) != 0) {
        *why = writer->reason;
        return -1;
    }
    writer->rows_left -= count;
    return 0;
}

static int write_end(pngfile_writer* w)
{
    if (setjmp(png_jmpbuf(w->png))) return -1;
    png_write_end(w->png, w->info);
    return 0;
}

int pngfile_end(pngfile_writer* writer, pngfile_reason* why)
{
    int bad = writer->rows_left > 0 ? refuse(&writer->reason, "the PNG is not complete") : write_end(writer);
    png_destroy_write_struct(&writer->png, &writer->info);
    pngfile_reason reason = writer->reason;
    free(writer);
    if (bad) *why = reason;
    return bad;
}
