"""The search of a library against comparing with every record."""

from __future__ import annotations

import numpy as np
import pytest
from nacre.library.find import Standard, _Search, colour_bound, lightness_bound
from nacre.library.index import Floats, Index, IndexWriter

import nacre


def pairs(count: int) -> tuple[Floats, Floats]:
    """(count, 3) L*a*b* of two colours, some near each other, some far apart, blues among them."""
    rng = np.random.default_rng(7)
    one = np.stack([rng.uniform(0, 160, count), *rng.normal(0, 60, (2, count))], axis=1)
    return one, one + rng.normal(0, 1, (count, 3)) * rng.choice([0.01, 1, 10, 60], (count, 1))


def test_no_delta_e_is_below_its_bounds() -> None:
    one, other = pairs(200_000)
    exact = nacre.delta_e_2000(one, other) * (1 + 1e-12)
    of_lightness = lightness_bound(one[:, :1], other[:, 0][:, None])
    # The bound of one angle each: N standards are as many angles of one record.
    tight = np.array(
        [
            colour_bound(one[i : i + 1].T[:, :, None], other[i : i + 1])[0]
            for i in range(0, len(one), 40)
        ]
    )
    assert np.all(of_lightness <= exact)
    assert np.all(tight <= exact[::40])
    assert np.median(tight / exact[::40]) > 0.5  # and they say something


@pytest.fixture(scope="module")
def index(tmp_path_factory: pytest.TempPathFactory) -> Index:
    """20 000 made-up paints at three angles, with sparkle."""
    rng = np.random.default_rng(11)
    writer = IndexWriter()
    head = {
        "geometries": ["45as15", "45as45", "45as110"],
        "theta_i_deg": [45, 45, 45],
        "theta_o_deg": [30, 0, 65],
        "phi_deg": [180, 0, 0],
    }
    for i in range(20_000):
        Lab = rng.uniform((5, -60, -60), (130, 60, 60), (1, 3)) + rng.normal(0, 10, (3, 3))
        writer.add(
            {
                "id": f"{i:032x}",
                "construction": f"kind {i % 7}",
                "settings": {},
                "readings": {**head, "Lab": Lab.tolist()},
                "sparkle": [{"sparkle": rng.uniform(0, 800)}],
                "graininess": rng.uniform(0, 40),
            }
        )
    folder = tmp_path_factory.mktemp("index")
    writer.write(folder)
    return Index.open(folder)


@pytest.mark.parametrize("places", [[0, 1, 2], [2, 0]])
def test_a_search_finds_what_comparing_with_all_finds(index: Index, places: list[int]) -> None:
    """By colour alone, and by sparkle too."""
    rng = np.random.default_rng(2)
    Lab = np.moveaxis(np.asarray(index.Lab), 0, -1)[:, places]
    for place in rng.integers(index.count, size=20):
        standard = Standard(
            "", Lab[place] + rng.normal(0, 3, (len(places), 3)), places, np.array([50.0, 9.0])
        )
        by_colour = nacre.delta_e_2000(Lab, standard.Lab).mean(axis=1)
        ratio = np.log2((1 + index.sparkle) / (1 + np.array([50.0, 9.0])))
        for weight in (0.0, 3.0):
            all_of_them = by_colour + weight * np.abs(ratio).mean(axis=1)
            order = np.argsort(all_of_them, kind="stable")
            search = _Search(index, standard, weight)
            assert search.nearest(25) == order[:25].tolist()
            best = [next(place for place in order if place % 7 == kind) for kind in range(7)]
            best.sort(key=lambda place: all_of_them[place])
            assert search.best_of_each(index.construction) == best
