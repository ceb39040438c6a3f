/* Writing a picture's maps side by side, row by row. */
#include "maps.h"
#include "command.h"
#include "report.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* The path with its first %d made the number; the caller frees it. */
static char* numbered(const char* path, uint32_t number)
{
    const char* place = strstr(path, "%d");
    size_t room = strlen(path) + 12;
    char* result = malloc(room);
    if (result && place)
        snprintf(result, room, "%.*s%u%s", (int)(place - path), path, number, place + 2);
    else if (result)
        snprintf(result, room, "%s", path);
    return result;
}

static int failed_png(const map_file* map, const pngfile_reason* why)
{
    int wrong = ferror(map->file.file);
    return failed("%s: %s", map->file.path, wrong && errno ? strerror(errno) : why->text);
}

static int open_map(map_file* map, const char* path, const weft_image* image)
{
    pngfile_reason why;
    int code = output_open(&map->file, path);
    if (code != EXIT_FINE) return code;
    if (pngfile_begin(map->file.file, image->width, image->height, map->channels, image->format, &map->writer, &why) !=
        0)
        return failed_png(map, &why);
    return EXIT_FINE;
}

int maps_open(map_files* maps, const char* path, const uint32_t* groups, int count, const weft_image* image)
{
    uint32_t first = 0;
    memset(maps, 0, sizeof *maps);
    maps->width = image->width;
    maps->channels = image->channels;
    maps->value = image->format == WEFT_FORMAT_U16 ? 2 : 1;
    for (int i = 0; i < count; i++) {
        map_file* map = &maps->map[maps->count++];
        map->number = (uint32_t)i + 1;
        map->first = first;
        map->channels = groups[i];
        first += groups[i];
        char* name = count > 1 ? numbered(path, map->number) : strdup(path);
        if (!name) return failed("out of memory");
        int code = open_map(map, name, image);
        map->file.path = path;
        free(name);
        if (code != EXIT_FINE) return code;
    }
    return EXIT_FINE;
}

/* Gathers one map's channels of some rows. */
static void copy_map(const map_files* maps, const map_file* map, const weft_image* image)
{
    size_t from = maps->value * maps->channels, to = maps->value * map->channels;
    unsigned char* target = maps->rows;
    for (uint32_t y = 0; y < image->height; y++) {
        const unsigned char* source =
            (const unsigned char*)image->data + (size_t)image->stride * y + maps->value * map->first;
        for (uint32_t x = 0; x < image->width; x++, source += from, target += to) memcpy(target, source, to);
    }
}

static int reserve_rows(map_files* maps, const weft_image* image)
{
    size_t size = maps->value * 4 * image->width * image->height;
    if (maps->count == 1 || size <= maps->rows_size) return EXIT_FINE;
    free(maps->rows);
    maps->rows = malloc(size);
    maps->rows_size = maps->rows ? size : 0;
    return maps->rows ? EXIT_FINE : failed("out of memory");
}

int maps_rows(map_files* maps, const weft_image* image)
{
    pngfile_reason why;
    int code = reserve_rows(maps, image);
    if (code != EXIT_FINE) return code;
    for (int i = 0; i < maps->count; i++) {
        map_file* map = &maps->map[i];
        const void* rows = image->data;
        size_t stride = (size_t)image->stride;
        if (maps->count > 1) {
            copy_map(maps, map, image);
            rows = maps->rows;
            stride = maps->value * map->channels * image->width;
        }
        errno = 0;
        if (pngfile_rows(map->writer, rows, stride, image->height, &why) != 0) return failed_png(map, &why);
    }
    return EXIT_FINE;
}

int maps_commit(map_files* maps)
{
    pngfile_reason why;
    for (int i = 0; i < maps->count; i++) {
        map_file* map = &maps->map[i];
        pngfile_writer* writer = map->writer;
        map->writer = NULL;
        errno = 0;
        if (pngfile_end(writer, &why) != 0) return failed_png(map, &why);
        if (fflush(map->file.file) != 0) return failed("%s: %s", map->file.path, strerror(errno));
    }
    for (int i = 0; i < maps->count; i++) {
        int code = output_commit(&maps->map[i].file);
        if (code != EXIT_FINE) return code;
    }
    maps_discard(maps);
    return EXIT_FINE;
}

int maps_write(const char* path, const weft_image* image, const uint32_t* groups, int count)
{
    map_files maps;
    int code = maps_open(&maps, path, groups, count, image);
    if (code == EXIT_FINE) code = maps_rows(&maps, image);
    if (code == EXIT_FINE) code = maps_commit(&maps);
    maps_discard(&maps);
    return code;
}

void maps_discard(map_files* maps)
{
    pngfile_reason why;
    for (int i = 0; i < maps->count; i++) {
        if (maps->map[i].writer) pngfile_end(maps->map[i].writer, &why); /* incomplete: nothing is written */
        output_discard(&maps->map[i].file);
    }
    free(maps->rows);
    memset(maps, 0, sizeof *maps);
}
