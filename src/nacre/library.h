#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "nacre/nacre.h"

// Libraries of paints, as `nacre-library` makes them (docs/library.md): a folder of records, each with
// a recipe and its readings. Here they are only read.

namespace nacre {

/// The record of a construction whose colours are nearest to a standard's.
struct NearestRecord {
    std::filesystem::path folder;
    std::string name;
    /// What the paint is made of, without numbers: "clear / TiO2_anatase|mica".
    std::string construction;
    /// Numbers by which its sweep's records differ, and between which values they lie in the records of
    /// this construction.
    std::vector<paint::ParameterBounds> swept;
    double mean_delta_e_2000 = 0;  ///< at the geometries that both have
    std::size_t shared_geometries = 0;
};

/// The nearest record of each of the nearest constructions, the nearest first. All readings are
/// compared, so that it takes some seconds for 10 000 records.
/// @param most  constructions, at least 1
/// @throws InputError if the folder is no library, a record in it is damaged, or none has a geometry
///         of the standard's; Stopped
std::vector<NearestRecord> nearest_constructions(const std::filesystem::path& library,
                                                 const Measurement& standard, std::size_t most,
                                                 const Progress& progress = {});

/// The numbers of a record's paint that a fit may turn: those that its sweep varies or, of a paint
/// from no sweep, the thicknesses of films, amounts, orientations and coefficients of pigments.
/// @throws InputError, DomainError, Error as Paint::free_keys()
std::vector<std::string> keys_to_fit(const NearestRecord& record, const Paint& paint,
                                     const FitSettings& settings, const Progress& progress = {});

/// What a fit that starts from a library found for one construction.
struct ConstructionMatch {
    NearestRecord start;
    Match match;
};

/// Fits constructions to a standard, each from its nearest record, between what its records and
/// fit::default_bounds() reach: of four times as many of the nearest,
/// those whose rough fits promise most. What might help is sought for the best match alone, if that does
/// not reach the standard.
/// @param most  constructions, at least 1
/// @param settings  FitSettings::starts holds for each
/// @return  the best match first
/// @throws as nearest_constructions() and Paint::fit()
std::vector<ConstructionMatch> fit_from_library(const std::filesystem::path& library,
                                                const Measurement& standard, std::size_t most,
                                                const FitSettings& settings = {},
                                                const Progress& progress = {});

}  // namespace nacre
