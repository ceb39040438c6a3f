/// Fourier transforms by FFTW 3 in single precision. The only file that includes fftw3.h.
#include "analysis/fft.h"
#include "base/array.h"
#include "base/error.h"
#include <fftw3.h>
#include <mutex>

namespace weft {
namespace {

/// The planner is shared by the whole process, so a lock of our own could not protect it from the application's calls.
void make_planner_safe()
{
    static std::once_flag once;
    std::call_once(once, fftwf_make_planner_thread_safe);
}

/// Plans are estimated: measured ones, and with them the last bits of a model, would depend on the machine's load.
fftwf_plan checked(fftwf_plan plan)
{
    if (!plan) throw Error(WEFT_ERROR_MEMORY, "no memory for a Fourier transform's plan");
    return plan;
}

struct PlanPair {
    fftwf_plan forward = nullptr, backward = nullptr;
    ~PlanPair()
    {
        if (forward) fftwf_destroy_plan(forward);
        if (backward) fftwf_destroy_plan(backward);
    }
};

fftwf_complex* fftw(Complex* values) { return reinterpret_cast<fftwf_complex*>(values); }

} // namespace

struct RowTransform::Plan : PlanPair {};

RowTransform::RowTransform(std::pmr::memory_resource* memory, std::uint32_t length) : plan_(new Plan)
{
    make_planner_safe();
    Array<float> values(memory, length);
    Array<Complex> half(memory, length / 2 + 1);
    const int n = static_cast<int>(length);
    plan_->forward =
        checked(fftwf_plan_dft_r2c_1d(n, values.data(), fftw(half.data()), FFTW_ESTIMATE | FFTW_DESTROY_INPUT));
    plan_->backward =
        checked(fftwf_plan_dft_c2r_1d(n, fftw(half.data()), values.data(), FFTW_ESTIMATE | FFTW_DESTROY_INPUT));
}

RowTransform::~RowTransform() = default;

void RowTransform::forward(float* values, Complex* half) const
{
    fftwf_execute_dft_r2c(plan_->forward, values, fftw(half));
}

void RowTransform::backward(Complex* half, float* values) const
{
    fftwf_execute_dft_c2r(plan_->backward, fftw(half), values);
}

struct ColumnTransform::Plan : PlanPair {};

ColumnTransform::ColumnTransform(std::pmr::memory_resource* memory, std::uint32_t length) : plan_(new Plan)
{
    make_planner_safe();
    Array<Complex> block(memory, std::size_t{length} * fft_lanes);
    const int n = static_cast<int>(length), lanes = static_cast<int>(fft_lanes);
    const auto plan = [&](int sign) {
        return checked(fftwf_plan_many_dft(1, &n, lanes, fftw(block.data()), nullptr, lanes, 1, fftw(block.data()),
                                           nullptr, lanes, 1, sign, FFTW_ESTIMATE));
    };
    plan_->forward = plan(FFTW_FORWARD);
    plan_->backward = plan(FFTW_BACKWARD);
}

ColumnTransform::~ColumnTransform() = default;

void ColumnTransform::forward(Complex* block) const { fftwf_execute_dft(plan_->forward, fftw(block), fftw(block)); }

void ColumnTransform::backward(Complex* block) const { fftwf_execute_dft(plan_->backward, fftw(block), fftw(block)); }

} // namespace weft
