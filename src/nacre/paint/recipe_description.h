#pragma once

#include <string>

#include "nacre/optics/thin_film.h"
#include "nacre/paint/description.h"
#include "nacre/paint/recipe.h"

// Every key of a recipe, once: what paint/description.h says of descriptions. To add a key, add a
// member to its struct (paint/recipe.h) and a line to its description; the reader, the writer, the
// checks, the numbers by key and the data sheet follow, and a test compares the tables of
// docs/recipe.md (and writes them with NACRE_WRITE_DOCS=1).

namespace nacre::paint {

void describe(Visitor& visit, Recipe& recipe);
void describe(Visitor& visit, Clearcoat& coat);
void describe(Visitor& visit, OrangePeel& peel);
void describe(Visitor& visit, FlakeLean& lean);
void describe(Visitor& visit, Layer& layer);
void describe(Visitor& visit, FlakeSpecies& species);
void describe(Visitor& visit, VolumeFraction& amount);
void describe(Visitor& visit, AreaDensity& amount);
void describe(Visitor& visit, StatedQuantiles& quantiles);
void describe(Visitor& visit, MedianDiameter& median);
void describe(Visitor& visit, DiameterQuantiles& quantiles);
void describe(Visitor& visit, Orientation& orientation);
void describe(Visitor& visit, TabulatedTilts& table);
void describe(Visitor& visit, TiltDensity& point);
void describe(Visitor& visit, optics::Platelet& platelet);
void describe(Visitor& visit, optics::FilmPopulation& film);
void describe(Visitor& visit, PrescribedFlake& flake);
void describe(Visitor& visit, Pigment& pigment);
void describe(Visitor& visit, PigmentCoefficients& pigment);
void describe(Visitor& visit, PigmentParticles& particles);
void describe(Visitor& visit, PigmentKubelkaMunk& pigment);
void describe(Visitor& visit, KubelkaMunk& constants);
void describe(Visitor& visit, PigmentUnstated& amount);
void describe(Visitor& visit, PigmentVolume& amount);
void describe(Visitor& visit, PigmentMass& amount);
void describe(Visitor& visit, Microfacet& microfacet);
void describe(Visitor& visit, MicrofacetFacets& facets);

/// What is said of a pigment of particles without its amount.
std::string amount_is_missing();

/// The table [substrate] of a recipe.
struct Substrate {
    spectra::Spectrum& reflectance;
};
void describe(Visitor& visit, Substrate& substrate);

}  // namespace nacre::paint
