#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/io/image.h"
#include "nacre/models/models.h"
#include "nacre/render/render.h"

namespace nacre::study {

/// The largest resident memory of the process since this object was made, in MiB. Where the system
/// cannot start counting afresh (it needs Linux's /proc/self/clear_refs): since the process began.
class PeakMemory {
 public:
    PeakMemory();
    /// @throws Error where the system does not tell
    double mebibytes() const;
};

// The pictures of a study: rendered once, kept on disk with what they cost, found again when the
// study goes on after an interruption.

/// Thrown when the user asked to stop. What has been finished is kept.
class Interrupted : public Error {
 public:
    using Error::Error;
};

/// Runs a piece of work under a label, with a progress callback for it. The library is silent; the
/// command line draws a bar.
using Stage =
    std::function<void(const std::string& label, const std::function<void(const Progress&)>& work)>;

/// All that a picture depends on.
struct PictureJob {
    std::string key;    ///< file name, unique in the study
    std::string title;  ///< for people
    std::filesystem::path paint;
    bsdf::Model model = models::default_model();
    render::RenderOptions render;
    std::string scene = "sphere";  ///< a built-in scene
    double scene_scale = 1;        ///< all its lengths times this: more flakes or facets fit on it
    double facet_count = 0;        ///< in place of the recipe's, where above zero
    double flake_scale = 1;        ///< diameters of the recipe's flakes times this
};

/// The recipe of a job, with the job's facets and flakes.
/// @throws InputError if it sets facets that the recipe does not have; what reading throws
paint::Recipe recipe_of(const PictureJob& job);

/// The flakes that a paint lays on a ball, over all layers and species: density times surface.
double flakes_on_ball(const paint::Recipe& recipe, double radius_mm);

/// A finished picture and what it cost.
struct Picture {
    io::Image image;
    std::string png;                     ///< the bytes of a PNG
    double prepare_s = 0, render_s = 0;  ///< wall-clock time
    double processor_s = 0;  ///< of rendering, summed over cores: other programs disturb it less
    double msamples_per_s = 0;
    double peak_mib = 0;         ///< largest resident memory of the process while it was made
    std::size_t file_bytes = 0;  ///< of the file with the solved paint or its table; 0: none
    std::size_t data_bytes = 0;  ///< of the table's values in memory; of a solved paint, its file
};

class Gallery {
 public:
    /// @param folder  made if it does not exist; pictures go to its sub-folder pictures/, files
    ///                with tables to tables/
    /// @param stage   runs the work
    Gallery(std::filesystem::path folder, Stage stage);

    /// The picture, from disk if it is there unaltered, with a record of the same description by the
    /// same version. One process at a time may work in a folder: FolderLock.
    /// @throws Interrupted, and what reading the recipe, solving and rendering throw
    Picture make(const PictureJob& job) const;

    const std::filesystem::path& folder() const { return folder_; }
    const Stage& stage() const { return stage_; }

 private:
    std::filesystem::path folder_;
    Stage stage_;
};

/// SHA-256 over all that the picture depends on.
std::string fingerprint(const PictureJob& job);

}  // namespace nacre::study
