#pragma once

#include "nacre/render/integrator.h"
#include "nacre/render/render.h"

namespace nacre::render {

/// As render(), with a choice of estimators of direct light, so that tests can compare them.
RenderResult render_with(const Scene& scene, const RenderOptions& options, DirectLight direct_light,
                         const Progress& progress = {});

}  // namespace nacre::render
