/// Progress and cancellation: monotone fractions reported on the calling thread.
#pragma once
#include "base/error.h"

namespace weft {

/// A share [from, to] of a call's work. Copies report into the same call.
class Progress {
public:
    Progress() = default; ///< reports to nobody
    Progress(weft_progress report, void* user) noexcept : report_(report), user_(user) {}

    /// Reports that `done` (0..1) of this share is finished; throws Error(WEFT_ERROR_CANCELLED) if the caller says
    /// stop. Only on the thread that called libweft.
    void at(double done) const
    {
        if (report_ && report_(user_, static_cast<float>(from_ + (to_ - from_) * done)) != 0)
            throw Error(WEFT_ERROR_CANCELLED, "the progress function asked to stop");
    }
    bool reports() const noexcept { return report_ != nullptr; }

    /// The part [from, to] of this share.
    Progress part(double from, double to) const noexcept
    {
        Progress share = *this;
        share.from_ = from_ + (to_ - from_) * from;
        share.to_ = from_ + (to_ - from_) * to;
        return share;
    }

private:
    weft_progress report_ = nullptr;
    void* user_ = nullptr;
    double from_ = 0, to_ = 1;
};

} // namespace weft
