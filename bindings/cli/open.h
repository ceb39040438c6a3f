/* What commands work on: a context, photographs, models. Each function answers with an exit code and has said what
 * failed. */
#ifndef WEFT_CLI_OPEN_H
#define WEFT_CLI_OPEN_H

#include "options.h"

#include <weft/weft.h>

int open_context(const arguments* common, weft_context** context);

/* One photograph, or the channels of several of one size one after the other. The caller frees image->data. */
int open_photos(const char* const* paths, int count, weft_image* image);

/* The same, and how many channels each has: `count` numbers. */
int open_maps(const char* const* paths, int count, weft_image* image, uint32_t* groups);

/* The bytes that the model was loaded from are counted by weft_model_info. */
int open_model(weft_context* context, const char* path, weft_model** model, weft_model_info* info);

int save_model(const weft_model* model, const char* path);

const char* method_name(weft_method method);

/* " of W x H" of models that have a size, else nothing; answers with `text`. */
enum { MODEL_SIZE_ROOM = 32 };
const char* model_size(const weft_model_info* info, char text[MODEL_SIZE_ROOM]);

/* The order of the B-spline, 0, 1, 3 or 5; -1 for none. */
int interpolation_order(weft_interpolation interpolation);

#endif
