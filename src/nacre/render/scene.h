#pragma once

#include <map>
#include <memory>
#include <string>

#include "nacre/bsdf/bsdf.h"
#include "nacre/render/scene_description.h"

namespace nacre::render {

/// The Bsdf of each paint, by the name of its material in the description.
using PaintTable = std::map<std::string, std::shared_ptr<const bsdf::Bsdf>>;

struct CompiledScene;

/// A scene ready to be rendered: geometry in a ray-tracing structure, tables for light sampling.
/// Immutable after construction and cheap to copy (copies share the structure).
class Scene {
 public:
    /// @param paints  one entry for each PaintMaterial; diffuse materials need none
    /// @throws DomainError from validate(), or naming a paint material without a Bsdf
    /// @throws InputError  naming the mesh file that cannot be read, and why
    Scene(const SceneDescription& description, const PaintTable& paints);

    const CompiledScene& compiled() const { return *compiled_; }

 private:
    std::shared_ptr<const CompiledScene> compiled_;
};

}  // namespace nacre::render
