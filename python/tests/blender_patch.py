"""What Cycles makes of a flat patch under a lamp, by `python blender_patch.py SCRIPT`.

Reads rows of theta_i, theta_o, phi in deg from the standard input as JSON; writes the BRDF in 1/sr,
linear Rec. 709, as JSON. Runs in a process of its own: bpy is one Blender for each process.
"""

from __future__ import annotations

import json
import math
import runpy
import sys
import tempfile
from pathlib import Path

import bpy
from mathutils import Vector

IRRADIANCE = math.pi


def direction(theta_deg: float, phi_deg: float) -> Vector:
    theta, phi = math.radians(theta_deg), math.radians(phi_deg)
    return Vector(
        (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))
    )


def towards_origin(thing: bpy.types.Object, where: Vector) -> None:
    thing.location = 2 * where
    thing.rotation_euler = where.to_track_quat("Z", "Y").to_euler()


def patch_scene(
    script: str, samples: int, inputs: dict[str, float]
) -> tuple[bpy.types.Scene, bpy.types.Object, bpy.types.Object]:
    """A patch in the plane z = 0, with a lamp of parallel light and an orthographic camera."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = 0
    scene.render.resolution_x = scene.render.resolution_y = 4
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.view_settings.view_transform = "Raw"
    bpy.ops.mesh.primitive_plane_add(size=1)
    patch = bpy.context.active_object
    material = runpy.run_path(script)["build_material"]()
    for node in material.node_tree.nodes:
        for name, value in inputs.items():
            if node.type == "GROUP":
                node.inputs[name].default_value = value
    patch.data.materials.append(material)
    sun = bpy.data.lights.new("lamp", "SUN")
    sun.energy, sun.angle = IRRADIANCE, 0.0
    lamp = bpy.data.objects.new("lamp", sun)
    lens = bpy.data.cameras.new("camera")
    lens.type, lens.ortho_scale = "ORTHO", 0.02
    camera = bpy.data.objects.new("camera", lens)
    for thing in (lamp, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    return scene, lamp, camera


def main() -> None:
    script = sys.argv[1]
    options = json.loads(sys.argv[2]) if len(sys.argv) > 2 else {}
    scene, lamp, camera = patch_scene(
        script, options.get("samples", 1), options.get("inputs", {})
    )
    camera.data.ortho_scale = options.get("size", 0.02)
    scene.render.resolution_x = scene.render.resolution_y = options.get("pixels", 4)
    found = []
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "patch.exr"
        scene.render.filepath = str(file)
        for theta_i, theta_o, phi in json.load(sys.stdin):
            towards_origin(lamp, direction(theta_i, 0.0))
            towards_origin(camera, direction(theta_o, phi))
            bpy.ops.render.render(write_still=True)
            image = bpy.data.images.load(str(file))
            values = list(image.pixels)
            bpy.data.images.remove(image)
            cosine = math.cos(math.radians(theta_i))
            count = len(values) // 4
            found.append([sum(values[c::4]) / count / (IRRADIANCE * cosine) for c in range(3)])
    Path(options["output"]).write_text(json.dumps(found)) if "output" in options else print(
        "BRDF " + json.dumps(found), flush=True
    )


if __name__ == "__main__":
    main()
