/// One pass of the texton's projections over all frequencies, for coefficients that live on a small support.
#pragma once
#include "analysis/spectra.h"
#include "analysis/spline.h"

namespace weft {

/// What a model error is made of: sums over all frequencies.
struct ModelSums {
    double agreement = 0; ///< |T*a^| with T = sqrt(b^) t^
    double power = 0;     ///< b^ |a^|^2
};

/// Only the support's rows are transformed along x, and each block of columns goes through the cache once: forward
/// transform, projection and backward transform happen there, so that no spectrum of the coefficients is ever whole.
class Projection {
public:
    enum Form {
        algorithm_1,   ///< IDFT(T s / b^): the coefficients that Algorithm 1 of the paper makes of others
        least_squares, ///< IDFT(T s - b^ a^): half the negative gradient of the squared model error for the phases s
    };

    /// `target` is T; it must outlive this. The support is at most its shorter side.
    Projection(Core& core, const Spectra& target, const SplineSamples& samples, std::uint32_t support);

    /// `result` <- what Algorithm 1 makes of white noise over the whole of Omega, cut to the support.
    void start(std::uint64_t seed, Planes& result);
    /// `result` <- the form's value cut to the support. s = T*a^ / sqrt(|T*a^|^2 + smoothing^2), a phase when smoothing
    /// is 0.
    void apply(Form form, float smoothing, const Planes& coefficients, Planes& result);
    ModelSums measure(const Planes& coefficients);

private:
    template <class Body> void for_each_block(const Body& body);
    void rows_forward(const Planes& coefficients);
    void rows_backward(Planes& result);
    void columns_forward(std::uint32_t b, Complex* block) const;
    void columns_backward(std::uint32_t b, Complex* block);

    Core& core_;
    const Spectra& target_;
    std::uint32_t support_, runs_;
    RowTransform rows_;
    ColumnTransform columns_;
    Array<float> b_x_, b_y_; ///< b^ along each axis; b_x_ in whole blocks
    Array<Complex> half_;    ///< the support's rows, transformed along x: [block][channel][row][lane]
    Array<Complex> scratch_; ///< one block of all channels for every run
};

} // namespace weft
