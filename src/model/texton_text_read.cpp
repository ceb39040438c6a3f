/// Reads the `.texton` text: tokens with their line, so that every sentence can say where.
#include "base/error.h"
#include "model/texton_text.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_model_load_texton: ";
constexpr std::uint32_t most_framed_side = most_side + 2, colours = 3;
constexpr std::size_t least_coefficient = 6; // the bytes of "0 0 0" and a separator

class Tokens {
public:
    Tokens(const char* text, std::size_t size) noexcept : at_(text), end_(text + size) {}

    std::string_view next(const char* what)
    {
        for (; at_ != end_ && is_space(*at_); ++at_) line_ += *at_ == '\n';
        const char* begin = at_;
        while (at_ != end_ && !is_space(*at_)) ++at_;
        if (at_ == begin) throw Error(WEFT_ERROR_FORMAT, function, "the text ends in line ", line_, " before ", what);
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }
    std::uint32_t whole_number(const char* what)
    {
        const std::string_view token = next(what);
        std::uint32_t number = 0;
        const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), number);
        if (error != std::errc() || end != token.data() + token.size()) fail(what);
        return number;
    }
    float number(const char* what)
    {
        const std::string_view token = next(what);
        const char* last = token.data() + token.size();
        float number = 0;
        auto result = std::from_chars(token.data(), last, number);
        if (result.ec == std::errc::result_out_of_range) { // too large, or so small that it is 0
            double wide = HUGE_VAL;
            result = std::from_chars(token.data(), last, wide);
            number = std::abs(wide) < 1 ? 0.0f : HUGE_VALF;
        }
        if (result.ec != std::errc() || result.ptr != last || !std::isfinite(number)) fail(what);
        return number;
    }
    /// A number at the text's very end may have been cut short.
    void require_more() const
    {
        if (at_ == end_)
            throw Error(WEFT_ERROR_FORMAT, function, "the text ends within line ", line_,
                        ", where a number may be cut short");
    }
    std::uint64_t line() const noexcept { return line_; }
    std::size_t left() const noexcept { return static_cast<std::size_t>(end_ - at_); }

private:
    static bool is_space(char c) noexcept { return c == ' ' || (c >= '\t' && c <= '\r'); }
    [[noreturn]] void fail(const char* what) const
    {
        throw Error(WEFT_ERROR_FORMAT, function, "line ", line_, " has something else where ", what, " should be");
    }

    const char* at_;
    const char* end_;
    std::uint64_t line_ = 1;
};

bool is_framed(const Planes& planes) noexcept
{
    if (planes.width < 3 || planes.height < 3) return false;
    const auto is_zero = [](float value) { return value == 0; };
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::uint32_t y = 0; y < planes.height; ++y) {
            const float* row = planes.row(c, y);
            const bool whole = y == 0 || y + 1 == planes.height;
            if (whole ? !std::all_of(row, row + planes.width, is_zero) : row[0] != 0 || row[planes.width - 1] != 0)
                return false;
        }
    return true;
}

Planes without_frame(Core& core, const Planes& planes)
{
    Planes inner(&core.memory, planes.width - 2, planes.height - 2, planes.count, Array<float>::unset);
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::uint32_t y = 0; y < inner.height; ++y)
            std::copy_n(planes.row(c, y + 1) + 1, inner.width, inner.row(c, y));
    return inner;
}

Planes read_coefficients(Core& core, Tokens& tokens, std::uint32_t width, std::uint32_t height)
{
    if (std::uint64_t{width} * height > tokens.left() / least_coefficient + 1)
        throw Error(WEFT_ERROR_FORMAT, function, "the text is too short for ", width, " x ", height, " coefficients");
    Planes planes(&core.memory, width, height, colours, Array<float>::unset);
    for (std::uint32_t y = height; y-- > 0;)
        for (std::uint32_t x = 0; x < width; ++x)
            for (std::uint32_t c = 0; c < colours; ++c) planes.row(c, y)[x] = tokens.number("a coefficient");
    tokens.require_more();
    return is_framed(planes) ? without_frame(core, planes) : std::move(planes);
}

std::uint32_t read_side(Tokens& tokens, const char* what)
{
    const std::uint32_t side = tokens.whole_number(what);
    if (side < 1 || side > most_framed_side)
        throw Error(WEFT_ERROR_FORMAT, function, "line ", tokens.line(), ": ", what, " is ", side, ", not 1..",
                    most_framed_side);
    return side;
}

} // namespace

Model read_texton_text(Core& core, const char* text, std::size_t size)
{
    Tokens tokens(text, size);
    if (tokens.next("TEXTON") != "TEXTON")
        throw Error(WEFT_ERROR_FORMAT, function, "the text does not begin with TEXTON");
    const std::uint32_t version = tokens.whole_number("the format's version");
    if (version != 1)
        throw Error(WEFT_ERROR_FORMAT, function, "the format's version is ", version, ", only 1 is known");
    const std::uint32_t order = tokens.whole_number("the order of the interpolation");
    if (order != 0 && order != 1 && order != 3 && order != 5)
        throw Error(WEFT_ERROR_FORMAT, function, "the order of the interpolation is ", order, ", not 0, 1, 3 or 5");
    Model model;
    model.method = WEFT_METHOD_TEXTON;
    model.channels = colours;
    for (std::uint32_t c = 0; c < colours; ++c) model.mean[c] = tokens.number("a mean colour");
    const std::uint32_t width = read_side(tokens, "the width"), height = read_side(tokens, "the height");
    model.texton.coefficients = read_coefficients(core, tokens, width, height);
    model.texton.taps = order + 1;
    check_model(model);
    return model;
}

} // namespace weft
