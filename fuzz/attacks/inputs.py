"""Inputs that are wrong: damaged, hostile, and at the ends of their ranges."""

import pathlib
import random
import re
import tempfile
from collections.abc import Iterator

from .lab import PAINT, ROOT, Lab

NUMBERS = ["0", "-0.0", "-1", "1e-320", "1e308", "1e309", "nan", "inf", "-inf", "0x10", "1e-9",
           "99999999999999999999", "true", '"text"', "[]", "{}"]


def mutated(seed: bytes, other: bytes, rng: random.Random) -> bytes:
    data = bytearray(seed)
    for _ in range(rng.choice([1, 1, 1, 2, 4, 16])):
        at = rng.randrange(len(data) + 1)
        length = rng.choice([1, 2, 4, 8, 64, 1024])
        match rng.randrange(8):
            case 0 if data:
                data[at % len(data)] ^= 1 << rng.randrange(8)
            case 1:
                data[at:at + length] = rng.randbytes(min(length, 8))
            case 2:
                del data[at:at + length]
            case 3:
                data = data[:at]
            case 4:
                data[at:at] = data[at:at + length] * rng.choice([1, 2, 50])
            case 5:
                begin = rng.randrange(len(other) + 1)
                data[at:at] = other[begin:begin + length]
            case 6:
                data[at:at + length] = rng.choice([b"\x00", b"\xff"]) * length
            case _:
                found = list(re.finditer(rb"-?\d+\.?\d*", bytes(data)))
                if found:
                    number = rng.choice(found)
                    data[number.start():number.end()] = rng.choice(NUMBERS).encode()
    return bytes(data)


IN_A_DIRECTION = ["--incident", "30", "--outgoing", "20,180"]
A_PICTURE = ["--size", "2x2", "--spp", "1", "-o", "out.exr"]

# Kinds of files, and commands that read one. "scene:" stands for a scene that names it.
READERS: dict[str, list[list[str]]] = {
    "recipe": [["info", "{}"], ["eval", "{}", *IN_A_DIRECTION, "--wavelength", "550"],
               ["render", "scene:recipe", *A_PICTURE, "--untrusted"]],
    "scene": [["render", "{}", *A_PICTURE], ["info", "{}", "--untrusted"]],
    "solved_paint": [["info", "{}"], ["eval", "{}", *IN_A_DIRECTION]],
    "brdf_table": [["info", "{}"], ["eval", "{}", "--table", "svd", *IN_A_DIRECTION]],
    "picture_shard": [["info", "{}"], ["merge", "{}", "-o", "out.exr"]],
    "rgl": [["info", "{}"], ["eval", "{}", *IN_A_DIRECTION]],
    "merl": [["info", "{}"], ["eval", "{}", *IN_A_DIRECTION]],
    "measurement": [["info", "{}"], ["measure", "{}"], ["measure", "gold.h5", "--versus", "{}"]],
    "image": [["diff", "{}", "{}"], ["info", "{}"], ["render", "scene:sky", *A_PICTURE]],
    "material": [["film", "--layer", "./{}:80", "--substrate", "1.5", "--angle", "30",
                  "--wavelength", "550"]],
    "mesh": [["render", "scene:mesh", *A_PICTURE]],
    "geometry": [["measure", "gold.h5", "--geometry", "{}"]],
}

GREY = '[materials.grey]\ntype = "diffuse"\nreflectance = 0.5\n'
SPHERE = '[[shapes]]\ntype = "sphere"\nmaterial = "grey"\n'
LIGHT = '[environment]\ntype = "constant"\n'
NAMING_SCENES = {
    "recipe": '[materials.grey]\ntype = "paint"\nrecipe = "{}"\n' + SPHERE + LIGHT,
    "sky": GREY + SPHERE + '[environment]\ntype = "image"\npath = "{}"\n',
    "mesh": GREY + '[[shapes]]\ntype = "mesh"\npath = "{}"\nmaterial = "grey"\n' + LIGHT,
}

GEOMETRIES = """name = "set"
summary = "two directions"
[[geometry]]
name = "45as15"
lamp_deg = 45
aspecular_deg = 15
[[geometry]]
lamp_deg = 30
view_deg = [20, -90]
"""

# What a terminal obeys: none may stand in a message, whatever a file is called or holds.
CONTROL = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]")


def seeds_of(kind: str, lab: Lab) -> list[pathlib.Path]:
    if kind == "geometry":
        lab.path("geometry.toml").write_text(GEOMETRIES)
        return [lab.path("geometry.toml")]
    folders = [ROOT / "fuzz/corpus" / kind]
    folders += [ROOT / "paints"] if kind == "recipe" else []
    folders += [ROOT / "scenes"] if kind == "scene" else []
    return sorted(p for f in folders if f.is_dir() for p in f.iterdir() if p.is_file())


def command_on(name: str, command: list[str], lab: Lab) -> list[str]:
    """The command on a file, in a scene that names it if need be."""
    if command[1].startswith("scene:"):
        scene = NAMING_SCENES[command[1].removeprefix("scene:")]
        lab.path("naming.toml").write_text(scene.replace("{}", name))
        return [command[0], "naming.toml", *command[2:]]
    return [a.replace("{}", name) for a in command]


def damaged_files(lab: Lab, tries: int) -> Iterator[str]:
    lab.run(["solve", PAINT, "--wavelength", "400:700:20", "-o", "gold.h5"])
    seeds_by_kind = {kind: seeds_of(kind, lab) for kind in READERS}
    # Each kind of mesh counts as a kind of its own.
    kinds = [k for k in READERS for _ in range(5 if k == "mesh" else 1)]
    for number in range(tries):
        kind = kinds[number % len(kinds)]
        seeds = seeds_by_kind[kind]
        seed = lab.random.choice(seeds)
        data = mutated(seed.read_bytes(), lab.random.choice(seeds).read_bytes(), lab.random)
        name = "damaged" + seed.suffix
        lab.path(name).write_bytes(data)
        command = command_on(name, lab.random.choice(READERS[kind]), lab)
        outcome = lab.run(command)
        complaint = outcome.complaint()
        if not complaint and CONTROL.search(outcome.stderr):
            complaint = f"sends control characters to the terminal: {outcome.stderr[-200:]!r}"
        if complaint:
            kept = pathlib.Path(tempfile.gettempdir()) / f"attack-{number}{seed.suffix}"
            kept.write_bytes(data)
            complaint = f"{' '.join(command)}: {complaint}; the file is {kept}"
        yield complaint


def hostile_texts(lab: Lab, tries: int) -> Iterator[str]:
    """Inputs that are small to write and large to read."""
    depth = 50_000
    gltf = '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[%s]}'
    nested = ",".join('{"children":[%d]}' % (i + 1) for i in range(20_000)) + ",{}"
    doubled = ",".join('{"children":[%d,%d]}' % (i + 1, i + 1) for i in range(40)) + ",{}"
    ply = ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
           "end_header\n0 0 0\n1 0 0\n0 1 0\n")
    texts = {
        "dotted.toml": ".".join(["a"] * depth) + " = 1\n",
        "brackets.toml": "a = " + "[" * depth + "]" * depth + "\n",
        "braces.toml": "a = " + "{b=" * depth + "1" + "}" * depth + "\n",
        "tables.toml": "[" + ".".join(["a"] * depth) + "]\n",
        "brackets.json": "[" * depth + "]" * depth,
        "sequences.yml": "[" * depth,
        "columns.csv": "wavelength_nm" + ",n" * depth + "\n" + "1," * depth + "1\n",
    }
    meshes = {"intact.ply": (ply + "3 0 1 2\n").encode(),
              "empty-face.ply": (ply + "0\n").encode(), "nested.gltf": (gltf % nested).encode(),
              "doubled.gltf": (gltf % doubled).encode(),
              "claims.glb": b"glTF" + (2).to_bytes(4, "little") + (0xFFFFFFFF).to_bytes(4, "little")
              + (0xFFFFFFF0).to_bytes(4, "little") + b"JSON" + b" " * 64}
    commands = []
    for name, text in texts.items():
        lab.path(name).write_text(text)
        commands.append(["info", name])
        if name.endswith(".toml"):
            commands.append(["render", name, "--size", "2x2", "--spp", "1", "-o", "out.exr"])
    for name, data in meshes.items():
        lab.path(name).write_bytes(data)
        scene = f"scene-{name}.toml"
        lab.path(scene).write_text(MESH_SCENE.format(name))
        commands.append(["render", scene, "--size", "2x2", "--spp", "1", "-o", "out.exr"])
    for command in commands:
        outcome = lab.run(command)
        complaint = outcome.complaint()
        intact = "intact" in command[1]  # the others are refused for what they hold, not how
        if not complaint and (outcome.status == 0) != intact:
            complaint = f"ended with {outcome.status}: {outcome.stderr!r}"
        yield f"{' '.join(command)}: {complaint}" if complaint else ""


MESH_SCENE = """[camera]
position_mm = [0, -3000, 1000]
target_mm = [0, 0, 0]
vertical_fov_deg = 32
[materials.grey]
type = "diffuse"
reflectance = 0.5
[[shapes]]
type = "mesh"
path = "{}"
material = "grey"
mm_per_unit = 1000
[environment]
type = "constant"
"""


def extreme_recipes(lab: Lab, tries: int) -> Iterator[str]:
    rng = lab.random
    for _ in range(tries):
        pick = rng.choice
        text = f"ior = {pick([1.0, 1.33, 1.5, 2.0, 3.0])}\n"
        if pick([True, False]):
            text += (f"[clearcoat]\nthickness_um = {pick([0, 1e-6, 45, 1e6])}\n"
                     f"absorption_per_mm = {pick([0.0, 1e-12, 6.0, 1e9])}\n"
                     f"roughness = {pick([0, 0, 0.05, 0.3, 1])}\n")
        for _ in range(pick([1, 1, 2])):
            text += f"[[layer]]\nthickness_um = {pick([1e-6, 1, 15, 1e3, 1e6])}\n"
            if pick([True, False]):
                r = pick([0, 1e-9, 0.5, 1])
                text += (f"[[layer.flakes]]\narea_density_per_um = {pick([1e-12, 0.1, 1e6])}\n"
                         f"diameter_um = {pick([1e-3, 20, 1e4])}\n"
                         f'orientation = {{ distribution = "beckmann", alpha = '
                         f"{pick([0.05, 0.1, 0.5, 1])} }}\n"
                         f"reflectance = {r}\ntransmittance = {pick([0, 1 - r])}\n")
            if pick([True, False]):
                text += (f"[[layer.pigment]]\nscattering_per_mm = "
                         f"{pick([0.0, 1e-13, 1.0, 1e4, 1e9])}\nabsorption_per_mm = "
                         f"{pick([0.0, 1e-13, 1.0, 1e9])}\n"
                         f"anisotropy = {pick([-0.9, 0, 0.5, 0.95])}\n")
        text += f"[substrate]\nreflectance = {pick([0, 1e-9, 0.5, 1])}\n"
        lab.path("extreme.toml").write_text(text)
        command = ["eval", "extreme.toml", "--incident", "45", "--outgoing", "0,0,45,180,80,90",
                   "--wavelength", "550"]
        command[4:6] = ["--outgoing", "0", "--outgoing", "45,180", "--outgoing", "80,90"]
        outcome = lab.run(command)
        complaint = outcome.complaint()
        if not complaint and outcome.status == 0:
            values = [float(line.split(",")[-1])
                      for line in outcome.stdout.decode().splitlines()[1:]]
            if not all(0 <= v < 1e9 for v in values) or len(values) != 3:
                complaint = f"gave {values}"
        elif not complaint and outcome.status != 3:
            complaint = f"was refused, though the page on recipes allows it: {outcome.stderr!r}"
        yield f"{complaint}\n{text}" if complaint else ""
