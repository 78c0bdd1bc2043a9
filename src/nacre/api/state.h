#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/io/recipe_file.h"
#include "nacre/nacre.h"

// What copies of a paint share. Internal to this folder.

namespace nacre {

/// A measured BRDF as it is shown.
struct MeasuredBrdf {
    std::shared_ptr<const bsdf::Bsdf> surface;
    bool isotropic = true;
    std::string bytes = {};  ///< of the file, for copies in other processes
};

/// Measured colours, and their text: an aperture that it does not state may be chosen later.
struct MeasuredColours {
    std::string text;
    std::string sample;  ///< which of the text's was asked for; empty: its only one
    measure::Measurement measurement;
    std::vector<std::string> notes, contradictions;
};

/// Position of a wavelength among those of a solved paint.
/// @throws InputError naming the file if it is not there
std::size_t wavelength_position(const solver::SolvedPaint& paint, double wavelength_nm,
                                const std::string& file);

/// @throws SettingError naming setting, value and range, unless the value is in it
void require_setting(const char* setting, const Range& range, double value);

/// Asks whether to go on, but reports nothing: before the work that `progress` is about, where
/// `fraction` is 0, or after it, where it is 1.
inline Progress cancel_only(const Progress& progress, double fraction = 0) {
    if (!progress) return {};
    return [&progress, fraction](double) { return progress(fraction); };
}

struct Paint::State {
    /// In the order of Kind.
    using Contents = std::variant<io::RecipeFile, std::shared_ptr<const solver::SolvedPaint>,
                                  bsdf::BrdfTable, MeasuredBrdf, MeasuredColours>;

    State(Contents c, std::string f, std::string sha256 = {})
        : contents(std::move(c)), file(std::move(f)), file_sha256(std::move(sha256)) {}

    const Contents contents;
    const std::string file;
    const std::string file_sha256;  ///< of binary files

    /// The recipe with what stands beside it in its file.
    /// @throws InputError as Paint::recipe()
    io::RecipeFile recipe_file() const;
    /// @throws InputError as Paint::recipe(), always
    [[noreturn]] void refuse_without_recipe() const;
    /// How messages name the paint.
    std::string label() const;
    /// @throws InputError naming the file if it holds an anisotropic BRDF or a paint whose flakes lean
    void require_isotropic() const;
    /// Rethrows what `work` throws about a setting or a recipe as an error of this file.
    template <class Work>
    auto naming_file(const Work& work) const {
        try {
            return work();
        } catch (const DomainError& error) {
            throw InputError(label() + ": " + error.what());
        }
    }

    /// One set of settings, asked for by any number of threads and solved by the first.
    struct Solution {
        SolveSettings settings;
        std::mutex mutex;  // held while it is being solved
        std::shared_ptr<const solver::SolvedPaint> paint;
    };
    std::shared_ptr<Solution> solution(const SolveSettings& settings) const;

    /// What a model made, as long as somebody holds it.
    struct CachedSurface {
        Model model;
        SolveSettings solve;
        std::weak_ptr<const bsdf::Bsdf> surface;
    };
    std::shared_ptr<const bsdf::Bsdf> cached_surface(const Model& model,
                                                     const SolveSettings& solve) const;

    mutable std::mutex mutex;  // of the lists, not of their entries
    static constexpr std::size_t kKeptSolutions = 8;
    /// Those that were asked for last, the last one last.
    mutable std::vector<std::shared_ptr<Solution>> solutions;
    mutable std::vector<CachedSurface> surfaces;
};

}  // namespace nacre
