#pragma once

#include <filesystem>
#include <string>

#include "apps/study/gallery.h"
#include "apps/study/mir_2022.h"
#include "nacre/io/image.h"

// Reference pictures that other renderers can be held against, which the paper names as future
// work [mir-2022].

namespace nacre::study {

/// Writes into settings.folder, made if it does not exist, for each paint of the comparison whose
/// picture does not depend on where single flakes lie:
///
///     NAME.exr    the mean of kReferenceBatches pictures with random numbers of their own: R, G, B,
///                 A and spectral radiance in bins of 10 nm over 400-700 nm (S0.405,000000nm ...),
///                 each with its standard error (stderr.R ...), for io::image_z_scores()
///     NAME.png    to look at
///     NAME.toml   the recipe, with every key written out
///     NAME.scene.toml  the scene with that recipe, its lamps written out
///     NAME.json   model, samples, seeds, version and checksums
///     SHA256SUMS  of all of these, as sha256sum -c takes it
///     README.md   what the files are
///
/// A picture that is there unaltered, made with the same settings by the same version, is kept.
/// settings.samples is that of the study; a reference has four times as many. Where it is quick,
/// two pictures only. The parts of the study play no role.
///
/// @return the folder
/// @throws as run_mir_2022()
std::filesystem::path write_references(const MirSettings& settings, const Stage& stage);

inline constexpr int kReferenceBatches = 16;

/// The mean of pictures with the same channels, and of each but A, as channels of
/// io::standard_error_channel(), its standard error; the number of pictures stands in the metadata.
/// @param batches  at least 2, of one size
/// @throws DomainError otherwise, or if their channels differ
io::Image mean_with_standard_error(const std::vector<io::Image>& batches);

}  // namespace nacre::study
