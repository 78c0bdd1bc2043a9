"""Plans of a library: sampling, keys, and what their records are named by."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import plan_of
from nacre.library import Plan, keys, sampling
from nacre.library.construction import construction, ingredients

import nacre

# Where a sweep looks


def test_grids_have_both_ends_and_every_combination() -> None:
    length = sampling.Range(1, 100, logarithmic=True, steps=3)
    assert length.grid() == [1, 10, 100]
    points = sampling.grid([length, sampling.Choice(("mica", "SiO2"))])
    assert points == [(x, m) for x in (1, 10, 100) for m in ("mica", "SiO2")]


@pytest.mark.parametrize("count", [1, 7, 50])
def test_a_latin_hypercube_has_one_point_in_each_interval(count: int) -> None:
    axes = [sampling.Range(10, 20), sampling.Range(1, 100, logarithmic=True)]
    points = np.array(sampling.latin_hypercube(axes, count, seed=5), dtype=float)
    units = np.stack([(points[:, 0] - 10) / 10, np.log10(points[:, 1]) / 2])
    for unit in units:
        assert sorted(np.floor(unit * count * (1 - 1e-6)).astype(int)) == list(range(count))


def test_a_longer_sobol_sequence_begins_with_the_shorter_one() -> None:
    axes: list[sampling.Axis] = [sampling.Range(0, 1), sampling.Choice(("a", "b", "c"))]
    points = sampling.sobol(axes, 64, seed=1)
    assert points[:10] == sampling.sobol(axes, 10, seed=1)
    assert points != sampling.sobol(axes, 64, seed=2)
    # Balanced: a power of two has as many points in each of two halves.
    assert sum(float(x) < 0.5 for x, _ in points) == 32
    assert {choice for _, choice in points} == {"a", "b", "c"}


# Keys


def test_numbers_set_by_key_are_those_of_paint() -> None:
    for name in ("ruby", "candy-red", "satin-silver", "black-pearl"):
        paint = nacre.Paint(name)
        recipe = paint.to_dict()
        for key, number in paint.parameters.items():
            changed = paint.to_dict()
            if number.value == 0:  # which may go without saying
                assert keys.all_values(recipe).get(key, 0) == 0
                continue
            assert keys.all_values(recipe)[key] == pytest.approx(number.value, abs=1e-15)
            value = 0.875 * number.value if number.value > number.lo else number.value
            keys.put(changed, key, value)
            expected = paint.with_values({key: value})
            assert nacre.Paint.from_dict(changed).sha256 == expected.sha256, key


def test_keys_are_found_by_their_end() -> None:
    recipe = nacre.Paint("ruby").to_dict()
    assert keys.matching(recipe, "substrate.reflectance") == ["substrate.reflectance"]
    assert keys.matching(recipe, "flakes[1].core.thickness_nm") == [
        "layer[0].flakes[1].core.thickness_nm"
    ]
    assert len(keys.matching(recipe, "*alpha")) == 2
    assert keys.matching(recipe, "pha") == []
    with pytest.raises(ValueError, match=r"flakes\[0\].*flakes\[1\].*write more of the key"):
        keys.matching(recipe, "alpha")


def test_what_is_not_there_is_added_by_its_whole_path() -> None:
    recipe = nacre.Paint("metallic-gray").to_dict()
    keys.put(recipe, "clearcoat.thickness_um", 40)
    assert recipe["clearcoat"] == {"thickness_um": 40}
    with pytest.raises(ValueError, match=r"layer\[1\].thickness_um: the recipe has no entry \[1\]"):
        keys.put(recipe, "layer[1].thickness_um", 40)
    with pytest.raises(ValueError, match="ior"):
        keys.put(recipe, "ior.n", 40)


def test_a_construction_has_no_numbers() -> None:
    black_pearl = nacre.Paint("black-pearl")
    text = "clear / TiO2_anatase|SiO2 + carbon black, fine"
    assert construction(black_pearl.to_dict()) == text
    changed = black_pearl.with_values({key: black_pearl[key] * 0.9 for key in ("alpha",)})
    assert construction(changed.to_dict()) == text
    assert construction(nacre.Paint("candy-red").to_dict()) == "tinted clear / Al2O3|Al"
    assert construction(nacre.Paint("satin-silver").to_dict()) == "rough clear / Al2O3|Al"
    assert construction(nacre.Paint("metallic-gray").to_dict()) == "prescribed flakes"
    assert ingredients(nacre.Paint("ruby").to_dict()) == ["Fe2O3|mica", "Al2O3|Al", "pigment"]


# Plans

SWEEP = '[[sweep]]\nbase = "tio2-mica-80"\n'
REFUSALS = {
    "[[sweep]": "cannot be read as a plan",
    "": "has no [[sweep]]",
    SWEEP + "colour = 1": "sweep[0].colour = 1: unknown key; allowed here: name, recipe, base",
    "[record]\nsolved = 1\n" + SWEEP: "record.solved = 1: must be true or false",
    '[record]\ngeometries = "byk-max"\n' + SWEEP: "did you mean 'byk-mac'",
    '[record]\nmodel = "glue"\n' + SWEEP: "record.model = 'glue'",
    "[record.rgl]\nresolution = 513\n" + SWEEP: "must be a whole number in [4, 512]",
    "[record.rgl]\nincidences = 257\n" + SWEEP: "must be a whole number in [2, 256]",
    "[record.sparkle]\nlamps_deg = [86]\n" + SWEEP: "lamps_deg = 86: must be an angle in [0, 85]",
    '[record]\nilluminant = "D66"\n' + SWEEP: "illuminant 'D66' is unknown",
    "[record.thumbnails]\nball = { size = 8 }\n"
    + SWEEP: "record.thumbnails.ball.size = 8: must be",
    '[[sweep]]\nbase = "tio2-mica-8"': "sweep[0].base = 'tio2-mica-8': must be a recipe's file or",
    SWEEP + "recipe = { ior = 1.5 }": "sweep[0].base or a table recipe",
    "[[sweep]]\nrecipe = { ior = 0.5 }": "sweep[0].recipe : recipe:1",
    SWEEP + 'method = "dice"': "sweep[0].method = 'dice': must be one of grid, list,",
    SWEEP + 'method = "sobol"\nvary = { ior = { from = 1, to = 2 } }': "sweep[0].count is missing",
    SWEEP + 'method = "sobol"\ncount = 8': "sweep[0].vary is missing",
    SWEEP + "vary = { ior = { from = 1, to = 2 } }": "sweep[0].vary.ior.steps is missing",
    SWEEP + "vary = { ior = { from = 2, to = 1, steps = 2 } }": "ior.to = 1.0: must be above from",
    SWEEP + 'vary = { ior = { from = 0, to = 1, steps = 2, scale = "log" } }': "above 0",
    SWEEP + "vary = { ior = { from = 1.4, to = 3.5, steps = 3 } }": (
        "sweep[0].vary.ior = 3.5, in TiO2 on mica, 80 nm (gold): recipe:2:7: ior = 3.5: "
        "must be a number in [1, 3]"
    ),
    SWEEP + 'vary = { "core.material" = ["mica", "micca"] }': (
        "sweep[0].vary.\"core.material\" = 'micca'"
    ),
    SWEEP + "vary = { thickness_nm = [1, 2] }": "write more of the key",
    SWEEP + 'vary = { "layer[0].thicknes_um" = [1, 2] }': "thicknes_um",
    SWEEP + "vary = { thicknes_um = [1, 2] }": "is no value of this recipe; its numbers are ior,",
    SWEEP + 'method = "list"\nvary = { ior = [1.5], "*alpha" = [0.1, 0.2] }': "equally long",
    SWEEP + 'set = { "substrate.reflectance" = 2 }': 'sweep[0].set."substrate.reflectance" = 2',
    SWEEP + 'name = "a"\n' + SWEEP + 'name = "a"': "name = 'a': must be another for each sweep",
    SWEEP + 'name_format = "{alpha}"\n': "sweep[0].name_format = '{alpha}': {alpha}: does not vary",
}


@pytest.mark.parametrize(("text", "message"), REFUSALS.items())
def test_what_is_wrong_in_a_plan_is_refused(tmp_path: Path, text: str, message: str) -> None:
    file = tmp_path / "plan.toml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(nacre.InputError) as error:
        Plan(file)
    assert str(error.value).startswith(f"{file}: ")
    assert message in str(error.value)


def ids_of(folder: Path, text: str) -> list[str]:
    return [record.id for record in plan_of(folder, text).records()]


def test_a_record_is_named_by_its_content(tmp_path: Path) -> None:
    sobol = SWEEP + 'method = "sobol"\nvary = {"*alpha" = {from = 0.05, to = 0.2}}\ncount = '
    few, many = ids_of(tmp_path, sobol + "4"), ids_of(tmp_path, sobol + "8")
    assert many[:4] == few
    assert len(set(many)) == 8
    # Whole numbers are numbers, and a paint that is planned twice is one record.
    whole, broken = (f'vary = {{"clearcoat.thickness_um" = [{x}]}}\n' for x in ("40", "40.0"))
    twice = SWEEP + 'name = "a"\n' + whole + SWEEP + 'name = "b"\n' + broken
    assert len(ids_of(tmp_path, twice)) == 1
    # What is computed is part of it.
    assert not set(few) & set(ids_of(tmp_path, "[record]\nsolved = true\n" + sobol + "4"))


def test_a_plan_is_the_same_in_every_process(tmp_path: Path) -> None:
    """Where it is read anew, by a run that goes on; whatever order sets have there."""
    sweep = """
        [[sweep]]
        name = "{method}"
        base = "tio2-mica-80"
        method = "{method}"
        count = 6
        [sweep.vary]
        "*alpha" = {{ from = 0.05, to = 0.2 }}
        "coats[0].material" = ["TiO2_anatase", "SiO2"]
        """
    methods = ("sobol", "latin-hypercube")
    here = ids_of(tmp_path, "".join(sweep.format(method=method) for method in methods))
    assert len(here) == 12
    code = "import sys, nacre.library as n; print(*(r.id for r in n.Plan(sys.argv[1]).records()))"
    there = subprocess.run(
        [sys.executable, "-c", code, tmp_path / "plan.toml"],
        env=os.environ | {"PYTHONHASHSEED": "7"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert there.stdout.split() == here


def test_records_do_not_share_what_they_take_from_a_list(tmp_path: Path) -> None:
    """A table that several points of a sweep choose is changed by each of them for itself."""
    plan = plan_of(
        tmp_path,
        """
        [[sweep]]
        name = "metallic"
        base = "blue-metallic"
        method = "grid"
        [sweep.vary]
        "layer[0].pigment" = [[{ from = "carbon-black-fine", volume_fraction = 0.03 }]]
        "layer[0].pigment[0].volume_fraction" = [0.01, 0.02, 0.04]
        """,
    )
    records = list(plan.records())
    amounts = [r.recipe["layer"][0]["pigment"][0]["volume_fraction"] for r in records]
    assert amounts == [0.01, 0.02, 0.04]
    for record in records:
        assert record.swept["layer[0].pigment"][0]["volume_fraction"] == 0.03


def test_a_base_may_be_a_file_beside_the_plan_with_files_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "primer.csv").write_text("wavelength_nm,value\n400,0.2\n700,0.4\n", "utf-8")
    recipe = (
        'ior = 1.5\n[[layer]]\nthickness_um = 5\n[substrate]\nreflectance = "primer.csv"\n'
        '[fit]\n"layer[0].thickness_um" = [4, 6]\n'
    )
    (tmp_path / "base.toml").write_text(recipe, "utf-8")
    plan = plan_of(
        tmp_path, '[[sweep]]\nbase = "base.toml"\nvary = {"layer[0].thickness_um" = [9]}\n'
    )
    (record,) = plan.records()
    assert record.recipe["substrate"]["reflectance"]["values"] == [0.2, 0.4]
    assert record.swept == {"layer[0].thickness_um": 9}
    assert record.name == "base, thickness_um 9"
    # Bounds of a fit are no part of the paint, and the swept value lies outside of them.
    assert nacre.Paint.from_dict(record.recipe)["layer[0].thickness_um"] == 9
