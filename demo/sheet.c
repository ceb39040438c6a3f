/* weft_sheet EXEMPLAR TEXTON OUTPUT SHEET: a picture of what libweft did. From left to right the exemplar and the texton,
 * each magnified by a whole number to fill its panel, a window of the output at the exemplar's scale, and 4x of its centre. */
#include <png.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { panel = 512, gap = 16, zoom = 4 };

typedef struct picture {
    uint32_t width, height;
    uint8_t *rgb;
} picture;

static int read_picture(const char *path, picture *out)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path)) {
        fprintf(stderr, "weft_sheet: %s: %s\n", path, image.message);
        return 0;
    }
    image.format = PNG_FORMAT_RGB;
    out->width = image.width;
    out->height = image.height;
    out->rgb = malloc(PNG_IMAGE_SIZE(image));
    const png_color white = { 255, 255, 255 };
    if (!out->rgb || !png_image_finish_read(&image, &white, out->rgb, 0, NULL)) {
        fprintf(stderr, "weft_sheet: %s: %s\n", path, out->rgb ? image.message : "out of memory");
        png_image_free(&image);
        return 0;
    }
    return 1;
}

/* Copies the middle of `from`, each pixel `scale` by `scale` times, into the middle of the panel at column `left`. */
static void place(picture *sheet, uint32_t left, uint32_t width, const picture *from, uint32_t scale)
{
    const uint32_t columns = from->width * scale < width ? from->width * scale : width;
    const uint32_t rows = from->height * scale < panel ? from->height * scale : panel;
    const uint32_t from_x = (from->width - columns / scale) / 2, from_y = (from->height - rows / scale) / 2;
    const uint32_t to_x = left + (width - columns) / 2, to_y = gap + (panel - rows) / 2;
    for (uint32_t y = 0; y < rows; ++y)
        for (uint32_t x = 0; x < columns; ++x) {
            const size_t source = ((size_t)(from_y + y / scale) * from->width + from_x + x / scale) * 3;
            memcpy(sheet->rgb + ((size_t)(to_y + y) * sheet->width + to_x + x) * 3, from->rgb + source, 3);
        }
}

static uint32_t fitting_scale(const picture *p)
{
    const uint32_t longer = p->width > p->height ? p->width : p->height;
    return longer < panel ? panel / longer : 1;
}

static int write_picture(const char *path, const picture *p)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = p->width;
    image.height = p->height;
    image.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&image, path, 0, p->rgb, 0, NULL)) return 1;
    fprintf(stderr, "weft_sheet: %s: %s\n", path, image.message);
    return 0;
}

int main(int count, char **arguments)
{
    picture exemplar, texton, output, sheet;
    if (count != 5) {
        fprintf(stderr, "usage: weft_sheet EXEMPLAR TEXTON OUTPUT SHEET\n");
        return 2;
    }
    if (!read_picture(arguments[1], &exemplar) || !read_picture(arguments[2], &texton) || !read_picture(arguments[3], &output)) return 1;
    sheet.width = 5 * panel + 5 * gap;
    sheet.height = panel + 2 * gap;
    sheet.rgb = malloc((size_t)sheet.width * sheet.height * 3);
    if (!sheet.rgb) return 1;
    memset(sheet.rgb, 255, (size_t)sheet.width * sheet.height * 3);
    const uint32_t scale = fitting_scale(&exemplar);
    place(&sheet, gap, panel, &exemplar, scale);
    place(&sheet, 2 * gap + panel, panel, &texton, fitting_scale(&texton));
    place(&sheet, 3 * gap + 2 * panel, 2 * panel, &output, scale);
    place(&sheet, 4 * gap + 4 * panel, panel, &output, scale * zoom);
    return write_picture(arguments[4], &sheet) ? 0 : 1;
}
