/// Writes the `.texton` text.
#include "base/error.h"
#include "model/texton_text.h"

namespace weft {
namespace {

/// Counts what is appended, and keeps it if there is room for keeping.
class Text {
public:
    Text() = default; ///< counts only
    explicit Text(char* to) noexcept : to_(to) {}
    std::size_t length() const noexcept { return length_; }

    void append(std::string_view part) noexcept
    {
        if (to_) std::memcpy(to_ + length_, part.data(), part.size());
        length_ += part.size();
    }
    template <class Number, class... Format> void append_number(char before, Number number, Format... format) noexcept
    {
        char digits[32] = {before};
        const auto end = std::to_chars(digits + 1, digits + sizeof digits, number, format...);
        append({digits, static_cast<std::size_t>(end.ptr - digits)});
    }

private:
    char* to_ = nullptr;
    std::size_t length_ = 0;
};

/// One line of three numbers; a single channel is every colour.
template <class Value> void append_colour(Text& text, std::uint32_t channels, const Value& value) noexcept
{
    for (std::uint32_t c = 0; c < 3; ++c)
        text.append_number(c ? ' ' : '\n', value(channels == 1 ? 0 : c), std::chars_format::scientific);
}

void append_model(Text& text, const Model& model) noexcept
{
    const Planes& planes = model.texton.coefficients;
    const std::uint32_t width = planes.width + 2, height = planes.height + 2;
    text.append("TEXTON\n1");
    text.append_number('\n', model.texton.taps - 1);
    append_colour(text, model.channels, [&](std::uint32_t c) { return model.mean[c]; });
    text.append_number('\n', width);
    text.append_number(' ', height);
    for (std::uint32_t y = height; y-- > 0;)
        for (std::uint32_t x = 0; x < width; ++x) {
            const bool frame = x == 0 || y == 0 || x + 1 == width || y + 1 == height;
            append_colour(text, model.channels,
                          [&](std::uint32_t c) { return frame ? 0.0f : planes.row(c, y - 1)[x - 1]; });
        }
    text.append("\nWritten by libweft\n");
}

} // namespace

std::size_t write_texton_text(const Model& model, char* text, std::size_t size)
{
    if (model.method != WEFT_METHOD_TEXTON || model.texton.images != 1 || (model.channels != 1 && model.channels != 3))
        throw Error(WEFT_ERROR_UNSUPPORTED, "weft_model_save_texton: the model is no texton of 1 or 3 channels");
    Text counted;
    append_model(counted, model);
    if (text && counted.length() <= size) {
        Text written(text);
        append_model(written, model);
    }
    return counted.length();
}

} // namespace weft
