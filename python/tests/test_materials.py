"""Materials fitted to paints, before the formats' own tools."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT

import nacre

VALIDATOR = Path(__file__).with_name("gltf_validator")
NM = [400.0, 430, 460, 490, 520, 550, 580, 610, 640, 670, 700]


@pytest.fixture(scope="module")
def gltf_validator() -> Path:
    """A folder with Khronos' validator, installed by its lock file."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        pytest.skip("there is no Node.js, which Khronos' validator of glTF needs")
    folder = ROOT / "build" / "gltf-validator"
    folder.mkdir(parents=True, exist_ok=True)
    lock = (VALIDATOR / "package-lock.json").read_bytes()
    installed = folder / "package-lock.json"
    if not ((folder / "node_modules").is_dir() and installed.read_bytes() == lock):
        shutil.rmtree(folder / "node_modules", ignore_errors=True)
        for file in ("package.json", "package-lock.json"):
            shutil.copy(VALIDATOR / file, folder)
        npm = subprocess.run(
            ["npm", "ci", "--silent", "--ignore-scripts"],
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
        )
        if npm.returncode != 0:
            pytest.skip(f"npm could not install Khronos' validator of glTF: {npm.stderr.strip()}")
    return folder


def test_gltf_is_valid(gltf_validator: Path, paints: Path, tmp_path: Path) -> None:
    files = []
    for name in ("red-gold", "satin-silver"):
        files.append(tmp_path / f"{name}.gltf")
        nacre.Paint(paints / f"{name}.toml").write(files[-1], wavelengths_nm=NM)
    found = subprocess.run(
        ["node", VALIDATOR / "validate.js", *files],
        cwd=gltf_validator,
        capture_output=True,
        text=True,
        check=True,
    )
    issues = json.loads(found.stdout)
    assert issues == {str(file): [] for file in files}


def test_materialx_is_valid_and_makes_a_shader(paints: Path, tmp_path: Path) -> None:
    mx = pytest.importorskip("MaterialX", reason="there is no package MaterialX")
    generators = pytest.importorskip("MaterialX.PyMaterialXGenShader")
    glsl = pytest.importorskip("MaterialX.PyMaterialXGenGlsl")
    library = mx.createDocument()
    folders, search = mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath()
    mx.loadLibraries(folders, search, library)
    for name in ("red-gold", "satin-silver"):
        file = tmp_path / f"{name}.mtlx"
        nacre.Paint(paints / f"{name}.toml").write(file, wavelengths_nm=NM)
        document = mx.createDocument()
        mx.readFromXmlFile(document, str(file))
        document.setDataLibrary(library)
        assert document.validate() == (True, "")
        generator = glsl.GlslShaderGenerator.create()
        context = generators.GenContext(generator)
        context.registerSourceCodeSearchPath(search)
        (material,) = generators.findRenderableElements(document)
        shader = generator.generate("paint", material, context)
        assert "cellnoise" in shader.getSourceCode("pixel")


def test_a_fit_says_what_it_misses(paints: Path, tmp_path: Path) -> None:
    paint = nacre.Paint(paints / "solid-red.toml")
    fitted = paint.write(tmp_path / "red.gltf", wavelengths_nm=NM)
    assert isinstance(fitted, nacre.FittedMaterial)
    assert list(fitted.delta_e_2000) == [
        *("45as-15", "45as15", "45as25", "45as45", "45as75", "45as110")
    ]
    assert fitted.max_delta_e_2000 == max(fitted.delta_e_2000.values())
    assert len(fitted.tested_delta_e_2000) == 17
    assert fitted.tested_max_delta_e_2000 == max(fitted.tested_delta_e_2000.values())
    assert 0 <= fitted.parameters["roughnessFactor"] <= 1
    # The colours themselves, and as a notebook shows them.
    for lab, delta_e in (
        (fitted.Lab, fitted.delta_e_2000),
        (fitted.tested_Lab, fitted.tested_delta_e_2000),
    ):
        again = nacre.delta_e_2000(lab[:, 0], lab[:, 1])
        np.testing.assert_allclose(again, list(delta_e.values()), rtol=1e-12)
    shown = fitted._repr_html_()
    assert shown.count("background:#") == 2 * (6 + 17)
    assert "45as-15" in shown
    assert f"ΔE {fitted.delta_e_2000['45as15']:.1f}" in shown
