"""Does what docs/python.md and the notebooks say, without Jupyter."""

from __future__ import annotations

import ast
import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

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


def test_how_to(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pandas", reason="pandas, which docs/python.md shows, is not installed")
    document = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    shutil.copytree(ROOT / "paints", tmp_path / "paints")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```$", document, flags=re.DOTALL | re.MULTILINE)
    assert len(blocks) > 5
    variables: dict[str, Any] = {}
    for i, block in enumerate(blocks):
        run_cell(block, f"docs/python.md, block {i + 1}", variables)
    assert (tmp_path / "pearl.exr").stat().st_size > 0


def test_an_error_is_quoted_as_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    document = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    block = document[document.rindex("```python\n") + 10 : document.rindex("```")]
    quoted = block.split("print(error)  # ")[1].strip()
    monkeypatch.chdir(ROOT)
    start = 'import nacre\npaint = nacre.Paint("paints/tio2-mica-80.toml")\n'
    run_cell(start + block, "the last block", {})
    assert capsys.readouterr().out.strip() == quoted


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: str(path.stem))
def test_notebook(notebook: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    assert len(code) >= 3
    monkeypatch.chdir(notebook.parent)
    variables: dict[str, Any] = {}
    shown = 0
    for i, cell in enumerate(code):
        assert cell["outputs"] == []
        value = run_cell("".join(cell["source"]), f"{notebook.name}, cell {i + 1}", variables)
        for representation in ("_repr_html_", "_repr_png_"):
            if hasattr(value, representation):
                assert getattr(value, representation)()
                shown += 1
    assert shown >= 2


def test_there_are_notebooks() -> None:
    assert len(NOTEBOOKS) == 3
