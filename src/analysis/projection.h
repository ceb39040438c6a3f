/// One pass of the texton's projections over all frequencies, for coefficients that live on a small support.
#pragma once
#include "analysis/matrix.h"
#include "analysis/spectra.h"
#include "analysis/spline.h"

namespace weft {

/// What the model error and the colour correction are made of, in the norm of b^.
struct ModelSums {
    double agreement = 0; ///< sum of |T*a^| over all frequencies, T = sqrt(b^) t^
    double power = 0;     ///< sum of b^ |a^|^2
};

/// Only the support's rows are transformed along x, and each block of columns goes through the cache once: forward
/// transform, projection and backward transform happen there, so that no spectrum of the coefficients is ever whole.
class Projection {
public:
    /// The support step of the least-squares form subtracts b^ a^, that of Algorithm 1 nothing.
    enum Form { algorithm_1, least_squares };

    /// `target` is T = sqrt(b^) t^; it must outlive this.
    Projection(Core& core, const Spectra& target, const SplineSamples& samples, std::uint32_t support, Form form);

    /// `result` <- the support's part of the projection of white noise over the whole of Omega.
    void start(std::uint64_t seed, Planes& result);
    /// `result` <- the support's part of IDFT(u T s - v a^), s = T*a^ / |T*a^|: u = 1 / b^ and v = 0 in the form of
    /// Algorithm 1; u = 1 and v = b^ in least squares, half the negative gradient of the squared model error.
    ModelSums apply(const Planes& coefficients, Planes& result);
    ModelSums measure(const Planes& coefficients);
    /// Covariance of the noise that the coefficients make, channel by channel.
    Matrix covariance(const Planes& coefficients);

private:
    struct Block;
    template <class Fill, class Use> void for_each_block(const Fill& fill, const Use& use);
    void rows_forward(const Planes& coefficients);
    void rows_backward(Planes& result);
    ModelSums project(std::uint32_t b, Complex* block, bool write) const;

    Core& core_;
    const Spectra& target_;
    std::uint32_t support_;
    Form form_;
    RowTransform rows_;
    ColumnTransform columns_;
    Array<float> b_x_, b_y_;  ///< b^ along each axis; b_x_ padded to whole blocks
    Array<Complex> half_;     ///< the support's rows, transformed along x: [block][channel][row][lane]
    Array<Complex> scratch_;  ///< one block of all channels for every run
    std::uint32_t runs_;
};

} // namespace weft
