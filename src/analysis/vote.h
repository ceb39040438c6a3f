/// A tile from its correspondence: each pixel is the mean of what the patches around it say.
#pragma once
#include "analysis/match_field.h"

namespace weft {

/// Fills `tile`, but for its margin. In integers: the same for any number of threads.
void vote(Core& core, const Match_field& field, const Lab_picture& exemplar, Lab_picture& tile,
          const Progress& progress);

} // namespace weft
