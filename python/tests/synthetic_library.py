"""Libraries of any size in seconds: real recipes and files, but readings by a formula.

    python python/tests/synthetic_library.py LIBRARY RECORDS

Half of the records have thumbnails. The page is written too, and expected.json beside it: what a
reader of the page must find, computed here.
"""

from __future__ import annotations

import hashlib
import json
import os
import struct
import sys
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from nacre.library.catalogue import Catalogue, write_catalogue
from nacre.library.construction import construction, ingredients
from nacre.library.page import write_page
from nacre.library.record import _readings, record_folder
from nacre.library.settings import read_settings
from numpy.typing import NDArray

import nacre
from nacre import Measurement, _toml

Floats = NDArray[np.float64]

GEOMETRIES = ["45as-15", "45as15", "45as25", "45as45", "45as75", "45as110", "15as15", "45as25az90"]
WAVELENGTHS_NM = np.arange(400.0, 701.0, 10.0)
TARGET = (38.5, 21.0, -12.25)
"""L*a*b* that a reader of the page types in."""

SETTINGS = read_settings(None).to_dict()
FILMS = ["TiO2_rutile", "Fe2O3", "SnO2", "SiO2"]
CORES = ["mica", "Al", "glass", "Al2O3"]


NASTY = '</script><b title="&amp;">\\ \u2028 \u00e4 \U0001f3a8'
"""The name of record 3, which must stay text wherever it is shown."""


def recipe(number: int, rng: np.random.Generator) -> dict[str, Any]:
    film, core = FILMS[number % len(FILMS)], CORES[number // 4 % len(CORES)]
    coat = {"material": film, "thickness_nm": round(rng.uniform(40, 240), 2), "spread_nm": 5.0}
    flakes = {
        "name": f"{film} on {core}",
        "volume_fraction": round(rng.uniform(0.01, 0.12), 4),
        "diameter_um": 18.0,
        "diameter_spread_um": 6.0,
        "orientation": {"distribution": "beckmann", "alpha": round(rng.uniform(0.05, 0.2), 3)},
        "core": {"material": core, "thickness_nm": 500.0, "spread_nm": 60.0},
        "coats": [coat],
    }
    return {
        "name": NASTY if number == 3 else f"{film} on {core}, no. {number}",
        "ior": 1.5,
        "clearcoat": {"thickness_um": 45.0},
        "layer": [{"thickness_um": 15.0, "flakes": [flakes]}],
        "substrate": {"reflectance": 0.05},
    }


def reflectance(of: dict[str, Any]) -> Floats:
    """(G, W): a lobe in which an interference fringe travels, over a little scattered light."""
    flakes = of["layer"][0]["flakes"][0]
    film, share = flakes["coats"][0], flakes["volume_fraction"]
    index = 1.4 + 0.35 * FILMS.index(film["material"])
    curves = []
    for name in GEOMETRIES:
        lamp, _, rest = name.partition("as")
        aspecular = float(rest.split("az")[0])
        inside = np.sin(np.radians(float(lamp) - aspecular / 2)) / index
        path_nm = 2 * index * film["thickness_nm"] * np.sqrt(1 - inside**2)
        fringe = np.cos(np.pi * path_nm / WAVELENGTHS_NM) ** 2
        lobe = np.exp(-((aspecular / (300 * flakes["orientation"]["alpha"])) ** 2))
        curves.append(0.004 + 0.3 * share * fringe + 25 * share * lobe * (0.1 + fringe))
    return np.array(curves)


def png(rng: np.random.Generator, size: int = 192) -> bytes:
    """A picture that is as long to decode as a rendered one."""
    colour = rng.integers(40, 215, 3)
    pixels = np.clip(colour + rng.normal(0, 12, (size, size, 3)), 0, 255).astype(np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(kind: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    head = struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        [chunk(b"IHDR", head), chunk(b"IDAT", zlib.compress(rows, 1)), chunk(b"IEND", b"")]
    )


def make(library: Path, records: int, seed: int = 1) -> list[str]:
    """Writes records and catalogue, and returns the records' ids in the catalogue's order."""
    rng = np.random.default_rng(seed)
    library.mkdir(parents=True, exist_ok=True)
    (library / "library.toml").write_text('[library]\nname = "Synthetic paints"\n')
    pictures = []
    for number in range(min(records, 8)):
        pictures.append(library / f".picture{number}.png")
        pictures[-1].write_bytes(png(rng))
    ids = [_write_record(library, number, rng, pictures) for number in range(records)]
    for picture in pictures:
        picture.unlink()
    for name in ("planned.txt", "LICENSE", "CITATION.cff"):
        (library / name).write_text("")  # no part of the page
    write_catalogue(library, ids)
    return ids


def _write_record(
    library: Path, number: int, rng: np.random.Generator, pictures: list[Path]
) -> str:
    made_of = recipe(number, rng)
    text = _toml.dumps(made_of)
    identity = hashlib.sha256(text.encode()).hexdigest()[:32]
    folder = record_folder(library, identity)
    folder.mkdir(parents=True)
    (folder / "recipe.toml").write_text(text)
    read = Measurement.from_spectra(
        GEOMETRIES, WAVELENGTHS_NM, reflectance(made_of), name=made_of["name"]
    )
    if number < 64:  # those that tests look at
        read.write(folder / "readings.csv")
    if number % 2 == 0:
        os.link(pictures[number // 2 % len(pictures)], folder / "ball.png")
    # Sums of pictures, which are not read here, would take most of the time.
    files = dict.fromkeys((entry.name for entry in os.scandir(folder)), "0" * 64)
    thickness_nm = made_of["layer"][0]["flakes"][0]["coats"][0]["thickness_nm"]
    record = {
        "id": identity,
        "name": made_of["name"],
        "sweep": f"sweep {number % 3}",
        "base": "synthetic",
        "construction": construction(made_of),
        "pigments": ingredients(made_of),
        "parameters": {"layer[0].flakes[0].coats[0].thickness_nm": thickness_nm},
        "swept": {"thickness_nm": thickness_nm, "core": CORES[number // 4 % len(CORES)]},
        "settings": SETTINGS,
        "readings": _readings([read]),
        "flop_index": read.flop_index,
        "colour_travel": read.colour_travel,
        "sparkle": _sparkle(rng),
        "graininess": rng.uniform(0, 40),
        "flakes_resolved": True,
        "warnings": ["this paint was made up"] if number % 7 == 0 else [],
        "recipe_sha256": hashlib.sha256(text.encode()).hexdigest(),
        "seconds": {"total": 0.01},
        "version": nacre.__version__,
        "files": files,
    }
    (folder / "record.json").write_text(json.dumps(record))
    return identity


def _sparkle(rng: np.random.Generator) -> list[dict[str, float]]:
    names = ("spots_per_cm2", "intensity", "contrast", "area_percent", "sparkle")
    return [
        {"lamp_deg": lamp_deg}
        | {f"{name}{se}": rng.uniform(1, 100) for name in names for se in ("", "_se")}
        for lamp_deg in (45.0, 15.0)
    ]


def expected(library: Path) -> dict[str, Any]:
    """By the package's own functions from the catalogue: no line of the page's takes part."""
    columns = ["id", "pigments", "Lab", "srgb", "flop_index", "h45", "sparkle"]
    rows = Catalogue(library).rows(columns)
    at: dict[str, Any] = {}
    for name in ("45as15", "45as45", "45as-15"):
        lab = np.array([row["Lab"][GEOMETRIES.index(name)] for row in rows])
        distance = nacre.delta_e_2000(np.array(TARGET), lab)
        order = np.argsort(distance, kind="stable")[:24]
        at[name] = [[rows[i]["id"], float(distance[i])] for i in order]
    film = [row for row in rows if "Fe2O3|mica" in row["pigments"]]
    first = rows[0]
    return {
        "target": TARGET,
        "nearest": at,
        "with_Fe2O3_mica": len(film),
        "flop_10_to_20": sum(1 for row in rows if 10 <= (row["flop_index"] or -1) <= 20),
        "hue_300_to_40": sum(1 for row in rows if not 40 < row["h45"] < 300),
        "sparkling": sum(1 for row in rows for lamp in row["sparkle"] if _sparkles(lamp, 15.0, 50)),
        "ids": [row["id"] for row in rows],
        "nasty": {"id": rows[3]["id"], "name": NASTY},
        "first": {
            "id": first["id"],
            "chips": [
                "#" + "".join(f"{round(255 * x):02x}" for x in srgb) for srgb in first["srgb"]
            ],
        },
        "difference": _difference(library, rows[0]["id"], rows[1]["id"]),
    }


def _sparkles(lamp: dict[str, float], lamp_deg: float, least: float) -> bool:
    return lamp["lamp_deg"] == lamp_deg and lamp["sparkle"] >= least


def _difference(library: Path, standard: str, sample: str) -> dict[str, Any]:
    a, b = (
        Measurement.read(record_folder(library, x) / "readings.csv") for x in (standard, sample)
    )
    difference = b.difference(a)
    return {
        "standard": standard,
        "sample": sample,
        "geometries": difference.geometries,
        "dLab": difference.dLab.tolist(),
        "dC": difference.dC.tolist(),
        "dH": difference.dH.tolist(),
        "dE2000": difference.dE2000.tolist(),
        "mean": difference.mean_dE2000,
        "max": difference.max_dE2000,
    }


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    make(folder, int(sys.argv[2]))
    (folder / "expected.json").write_text(json.dumps(expected(folder)))
    write_page(folder)
