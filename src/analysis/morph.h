/// Between two wavelet noise models.
#pragma once
#include "model/model.h"

namespace weft {

/// The model at t within 0..1 between a (0) and b (1): every parameter linear, the axes by the shortest rotation
/// (rotation.h).
/// - An axis and its noise, negated, are the same texture, and so are axes in another order: those of b are taken that
/// are
///   closest to a's. At t = 1 the result is b itself, in its own order: the same texture, but another sample of it
///   where order or signs differ.
/// - A band that one model lacks has weight 0 there; tone curves get the same number of knots, which changes no curve;
/// none is a
///   straight line.
/// Throws WEFT_ERROR_ARGUMENT unless both are wavelet noise of as many channels.
Model morph_wavelets(const Model& a, const Model& b, float t);

} // namespace weft
