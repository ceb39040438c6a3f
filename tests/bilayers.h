/* Small bi-layer models of every kind, for the tests that look at models and textures. */
#ifndef WEFT_TESTS_BILAYERS_H
#define WEFT_TESTS_BILAYERS_H

#include "support.h"

/* Discs on a ground, each with a noise of its own; values around 0.5. */
weft_image new_discs(uint32_t width, uint32_t height, uint32_t channels, uint64_t seed);

/* Kinds of models: what they are made of, and of what photo. */
#define BILAYER_KINDS 8
const char *bilayer_kind(uint32_t kind);
weft_bilayer_options bilayer_options(uint32_t kind);
weft_model *new_bilayer(weft_context *context, uint32_t kind);

/* The index of the part of that name; fails where there is none. */
uint32_t part_named(const weft_model *model, const char *name);

#endif
