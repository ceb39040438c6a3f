/* The PNG files of one picture: all its channels in one file, or groups of them, its maps, in one file each. */
#ifndef WEFT_CLI_MAPS_H
#define WEFT_CLI_MAPS_H

#include "file.h"
#include "png.h"

#include <weft/weft.h>

typedef struct map_file {
    output_file file;
    pngfile_writer* writer;
    uint32_t first, channels; /* of the picture's */
    uint32_t number;          /* from 1 on */
} map_file;

typedef struct map_files {
    map_file map[16];
    int count;
    uint32_t width, channels;
    size_t value;        /* bytes */
    unsigned char* rows; /* one map's rows, when there are several maps */
    size_t rows_size;
} map_files;

/* Opens a file per count of channels in `groups`; they sum up to image->channels. With several, the %d in `path` is the
 * map's number. `image` gives width, channels, format and the height of the whole picture. */
int maps_open(map_files* maps, const char* path, const uint32_t* groups, int count, const weft_image* image);

/* Appends image->height rows of all channels. */
int maps_rows(map_files* maps, const weft_image* image);

/* Puts the complete files in their places. */
int maps_commit(map_files* maps);

/* The whole at once: opens, writes all rows and commits. */
int maps_write(const char* path, const weft_image* image, const uint32_t* groups, int count);

/* Leaves no file that maps_commit has not put in its place. Does nothing on zeros. */
void maps_discard(map_files* maps);

#endif
