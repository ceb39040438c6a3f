/* A map put together as a model's tile was, shared by `apply` and `tile`. */
#ifndef WEFT_CLI_APPLY_H
#define WEFT_CLI_APPLY_H

#include <weft/weft.h>

/* In the map's channels and format. The caller frees tile->data. An exit code. */
int apply_model(const weft_model* model, const weft_image* map, weft_image* tile);

#endif
