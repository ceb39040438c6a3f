/// Evaluating a program: layer by layer, first its planes, then its share of the result.
#include "opencl/texture.h"
#include <algorithm>

namespace weft::opencl {

namespace {

constexpr std::size_t group_size = 64;          // of the gathering kernels
constexpr std::uint64_t most_spots = 65536;     // of one step
constexpr std::size_t frame_floats = 9;         // of a spot on a surface
constexpr weft_u32 segment_blocks = 32;         // of one work-item of splat_bands
constexpr std::uint64_t most_floats = 1u << 24; // of a workspace's field, sums and result together
constexpr std::uint64_t most_cells = 1u << 20;  // from which one list of impacts is drawn

template <class Number> Number round_up(Number n, Number to) { return (n + to - 1) / to * to; }

weft_u32 padded_stride(weft_u32 width) { return round_up(width, weft_u32{WEFT_SAMPLES}); }

} // namespace

/// A workspace for the time of a call.
class Texture::Lease {
public:
    explicit Lease(Texture& texture) : texture_(texture)
    {
        std::unique_lock lock(texture.mutex_);
        texture.returned_.wait(lock, [&] {
            index_ = 0;
            while (index_ < concurrency && texture.taken_[index_]) ++index_;
            return index_ < concurrency;
        });
        texture.taken_[index_] = true;
    }
    Lease(const Lease&) = delete;
    ~Lease()
    {
        // After an error, too, nothing may still write to the caller's memory.
        clFinish(texture_.workspaces_[index_]->queue.get());
        {
            const std::lock_guard lock(texture_.mutex_);
            texture_.taken_[index_] = false;
        }
        texture_.returned_.notify_one();
    }
    Workspace& operator*() const noexcept { return *texture_.workspaces_[index_]; }

private:
    Texture& texture_;
    std::uint32_t index_ = 0;
};

Texture::Texture(const Device& device, const weft_program& program, std::pmr::memory_resource* memory)
    : device_(device), tables_(device, program, memory)
{
    for (auto& work : workspaces_) work.emplace(device, memory);
    layers_ = upload(tables_.layers.data(), tables_.layers.size() * sizeof(LayerLayout));
    levels_ = upload(tables_.levels.data(), tables_.levels.size() * sizeof(LevelLayout));
    lattices_ = upload(tables_.lattices.data(), tables_.lattices.size() * sizeof(LatticeLayout));
    words_ = upload(tables_.words.data(), tables_.words.size() * sizeof(weft_u32));
    numbers_ = upload(tables_.numbers.data(), tables_.numbers.size() * sizeof(float));
    std::pmr::vector<float> texels(tables_.texel_count * 4, memory);
    tables_.fill_texels(texels.data());
    texels_ = upload(texels.data(), texels.size() * sizeof(float));
}

Buffer Texture::upload(const void* data, std::size_t bytes)
{
    cl_int code = CL_SUCCESS;
    Buffer buffer(clCreateBuffer(device_.context, CL_MEM_READ_ONLY, bytes, nullptr, &code));
    check(code, "clCreateBuffer");
    check(clEnqueueWriteBuffer(workspaces_[0]->queue.get(), buffer.get(), CL_TRUE, 0, bytes, data, 0, nullptr, nullptr),
          "clEnqueueWriteBuffer");
    return buffer;
}

/// Would a window need too much memory for its planes, or for its list of impacts?
bool Texture::too_large(const weft_window& window) const
{
    const std::uint64_t planes = tables_.slots + tables_.sums + tables_.program.channels;
    if (std::uint64_t{padded_stride(window.width)} * window.height * planes > most_floats) return true;
    for (const LayerLayout& layer : tables_.layers) {
        if (layer.form != WEFT_SPLAT_BANDS || window.level >= layer.levels) continue;
        const LevelLayout& level = tables_.levels[layer.first_level + window.level];
        const auto reach_x =
            static_cast<std::uint64_t>(level.before_x + level.after_x) + (std::uint64_t{window.width} << window.level);
        const auto reach_y =
            static_cast<std::uint64_t>(level.before_y + level.after_y) + (std::uint64_t{window.height} << window.level);
        if ((reach_x >> layer.cell_log2) * (reach_y >> layer.cell_log2) > most_cells) return true;
    }
    return false;
}

void Texture::render(const weft_window& window)
{
    Lease work(*this);
    const std::size_t plane = std::size_t{window.stride} * window.height;
    weft_u32 step_x = window.width, step_y = window.height;
    weft_window part = window;
    while (part.width = step_x, part.height = step_y, too_large(part)) {
        if (step_y > 16 && step_y >= step_x / 4)
            step_y = (step_y + 1) / 2;
        else if (step_x > 4 * WEFT_SAMPLES)
            step_x = padded_stride(step_x / 2);
        else
            break;
    }
    for (weft_u32 y = 0; y < window.height; y += step_y) {
        for (weft_u32 x = 0; x < window.width; x += step_x) {
            part.x = window.x + x;
            part.y = window.y + y;
            part.width = std::min(step_x, window.width - x);
            part.height = std::min(step_y, window.height - y);
            part.data = window.data + std::size_t{y} * window.stride + x;
            render_part(*work, part, plane);
        }
    }
}

void Texture::render_part(Workspace& work, const weft_window& part, std::size_t plane)
{
    const weft_u32 stride = padded_stride(part.width), channels = tables_.program.channels;
    SamplesLayout samples = {};
    samples.x = part.x;
    samples.y = part.y;
    samples.level = part.level;
    samples.width = part.width;
    samples.height = part.height;
    samples.stride = stride;
    samples.pitch = stride * part.height;
    samples.span = device_.cpu ? stride : weft_u32{WEFT_SAMPLES};
    if (device_.cpu) return render_in_place(work, samples, part, plane);
    const cl_mem out = work.out.get(device_.context, std::size_t{samples.pitch} * channels * sizeof(float));
    evaluate(work, samples, &part, out, {1, stride, samples.pitch});
    const std::size_t zero[3] = {0, 0, 0};
    const std::size_t region[3] = {part.width * sizeof(float), part.height, channels};
    check(clEnqueueReadBufferRect(work.queue.get(), out, CL_TRUE, zero, zero, region, stride * sizeof(float),
                                  samples.pitch * sizeof(float), part.stride * sizeof(float), plane * sizeof(float),
                                  part.data, 0, nullptr, nullptr),
          "clEnqueueReadBufferRect");
}

/// The device has the host's memory: no copy.
void Texture::render_in_place(Workspace& work, const SamplesLayout& samples, const weft_window& part, std::size_t plane)
{
    const std::size_t floats =
        (tables_.program.channels - 1) * plane + std::size_t{part.height - 1} * part.stride + part.width;
    cl_int code = CL_SUCCESS;
    const Buffer out(clCreateBuffer(device_.context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR, floats * sizeof(float),
                                    part.data, &code));
    check(code, "clCreateBuffer");
    evaluate(work, samples, &part, out.get(), {1, part.stride, plane});
    void* mapped = clEnqueueMapBuffer(work.queue.get(), out.get(), CL_TRUE, CL_MAP_READ, 0, floats * sizeof(float), 0,
                                      nullptr, nullptr, &code);
    check(code, "clEnqueueMapBuffer");
    check(clEnqueueUnmapMemObject(work.queue.get(), out.get(), mapped, 0, nullptr, nullptr), "clEnqueueUnmapMemObject");
}

void Texture::sample(const weft_batch& batch)
{
    Lease work(*this);
    const std::uint32_t channels = tables_.program.channels;
    const auto step = static_cast<std::uint32_t>(std::min(most_spots, most_floats / (tables_.slots + channels)));
    weft_batch part = batch;
    for (std::uint32_t first = 0; first < batch.count; first += step) {
        part.count = std::min(step, batch.count - first);
        part.spots = batch.spots + first;
        if (tables_.program.use == WEFT_USE_SURFACE) part.frames = batch.frames + std::size_t{first} * frame_floats;
        part.out = batch.out + std::size_t{first} * channels;
        sample_part(*work, part);
    }
}

void Texture::sample_part(Workspace& work, const weft_batch& part)
{
    static_assert(sizeof(weft_spot) == sizeof(SpotLayout));
    const weft_u32 channels = tables_.program.channels;
    SamplesLayout samples = {};
    samples.spots = 1;
    samples.width = part.count;
    samples.height = 1;
    samples.stride = samples.pitch = padded_stride(part.count);
    samples.span = (device_.cpu ? 16u : 1u) * WEFT_SAMPLES;
    const std::size_t bytes = std::size_t{part.count} * channels * sizeof(float);
    send(work, work.spots, part.spots, part.count * sizeof *part.spots);
    if (tables_.program.use == WEFT_USE_SURFACE)
        send(work, work.frames, part.frames, std::size_t{part.count} * frame_floats * sizeof(float));
    const cl_mem result = work.out.get(device_.context, bytes);
    evaluate(work, samples, nullptr, result, {channels, 0, 1});
    check(clEnqueueReadBuffer(work.queue.get(), result, CL_TRUE, 0, bytes, part.out, 0, nullptr, nullptr),
          "clEnqueueReadBuffer");
}

void Texture::evaluate(Workspace& work, const SamplesLayout& samples, const weft_window* window, cl_mem out,
                       const ResultLayout& result)
{
    const cl_mem layers = layers_.get(), words = words_.get(), numbers = numbers_.get();
    const std::size_t floats = std::max<std::size_t>(std::size_t{tables_.slots} * samples.pitch, 1);
    const cl_mem field = work.field.get(device_.context, floats * sizeof(float));
    for (weft_u32 i = 0; i < tables_.layers.size(); ++i) {
        const LayerLayout& layer = tables_.layers[i];
        SumsLayout blocks = {};
        if (layer.form == WEFT_SPLAT_BANDS)
            blocks = splat_bands(work, i, *window);
        else
            gather(work, samples, i, field);
        const cl_mem sums = work.sums.get(device_.context, sizeof(float));
        const std::size_t spans[3] = {(samples.width + samples.span - 1) / samples.span, samples.height, 1};
        work.layer_sum.enqueue(work.queue.get(), spans, 1, layers, words, numbers, field, sums, out, samples, blocks,
                               result, i);
    }
}

/// A layer's planes into the field.
void Texture::gather(Workspace& work, const SamplesLayout& samples, weft_u32 index, cl_mem field)
{
    const LayerLayout& layer = tables_.layers[index];
    const cl_command_queue queue = work.queue.get();
    const cl_mem layers = layers_.get(), levels = levels_.get(), lattices = lattices_.get(), words = words_.get(),
                 numbers = numbers_.get(), texels = texels_.get();
    const cl_mem spots = work.spots.get(device_.context, sizeof(SpotLayout));
    const cl_mem frames = work.frames.get(device_.context, sizeof(float));
    const std::size_t columns = round_up(std::size_t{samples.width}, group_size), rows = samples.height;
    const std::size_t groups[3] = {columns, rows, (layer.planes + 3) / 4}, planes[3] = {columns, rows, layer.planes};
    const std::size_t tiles[3] = {(samples.width + WEFT_TILE_COLUMNS - 1) / WEFT_TILE_COLUMNS,
                                  (rows + WEFT_TILE_ROWS - 1) / WEFT_TILE_ROWS, layer.planes};
    switch (layer.form) {
    case WEFT_SPLAT_GATHER:
        return work.splat_gather.enqueue(queue, groups, group_size, layers, levels, texels, spots, field, samples,
                                         index, words, numbers);
    case WEFT_SURFACE_GATHER:
        return work.surface_gather.enqueue(queue, groups, group_size, layers, levels, texels, spots, frames, field,
                                           samples, index, words, numbers);
    case WEFT_TILE_COMPOSED:
        return work.tile_composed.enqueue(queue, {columns, rows, 1}, group_size, layers, levels, texels, spots, field,
                                          samples, index, words, numbers);
    case WEFT_LATTICE_GATHER:
        return work.lattice_gather.enqueue(queue, planes, group_size, layers, lattices, texels, spots, field, samples,
                                           index);
    case WEFT_LATTICE_SOLID:
        return work.lattice_solid.enqueue(queue, planes, group_size, layers, lattices, texels, spots, field, samples,
                                          index);
    case WEFT_LATTICE_PYRAMID:
        return work.lattice_pyramid.enqueue(queue, tiles, 1, layers, lattices, texels, field, samples, index);
    default:
        return work.tile_gather.enqueue(queue, groups, group_size, layers, levels, texels, spots, field, samples,
                                        index);
    }
}

cl_mem Texture::send(Workspace& work, Scratch& scratch, const void* data, std::size_t bytes)
{
    const cl_mem buffer = scratch.get(device_.context, std::max<std::size_t>(bytes, 1));
    // Blocking, and the queue is in order: after it the data may be made anew, for the next layer.
    if (bytes != 0)
        check(clEnqueueWriteBuffer(work.queue.get(), buffer, CL_TRUE, 0, bytes, data, 0, nullptr, nullptr),
              "clEnqueueWriteBuffer");
    return buffer;
}

SumsLayout Texture::splat_bands(Workspace& work, weft_u32 index, const weft_window& window)
{
    const LayerLayout& layer = tables_.layers[index];
    const Choice choice(tables_.program, *tables_.program.layers[index]->splat);
    SumsLayout blocks = {};
    blocks.level = window.level;
    if (window.level >= layer.levels) return blocks; // layer_sum takes f = 0
    blocks.index = layer.first_level + window.level;
    work.impacts.collect(layer, tables_.levels[blocks.index], tables_.words.data() + layer.counts, choice, window);
    const auto& list = work.impacts.list();
    const auto& begins = work.impacts.bands();
    const cl_mem impacts = send(work, work.lists, list.data(), list.size() * sizeof list[0]);
    const cl_mem bands = send(work, work.bands, begins.data(), begins.size() * sizeof begins[0]);
    const std::size_t band_count = begins.size() - 2;
    blocks.blocks = padded_stride(window.width) / WEFT_BLOCK_COLUMNS + 1;
    blocks.stride = blocks.blocks * WEFT_BLOCK_COLUMNS;
    blocks.segment = std::min(blocks.blocks, segment_blocks);
    blocks.step = blocks.stride * static_cast<weft_u32>(band_count) * WEFT_BLOCK_ROWS(layer.taps);
    blocks.jitter = static_cast<weft_i32>((1u << layer.cell_log2) >> window.level) + 2;
    const cl_mem sums = work.sums.get(device_.context, std::size_t{tables_.sums} * blocks.step * sizeof(float));
    const cl_mem levels = levels_.get(), texels = texels_.get();
    const std::size_t segments = (blocks.blocks + blocks.segment - 1) / blocks.segment;
    work.splat_bands[layer.taps / 2].enqueue(work.queue.get(), {segments, band_count, layer.planes}, 1, levels, texels,
                                             impacts, bands, sums, blocks);
    return blocks;
}

} // namespace weft::opencl
