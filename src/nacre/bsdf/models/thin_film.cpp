#include "nacre/bsdf/models/thin_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/microfacet.h"
#include "nacre/optics/airy.h"
#include "nacre/optics/antialiased.h"
#include "nacre/spectra/rgb.h"

// The reflectance F of the thin-film model.

namespace nacre::bsdf {

/// Linear Rec. 709 colour of the film by the cosine of incidence, by spectral antialiasing.
class FilmColours {
 public:
    FilmColours(const optics::AiryFilm& film, double thickness_nm, ThinFilmColour colour);

    /// Linear between kIntervals + 1 equally spaced cosines.
    spectra::Rgb at(float cosine) const;

    static constexpr int kIntervals = 1024;

 private:
    std::vector<spectra::Rgb> rgb_;
};

/// The film at eight wavelengths: a function of the cosine of incidence.
class FilmReflectance {
 public:
    /// @param colours  null for the spectral mode; kept by reference
    FilmReflectance(const optics::AiryFilm& film, double thickness_nm, const FilmColours* colours,
                    const Wavelengths& wavelengths_nm);

    FloatLanes operator()(float cosine) const {
        if (!colours_) [[likely]] {
            return film_.at(cosine).reflectance(thickness_over_wavelength_);
        }
        const auto rgb = colours_->at(cosine);
        const FloatLanes sum = rgb[0] * basis_[0] + rgb[1] * basis_[1] + rgb[2] * basis_[2];
        return min_lanes(max_lanes(sum, FloatLanes{}), splat(1.0f));
    }

 private:
    optics::AiryFilm film_;
    const FilmColours* colours_;
    FloatLanes thickness_over_wavelength_;
    std::array<FloatLanes, 3> basis_;
};

FilmColours::FilmColours(const optics::AiryFilm& film, double thickness_nm, ThinFilmColour colour) {
    optics::Antialiasing how;
    if (colour == ThinFilmColour::paper) how.transform = optics::ObserverTransform::paper;
    for (int i = 0; i <= kIntervals; ++i) {
        rgb_.push_back(to_float(
            optics::antialiased_rgb(film, static_cast<double>(i) / kIntervals, thickness_nm, how)));
    }
}

spectra::Rgb FilmColours::at(float cosine) const {
    const float x = std::clamp(cosine, 0.0f, 1.0f) * kIntervals;
    const int row = std::min(static_cast<int>(x), kIntervals - 1);
    const float t = x - static_cast<float>(row);
    return rgb_[row] + t * (rgb_[row + 1] - rgb_[row]);
}

FilmReflectance::FilmReflectance(const optics::AiryFilm& film, double thickness_nm,
                                 const FilmColours* colours, const Wavelengths& wavelengths_nm)
    : film_(film), colours_(colours), basis_{} {
    thickness_over_wavelength_ =
        make_lanes([&](int i) { return static_cast<float>(thickness_nm / wavelengths_nm[i]); });
    if (!colours) return;
    const auto& basis = spectra::linear_rec709_basis();
    for (int c = 0; c < 3; ++c) {
        basis_[c] =
            make_lanes([&](int i) { return static_cast<float>(basis[c](wavelengths_nm[i])); });
    }
}

struct ThinFilm::Tables {
    paint::Recipe recipe;
    optics::AiryFilm film;
    MicrofacetDistribution facets;
    std::optional<FilmColours> colours;
};

namespace {

class BoundThinFilm final : public BoundMicrofacets<BoundThinFilm> {
 public:
    BoundThinFilm(std::shared_ptr<const ThinFilm::Tables> tables, const Wavelengths& wavelengths_nm)
        : BoundMicrofacets(tables->recipe, tables->facets, wavelengths_nm),
          tables_(std::move(tables)),
          reflectance_(tables_->film, tables_->recipe.microfacet->film_thickness_nm,
                       tables_->colours ? &*tables_->colours : nullptr, wavelengths_nm) {
        tabulate_albedo();
    }

 private:
    friend BoundMicrofacets;

    // Two directions, and what value and density share.
    struct Pair {
        Ray i, o;
        float cosine;  // w_i.h, from the half vector alone, which is symmetric in its arguments
        float density, lambda_i;

        Pair(const BoundThinFilm& b, const Ray& i, const Ray& o) : i(i), o(o) {
            const Vec3f sum = i.inside + o.inside;
            const float twice = length(sum);
            cosine = std::min(1.0f, 0.5f * twice);
            density = b.facets().density(sum * (1 / twice));
            lambda_i = b.facets().lambda(i.inside);
        }
    };

    FloatLanes mean_value(const Pair& p) const {
        if (p.density == 0) return FloatLanes{};
        const float visible =
            MicrofacetDistribution::masking_shadowing(p.lambda_i, facets().lambda(p.o.inside));
        const float geometry = 0.25f * p.density * visible / (p.i.inside.z * p.o.inside.z);
        return reflectance_(p.cosine) * geometry * coat().transfer(p.i, p.o);
    }

    // A direction into which visible facets reflect.
    std::optional<Ray> draw(const Ray& i, Vec2f u, Vec2f) const {
        const Vec3f h = facets().sample_visible(i.inside, u);
        return leave(2 * dot(i.inside, h) * h - i.inside);
    }

    // Of draw(): visible normals over the Jacobian of reflection, times that of refraction.
    float facet_density(const Pair& p) const {
        return 0.25f * p.density / (p.i.inside.z * (1 + p.lambda_i)) *
               coat().solid_angle_ratio(p.o);
    }

    std::shared_ptr<const ThinFilm::Tables> tables_;
    FilmReflectance reflectance_;
};

ThinFilm::Tables make_tables(const paint::Recipe& recipe, ThinFilmColour colour) {
    validate_microfacet_recipe(recipe);
    const paint::Microfacet& m = *recipe.microfacet;
    const optics::AiryFilm film(index_around_facets(recipe), m.film_ior, m.base_ior,
                                m.base_extinction);
    ThinFilm::Tables tables{recipe, film, MicrofacetDistribution(m.distribution, m.alpha),
                            std::nullopt};
    if (colour != ThinFilmColour::spectral) {
        tables.colours.emplace(film, m.film_thickness_nm, colour);
    }
    return tables;
}

}  // namespace

ThinFilm::ThinFilm(const paint::Recipe& recipe, ThinFilmColour colour)
    : tables_(std::make_shared<const Tables>(make_tables(recipe, colour))) {}

ThinFilm::~ThinFilm() = default;

std::unique_ptr<const BoundBsdf> ThinFilm::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundThinFilm>(tables_, wavelengths_nm);
}

namespace {

constexpr std::string_view kColourNames[] = {"spectral", "table", "paper"};
constexpr ModelOption kThinFilmOptions[] = {OptionFor<&ThinFilmModel::colour>::choice(
    "--colour",
    "thin-film: spectral (exact), or RGB by spectral antialiasing: table (Fourier transform of the "
    "observer) or paper (Gaussian fit)",
    kColourNames)};

}  // namespace

constinit const ModelInfo ThinFilmModel::info = {
    .name = "thin-film",
    .summary = "microfacets under one smooth interference film",
    .source = "Belcour and Barla 2017",
    .ingredients = Ingredients::microfacet,
    .solution = Solution::none,
    .can = {.goniochromism = true},
    .standard = standard_model<ThinFilmModel>,
    .options = kThinFilmOptions};

std::string ThinFilmModel::text() const {
    return fmt::format("colour={}", kColourNames[static_cast<int>(colour)]);
}

std::shared_ptr<const Bsdf> ThinFilmModel::make(const ModelInput& input, const Progress&) const {
    return std::make_shared<const ThinFilm>(input.recipe, colour);
}

}  // namespace nacre::bsdf
