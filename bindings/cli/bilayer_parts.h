/* Parts of models as values, and what of bi-layer models is made for the eye. */
#ifndef WEFT_CLI_BILAYER_PARTS_H
#define WEFT_CLI_BILAYER_PARTS_H

#include <weft/weft.h>

/* All values of a part, F32; the caller frees image->data, also after failures. */
int read_part(const weft_model* model, uint32_t index, weft_part_info* part, weft_image* image);

/* The index of the part of that name; weft_model_info.parts if there is none. */
uint32_t find_part(const weft_model* model, const weft_model_info* info, const char* name);

/* Whether a part is a texton of a bi-layer model, which has a spectrum. */
int has_spectrum(const weft_model_info* info, const weft_part_info* part);

/* A texton's power spectrum, channel by channel: log10 of its power, six decades of it; frequency 0 in the middle.
 * `part` becomes the spectrum's, its name "spectrum 0" for "texton 0". */
int spectrum_of(const weft_image* texton, weft_part_info* part, weft_image* spectrum);

/* Patches' numbers as colours, U8. */
int colours_of(const weft_image* patches, weft_image* colours);

#endif
