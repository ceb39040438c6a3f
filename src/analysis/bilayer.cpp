/// Photo -> structure layer, masks, noises: the order of the steps, and the choices that the caller left open.
#include "analysis/bilayer.h"
#include "analysis/noise_learning.h"
#include "analysis/rearrangement.h"
#include "analysis/statistics.h"
#include "analysis/structure_filter.h"
#include "base/hash.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_analyze_bilayer";
constexpr std::uint32_t least_side = 32, most_photo_side = 8192, most_border = 64, most_depth = 4;
constexpr std::uint32_t least_support = 8, most_support = 256, default_support = 64;

struct Choices {
    std::uint32_t noises, window, mask_window, support, border, depth;
    Structure_filter filter;
    bool barycentric, equalize, plain;
    std::uint64_t seed;
};

std::uint32_t window_of(std::uint32_t given, std::uint32_t otherwise, const char* name)
{
    require(given == 0 || given == 2 || given == 4 || given == 8 || given == 16, function, ": options->", name, " is ",
            given, ", not 2, 4, 8 or 16");
    return given ? given : otherwise;
}

/// `given`, or `otherwise` if it is 0.
std::uint32_t choice(std::uint32_t given, std::uint32_t otherwise, std::uint32_t least, std::uint32_t most,
                     const char* name)
{
    require(given == 0 || (given >= least && given <= most), function, ": options->", name, " is ", given,
            ", neither 0 nor ", least, "..", most);
    return given ? given : otherwise;
}

Choices choose(const weft_image& photo, const weft_bilayer_options& options)
{
    for (const std::uint32_t side : {photo.width, photo.height})
        require(side >= least_side && side <= most_photo_side, function, ": photo is ", photo.width, " x ",
                photo.height, " pixels, not ", least_side, "..", most_photo_side, " a side");
    const std::uint32_t side = std::min(photo.width, photo.height);
    Choices choices{};
    choices.noises = choice(options.noises, 0, 1, most_noises, "noises");
    choices.window = window_of(options.window, 4, "window");
    choices.mask_window = window_of(options.mask_window, 8, "mask_window");
    choices.support = choice(options.support, std::min(default_support, side), least_support, most_support, "support");
    require(choices.support <= side, function, ": options->support is ", choices.support,
            ", the photo's shorter side has ", side, " pixels");
    require(options.masks >= WEFT_MASKS_DEFAULT && options.masks <= WEFT_MASKS_BARYCENTRIC, function,
            ": options->masks is ", options.masks, ", which is no weft_masks");
    require(options.structure >= WEFT_STRUCTURE_AUTO && options.structure <= WEFT_STRUCTURE_NONE, function,
            ": options->structure is ", options.structure, ", which is no weft_structure");
    choice(options.colours, 4, 2, 16, "colours");
    choices.border = choice(options.border, 0, 1, most_border, "border");
    require(options.equalize <= 1, function, ": options->equalize is ", options.equalize, ", neither 0 nor 1");
    choices.depth = choice(options.depth, 1, 1, most_depth, "depth");
    choices.filter.width = choice(options.filter_width, 16, 2, 64, "filter_width");
    choices.filter.iterations = choice(options.filter_iterations, 5, 1, 32, "filter_iterations");
    require(options.filter_sigma == 0 || (options.filter_sigma >= 1e-6F && options.filter_sigma <= 1e3F), function,
            ": options->filter_sigma is ", options.filter_sigma, ", neither 0 nor 1e-6..1000");
    choices.filter.sigma = options.filter_sigma > 0 ? options.filter_sigma : 0.01F;
    choices.barycentric = options.masks == WEFT_MASKS_BARYCENTRIC;
    choices.equalize = options.equalize == 1;
    choices.plain = options.structure == WEFT_STRUCTURE_NONE;
    choices.seed = options.seed;
    return choices;
}

/// What local spectra are of: luminance, of 3 or 4 channels as of gamma-coded RGB, else the channels' mean; times
/// `gain`, plus `shift`.
void set_luminance(Core& core, const Planes& planes, float gain, float shift, float* luminance)
{
    static constexpr float rgb[] = {0.299F, 0.587F, 0.114F, 0};
    const bool coloured = planes.count == 3 || planes.count == 4;
    for_each_run(core.parallel, planes.height, [&](std::uint32_t first, std::uint32_t last) {
        const std::size_t begin = std::size_t{first} * planes.width, end = std::size_t{last} * planes.width;
        std::fill(luminance + begin, luminance + end, shift);
        for (std::uint32_t c = 0; c < planes.count; ++c) {
            const float weight = gain * (coloured ? rgb[c] : 1.0F / static_cast<float>(planes.count));
            const float* from = planes.plane(c);
            for (std::size_t i = begin; i < end; ++i) luminance[i] += weight * from[i];
        }
    });
}

/// The photo while it is taken apart.
class Layers {
public:
    Layers(Core& core, Planes photo, const Choices& choices)
        : core_(core), choices_(choices), photo_(std::move(photo)),
          luminance_(&core.memory, photo_.width, photo_.height, 1, Array<float>::unset),
          residual_(&core.memory, photo_.width, photo_.height, photo_.count, Array<float>::unset)
    {
        std::copy(photo_.values.begin(), photo_.values.end(), residual_.values.begin());
        centring_ = centre(core_, residual_);
        set_luminance(core_, photo_, 1, 0, luminance_.plane(0));
        const auto range = std::minmax_element(luminance_.values.begin(), luminance_.values.end());
        const float least = *range.first, most = *range.second;
        if (least >= 0 && most <= 1) return;
        gain_ = most - least > 1e-30F ? 1 / (most - least) : 1; // values in 0..1, which sigma is a distance of
        for (float& value : luminance_.values) value = (value - least) * gain_;
    }

    const Centring& centring() const noexcept { return centring_; }
    const Planes& residual() const noexcept { return residual_; } ///< N times the centring's scale

    Local_spectra spectra(std::uint32_t window, const Progress& progress) const
    {
        return local_spectra_of(core_, luminance_.plane(0), photo_.width, photo_.height, window, progress);
    }

    /// Takes the structure of what is left out of it.
    void filter(const Progress& progress)
    {
        Planes structure(&core_.memory, photo_.width, photo_.height, photo_.count, Array<float>::unset);
        std::copy(residual_.values.begin(), residual_.values.end(), structure.values.begin());
        filter_structure(core_, spectra(choices_.window, progress.part(0, 0.1)), choices_.filter, structure,
                         progress.part(0.1, 1));
        for (std::size_t i = 0; i < residual_.values.size(); ++i) residual_.values[i] -= structure.values[i];
    }
    /// From here on spectra are those of the residual; around 1/2, as magnitudes would not tell its sign.
    void look_at_residual()
    {
        set_luminance(core_, residual_, static_cast<float>(static_cast<double>(gain_) / centring_.scale), 0.5F,
                      luminance_.plane(0));
    }

    /// `structure`, unless it is the mean alone, <- P in its first planes, `residual` <- N: P + N is the photo, but for
    /// the rounding of one sum.
    void part(const Regions& regions, Planes* structure, Planes& residual)
    {
        const auto unit = static_cast<float>(1 / centring_.scale);
        for (std::size_t c = 0; c < photo_.count; ++c) {
            const float *from = photo_.plane(c), *noise = residual_.plane(c);
            for (std::size_t i = 0; i < photo_.area(); ++i) {
                const bool bare = structure && regions.nearest[i] == no_cluster;
                const float p = bare ? from[i] : structure ? from[i] - noise[i] * unit : mean(c);
                if (structure) structure->plane(c)[i] = p;
                residual.plane(c)[i] = from[i] - p;
            }
        }
    }
    float mean(std::size_t c) const noexcept { return static_cast<float>(centring_.mean[c]); }

private:
    Core& core_;
    const Choices& choices_;
    Planes photo_, luminance_, residual_;
    Centring centring_;
    float gain_ = 1;
};

} // namespace

Model analyze_bilayer(Core& core, const weft_image& photo, const weft_bilayer_options& options,
                      const Progress& progress)
{
    const Choices choices = choose(photo, options);
    progress.at(0);
    const std::uint32_t channels = photo.channels;
    Layers layers(core, read_image(photo, &core.memory, core.parallel, function, "photo"), choices);
    for (std::uint32_t pass = 0; !choices.plain && pass < choices.depth; ++pass) {
        if (pass > 0) layers.look_at_residual();
        layers.filter(progress.part(0.02 + 0.48 * pass / choices.depth, 0.02 + 0.48 * (pass + 1) / choices.depth));
    }
    if (choices.depth > 1 && !choices.plain) layers.look_at_residual();

    Regions regions;
    {
        const Local_spectra spectra = layers.spectra(choices.mask_window, progress.part(0.5, 0.55));
        const Clusters clusters = find_clusters(core, spectra, choices.noises, choices.seed, progress.part(0.55, 0.62));
        regions = regions_of(core, spectra, clusters, choices.barycentric, progress.part(0.62, 0.64));
    }
    if (choices.border > 0 && !choices.plain) clear_borders(core, choices.border, regions, progress.part(0.64, 0.65));

    Model model;
    model.method = WEFT_METHOD_BILAYER;
    model.channels = channels;
    Bilayer& bilayer = model.bilayer;
    Region_spectrum spectrum(core, photo.width, photo.height, choices.support);
    const std::uint32_t count = regions.masks.count;
    for (std::uint32_t k = 0; k < count; ++k)
        bilayer.noises.push_back(
            learn_noise(core, layers.residual(), regions, k,
                        {choices.support, choices.equalize, layers.centring().scale, mix_in(choices.seed, 1)}, spectrum,
                        progress.part(0.65 + 0.15 * k / count, 0.65 + 0.15 * (k + 1) / count)));
    bilayer.plain = choices.plain ? 1 : 0;
    for (std::uint32_t c = 0; choices.plain && c < channels; ++c) model.mean[c] = layers.mean(c);
    bilayer.residual = Planes(&core.memory, photo.width, photo.height, channels);
    const std::uint32_t first = choices.plain ? 0 : channels; // of the masks
    Planes structure(&core.memory, photo.width, photo.height, first + count);
    layers.part(regions, choices.plain ? nullptr : &structure, bilayer.residual);
    std::copy(regions.masks.values.begin(), regions.masks.values.end(), structure.plane(first));
    bilayer.structure = std::move(structure);
    if (!choices.plain || count > 1) // else there is nothing in space to arrange
        arrange_structure(core, choices.plain ? 0 : channels, options, bilayer, progress.part(0.8, 0.99));
    check_model(model);
    progress.at(1);
    return model;
}

} // namespace weft
