/* The parameters of wavelet noise as JSON, to be read, edited and written by people and programs. */
#ifndef WEFT_CLI_WAVELET_JSON_H
#define WEFT_CLI_WAVELET_JSON_H

#include "json.h"

#include <weft/weft.h>

/* The parameters of a model of wavelet noise; an exit code. */
int get_wavelet(const weft_model* model, weft_wavelet* wavelet);

/* An object, as weft.h has the fields but axis by axis: "mean", "axes" [axis][channel], "weights" [axis][band], "tone"
 * with x, y and slope of the knots of each axis, empty without tone curves. */
void json_wavelet(json* out, const char* key, const weft_wavelet* wavelet);

/* Reads such an object. `path` is for what is said about errors; an exit code. What the numbers may be is the library's
 * to say. */
int read_wavelet(const char* path, const char* text, size_t size, weft_wavelet* wavelet);

#endif
