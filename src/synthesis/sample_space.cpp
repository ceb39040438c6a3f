/// Points in space: on surfaces and in solids.
#include "base/error.h"
#include "synthesis/footprint.h"
#include "synthesis/texture.h"
#include <algorithm>
#include <cmath>

namespace weft {

/// Opened when it is first asked for: other textures need not pay for it.
struct Texture::Space {
    Space(Core& core, const Model& model, const weft_texture_options& options)
        : program(core, model, options, Program::in_space)
    {
    }

    Program program;
    Opened opened;
    Scratch_pool scratch;
};

namespace {

constexpr char surface_function[] = "weft_texture_sample_surface", solid_function[] = "weft_texture_sample_solid";

double product(const float* a, const float* b) noexcept
{
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) sum += static_cast<double>(a[axis]) * static_cast<double>(b[axis]);
    return sum;
}

void check_position(const double* position, const char* function, std::size_t i)
{
    for (int axis = 0; axis < 3; ++axis)
        require(std::abs(position[axis]) < most_coordinate, function, ": points[", i, "].position[", axis, "] is ",
                position[axis], ", not within 2^52");
}

void check(const weft_surface_point& point, std::size_t i)
{
    constexpr double most_error = 1e-3;
    const auto is_unit = [&](const float* vector) {
        return std::abs(std::sqrt(product(vector, vector)) - 1) <= most_error;
    };
    check_position(point.position, surface_function, i);
    require(is_unit(point.tangent), surface_function, ": points[", i, "].tangent is not of length 1");
    require(is_unit(point.bitangent), surface_function, ": points[", i, "].bitangent is not of length 1");
    const double cosine = product(point.tangent, point.bitangent);
    require(std::abs(cosine) <= most_error, surface_function, ": points[", i,
            "].tangent and .bitangent are not orthogonal: their product is ", cosine);
}

void check(const weft_solid_point& point, std::size_t i)
{
    check_position(point.position, solid_function, i);
    require(std::isfinite(point.footprint) && point.footprint >= 0, solid_function, ": points[", i, "].footprint is ",
            point.footprint, ", not finite and 0 or more");
    if (!(point.zero == 0))
        throw Error(WEFT_ERROR_UNSUPPORTED, solid_function, ": points[", i, "].zero is ", point.zero,
                    ", which this libweft does not know");
}

/// Tangent, bitangent, and the normal that is their cross product.
void make_frame(const weft_surface_point& point, float* frame) noexcept
{
    const float *u = point.tangent, *v = point.bitangent;
    std::copy_n(u, 3, frame);
    std::copy_n(v, 3, frame + 3);
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        frame[6 + axis] = static_cast<float>(static_cast<double>(u[next]) * static_cast<double>(v[last]) -
                                             static_cast<double>(u[last]) * static_cast<double>(v[next]));
    }
}

} // namespace

const Texture::Space& Texture::space(const char* function) const
{
    if (const Space* space = space_.load(std::memory_order_acquire)) return *space;
    const std::lock_guard lock(opening_);
    if (!owner_) {
        const std::pmr::polymorphic_allocator<Space> allocator(&core_.memory);
        const auto made = std::allocate_shared<Space>(allocator, core_, model_, options_);
        open(made->opened, made->program.space(), function);
        const auto frames =
            model_.method == WEFT_METHOD_TEXTON ? Scratch_pool::with_frames : Scratch_pool::without_frames;
        made->scratch = Scratch_pool(&core_.memory, made->opened.device().limits().batch, channels(), frames);
        owner_ = made;
        space_.store(made.get(), std::memory_order_release);
    }
    return *owner_;
}

/// place(point), or place(point, frame) on surfaces, makes the one spot that a point is.
template <class Point, class Place>
void Texture::sample_space(std::size_t count, const Point* points, float* out, const char* function,
                           const Place& place) const
{
    require(options_.period_x == 0 && options_.period_y == 0, function, ": the texture has a period");
    require(count == 0 || points, function, ": points is NULL");
    require(count == 0 || out, function, ": out is NULL");
    for (std::size_t i = 0; i < count; ++i) check(points[i], i);
    if (count == 0) return;
    const Space& opened = space(function);
    Room room(opened.scratch, count);
    const Scratch scratch = room.scratch();
    for (std::size_t done = 0; done < count;) {
        const auto spots = static_cast<std::uint32_t>(std::min<std::size_t>(count - done, scratch.capacity));
        constexpr bool surface = std::is_same_v<Point, weft_surface_point>;
        for (std::uint32_t i = 0; i < spots; ++i) {
            if constexpr (surface)
                scratch.spots[i] = place(points[done + i], scratch.frames + std::size_t{i} * 9);
            else
                scratch.spots[i] = place(points[done + i]);
        }
        const weft_batch batch{sizeof(weft_batch), spots, scratch.spots, surface ? scratch.frames : nullptr,
                               out + done * channels()};
        opened.opened.sample(batch, function);
        done += spots;
    }
}

void Texture::sample_surface(std::size_t count, const weft_surface_point* points, float* out) const
{
    if (model_.method != WEFT_METHOD_TEXTON)
        throw Error(WEFT_ERROR_UNSUPPORTED, surface_function, ": the texture is not of a texton model");
    require(!mixed_, surface_function, ": the texture was made with options->mix");
    sample_space(count, points, out, surface_function, [](const weft_surface_point& point, float* frame) {
        make_frame(point, frame);
        return spot_in_space(point.position, 0);
    });
}

void Texture::sample_solid(std::size_t count, const weft_solid_point* points, float* out) const
{
    if (model_.method != WEFT_METHOD_WAVELET)
        throw Error(WEFT_ERROR_UNSUPPORTED, solid_function, ": the texture is not of a wavelet model");
    sample_space(count, points, out, solid_function, [](const weft_solid_point& point) {
        return spot_in_space(point.position, level_of(point.footprint));
    });
}

} // namespace weft
