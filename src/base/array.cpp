/// The one thing about arrays that is no template: their refusal.
#include "base/array.h"
#include "base/error.h"

namespace weft {

void fail_array_size() { throw Error(WEFT_ERROR_MEMORY, "an array of more than 2^62 bytes is needed"); }

} // namespace weft
