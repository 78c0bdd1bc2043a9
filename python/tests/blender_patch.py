"""What Cycles makes of a flat patch under a lamp: `python blender_patch.py SCRIPT < ANGLES.json`.

SCRIPT is an exported `.blender.py`. Rows of theta_i, theta_o and phi in deg come in; the BRDF in
1/sr, linear Rec. 709, goes out, after "BRDF " on a line of its own. A program, since a process has
one Blender. Of Blender it needs the package bpy.

With sparkle, as `blender_patch.py SCRIPT 0.5`, it is the mean over a million flakes.
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


def stand(thing: bpy.types.Object, where: Vector) -> None:
    """Both lamps and cameras look along their -z."""
    thing.location = 2 * where
    thing.rotation_euler = where.to_track_quat("Z", "Y").to_euler()


def patch_scene(
    script: str, sparkle: float
) -> tuple[bpy.types.Scene, bpy.types.Object, bpy.types.Object]:
    """A patch in z = 0, parallel light and an orthographic camera; one bounce, without noise."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 16 if sparkle else 1
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = 0
    scene.render.resolution_x = scene.render.resolution_y = 128 if sparkle else 4
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.view_settings.view_transform = "Raw"
    bpy.ops.mesh.primitive_plane_add(size=1)
    material = runpy.run_path(script)["build_material"]()
    (group,) = (node for node in material.node_tree.nodes if node.type == "GROUP")
    group.inputs["Sparkle"].default_value = sparkle
    bpy.context.active_object.data.materials.append(material)
    sun = bpy.data.lights.new("lamp", "SUN")
    sun.energy, sun.angle = IRRADIANCE, 0.0
    lens = bpy.data.cameras.new("camera")
    lens.type, lens.ortho_scale = "ORTHO", 0.02
    lamp, camera = bpy.data.objects.new("lamp", sun), bpy.data.objects.new("camera", lens)
    for thing in (lamp, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    return scene, lamp, camera


def main() -> None:
    script, sparkle = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 0.0
    scene, lamp, camera = patch_scene(script, sparkle)
    found = []
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "patch.exr"
        scene.render.filepath = str(file)
        for theta_i, theta_o, phi in json.load(sys.stdin):
            stand(lamp, direction(theta_i, 0.0))
            stand(camera, direction(theta_o, phi))
            bpy.ops.render.render(write_still=True)
            image = bpy.data.images.load(str(file))
            values = list(image.pixels)
            bpy.data.images.remove(image)
            irradiance = IRRADIANCE * math.cos(math.radians(theta_i))
            found.append([sum(values[c::4]) / (len(values) // 4) / irradiance for c in range(3)])
    print("BRDF", json.dumps(found), flush=True)


if __name__ == "__main__":
    main()
