/// Brings two models to one order of axes, as many bands and as many knots; the rest is linear.
#include "analysis/morph.h"
#include "analysis/rotation.h"
#include "base/error.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_model_mix";
constexpr double straight_reach = 6; // of the line that stands for no tone curve, in standard deviations of the noise

struct Knot {
    double x, y, slope;
};

struct Curve {
    std::uint32_t count = 0;
    Knot knot[most_knots];
};

Curve curve_of(const Wavelet& wavelet, std::uint32_t axis) noexcept
{
    Curve curve;
    curve.count = wavelet.knots;
    for (std::uint32_t k = 0; k < curve.count; ++k)
        curve.knot[k] = {static_cast<double>(wavelet.knot_x[k][axis]), static_cast<double>(wavelet.knot_y[k][axis]),
                         static_cast<double>(wavelet.knot_slope[k][axis])};
    if (curve.count > 0) return curve;
    double power = 0;
    for (std::uint32_t b = 0; b < wavelet.bands; ++b)
        power += std::pow(static_cast<double>(wavelet.weight[b][axis]), 2);
    const double reach = power > 0 ? straight_reach * std::sqrt(power) : 1;
    curve.count = 2;
    curve.knot[0] = {-reach, -reach, 1};
    curve.knot[1] = {reach, reach, 1};
    return curve;
}

/// The curve of the negated axis and noise.
void negate(Curve& curve) noexcept
{
    std::reverse(curve.knot, curve.knot + curve.count);
    for (std::uint32_t k = 0; k < curve.count; ++k) {
        curve.knot[k].x = -curve.knot[k].x;
        curve.knot[k].y = -curve.knot[k].y;
    }
}

/// Knots in the middle of the widest gaps, on the curve; where that is not monotone, as near as a model's rules allow.
void refine(Curve& curve, std::uint32_t count) noexcept
{
    for (; curve.count < count; ++curve.count) {
        std::uint32_t widest = 0;
        for (std::uint32_t k = 1; k + 1 < curve.count; ++k)
            if (curve.knot[k + 1].x - curve.knot[k].x > curve.knot[widest + 1].x - curve.knot[widest].x) widest = k;
        const Knot left = curve.knot[widest], right = curve.knot[widest + 1];
        const double width = right.x - left.x;
        const double y = 0.5 * (left.y + right.y) + width / 8 * (left.slope - right.slope);
        const double slope = 1.5 * (right.y - left.y) / width - 0.25 * (left.slope + right.slope);
        const Knot middle{0.5 * (left.x + right.x), std::clamp(y, left.y, right.y), std::max(slope, 0.0)};
        std::copy_backward(curve.knot + widest + 1, curve.knot + curve.count, curve.knot + curve.count + 1);
        curve.knot[widest + 1] = middle;
    }
}

Matrix axes_of(const Model& model) noexcept
{
    Matrix axes;
    axes.size = model.channels;
    for (std::uint32_t p = 0; p < axes.size; ++p)
        for (std::uint32_t o = 0; o < axes.size; ++o) axes[p][o] = static_cast<double>(model.wavelet.axes[p][o]);
    return axes;
}

class Line {
public:
    explicit Line(float t) noexcept : t_(static_cast<double>(t)) {}
    double t() const noexcept { return t_; }
    double between(double a, double b) const noexcept { return a + t_ * (b - a); }
    float operator()(float a, float b) const noexcept
    {
        return static_cast<float>(between(static_cast<double>(a), static_cast<double>(b)));
    }

private:
    double t_;
};

/// Axis p of the result from p of a and q of b.
void morph_axis(const Wavelet& a, const Wavelet& b, std::uint32_t p, std::uint32_t q, bool negated, const Line& line,
                Wavelet& result)
{
    for (std::uint32_t band = 0; band < result.bands; ++band)
        result.weight[band][p] =
            line(band < a.bands ? a.weight[band][p] : 0.0f, band < b.bands ? b.weight[band][q] : 0.0f);
    if (result.knots == 0) return;
    Curve from = curve_of(a, p), to = curve_of(b, q);
    if (negated) negate(to);
    refine(from, result.knots);
    refine(to, result.knots);
    for (std::uint32_t k = 0; k < result.knots; ++k) {
        result.knot_x[k][p] = static_cast<float>(line.between(from.knot[k].x, to.knot[k].x));
        result.knot_y[k][p] = static_cast<float>(line.between(from.knot[k].y, to.knot[k].y));
        result.knot_slope[k][p] =
            std::max(0.0f, static_cast<float>(line.between(from.knot[k].slope, to.knot[k].slope)));
    }
}

} // namespace

Model morph_wavelets(const Model& a, const Model& b, float t)
{
    require(a.method == WEFT_METHOD_WAVELET && b.method == WEFT_METHOD_WAVELET, function,
            ": the methods of the models are ", a.method, " and ", b.method, ", not both WEFT_METHOD_WAVELET");
    require(a.channels == b.channels, function, ": b has ", b.channels, " channels, a has ", a.channels);
    require(t >= 0 && t <= 1, function, ": t is ", t, ", not 0..1");
    Model model;
    model.method = a.method;
    model.channels = a.channels;
    if (t == 0 || t == 1) {
        model.mean = t == 0 ? a.mean : b.mean;
        model.wavelet = t == 0 ? a.wavelet : b.wavelet;
        return model;
    }
    const Line line(t);
    for (std::uint32_t o = 0; o < a.channels; ++o) model.mean[o] = line(a.mean[o], b.mean[o]);
    Wavelet& wavelet = model.wavelet;
    wavelet.bands = std::max(a.wavelet.bands, b.wavelet.bands);
    wavelet.knots = std::max(a.wavelet.knots, b.wavelet.knots);

    const Matrix from = axes_of(a), to = axes_of(b);
    const Axis_match match = match_axes(from, to);
    Matrix matched = to;
    for (std::uint32_t p = 0; p < to.size; ++p) {
        for (std::uint32_t o = 0; o < to.size; ++o) matched[p][o] = match.sign[p] * to[match.order[p]][o];
        morph_axis(a.wavelet, b.wavelet, p, match.order[p], match.sign[p] < 0, line, wavelet);
    }
    const Matrix axes = rotate_frame(from, matched, line.t());
    for (std::uint32_t p = 0; p < to.size; ++p)
        for (std::uint32_t o = 0; o < to.size; ++o) wavelet.axes[p][o] = static_cast<float>(axes[p][o]);
    check_model(model);
    return model;
}

} // namespace weft
