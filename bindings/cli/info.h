/* A model's description as JSON, shared by `info` and `export`. */
#ifndef WEFT_CLI_INFO_H
#define WEFT_CLI_INFO_H

#include "json.h"

#include <weft/weft.h>

/* The members that describe the model, into the object that is open. */
void json_model(json* out, const weft_model_info* info);

/* The members that describe a part. */
void json_part(json* out, const weft_part_info* part);

#endif
