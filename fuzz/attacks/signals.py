"""Signals at random moments."""

import contextlib
import os
import pathlib
import resource
import signal
import subprocess
import time
from collections.abc import Iterator

from .lab import (
    ANSWER_CPU_S,
    ANSWER_S,
    HANG_S,
    PAINT,
    WRITERS,
    Lab,
    digest,
    partial_files,
    references,
    remove_outputs,
    torn,
)

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
