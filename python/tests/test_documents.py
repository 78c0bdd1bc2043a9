"""Does what docs/python.md, library.md and the notebooks say, without Jupyter."""

from __future__ import annotations

import ast
import inspect
import json
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT

import nacre

NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))


def run_cell(source: str, name: str, variables: dict[str, Any]) -> Any:
    """Runs code, and hands back the value of its last line where that is an expression."""
    tree = ast.parse(source, name)
    last = tree.body[-1]
    if not isinstance(last, ast.Expr):
        exec(compile(tree, name, "exec"), variables)
        return None
    head = ast.Module(tree.body[:-1], type_ignores=[])
    exec(compile(head, name, "exec"), variables)
    return eval(compile(ast.Expression(last.value), name, "eval"), variables)


def how_to(name: str = "python.md") -> list[str]:
    """The blocks of a page."""
    document = (ROOT / "docs" / name).read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```$", document, flags=re.DOTALL | re.MULTILINE)


def cells(notebook: Path) -> list[str]:
    """The code of a notebook, which must be without outputs."""
    found = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    code = [cell for cell in found if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] for cell in code)
    return ["".join(cell["source"]) for cell in code]


def test_how_to(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pandas", reason="pandas, which docs/python.md shows, is not installed")
    blocks = how_to()
    shutil.copytree(ROOT / "paints", tmp_path / "paints")
    (tmp_path / "library").symlink_to(ROOT / "library")
    monkeypatch.chdir(tmp_path)
    assert len(blocks) > 5
    variables: dict[str, Any] = {}
    for i, block in enumerate(blocks):
        run_cell(block, f"docs/python.md, block {i + 1}", variables)
    assert (tmp_path / "pearl.exr").stat().st_size > 0


def test_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from nacre.library import Plan, catalogue

    document = (ROOT / "docs" / "library.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    variables: dict[str, Any] = {}
    for i, block in enumerate(how_to("library.md")):
        run_cell(block, f"docs/library.md, block {i + 1}", variables)
    assert len(variables["frame"]) == 3
    (plan,) = re.findall(r"^```toml\n(.*?)^```$", document, flags=re.DOTALL | re.MULTILINE)
    Path("plan.toml").write_text(plan, encoding="utf-8")
    assert len(Plan("plan.toml")) == 64 + 16
    table = document.split("<!-- columns -->")[1].split("\n\n")[0]
    first_cells = [line.split("|")[1] for line in table.strip().splitlines()[2:]]
    columns = [name for cell in first_cells for name in re.findall(r"`(\w+)`", cell)]
    assert sorted(columns) == sorted(name for name, _ in catalogue.COLUMNS)


def test_project_plans() -> None:
    from nacre.library import Plan

    assert len(list(Plan(ROOT / "library" / "sweep.toml").records())) == 500
    named = {
        base for sweep in Plan(ROOT / "library" / "paints.toml").sweeps for base, _ in sweep.bases
    }
    assert named == {nacre.Paint(name).name for name in nacre.shipped_paints()}


def test_mitsuba(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("mitsuba", reason="Mitsuba is not installed here")
    blocks = how_to("mitsuba.md")
    shutil.copytree(ROOT / "paints", tmp_path / "paints")
    monkeypatch.chdir(tmp_path)
    assert blocks
    variables: dict[str, Any] = {}
    for i, block in enumerate(blocks):
        run_cell(block, f"docs/mitsuba.md, block {i + 1}", variables)
    assert np.array(variables["flakes"]).std() > 0
    # The thickness that was looked for; one picture more or less is worth 0.6 nm.
    recovered = np.array(variables["optimizer"][variables["name"]])
    assert abs(float(recovered.item()) - 88) < 1.5


def test_an_error_is_quoted_as_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    block = how_to()[-1]
    quoted = block.split("print(error)  # ")[1].strip()
    monkeypatch.chdir(ROOT)
    start = 'import nacre\npaint = nacre.Paint("paints/tio2-mica-80.toml")\n'
    run_cell(start + block, "the last block", {})
    assert capsys.readouterr().out.strip() == quoted


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: str(path.stem))
def test_notebook(notebook: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    code = cells(notebook)
    assert len(code) >= 3
    monkeypatch.chdir(notebook.parent)
    variables: dict[str, Any] = {}
    shown = 0
    for i, cell in enumerate(code):
        value = run_cell(cell, f"{notebook.name}, cell {i + 1}", variables)
        for representation in ("_repr_html_", "_repr_png_"):
            if hasattr(value, representation):
                assert getattr(value, representation)()
                shown += 1
    assert shown >= 2


def test_there_are_notebooks() -> None:
    assert len(NOTEBOOKS) == 3


def test_everything_public_says_what_it_is() -> None:
    silent, asked = [], 0
    for name in nacre.__all__:
        thing = getattr(nacre, name)
        if not callable(thing):
            continue
        members = vars(thing).items() if inspect.isclass(thing) else ()
        parts = {name: thing} | {
            f"{name}.{key}": value for key, value in members if not key.startswith("_")
        }
        for path, part in parts.items():
            function = part.fget if isinstance(part, property) else getattr(part, "__func__", part)
            if callable(function):
                asked += 1
                if not (function.__doc__ or "").strip():
                    silent.append(path)
    assert asked > 100
    assert silent == []


def test_types_of_what_is_shown(tmp_path: Path) -> None:
    mypy = pytest.importorskip("mypy.api", reason="mypy is not installed")
    shown = {"how_to": "\n".join(how_to())}
    shown |= {path.stem.replace("-", "_"): "\n".join(cells(path)) for path in NOTEBOOKS}
    for name, code in shown.items():
        (tmp_path / f"{name}.py").write_text(code, encoding="utf-8")
    files = [str(tmp_path / f"{name}.py") for name in shown]
    text, errors, status = mypy.run(["--config-file", str(ROOT / "pyproject.toml"), *files])
    assert status == 0, text + errors
