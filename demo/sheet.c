/* weft_sheet SHEET {EXEMPLAR TEXTON OUTPUT}...: a picture of what libweft did, a row for each exemplar. From left to
 * right the exemplar and the texton, magnified by a whole number to fill their panels, a window of the output at the
 * exemplar's scale, and 4x of its centre. */
#include <png.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { panel = 512, gap = 16, zoom = 4 };

typedef struct picture {
    uint32_t width, height;
    uint8_t* rgb;
} picture;

static int read_picture(const char* path, picture* out)
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
    const png_color white = {255, 255, 255};
    if (!out->rgb || !png_image_finish_read(&image, &white, out->rgb, 0, NULL)) {
        fprintf(stderr, "weft_sheet: %s: %s\n", path, out->rgb ? image.message : "out of memory");
        png_image_free(&image);
        return 0;
    }
    return 1;
}

/* Copies the middle of `from`, each pixel `scale` by `scale` times, into the middle of the panel at (left, top). */
static void place(picture* sheet, uint32_t left, uint32_t top, uint32_t width, const picture* from, uint32_t scale)
{
    const uint32_t columns = from->width * scale < width ? from->width * scale : width;
    const uint32_t rows = from->height * scale < panel ? from->height * scale : panel;
    const uint32_t from_x = (from->width - columns / scale) / 2, from_y = (from->height - rows / scale) / 2;
    const uint32_t to_x = left + (width - columns) / 2, to_y = top + (panel - rows) / 2;
    for (uint32_t y = 0; y < rows; ++y)
        for (uint32_t x = 0; x < columns; ++x) {
            const size_t source = ((size_t)(from_y + y / scale) * from->width + from_x + x / scale) * 3;
            memcpy(sheet->rgb + ((size_t)(to_y + y) * sheet->width + to_x + x) * 3, from->rgb + source, 3);
        }
}

static uint32_t fitting_scale(const picture* p)
{
    const uint32_t longer = p->width > p->height ? p->width : p->height;
    return longer < panel ? panel / longer : 1;
}

static int write_picture(const char* path, const picture* p)
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

static int place_row(picture* sheet, uint32_t top, char** paths)
{
    picture exemplar, texton, output;
    if (!read_picture(paths[0], &exemplar) || !read_picture(paths[1], &texton) || !read_picture(paths[2], &output))
        return 0;
    const uint32_t scale = fitting_scale(&exemplar);
    place(sheet, gap, top, panel, &exemplar, scale);
    place(sheet, 2 * gap + panel, top, panel, &texton, fitting_scale(&texton));
    place(sheet, 3 * gap + 2 * panel, top, 2 * panel, &output, scale);
    place(sheet, 4 * gap + 4 * panel, top, panel, &output, scale * zoom);
    free(exemplar.rgb);
    free(texton.rgb);
    free(output.rgb);
    return 1;
}

int main(int count, char** arguments)
{
    picture sheet;
    const uint32_t rows = count > 2 ? (uint32_t)(count - 2) / 3 : 0;
    if (rows == 0 || (uint32_t)count != 2 + 3 * rows) {
        fprintf(stderr, "usage: weft_sheet SHEET {EXEMPLAR TEXTON OUTPUT}...\n");
        return 2;
    }
    sheet.width = 5 * panel + 5 * gap;
    sheet.height = rows * (panel + gap) + gap;
    sheet.rgb = malloc((size_t)sheet.width * sheet.height * 3);
    if (!sheet.rgb) return 1;
    memset(sheet.rgb, 255, (size_t)sheet.width * sheet.height * 3);
    for (uint32_t i = 0; i < rows; ++i)
        if (!place_row(&sheet, gap + i * (panel + gap), arguments + 2 + 3 * i)) return 1;
    return write_picture(arguments[1], &sheet) ? 0 : 1;
}
