#pragma once

#include <any>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/progress.h"
#include "nacre/paint/recipe.h"

// What an appearance model is to the rest of Nacre: an entry that describes it (ModelInfo), and a
// struct of settings of its own, which makes a surface of a paint. Both are defined beside the
// model itself; nacre/models/models.h lists them, and everything else asks the entries.
//
// A settings type M is a copyable struct with ==, whose default is the model as it is without any
// choice, and has
//
//     static const ModelInfo info;
//     std::shared_ptr<const Bsdf> make(const ModelInput&, const Progress&) const;
//     std::string text() const;  every setting, as in "specimen=1 hot_spot=false"
//
// and, where they mean something,
//
//     std::uint64_t specimen;    which panel of the batch: the seed of its flakes, facets and waves
//     void lie_on(const std::string& material, std::span<const PaintedShape>);
//     std::optional<BrdfTable> make_table(const solver::SolvedPaint&, const Progress&) const;
//     bool makes_table() const;
//     void require_kind(const BrdfTable&, const std::string& file) const;
//     std::shared_ptr<const Bsdf> make_mean(std::shared_ptr<const solver::SolvedPaint>,
//                                           const Progress&) const;
//     bool makes_arrays() const;
//     std::shared_ptr<NacreArrays> make_arrays(const std::shared_ptr<const solver::SolvedPaint>&,
//                                              ArrayParts, const Progress&) const;
//     bool shows_hot_spot() const;
//
// which Model's members of the same name explain.

namespace nacre::solver {
struct SolvedPaint;
}

namespace nacre::bsdf {

class Model;
struct ModelInfo;
struct NacreArrays;  // bsdf/models/nacre_arrays.h
enum class ArrayParts;
struct RawBrdfTable;
struct CompressedBrdfTable;

/// A BRDF as a table of RGB values, raw or compressed; shared, as it is large.
using BrdfTable =
    std::variant<std::shared_ptr<const RawBrdfTable>, std::shared_ptr<const CompressedBrdfTable>>;

/// What a model can show and tell. The first three are the columns of Table 3 of Mir et al.
/// [mir-2022]; tests measure them.
struct Capabilities {
    bool goniochromism = false;        ///< colour that turns with angle
    bool sparkle = false;              ///< single flakes that flash
    bool multiple_scattering = false;  ///< between flakes and between layers
    bool reference_only = false;       ///< an unbiased simulation: no values, only pictures
    /// Reference: montecarlo::reference_brdf() estimates its values, with standard errors.
    bool estimated_values = false;
    /// Tells light that met one flake from what was scattered again (nacre::Part).
    bool parts = false;
    /// Paints can be sought by their colours as it shows them (nacre/fit), with or without its hot spot.
    bool fitted = false;
};

/// Which part of a recipe a model reads: layers, or [microfacet] without or with its facets.
enum class Ingredients { layers, microfacet, facets };

/// What a model is made from: the recipe, with the option that some models have of its solution.
enum class Solution {
    none,    ///< the recipe alone
    solved,  ///< a solved paint
    table    ///< a solved paint, or a BRDF table that was made of it
};

/// A setting that users choose by a name, as on the command line: a switch, one of several names,
/// or a whole number.
struct ModelOption {
    std::string_view flag;  ///< "--table"
    std::string_view help;
    /// One of several: the names of the values 0, 1, ...
    std::span<const std::string_view> names = {};
    /// A number: its range. A switch has neither names nor a range.
    std::optional<std::pair<int, int>> range = {};
    /// Says in which form a solution is kept, hence is for `nacre solve` as well.
    bool of_solution = false;
    int (*get)(const Model&) = nullptr;
    void (*set)(Model&, int) = nullptr;
};

/// How a model is chosen that shows the same paint as another one in another way, under the other's
/// name: by an option beside the other's own.
struct Alternative {
    const ModelInfo* to;    ///< the other model
    std::string_view flag;  ///< "--flakes"
    std::string_view help;
    std::string_view usual;  ///< the option's value that means the other model
    std::string_view value;  ///< and that means this one
    /// Takes over what was chosen about the other model.
    /// @throws DomainError if this one has no such choice
    Model (*from)(const Model& other);
};

/// One entry of the list of models.
struct ModelInfo {
    std::string_view name;     ///< on the command line
    std::string_view summary;  ///< in one line
    std::string_view source;   ///< authors and year
    Ingredients ingredients;
    Solution solution;
    Capabilities can;
    /// By what its surfaces vary: Bsdf::surface_coordinates().
    SurfaceCoordinates coordinates = SurfaceCoordinates::none;
    Model (*standard)();  ///< the model with its default settings
    std::span<const ModelOption> options = {};
    const Alternative* alternative = nullptr;  ///< null: chosen by its own name
};

/// What a surface is made from.
struct ModelInput {
    paint::Recipe recipe = {};                               ///< not needed with `table`
    std::shared_ptr<const solver::SolvedPaint> solved = {};  ///< needed by ModelInfo::solution,
    std::optional<BrdfTable> table = {};                     ///< unless there is a table
};

/// A shape that a paint lies on, for models that must know it.
struct PaintedShape {
    enum class Kind { sphere, panel, other } kind = Kind::other;
    double radius_mm = std::numeric_limits<double>::infinity();  ///< of a sphere
    double width_mm = 0, height_mm = 0;                          ///< of a flat panel
};

template <class M>
concept ModelSettings = std::same_as<decltype((M::info)), const ModelInfo&>;

/// The last whole number up to which a double holds all.
inline constexpr std::uint64_t kMaxSpecimen = std::uint64_t{1} << 53;

/// A model and what was chosen about it: any of the settings types, as a value.
class Model {
 public:
    template <ModelSettings M>
    Model(M settings)
        : settings_(std::move(settings)), operations_(&kOperations<M>) {}  // NOLINT: converts

    const ModelInfo& info() const { return *operations_->info; }
    /// Null if it is another model.
    template <ModelSettings M>
    const M* get() const {
        return std::any_cast<M>(&settings_);
    }
    template <ModelSettings M>
    M* get() {
        return std::any_cast<M>(&settings_);
    }

    /// The surface that the model makes of a paint.
    ///
    /// @throws DomainError if the recipe lacks what the model reads (layers or [microfacet] with
    ///         its [microfacet.facets]), holds what it cannot do, the solution is missing, or a
    ///         setting is out of range
    /// @throws Error if `progress` asks to stop
    std::shared_ptr<const Bsdf> make(const ModelInput& input, const Progress& progress = {}) const;

    /// Which panel of the batch is seen, at most kMaxSpecimen; nothing to a model for which all panels
    /// look alike.
    void set_specimen(std::uint64_t specimen);
    /// Empty for a model for which all panels look alike.
    std::optional<std::uint64_t> specimen() const;
    /// Tells a model that must know it what the paint lies on; nothing to others.
    /// @param material  its name, for messages
    /// @throws DomainError if the model does not go on these shapes
    void lie_on(const std::string& material, std::span<const PaintedShape> shapes);

    /// Whether it renders from a BRDF table rather than from the solved paint itself.
    bool makes_table() const;
    /// The table that it renders from; none if it renders from the solved paint itself.
    /// @throws as make_raw_table() and compress()
    std::optional<BrdfTable> make_table(const solver::SolvedPaint& paint,
                                        const Progress& progress = {}) const;
    /// @param file  that the table was read from, for messages
    /// @throws DomainError if another kind of table was chosen than this one
    void require_kind(const BrdfTable& table, const std::string& file) const;

    /// Whether make_mean() can be called.
    bool makes_mean() const { return operations_->make_mean; }
    /// A surface for its mean alone, bit for bit that of make(), in a fraction of the time: only
    /// BoundBsdf::eval() may be called, or where flakes lean bind_with_lean()'s.
    /// @throws as make()
    std::shared_ptr<const Bsdf> make_mean(std::shared_ptr<const solver::SolvedPaint> paint,
                                          const Progress& progress = {}) const;

    /// Whether make_arrays() can be called, by this model with these settings.
    bool makes_arrays() const;
    /// What programs that evaluate the model themselves compute it from; never null.
    /// @throws DomainError, Error as make(); DomainError if the paint has what the arrays do not hold
    std::shared_ptr<NacreArrays> make_arrays(
        const std::shared_ptr<const solver::SolvedPaint>& paint, ArrayParts parts,
        const Progress& progress = {}) const;

    /// Whether its mean has the hot spot of large flakes (HotSpotTables), which the equation of
    /// transfer does not know.
    bool shows_hot_spot() const;

    /// The model's name and every setting, for records and fingerprints: alike for equal models
    /// alone.
    std::string text() const;

    friend bool operator==(const Model& a, const Model& b) {
        return a.operations_ == b.operations_ && a.operations_->equal(a.settings_, b.settings_);
    }

 private:
    struct Operations {
        const ModelInfo* info;
        std::shared_ptr<const Bsdf> (*make)(const std::any&, const ModelInput&, const Progress&);
        bool (*equal)(const std::any&, const std::any&);
        std::string (*text)(const std::any&);
        void (*set_specimen)(std::any&, std::uint64_t);
        std::uint64_t (*specimen)(const std::any&);
        void (*lie_on)(std::any&, const std::string&, std::span<const PaintedShape>);
        bool (*makes_table)(const std::any&);
        std::optional<BrdfTable> (*make_table)(const std::any&, const solver::SolvedPaint&,
                                               const Progress&);
        void (*require_kind)(const std::any&, const BrdfTable&, const std::string&);
        std::shared_ptr<const Bsdf> (*make_mean)(const std::any&,
                                                 std::shared_ptr<const solver::SolvedPaint>,
                                                 const Progress&);
        bool (*makes_arrays)(const std::any&);
        std::shared_ptr<NacreArrays> (*make_arrays)(
            const std::any&, const std::shared_ptr<const solver::SolvedPaint>&, ArrayParts,
            const Progress&);
        bool (*shows_hot_spot)(const std::any&);
    };

    template <class M>
    static const M& as(const std::any& settings) {
        return *std::any_cast<M>(&settings);
    }
    template <class M>
    static M& as(std::any& settings) {
        return *std::any_cast<M>(&settings);
    }

    template <class M>
    static constexpr Operations operations() {
        Operations all{};
        all.info = &M::info;
        all.make = [](const std::any& s, const ModelInput& input, const Progress& progress) {
            return as<M>(s).make(input, progress);
        };
        all.equal = [](const std::any& a, const std::any& b) { return as<M>(a) == as<M>(b); };
        all.text = [](const std::any& s) { return as<M>(s).text(); };
        if constexpr (requires(M m) { m.specimen; }) {
            all.set_specimen = [](std::any& s, std::uint64_t n) { as<M>(s).specimen = n; };
            all.specimen = [](const std::any& s) { return as<M>(s).specimen; };
        }
        if constexpr (requires { &M::lie_on; }) {
            all.lie_on = [](std::any& s, const std::string& material,
                            std::span<const PaintedShape> shapes) {
                as<M>(s).lie_on(material, shapes);
            };
        }
        if constexpr (requires { &M::make_table; }) {
            all.makes_table = [](const std::any& s) { return as<M>(s).makes_table(); };
            all.make_table = [](const std::any& s, const solver::SolvedPaint& paint,
                                const Progress& progress) {
                return as<M>(s).make_table(paint, progress);
            };
            all.require_kind = [](const std::any& s, const BrdfTable& table,
                                  const std::string& file) { as<M>(s).require_kind(table, file); };
        }
        if constexpr (requires { &M::make_mean; }) {
            all.make_mean = [](const std::any& s, std::shared_ptr<const solver::SolvedPaint> paint,
                               const Progress& progress) {
                return as<M>(s).make_mean(std::move(paint), progress);
            };
        }
        if constexpr (requires { &M::make_arrays; }) {
            all.makes_arrays = [](const std::any& s) { return as<M>(s).makes_arrays(); };
            all.make_arrays = [](const std::any& s,
                                 const std::shared_ptr<const solver::SolvedPaint>& paint,
                                 ArrayParts parts, const Progress& progress) {
                return as<M>(s).make_arrays(paint, parts, progress);
            };
        }
        if constexpr (requires { &M::shows_hot_spot; }) {
            all.shows_hot_spot = [](const std::any& s) { return as<M>(s).shows_hot_spot(); };
        }
        return all;
    }
    template <class M>
    static constexpr Operations kOperations = operations<M>();

    std::any settings_;
    const Operations* operations_;
};

/// ModelInfo::standard of a settings type.
template <ModelSettings M>
Model standard_model() {
    return M{};
}

/// The value of an option, as users write it: a name, a number, "on" or "off".
std::string option_text(const Model& model, const ModelOption& option);
/// @param model  one that has this option
/// @throws DomainError naming option, value and the values that are allowed
void set_option(Model& model, const ModelOption& option, std::string_view text);

/// An option that sets a member of a settings type: a bool is a switch, an enumeration one of
/// several names, an int a number within a range.
template <auto member>
struct OptionFor;

template <class M, class T, T M::*member>
struct OptionFor<member> {
    static int get(const Model& model) { return static_cast<int>(model.get<M>()->*member); }
    static void set(Model& model, int value) { model.get<M>()->*member = static_cast<T>(value); }

    static constexpr ModelOption toggle(std::string_view flag,
                                        std::string_view help) requires std::same_as<T, bool> {
        return {.flag = flag, .help = help, .get = get, .set = set};
    }
    static constexpr ModelOption choice(
        std::string_view flag, std::string_view help,
        std::span<const std::string_view> names) requires std::is_enum_v<T> {
        return {.flag = flag, .help = help, .names = names, .get = get, .set = set};
    }
    static constexpr ModelOption number(std::string_view flag, std::string_view help, int lo,
                                        int hi) requires std::same_as<T, int> {
        return {.flag = flag, .help = help, .range = std::pair{lo, hi}, .get = get, .set = set};
    }
};

}  // namespace nacre::bsdf
