/* What a photo is like, shared by `describe` and `analyze --method auto`. */
#ifndef WEFT_CLI_DESCRIBE_H
#define WEFT_CLI_DESCRIBE_H

#include "progress.h"

#include <weft/weft.h>

/* Describes the photo, with a bar over `span`; an exit code. */
int describe_photo(weft_context* context, const weft_image* photo, progress_span* span, weft_description* description);

#endif
