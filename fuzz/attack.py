#!/usr/bin/env python3
"""Attacks the program as accidents and strangers do, and counts what did not hold.

    fuzz/attack.py PROGRAM [--tries N] [--seed S] [--markdown]

Each attack makes some number of tries and says for each whether a promise of docs/conventions.md
was kept: the program ends by itself with one of its exit statuses, says why unless all went well,
leaves every file whole, either the old or the new one, and gives the same bytes for the same input.
fuzz/run.sh looks for memory errors inside of the readers; this looks at the program from outside.

Exit status: 0 if all held, 1 if not; each failure is printed with what repeats it.
"""

import argparse
import contextlib
import dataclasses
import hashlib
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator

ROOT = pathlib.Path(__file__).resolve().parent.parent
STATUSES = range(5)  # docs/conventions.md, "Errors and exit status"
HANG_S = 120.0
# After a signal, a second on two cores; by the clock more, as the machine may do other things too.
ANSWER_CPU_S, ANSWER_S = 3.0, 20.0
MEMORY_BYTES = 4 << 30
PAINT = "paints/metallic-gray.toml"


@dataclasses.dataclass
class Outcome:
    status: int  # negative: ended by that signal
    stdout: bytes
    stderr: bytes
    hung: bool = False

    def complaint(self) -> str:
        """Why this is no way to end, or nothing."""
        if self.hung:
            return f"did not end within {HANG_S:.0f} s"
        if self.status < 0:
            return f"was ended by {signal.Signals(-self.status).name}"
        if self.status not in STATUSES:
            return f"ended with {self.status}: {self.stderr[-200:]!r}"
        if self.status not in (0, 4) and not self.stderr.strip():
            return f"ended with {self.status} without a word"
        return ""


class Lab:
    """The program and a scratch folder to run it in."""

    def __init__(self, program: pathlib.Path, folder: pathlib.Path, rng: random.Random) -> None:
        self.program, self.folder, self.random = program, folder, rng
        self.note = ""  # what an attack has to say besides its failures
        for name in ("paints", "scenes"):
            shutil.copytree(ROOT / name, folder / name)

    def path(self, name: str) -> pathlib.Path:
        return self.folder / name

    def start(self, arguments: list[str], limits: dict[int, int] | None = None, **how):
        def restrict() -> None:
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            for what, value in {resource.RLIMIT_AS: MEMORY_BYTES, **(limits or {})}.items():
                resource.setrlimit(what, (value, value))
            if limits and resource.RLIMIT_FSIZE in limits:
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

        return subprocess.Popen([self.program, *arguments], cwd=self.folder, preexec_fn=restrict,
                                **{"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE,
                                   "stderr": subprocess.PIPE, **how})

    def run(self, arguments: list[str], limits: dict[int, int] | None = None, **how) -> Outcome:
        process = self.start(arguments, limits, **how)
        try:
            out, err = process.communicate(timeout=HANG_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return Outcome(0, b"", b"", hung=True)
        return Outcome(process.returncode, out or b"", err or b"")


# An attack yields, for each of its tries, what went wrong, or nothing.
Attack = Callable[[Lab, int], Iterator[str]]

# A command, and the files that it writes.
WRITERS: dict[str, tuple[list[str], list[str]]] = {
    "solve": (["solve", PAINT, "--wavelength", "450,550,650", "-o", "out.h5"], ["out.h5"]),
    "render": (["render", "sphere", "--paint", PAINT, "--size", "16x16", "--spp", "2", "-o",
                "out.exr"], ["out.exr", "out.png"]),
    "eval": (["eval", PAINT, "--incident", "45", "--outgoing", "0:80:10", "-o", "out.csv"],
             ["out.csv"]),
    "measure": (["measure", PAINT, "-o", "out-measured.csv"], ["out-measured.csv"]),
    "export": (["export", PAINT, "--cells", "8,8,16", "-o", "out.binary"],
               ["out.binary"]),
}


def digest(path: pathlib.Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else "nothing"


def partial_files(lab: Lab) -> list[str]:
    return [p.name for p in lab.folder.iterdir() if ".partial" in p.name]


def remove_outputs(lab: Lab) -> None:
    for _, outputs in WRITERS.values():
        for name in outputs:
            lab.path(name).unlink(missing_ok=True)


def references(lab: Lab) -> dict[str, tuple[float, dict[str, str]]]:
    """For each command, its time and the digests of what it writes when nobody disturbs it."""
    found = {}
    for name, (arguments, outputs) in WRITERS.items():
        remove_outputs(lab)
        start = time.monotonic()
        outcome = lab.run(arguments)
        seconds = time.monotonic() - start
        if outcome.status != 0:
            sys.exit(f"attack: '{' '.join(arguments)}' fails undisturbed: {outcome.stderr!r}")
        found[name] = seconds, {o: digest(lab.path(o)) for o in outputs}
    return found


def torn(lab: Lab, before: dict[str, str], after: dict[str, str]) -> str:
    """Which output is neither the old one nor the new one, or nothing."""
    for name, new in after.items():
        now = digest(lab.path(name))
        if now not in (before[name], new):
            size = lab.path(name).stat().st_size if lab.path(name).exists() else 0
            return f"left '{name}' neither old nor new ({size} bytes)"
    return ""


# Inputs that are wrong.

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
    "picture_share": [["info", "{}"], ["merge", "{}", "-o", "out.exr"]],
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


# Accidents while it writes.

def killed(lab: Lab, tries: int, signals: list[int]) -> Iterator[str]:
    undisturbed = references(lab)
    for number in range(tries):
        name = list(WRITERS)[number % len(WRITERS)]
        arguments, outputs = WRITERS[name]
        seconds, after = undisturbed[name]
        remove_outputs(lab)
        for output in outputs:
            if output != "out.png":  # a picture beside that is not ours is never replaced
                lab.path(output).write_bytes(b"old")
        before = {o: digest(lab.path(o)) for o in outputs}
        sent = lab.random.choice(signals)
        process = lab.start(arguments)
        time.sleep(lab.random.uniform(0, 1.2 * seconds))
        with contextlib.suppress(ProcessLookupError):
            process.send_signal(sent)
        try:
            process.communicate(timeout=HANG_S)
            complaint = torn(lab, before, after)
            if name == "render" and sent != signal.SIGKILL and complaint:
                # What an interrupted render has done is a whole picture of fewer samples.
                whole = lab.run(["diff", "out.exr", "out.exr"]).status == 0
                complaint = "" if whole else complaint
        except subprocess.TimeoutExpired:
            process.kill()
            complaint = "went on after the signal"
        if sent != signal.SIGKILL and not complaint and partial_files(lab):
            complaint = f"left {partial_files(lab)} behind"
        for partial in partial_files(lab):
            lab.path(partial).unlink()
        yield f"{name}, {signal.Signals(sent).name}: {complaint}" if complaint else ""


def sigkill(lab: Lab, tries: int) -> Iterator[str]:
    return killed(lab, tries, [signal.SIGKILL])


def interrupts(lab: Lab, tries: int) -> Iterator[str]:
    return killed(lab, tries, [signal.SIGINT, signal.SIGTERM])


def long_work(lab: Lab) -> list[list[str]]:
    """Commands that go on for seconds to hours, each of which writes the file after -o."""
    head = "ior = 1.5\n[[layer]]\nthickness_um = 15\n[[layer.flakes]]\n"
    flakes = ('area_density_per_um = 0.1\ndiameter_um = {}\norientation = {{ distribution = "beckmann",'
              " alpha = {} }}\n")
    films = ('core = {{ material = "mica", thickness_nm = 500, spread_nm = 100 }}\n'
             'coats = [{{ material = "TiO2_anatase", thickness_nm = {}, spread_nm = 80 }}, '
             '{{ material = "SiO2", thickness_nm = 300, spread_nm = 1000 }}]\n')
    white = "reflectance = 1.0\n[substrate]\nreflectance = 1.0\n"
    lab.path("narrow.toml").write_text(
        head + flakes.format(20, 0.01)
        + "reflectance = { wavelengths_nm = [400, 700], values = [0.5, 0.9] }\n")
    for name, thickness_nm in (("films.toml", 80), ("other-films.toml", 100)):
        lab.path(name).write_text(head + flakes.format(18, 0.1) + films.format(thickness_nm))
    lab.path("small.toml").write_text(head + flakes.format(5, 0.1) + "reflectance = 0.6\n")
    lab.path("lossless.toml").write_text(
        head.replace("15", "10000") + flakes.format(20, 0.1) + white)
    lab.path("panel.toml").write_text(PANEL_SCENE)
    pearl = "paints/tio2-mica-80.toml"
    return [
        ["solve", "narrow.toml", "--wavelength", "400:700:1", "-o", "long.h5"],
        ["solve", "films.toml", "--wavelength", "400:700:1", "-o", "long.h5"],
        ["solve", pearl, "--table", "raw", "-o", "long.h5"],
        ["reference", PAINT, "--incident", "45", "--outgoing", "0:80:0.02", "--samples",
         "100000000", "-o", "long.csv"],
        ["reference", "films.toml", "--incident", "45", "--outgoing", "0", "-o", "long.csv"],
        ["reference", "lossless.toml", "--incident", "45", "--outgoing", "0", "-o", "long.csv"],
        ["export", pearl, "--model", "nacre", "--resolution", "256", "-o", "long.bsdf"],
        ["export", PAINT, "--resolution", "512", "--incidences", "96", "--wavelength",
         "450:650:100", "-o", "long.bsdf"],
        ["export", PAINT, "-o", "long.binary"],
        ["export", PAINT, "--cells", "512,512,128", "-o", "long.binary"],
        ["fit", "paints/tio2-mica-110.toml", "--start", pearl, "--free",
         "coats[0].thickness_nm,volume_fraction", "-o", "long.toml"],
        ["fit", "other-films.toml", "--start", "films.toml", "--free", "coats[0].thickness_nm",
         "-o", "long.toml"],
        ["measure", pearl, "--aperture", "5,5", "--wavelength", "400:700:1", "-o", "long.csv"],
        ["measure", PAINT, "--model", "walk", "--samples", "100000000", "-o", "long.csv"],
        ["sparkle", PAINT, "-o", "long.csv"],
        ["sparkle", PAINT, "--field", "20", "--lamp", "15", "--diffuse-samples", "2", "-o",
         "long.csv"],
        ["atlas", "--recipe", "films.toml", "--key", "coats[0].thickness_nm", "--values",
         "40:160:20", "-o", "long.png"],
        ["panel", PAINT, "--versus", "films.toml", "-o", "long.html"],
        ["render", "sphere", "--paint", PAINT, "--size", "512x512", "--spp", "4096", "-o",
         "long.exr"],
        ["render", "sphere", "--paint", "films.toml", "--model", "nacre", "-o", "long.exr"],
        ["render", "sphere", "--paint", "lossless.toml", "--model", "walk", "-o", "long.exr"],
        ["render", "sphere", "--paint", "lossless.toml", "--model", "volume", "-o", "long.exr"],
        ["render", "panel.toml", "--paint", "small.toml", "--model", "nacre", "--flakes",
         "explicit", "-o", "long.exr"],
        ["render", "panel.toml", "--paint", "films.toml", "--model", "nacre", "--flakes",
         "explicit", "-o", "long.exr"],
    ]


PANEL_SCENE = """[camera]
position_mm = [0, 0, 100]
target_mm = [0, 0, 0]
up = [0, 1, 0]
[materials.paint]
type = "paint"
[[shapes]]
type = "flat-panel"
material = "paint"
width_mm = 8
height_mm = 8
[environment]
type = "constant"
"""


def finished_processor_s() -> float:
    """Processor time of all processes that have been waited for."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def processor_s(process: subprocess.Popen) -> float:
    """Processor time of one that runs."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def slow_interrupts(lab: Lab, tries: int) -> Iterator[str]:
    """Long work ends soon after SIGINT or SIGTERM, at any moment, and leaves the old file."""
    commands = long_work(lab)
    lasts_s = [6.0] * len(commands)  # as far as has been seen
    slowest_s = slowest_cpu_s = 0.0
    order = lab.random.sample(range(len(commands)), len(commands))
    for number in range(tries):
        which = order[number % len(commands)]
        command = commands[which]
        output = lab.path(command[command.index("-o") + 1])
        output.with_suffix(".png").unlink(missing_ok=True)
        output.write_bytes(b"old")
        sent = lab.random.choice([signal.SIGINT, signal.SIGTERM])
        begun = time.monotonic()
        process = lab.start(command)
        moment = lab.random.uniform(0, 1.05 * lasts_s[which])
        try:
            process.communicate(timeout=0.1 + moment)
            lasts_s[which] = time.monotonic() - begun
            ended = process.returncode  # 0: it was not that long
            yield f"{' '.join(command)}: ended with {ended}" if ended else ""
            continue
        except subprocess.TimeoutExpired:
            pass
        start, cpu_s = time.monotonic(), -processor_s(process) - finished_processor_s()
        process.send_signal(sent)
        try:
            process.communicate(timeout=HANG_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
        seconds = time.monotonic() - start
        cpu_s += finished_processor_s()
        slowest_s, slowest_cpu_s = max(slowest_s, seconds), max(slowest_cpu_s, cpu_s)
        lab.note = (f", answered within {slowest_s:.1f} s and {slowest_cpu_s:.1f} s of processor "
                    "time")
        complaint = ""
        if seconds > ANSWER_S or cpu_s > ANSWER_CPU_S:
            complaint = (f"ended {seconds:.1f} s, {cpu_s:.1f} s of processor time, after "
                         f"{sent.name}")
        elif process.returncode == 0 and cpu_s > 0.5:
            complaint = f"went on to its end after {sent.name}"
        elif process.returncode not in (0, 3, -sent):
            complaint = f"ended with {process.returncode}"
        elif process.returncode and command[0] != "render" and output.read_bytes() != b"old":
            complaint = "replaced the old file by half a result"
        elif partial_files(lab):
            complaint = f"left {partial_files(lab)} behind"
        yield (f"{' '.join(command)}: {complaint}, {moment:.2f} s after its start" if complaint
               else "")


def limited(lab: Lab, tries: int, what: int, values: Callable[[random.Random], int]
            ) -> Iterator[str]:
    undisturbed = references(lab)
    for number in range(tries):
        name = list(WRITERS)[number % len(WRITERS)]
        arguments, outputs = WRITERS[name]
        remove_outputs(lab)
        for output in outputs:
            if output != "out.png":
                lab.path(output).write_bytes(b"old")
        before = {o: digest(lab.path(o)) for o in outputs}
        value = values(lab.random)
        outcome = lab.run(arguments, {what: value})
        if b"error while loading shared libraries" in outcome.stderr:
            yield ""  # the program has not begun
            continue
        complaint = outcome.complaint() or torn(lab, before, undisturbed[name][1])
        if not complaint and outcome.status == 0:
            wrong = [o for o, new in undisturbed[name][1].items() if digest(lab.path(o)) != new]
            complaint = f"ended with 0, and {wrong} is not what it should be" if wrong else ""
        yield f"{name}, limit {value}: {complaint}" if complaint else ""


def full_disk(lab: Lab, tries: int) -> Iterator[str]:
    return limited(lab, tries, resource.RLIMIT_FSIZE, lambda rng: rng.choice([0, 1, 100, 1000]))


def few_descriptors(lab: Lab, tries: int) -> Iterator[str]:
    return limited(lab, tries, resource.RLIMIT_NOFILE, lambda rng: rng.randrange(3, 24))


def little_memory(lab: Lab, tries: int) -> Iterator[str]:
    return limited(lab, tries, resource.RLIMIT_AS, lambda rng: rng.randrange(80, 600) << 20)


def closed_streams(lab: Lab, tries: int) -> Iterator[str]:
    commands = [["info", PAINT], ["info", "nowhere.toml"], ["eval", PAINT, "--incident", "200",
                "--outgoing", "0"], ["measure", PAINT, "-o", "out-measured.csv"], ["nonsense"],
                ["--version"], ["--help"]]
    for command in commands:
        for stream in ("stdin", "stdout", "stderr"):
            for what in ("closed", "/dev/full"):
                redirect = {"stdin": "<", "stdout": ">", "stderr": "2>"}[stream]
                redirect += "&-" if what == "closed" else what
                usual = lab.run(command)
                shell = subprocess.run(
                    ["bash", "-c", f'exec "$0" "$@" {redirect}', str(lab.program), *command],
                    cwd=lab.folder, capture_output=True, timeout=HANG_S)
                writes = stream == "stdout" and usual.stdout
                expected = {3} if writes else {usual.status}
                if command[0].startswith("--"):
                    expected.add(0)  # nothing is lost
                status = shell.returncode
                yield ("" if status in expected else
                       f"{' '.join(command)} {redirect}: ended with {status}, not {expected}")


def output_is_input(lab: Lab, tries: int) -> Iterator[str]:
    measured = "measured.csv"
    lab.run(["measure", PAINT, "-o", measured])
    lab.run(WRITERS["solve"][0])
    os.replace(lab.path("out.h5"), lab.path("solved.h5"))
    lab.run(WRITERS["render"][0])
    os.replace(lab.path("out.exr"), lab.path("one.exr"))
    shutil.copy(lab.path(PAINT), lab.path("paint.toml"))
    shutil.copy(lab.path("paint.toml"), lab.path("foreign.png"))
    cases = [
        (["solve", "paint.toml", "-o", "{}"], "paint.toml"),
        (["measure", "paint.toml", "-o", "{}"], "paint.toml"),
        (["export", "paint.toml", "--cells", "8,8,16", "-o", "{}"], "paint.toml"),
        (["eval", "solved.h5", "--incident", "45", "--outgoing", "0", "-o", "{}"], "solved.h5"),
        (["diff", "one.exr", "one.exr", "-o", "{}"], "one.exr"),
        (["fit", measured, "--start", "paint.toml", "--free", "layer[0].thickness_um", "-o", "{}"],
         "paint.toml"),
        (["fit", measured, "--start", "paint.toml", "--free", "layer[0].thickness_um", "-o", "{}"],
         measured),
        (["panel", "paint.toml", "--quality", "low", "-o", "{}"], "paint.toml"),
        (["solve", "paint.toml", "-o", "new.h5", "--report", "{}"], "paint.toml"),
        (["render", "sphere", "--paint", "paint.toml", "--size", "2x2", "--spp", "1", "-o", "{}"],
         "paint.toml"),
        (["render", "sphere", "--paint", "paint.toml", "--size", "2x2", "--spp", "1", "-o",
          "foreign.exr"], "foreign.png"),
    ]
    os.link(lab.path("paint.toml"), lab.path("hard-link.toml"))
    os.symlink("paint.toml", lab.path("soft-link.toml"))
    for command, victim in cases:
        names = [victim]
        if victim == "paint.toml":
            names += ["./paint.toml", "hard-link.toml", "soft-link.toml"]
        for name in names:
            before = digest(lab.path(victim))
            outcome = lab.run([a.replace("{}", name) for a in command])
            complaint = outcome.complaint()
            if not complaint and digest(lab.path(victim)) != before:
                complaint = "replaced its input"
            elif not complaint and outcome.status == 0:
                complaint = "ended with 0"
            yield f"{' '.join(command)} with {name}: {complaint}" if complaint else ""


def unusual_places(lab: Lab, tries: int) -> Iterator[str]:
    """Outputs that cannot be written are refused at once, and nothing is replaced."""
    lab.path("folder").mkdir()
    for arguments, _ in WRITERS.values():
        for name in ("", "folder", "no-such-folder/x.h5", "dangling", PAINT + "/x"):
            command = arguments[:-1] + [name]
            lab.path("dangling").unlink(missing_ok=True)
            os.symlink("nowhere/at-all", lab.path("dangling"))
            outcome = lab.run(command)
            complaint = outcome.complaint() or ("ended with 0" if outcome.status == 0 else "")
            if not complaint and not lab.path("dangling").is_symlink():
                complaint = "replaced a link"
            yield f"{command}: {complaint}" if complaint else ""
    os.mkfifo(lab.path("fifo"))
    for name in ("fifo", "folder", "/dev/zero", "/dev/null", "dangling"):
        for command in (["info", name], ["solve", name, "-o", "x.h5"]):
            outcome = lab.run(command)
            complaint = outcome.complaint() or ("ended with 0" if outcome.status == 0 else "")
            yield f"{' '.join(command)}: {complaint}" if complaint else ""


def same_bytes(lab: Lab, tries: int) -> Iterator[str]:
    """The same input gives the same bytes, in another second and on any number of threads."""
    undisturbed = references(lab)
    time.sleep(1.1)
    for name, (arguments, outputs) in WRITERS.items():
        for threads in ("1", "2", "7"):
            remove_outputs(lab)
            outcome = lab.run([*arguments, "--threads", threads])
            wrong = [o for o in outputs if digest(lab.path(o)) != undisturbed[name][1][o]]
            yield (f"{name} with {threads} threads: other bytes in {wrong}, {outcome.stderr!r}"
                   if wrong else "")


# What each is called in the report, and how many of N tries it makes.
ATTACKS: list[tuple[str, Attack, float]] = [
    ("damaged files of twelve kinds", damaged_files, 1.0),
    ("small files that are large to read", hostile_texts, 0),
    ("recipes at the ends of the allowed ranges", extreme_recipes, 0.1),
    ("SIGKILL at a random moment", sigkill, 0.1),
    ("SIGINT or SIGTERM at a random moment", interrupts, 0.05),
    ("SIGINT or SIGTERM during long work", slow_interrupts, 0.08),
    ("a disk that fills up", full_disk, 0.02),
    ("3 to 23 file descriptors", few_descriptors, 0.05),
    ("80 to 600 MB of memory", little_memory, 0.05),
    ("closed or full standard streams", closed_streams, 0),
    ("an output that is an input or a foreign file", output_is_input, 0),
    ("outputs and inputs that are no files", unusual_places, 0),
    ("the same input again, on 1, 2 and 7 threads", same_bytes, 0),
]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--tries", type=int, default=1000, help="of the largest attack")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="attacks whose name contains this")
    parser.add_argument("--markdown", action="store_true", help="print the table of the docs")
    options = parser.parse_args()
    rows, failures = [], 0
    for name, attack, share in ATTACKS:
        if options.only not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            lab = Lab(options.program.resolve(), pathlib.Path(folder), random.Random(options.seed))
            start, tries, wrong = time.monotonic(), 0, 0
            for complaint in attack(lab, max(5, round(share * options.tries))):
                tries += 1
                if complaint:
                    wrong += 1
                    print(f"{name}: {complaint}", file=sys.stderr)
            seconds = time.monotonic() - start
        name += lab.note
        print(f"{name}: {tries} tries, {wrong} failures, {seconds:.0f} s", file=sys.stderr)
        rows.append((name, tries, wrong))
        failures += wrong
    if options.markdown:
        print("| Attack | Tries | Failures |\n|---|--:|--:|")
        for row in rows:
            print("| {} | {} | {} |".format(*row))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
