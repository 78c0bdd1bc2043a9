#pragma once

#include "nacre/core/progress.h"
#include "nacre/fit/free_numbers.h"
#include "nacre/solver/medium.h"

namespace nacre::fit {

/// How a message goes on about a number without effect, after its key.
inline constexpr const char* kNoEffect = "does not change the colours of this paint";

/// Whether numbers of a paint change its colours. The diameter of flakes does not change the mean
/// colour, nor does the thickness of a clearcoat that absorbs nothing.
class EffectOnColours {
 public:
    /// @param hot_spot  as TargetOptions::hot_spot
    /// @param work      asked whether to go on
    /// @throws DomainError, Error, Stopped as solver::make_medium()
    EffectOnColours(const paint::Recipe& recipe, bool hot_spot, SharedProgress& work);

    /// @param number  of that recipe
    /// @throws Stopped as the constructor
    bool of(const FreeNumber& number) const;

 private:
    const paint::Recipe& recipe_;
    bool hot_spot_;
    SharedProgress& work_;
    solver::PaintMedium medium_;
};

}  // namespace nacre::fit
