/* The reference: a DFT by rows and columns with a table of roots, periodic component, projections, model error. */
#include "reference.h"
#include "covariance.h"
#include <math.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

/* Transforms `count` sequences of `length` numbers, `step` apart. */
static void transform_axis(Complex *values, uint32_t length, size_t step, uint32_t count, size_t next, double sign)
{
    Complex *root = malloc(sizeof *root * length), *out = malloc(sizeof *out * length);
    for (uint32_t i = 0; i < length; ++i) {
        root[i].re = cos(2 * pi * i / length);
        root[i].im = sign * sin(2 * pi * i / length);
    }
    for (uint32_t s = 0; s < count; ++s) {
        Complex *sequence = values + s * next;
        for (uint32_t k = 0; k < length; ++k) {
            Complex sum = {0, 0};
            for (uint32_t i = 0, at = 0; i < length; ++i, at = at + k < length ? at + k : at + k - length) {
                sum.re += sequence[i * step].re * root[at].re - sequence[i * step].im * root[at].im;
                sum.im += sequence[i * step].re * root[at].im + sequence[i * step].im * root[at].re;
            }
            out[k] = sum;
        }
        for (uint32_t k = 0; k < length; ++k) sequence[k * step] = out[k];
    }
    free(root);
    free(out);
}

static void transform(Complex *values, uint32_t width, uint32_t height, double sign)
{
    transform_axis(values, width, 1, height, width, sign);
    transform_axis(values, height, width, width, 1, sign);
}

/* Periodic component (Moisan 2011): the spectrum minus that of the smooth component, whose Laplacian is the border's
 * jumps. */
static void periodic_component(const weft_image *photo, uint32_t c, Complex *spectrum)
{
    const uint32_t width = photo->width, height = photo->height;
    Complex *jump = calloc((size_t)width * height, sizeof *jump);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const Complex value = {(double)value_at(photo, x, y, c), 0};
            spectrum[y * width + x] = value;
        }
    for (uint32_t x = 0; x < width; ++x) {
        const double d = (double)value_at(photo, x, height - 1, c) - (double)value_at(photo, x, 0, c);
        jump[x].re += d;
        jump[(size_t)(height - 1) * width + x].re -= d;
    }
    for (uint32_t y = 0; y < height; ++y) {
        const double d = (double)value_at(photo, width - 1, y, c) - (double)value_at(photo, 0, y, c);
        jump[(size_t)y * width].re += d;
        jump[(size_t)y * width + width - 1].re -= d;
    }
    transform(spectrum, width, height, -1);
    transform(jump, width, height, -1);
    for (uint32_t v = 0; v < height; ++v)
        for (uint32_t u = 0; u < width; ++u) {
            if (u == 0 && v == 0) continue;
            const double laplacian = 2 * cos(2 * pi * u / width) + 2 * cos(2 * pi * v / height) - 4;
            spectrum[v * width + u].re -= jump[v * width + u].re / laplacian;
            spectrum[v * width + u].im -= jump[v * width + u].im / laplacian;
        }
    free(jump);
}

static double spline_spectrum(weft_interpolation interpolation, uint32_t frequency, uint32_t length)
{
    double sum = 0;
    for (int k = -5; k <= 5; ++k)
        sum += spline_autocorrelation(interpolation, k) * cos(2 * pi * frequency * k / length);
    return sum;
}

void reference_open(Reference *reference, const weft_image *photo, weft_interpolation interpolation)
{
    const uint32_t width = photo->width, height = photo->height, area = width * height;
    assert_true(photo->channels <= REFERENCE_CHANNELS);
    reference->width = width;
    reference->height = height;
    reference->channels = photo->channels;
    reference->spline = malloc(sizeof *reference->spline * area);
    for (uint32_t i = 0; i < area; ++i)
        reference->spline[i] =
            spline_spectrum(interpolation, i % width, width) * spline_spectrum(interpolation, i / width, height);
    for (uint32_t c = 0; c < photo->channels; ++c) {
        Complex *spectrum = reference->spectrum[c] = malloc(sizeof *spectrum * area);
        periodic_component(photo, c, spectrum);
        reference->mean[c] = spectrum[0].re / area;
        spectrum[0].re = spectrum[0].im = 0;
        for (uint32_t i = 0; i < area; ++i) {
            spectrum[i].re /= sqrt(area);
            spectrum[i].im /= sqrt(area);
        }
    }
    for (uint32_t a = 0; a < photo->channels; ++a)
        for (uint32_t b = 0; b < photo->channels; ++b) {
            double sum = 0;
            for (uint32_t i = 0; i < area; ++i)
                sum += reference->spectrum[a][i].re * reference->spectrum[b][i].re +
                       reference->spectrum[a][i].im * reference->spectrum[b][i].im;
            reference->covariance[a][b] = sum / area;
        }
}

void reference_close(Reference *reference)
{
    for (uint32_t c = 0; c < reference->channels; ++c) free(reference->spectrum[c]);
    free(reference->spline);
}

/* The coefficients' DFT on the exemplar's grid. */
static void spectrum_of(const Reference *reference, const weft_image *coefficients, uint32_t c, Complex *out)
{
    const Complex zero = {0, 0};
    for (uint32_t i = 0; i < reference->width * reference->height; ++i) out[i] = zero;
    for (uint32_t y = 0; y < coefficients->height; ++y)
        for (uint32_t x = 0; x < coefficients->width; ++x)
            out[y * reference->width + x].re = (double)value_at(coefficients, x, y, c);
    transform(out, reference->width, reference->height, -1);
}

/* t^* alpha^ at frequency i. */
static Complex agreement_at(const Reference *reference, Complex *const *alpha, uint32_t i)
{
    Complex sum = {0, 0};
    for (uint32_t c = 0; c < reference->channels; ++c) {
        const Complex t = reference->spectrum[c][i], a = alpha[c][i];
        sum.re += t.re * a.re + t.im * a.im;
        sum.im += t.re * a.im - t.im * a.re;
    }
    return sum;
}

double reference_error(const Reference *reference, const weft_image *coefficients)
{
    const uint32_t area = reference->width * reference->height;
    Complex *alpha[REFERENCE_CHANNELS];
    double distance = 0, power = 0;
    for (uint32_t c = 0; c < reference->channels; ++c) {
        alpha[c] = malloc(sizeof **alpha * area);
        spectrum_of(reference, coefficients, c, alpha[c]);
    }
    for (uint32_t i = 0; i < area; ++i) {
        const Complex agreement = agreement_at(reference, alpha, i);
        double ours = 0, theirs = 0;
        for (uint32_t c = 0; c < reference->channels; ++c) {
            const Complex t = reference->spectrum[c][i], a = alpha[c][i];
            theirs += t.re * t.re + t.im * t.im;
            ours += a.re * a.re + a.im * a.im;
        }
        power += theirs;
        distance += theirs + reference->spline[i] * ours -
                    2 * sqrt(reference->spline[i]) * sqrt(agreement.re * agreement.re + agreement.im * agreement.im);
    }
    for (uint32_t c = 0; c < reference->channels; ++c) free(alpha[c]);
    return sqrt((distance > 0 ? distance : 0) / power);
}

/* One channel: what the support took from the variance is given back (the colour correction of one channel). */
static void correct_variance(const Reference *reference, weft_image *coefficients)
{
    Complex *alpha = malloc(sizeof *alpha * reference->width * reference->height);
    double power = 0;
    spectrum_of(reference, coefficients, 0, alpha);
    for (uint32_t i = 0; i < reference->width * reference->height; ++i)
        power += reference->spline[i] * (alpha[i].re * alpha[i].re + alpha[i].im * alpha[i].im);
    const double scale = sqrt(reference->covariance[0][0] * reference->width * reference->height / power);
    for (uint32_t i = 0; i < coefficients->width * coefficients->height; ++i)
        values(coefficients)[i] = (float)((double)values(coefficients)[i] * scale);
    free(alpha);
}

weft_image reference_projections(const Reference *reference, uint32_t support, uint32_t iterations, uint64_t seed)
{
    const uint32_t width = reference->width, area = width * reference->height, channels = reference->channels;
    Complex *alpha[REFERENCE_CHANNELS];
    Random random = {seed};
    for (uint32_t c = 0; c < channels; ++c) {
        alpha[c] = malloc(sizeof **alpha * area);
        for (uint32_t i = 0; i < area; ++i) {
            const Complex start = {random_normal(&random), 0};
            alpha[c][i] = start;
        }
    }
    for (uint32_t n = 0; n < iterations; ++n) {
        for (uint32_t c = 0; c < channels; ++c) transform(alpha[c], width, reference->height, -1);
        for (uint32_t i = 0; i < area; ++i) {
            const Complex s = agreement_at(reference, alpha, i);
            const double modulus = sqrt(s.re * s.re + s.im * s.im),
                         scale = modulus > 0 ? 1 / (modulus * sqrt(reference->spline[i])) : 0;
            for (uint32_t c = 0; c < channels; ++c) {
                const Complex t = reference->spectrum[c][i],
                              projected = {(t.re * s.re - t.im * s.im) * scale, (t.re * s.im + t.im * s.re) * scale};
                alpha[c][i] = projected;
            }
        }
        for (uint32_t c = 0; c < channels; ++c) {
            transform(alpha[c], width, reference->height, 1);
            for (uint32_t i = 0; i < area; ++i) {
                const int inside = i % width < support && i / width < support;
                const Complex kept = {inside ? alpha[c][i].re / area : 0, 0};
                alpha[c][i] = kept;
            }
        }
    }
    weft_image result = new_image(support, support, channels, WEFT_FORMAT_F32);
    for (uint32_t c = 0; c < channels; ++c) {
        for (uint32_t i = 0; i < support * support; ++i)
            values(&result)[i * channels + c] = (float)alpha[c][i / support * width + i % support].re;
        free(alpha[c]);
    }
    if (channels == 1) correct_variance(reference, &result);
    return result;
}
