#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/models/special_effect.h"
#include "nacre/bsdf/models/thin_film.h"
#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/core/references.h"
#include "nacre/exchange/material_fit.h"
#include "nacre/fit/fit.h"
#include "nacre/fit/free_keys.h"
#include "nacre/fit/uncertainty.h"
#include "nacre/measure/acquire.h"
#include "nacre/measure/geometry.h"
#include "nacre/measure/instrument.h"
#include "nacre/measure/measurement.h"
#include "nacre/measure/sparkle_measurement.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/montecarlo/reference.h"
#include "nacre/montecarlo/shell_walk.h"
#include "nacre/paint/parameter_correlation.h"
#include "nacre/paint/parameter_deviation.h"
#include "nacre/paint/recipe.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/solver/solved_paint.h"

// The front door: open a paint, look at it, measure it, fit it, export it.
//
//   const nacre::Paint paint = nacre::open("violet.toml");
//   const auto look = paint.appearance(nacre::NacreModel{.specimen = 1});  // for a renderer
//   const auto brdf = paint.brdf();                            // by values
//   const auto readings = paint.measure(nacre::geometries("byk-mac"));
//   const auto match = paint.fit(readings.measurement, {"coats[0].thickness_nm"});
//   paint.export_rgl().write("violet.bsdf");
//
// Everything here is a value: copies share what they hold, may be used from any number of threads
// at once, and give the same bits on all of them. Nothing is printed; long work reports through a
// Progress and may be stopped by it (core/progress.h); what goes wrong is thrown (core/error.h):
// InputError where a file is wrong, naming file, key, value and allowed range; SettingError, a
// DomainError, where a setting is; Error where the work itself failed or was stopped. Units and
// conventions: docs/conventions.md.
//
// Link nacre::nacre (find_package(nacre COMPONENTS core)). Pictures need ray tracing, and have a
// header of their own: nacre/render.h. Measuring and fitting are members of Paint, as
// nacre::measure, nacre::fit and nacre::render are namespaces.

namespace nacre::bsdf {
struct NacreArrays;  // bsdf/models/nacre_arrays.h
enum class ArrayParts;
}  // namespace nacre::bsdf

namespace nacre {

using measure::Aperture;
using measure::Geometry;
using measure::Measurement;
using measure::MerlSettings;
using measure::RglSettings;
using measure::SparkleCamera;
using measure::Viewing;
using montecarlo::Direction;
using spectra::Illuminant;
using spectra::Observer;

// A model is chosen by a value of its settings type; any of them is a Model. The first is the
// default.
using bsdf::MicroflakeModel;
using bsdf::Model;
using bsdf::NacreModel;
using bsdf::SpecialEffectModel;
using bsdf::ThinFilmModel;
using montecarlo::VolumeModel;
using montecarlo::WalkModel;

/// A setting is out of range, or does not fit the paint that it is for.
class SettingError : public DomainError {
 public:
    /// The message is "setting = value: reason", or "setting: reason".
    SettingError(const std::string& setting, const std::string& reason,
                 const std::string& value = {})
        : DomainError(setting + (value.empty() ? "" : " = " + value) + ": " + reason),
          setting_(setting),
          reason_(reason) {}

    /// From such a message.
    explicit SettingError(const std::string& message);

    const std::string& setting() const { return setting_; }
    const std::string& reason() const { return reason_; }

 private:
    std::string setting_, reason_;
};

/// What a file holds. Its contents tell, not its name.
enum class Kind {
    recipe,           ///< TOML (docs/recipe.md)
    solved_paint,     ///< a recipe and its solution, HDF5
    brdf_table,       ///< raw or SVD, HDF5 (docs/tables.md)
    measured_brdf,    ///< of the RGL database (.bsdf) or of MERL (.binary)
    measured_colours  ///< of a multi-angle instrument, CSV, JSON or CGATS (docs/measure.md)
};

/// A text that is none of the others counts as a recipe, whose reader says what is wrong with it.
Kind kind_of(std::string_view bytes);

/// How a recipe is solved.
struct SolveSettings {
    /// Vacuum wavelengths, nm; order and repetitions do not matter. Empty: 400 to 700 by 10.
    std::vector<double> wavelengths_nm = {};
    solver::SolverSettings resolution = {};

    friend bool operator==(const SolveSettings&, const SolveSettings&) = default;
};

/// The largest number of wavelengths that are solved at once.
inline constexpr std::size_t kMaxSolvedWavelengths = 2000;

/// A quantity that the solver could not resolve, so that multiple scattering is less accurate.
struct SolverWarning {
    enum class What { scattering, azimuthal_series } what;
    bool held_back = false;  ///< by SolverSettings; with 0 there, more would have been chosen
    std::string message;     ///< naming file, quantity, value and what does no harm
};

/// The warnings about a solved paint. `file` is for the messages.
std::vector<SolverWarning> solver_warnings(const solver::SolvedPaint& paint,
                                           const std::string& file);

/// Which values of a BRDF are wanted.
struct BrdfSettings {
    /// None: models::default_model(), and measured BRDFs as they are.
    std::optional<Model> model = {};
    Part part = Part::total;  ///< other than the total: of models that can tell (Capabilities)
    /// Vacuum wavelengths, nm. Empty: those of the solved paint where the values are its own, else
    /// 400 to 700 by 10.
    std::vector<double> wavelengths_nm = {};
    /// As a renderer gets the paint, rather than exactly: a hundred times faster, in single
    /// precision, multiple scattering interpolated in tables; off by less than
    /// bsdf::kMicroflakeError of the peak, or kMicroflakeRoughError under a rough coat. Over the
    /// shipped paints at byk-mac's angles that is up to 2.6 % of values above a thousandth of the
    /// largest, and up to 0.28 in CIEDE2000.
    bool as_rendered = false;
    /// Whether values of patches are wanted as well, PaintBrdf::on(): then single flakes are made at once,
    /// which takes most of the time, and else when the first patch is looked at.
    bool patches = false;
};

/// The BRDF of a paint by values: those of the solved paint in double precision where the model is
/// no more than its solution (microflake), else those that a renderer gets.
class PaintBrdf {
 public:
    const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }
    /// In 1/sr at each wavelength, without the specular lobe of a smooth interface, the mean over
    /// the surface; angles in rad, theta in [0, pi/2), phi = phi_o - phi_i, pi being the mirror
    /// side.
    /// @throws DomainError if an angle is out of range
    std::vector<double> operator()(double theta_i, double theta_o, double phi) const {
        return values_(theta_i, theta_o, phi);
    }

    /// The coordinates by which it varies over the surface, which it does where single flakes show.
    bsdf::SurfaceCoordinates surface_coordinates() const { return coordinates_; }
    /// What on() takes: mm on a flat panel, or fractions of the object's unit square.
    Range place_range() const;
    Range side_range() const;
    /// The same on a square patch about (x, y), with its own flakes instead of their mean.
    /// @throws DomainError if the surface does not vary, or a number is out of range
    PaintBrdf on(double x, double y, double side) const;

 private:
    friend class Paint;
    std::vector<double> wavelengths_nm_;
    measure::Brdf values_;
    bsdf::SurfaceCoordinates coordinates_ = bsdf::SurfaceCoordinates::none;
    std::function<measure::Brdf(const bsdf::Patch&)> values_on_;
};

/// How a paint is measured. A setting that is not given is that of the file, where it holds
/// measured colours, or else the default that stands beside it.
struct MeasureSettings {
    std::optional<Model> model = {};            ///< as in BrdfSettings
    std::optional<Illuminant> illuminant = {};  ///< D65
    std::optional<Observer> observer = {};      ///< 10 degrees
    std::optional<Aperture> aperture = {};      ///< of lamp and detector; points
    /// Vacuum wavelengths in equal steps, nm. Empty: as BrdfSettings::wavelengths_nm.
    std::vector<double> wavelengths_nm = {};
    std::uint64_t walks = std::uint64_t{1} << 18;  ///< per lamp, of models that follow light
    std::uint64_t seed = 0;                        ///< of those walks
};

struct Readings {
    Measurement measurement;
    /// Of the reflectance factor, by reading and wavelength; empty where values are not estimates.
    std::vector<std::vector<double>> standard_error = {};

    /// As a file that open() reads (docs/measure.md).
    std::string csv() const;
};

using measure::kDefaultGeometries;

/// A set that is built in ("byk-mac"), a file of a set (.toml), or a list as in
/// "45as15,45as25az90,45to30,90".
/// @throws DomainError if it is none of these; InputError if the file is wrong
std::vector<Geometry> geometries(const std::string& text);

/// How a BRDF is estimated by random walks.
struct ReferenceSettings {
    /// Vacuum wavelengths, nm. Empty: 400 to 700 by 10.
    std::vector<double> wavelengths_nm = {};
    montecarlo::ReferenceSettings walks = {};
};

/// The bytes of a file, and its error against the values that it was made from.
struct Exported {
    std::string bytes;
    measure::TableError error;

    /// Whole or not at all. @throws InputError, Error as core/file.h
    void write(const std::filesystem::path& path) const;
};

/// A material of another renderer's format that looks like the paint as nearly as a fit makes it.
struct FittedMaterial {
    std::string format;  ///< for people: "glTF 2.0"
    std::string bytes;   ///< of the file
    /// By the format's names, in its order.
    std::vector<std::pair<std::string, double>> parameters;
    exchange::MaterialFit fit;  ///< and how far it remains from the paint

    /// Whole or not at all. @throws InputError, Error as core/file.h
    void write(const std::filesystem::path& path) const;
};
enum class MaterialFormat { gltf, materialx, cycles };

/// The paint's own model as a shader, for a program that takes one.
struct ShaderMaterial {
    std::string bytes;     ///< of the file
    std::string model;     ///< that the shader shows
    std::string standard;  ///< the model by which the paint is seen that the difference is from
    /// From the paint at exchange::shader_geometries() under D65 for 2 degrees.
    measure::Difference difference;

    /// Whole or not at all. @throws InputError, Error as core/file.h
    void write(const std::filesystem::path& path) const;
};

struct SparkleSettings {
    SparkleCamera camera = {};
    Viewing viewing = {};
};
struct SparkleReadings {
    measure::PanelPictures pictures;
    measure::SparkleMeasurement measurement;
};
/// Takes pictures of a panel with a virtual camera and reads sparkle and graininess off them.
/// @throws DomainError, Error as measure::take_pictures() and measure::measure_pictures()
SparkleReadings measure_sparkle(const bsdf::Bsdf& look, const SparkleSettings& settings = {},
                                const Progress& progress = {});

namespace io {
struct RecipeText;  // io/recipe_text.h
struct TypedFile;   // io/file_kind.h
}  // namespace io

using FitSettings = fit::FitOptions;
struct Match;

using fit::Uncertainty;
struct UncertaintySettings {
    /// How well numbers are known, in addition to Paint::deviations() or in their place. Keys as
    /// paint::matching_parameters().
    std::vector<paint::ParameterDeviation> deviations = {};
    int samples = 0;         ///< recipes drawn and read besides (fit::UncertaintyOptions); 0: none
    std::uint64_t seed = 0;  ///< of these
    /// Which numbers are wrong together, in addition to Paint::correlations(); of a pair, in place of
    /// what these say. Keys as paint::matching_parameters(); one with `*` means those of its numbers
    /// that have a standard deviation.
    std::vector<paint::ParameterCorrelation> correlations = {};
};
/// Whether a model gives exact values, whose uncertainty differences can tell: not estimates, nor
/// tables made of them, nor pictures alone.
bool has_uncertainty(const Model& model);

/// The bytes of a file, and which sample of its measured colours is meant, as for open_text().
struct PaintContents {
    std::string bytes, sample = {};
};

class Paint;
/// A paint that is fitted to a standard's colours is seen by the model that saw the standard, or, where
/// that cannot be (Capabilities::fitted), by the equation of transfer; but if the standard was measured,
/// no model saw it, and such a model would have no part in the fit at all.
/// @throws SettingError naming the model, the standard and the models that are possible then
void require_part_in_fit(const Model& model, const Paint& standard);

class Paint {
 public:
    /// A paint that no file holds.
    /// @param bounds  between which a fit seeks its numbers, as the table [fit] of a recipe's file
    /// @param deviations  how well numbers are known, as its table [uncertainty]
    /// @param correlations  which of these are wrong together
    /// @throws DomainError as paint::validate(), check_bounds(), check_deviation() and
    ///         check_correlations()
    explicit Paint(paint::Recipe recipe, std::vector<paint::ParameterBounds> bounds = {},
                   std::vector<paint::ParameterDeviation> deviations = {},
                   std::vector<paint::ParameterCorrelation> correlations = {});

    Kind kind() const;
    /// The file as it was opened, or what a text was said to be; empty for a recipe alone.
    const std::string& file() const;
    /// The recipe's name, or where it has none the file's, without folder and extension.
    std::string name() const;

    bool has_recipe() const;
    /// Whether the file holds a measured BRDF or measured colours, which need no model.
    bool is_measured() const;
    /// What was decided about measured colours that their file does not say, such as a scale in
    /// percent; each names the file.
    const std::vector<std::string>& notes() const;
    /// @throws InputError naming the file if it holds none: tables and measured values
    const paint::Recipe& recipe() const;
    /// SHA-256 of what the recipe says (io/recipe_file.h); empty without a recipe.
    std::string recipe_sha256() const;
    /// SHA-256 of the file of a solved paint, a table or a measured BRDF; empty of others.
    const std::string& file_sha256() const;
    /// The table [fit] of a recipe's file.
    const std::vector<paint::ParameterBounds>& bounds() const;
    /// The table [uncertainty] of a recipe's file.
    const std::vector<paint::ParameterDeviation>& deviations() const;
    /// Its tables [[uncertainty.correlation]].
    const std::vector<paint::ParameterCorrelation>& correlations() const;
    /// The key of the one number that a key, or the end of one, means: "coats[0].thickness_nm".
    /// @param key  as paint::matching_parameters()
    /// @throws InputError as recipe(); DomainError if there is no such number; SettingError named as the
    ///         key if it means several
    std::string whole_key(std::string_view key) const;
    /// The same paint with one number changed, to be solved anew.
    /// @param key  as whole_key()
    /// @throws InputError, SettingError as whole_key(); DomainError naming key, value and range
    Paint with(std::string_view key, double value) const;
    /// The same with any values of the recipe changed, numbers and texts, as a user writes them:
    /// {{"coats[0].material", "SiO2"}, {"alpha", "0.2"}}. Keys and values: io::with_settings().
    /// @throws InputError as recipe(); DomainError "key=value: reason"
    Paint with_settings(const std::vector<std::pair<std::string, std::string>>& settings) const;
    /// The same recipe that says how well these numbers are known, in place of what it said of them;
    /// correlations of theirs with others are forgotten.
    /// @throws InputError as recipe(); DomainError as paint::check_deviation() and
    ///         check_correlations()
    Paint with_uncertainty(const std::vector<paint::ParameterDeviation>& deviations,
                           const std::vector<paint::ParameterCorrelation>& correlations = {}) const;
    /// The recipe as a file that keeps what a person wrote into the one that it was read from.
    /// @param there  the files that it may name where it will stand
    /// @throws InputError as recipe()
    io::RecipeText recipe_text(const References& there) const;

    /// The paint solved: as its file holds it, whatever the settings' resolution, or its recipe
    /// solved, once for all copies of this paint, when first asked with such settings; the last
    /// eight are kept.
    /// @throws InputError as recipe(), if the recipe cannot be solved, or if the file holds the
    ///         solution at other wavelengths
    /// @throws DomainError if the settings are out of range; Error as solver::solve()
    std::shared_ptr<const solver::SolvedPaint> solved(const SolveSettings& settings = {},
                                                      const Progress& progress = {}) const;
    /// The memory in bytes that solving it takes, about: solver::memory_to_solve(). 0 where the
    /// file holds a solution.
    /// @throws as solved()
    std::size_t memory_to_solve(const SolveSettings& settings = {}) const;
    /// Of all solutions so far.
    std::vector<SolverWarning> warnings() const;
    /// The numbers that can be computed with and are hardly meant, the file before each: of a recipe
    /// by paint::implausible_numbers(), of measured colours where columns of this sample contradict
    /// each other (io::MeasurementFile::contradictions). None of other kinds.
    std::vector<std::string> implausible_numbers() const;

    /// The paint as a model shows it, for a renderer; measured and tabulated BRDFs as they are.
    /// Made once for all who hold it at a time.
    /// @param model  none: models::default_model(), and measured BRDFs as they are
    /// @param solve  where the model needs the paint solved
    /// @throws InputError naming the file if it lacks what the model reads, or is shown without one
    /// @throws SettingError if the file holds another kind of table than the model makes
    /// @throws DomainError, Error as solved() and Model::make()
    std::shared_ptr<const bsdf::Bsdf> appearance(const std::optional<Model>& model = {},
                                                 const SolveSettings& solve = {},
                                                 const Progress& progress = {}) const;
    /// @throws InputError, DomainError, Error as appearance(); DomainError if the model follows
    ///         light and has no values to give, or a part is asked for that it cannot tell
    PaintBrdf brdf(const BrdfSettings& settings = {}, const Progress& progress = {}) const;

    /// What a multi-angle spectrophotometer reads on the paint. Measured colours are what was read:
    /// the geometries asked for are picked, colours stated anew under the light asked for. A model
    /// that follows light gives estimates, read by the walks of montecarlo/reference.h.
    /// @param geometries  empty: those of measured colours; else kDefaultGeometries
    /// @throws InputError as brdf(), or naming file and geometry where measured colours cannot be
    ///         stated as asked; DomainError, Error as measure::measure()
    Readings measure(const std::vector<Geometry>& geometries = {},
                     const MeasureSettings& settings = {}, const Progress& progress = {}) const;

    /// The BRDF by a random walk through the recipe that is independent of the solver
    /// (docs/reference.md): a check of everything else that gives values.
    /// @return  in 1/sr, [incident][outgoing][wavelength], row-major, with standard errors
    /// @throws SettingError naming incident, outgoing, wavelength or samples where it is out of range;
    ///         InputError as recipe(), or naming the file where light cannot be followed through the
    ///         recipe; Error as montecarlo::reference_brdf()
    std::vector<Estimate> reference(std::span<const Direction> incident,
                                    std::span<const Direction> outgoing,
                                    const ReferenceSettings& settings = {},
                                    const Progress& progress = {}) const;

    /// How far those readings are spread if numbers of the recipe are known to standard deviations
    /// only: the paint is solved anew beside each of them (docs/uncertainty.md).
    /// @param settings  the model must be one of values, not of estimates
    /// @throws InputError as recipe(), or where the recipe cannot be solved; SettingError where the
    ///         model gives no values; DomainError, Error as fit::uncertainty()
    Uncertainty measure_uncertainty(const std::vector<Geometry>& geometries = {},
                                    const MeasureSettings& settings = {},
                                    const UncertaintySettings& uncertainty = {},
                                    const Progress& progress = {}) const;

    /// The BRDF as the files of the RGL database hold it, or those of MERL, for other renderers.
    /// The specular lobe of a smooth interface is not part of it.
    /// @param settings  as_rendered is taken as true, part as total
    /// @throws InputError, DomainError, Error as brdf() and measure/acquire.h; InputError if the
    ///         BRDF is anisotropic
    Exported export_rgl(const RglSettings& rgl = {}, const BrdfSettings& settings = {},
                        const Progress& progress = {}) const;
    Exported export_merl(const MerlSettings& merl = {}, const BrdfSettings& settings = {},
                         const Progress& progress = {}) const;
    /// A material of a renderer that knows no paints, fitted to the paint's colours at
    /// exchange::fit_geometries(), and its differences there and at angles that the fit did not see.
    /// A smooth interface of the paint becomes the format's clearcoat, whose reflection no angle
    /// reads; a paint without a recipe is taken to have none.
    /// @param settings  as_rendered and part have no part in it
    /// @throws InputError, DomainError, Error as measure(); Error as exchange::fit_material()
    FittedMaterial export_material(MaterialFormat format, const BrdfSettings& settings = {},
                                   const Progress& progress = {}) const;
    /// An ES module with a material of three.js that shows the mean of a model by a shader.
    /// @param model  one of bsdf::Model::makes_arrays(); none: models::default_picture_model()
    /// @throws InputError as recipe(), or what bsdf::Model::make_arrays() refuses of it; SettingError if
    ///         it is another model, or renders from tables; DomainError as
    ///         exchange::make_webgl_shader()
    ShaderMaterial export_threejs(const std::optional<Model>& model = {},
                                  const Progress& progress = {}) const;
    /// What such shaders, and renderers with programs of their own, compute the paint from.
    /// @throws as export_threejs()
    bsdf::NacreArrays arrays(const Model& model, bsdf::ArrayParts parts,
                             const Progress& progress = {}) const;
    /// The bytes of a file of the solved paint. @throws as solved() and io::solved_paint_bytes()
    std::string export_solved(const SolveSettings& settings = {},
                              const Progress& progress = {}) const;
    /// The bytes of a file of the table that a model renders from.
    /// @throws as solved() and Model::make_table(); DomainError if the model makes no table
    std::string export_table(const Model& model, const SolveSettings& solve = {},
                             const Progress& progress = {}) const;

    /// For copies in other processes: files that open_text() opens to an equal paint, whatever has become
    /// of those that this one is from.
    PaintContents contents() const;

    /// Seeks the composition, starting from this one, whose colours are nearest to a standard's.
    /// @param keys  of the numbers that may change, as fit::free_keys(); empty: those between
    ///        bounds()
    /// @throws InputError as recipe(), or without layers; DomainError, Error as fit::fit()
    Match fit(const Measurement& standard, const std::vector<std::string>& keys = {},
              const FitSettings& settings = {}, const Progress& progress = {}) const;
    /// The numbers that such keys mean, and those among them that cannot be free.
    /// @throws InputError as recipe(); DomainError if there are none, or as fit::free_keys()
    fit::FreeKeys free_keys(const std::vector<std::string>& patterns,
                            const FitSettings& settings = {}, const Progress& progress = {}) const;

 private:
    struct State;
    friend Paint open_typed(io::TypedFile file, const std::string& sample);
    explicit Paint(std::shared_ptr<const State> state) : state_(std::move(state)) {}

    std::shared_ptr<const State> state_;  // never null
};

/// What a fit found: its numbers, how sure they are, and the paint that they make.
struct Match : fit::Fit {
    Paint paint;
    std::vector<fit::SkippedNumber> skipped;  ///< which keys with `*` meant, but cannot be free
};

/// Measures two panels so that they can be compared: beside measured colours, a paint is measured
/// as those were, except for what is asked for. The model is for those that take one.
/// @return  of the sample and of the standard
/// @throws InputError, DomainError, Error as Paint::measure()
std::pair<Readings, Readings> measure_alike(const Paint& sample, const Paint& standard,
                                            const std::vector<Geometry>& geometries = {},
                                            const MeasureSettings& settings = {},
                                            const Progress& progress = {});

/// The names of the recipes that ship with Nacre (paints/), as "ruby", by alphabet.
/// @throws InputError as data_directory()
std::vector<std::string> shipped_paints();

/// The file that a text names: a stream ("-"), a file that exists, or, of a text without a slash,
/// the shipped paint of this name.
/// @throws InputError naming the text, with what may have been meant, if it is neither
std::filesystem::path find_paint(const std::string& text);

/// Reads a file of any kind, once: the paint needs it no more. One sample of several in a file of
/// measured colours is named behind '#', as in "panels.csv#Silver 2". Materials that a recipe names as
/// files are read too, wherever they are; "-" is the standard input (core/file.h), whose recipes may
/// name no files.
/// @throws InputError naming the file and what is wrong in it
Paint open(const std::filesystem::path& path);

/// The same for a file from elsewhere, which must not reach those of its reader.
/// @param references  the files that a recipe may name: References::within() a folder, or none
Paint open(const std::filesystem::path& path, const References& references);

/// The same from the contents of a file.
/// @param name        for messages
/// @param references  as open(); a folder for files anywhere, relative names starting there
/// @param sample  of measured colours that hold several; empty: there is one
/// @throws InputError as open()
Paint open_text(std::string bytes, const std::string& name, const References& references = {},
                const std::string& sample = {});

/// The same from a file that has been told apart (io::typed_file()).
Paint open_typed(io::TypedFile file, const std::string& sample = {});

}  // namespace nacre
