"""Work that takes long: progress, Ctrl-C, threads, the interpreter's lock."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import nacre


@pytest.fixture
def flakes(paints: Path) -> nacre.Paint:
    return nacre.Paint(paints / "metallic-silver.toml")


LONG = 1 << 20  # samples per pixel of a picture that nobody waits for


def test_progress_is_told_and_may_stop_a_picture(flakes: nacre.Paint) -> None:
    told: list[float] = []
    caller = threading.get_ident()

    def three_times(fraction: float) -> bool:
        assert threading.get_ident() == caller
        told.append(fraction)
        return sum(drawn > 0 for drawn in told) < 3  # 0 while the paint is solved

    picture = nacre.render("sphere", flakes, spp=LONG, size=(16, 16), progress=three_times)
    assert not picture.complete
    assert len(told) >= 3
    assert all(0 <= fraction <= 1 for fraction in told)


def test_what_has_nothing_to_hand_over_raises_stopped(paints: Path) -> None:
    paint = nacre.Paint(paints / "tio2-mica-80.toml")
    with pytest.raises(nacre.Stopped, match="stopped"):
        paint.solve(np.linspace(400, 700, 301), progress=lambda _: False)
    with pytest.raises(nacre.Stopped):
        nacre.fit(paint, paint, "coats[0].thickness_nm", progress=lambda _: False)
    with pytest.raises(nacre.Stopped):  # numpy's, as of a comparison of its numbers
        paint.solve(np.linspace(400, 700, 302), progress=lambda _: np.float64(1) < 0)


@pytest.mark.parametrize("returned", [None, 0, "", np.True_, np.zeros(3)])
def test_what_is_not_false_lets_the_work_go_on(paints: Path, returned: object) -> None:
    told: list[float] = []

    def tell(fraction: float) -> object:
        told.append(fraction)
        return returned

    nacre.Paint(paints / "tio2-mica-80.toml").solve([550.0], progress=tell)
    assert told


def test_what_progress_raises_is_raised(flakes: nacre.Paint) -> None:
    def fail(_: float) -> None:
        raise LookupError("of mine")

    with pytest.raises(LookupError, match="of mine"):
        nacre.render("sphere", flakes, spp=LONG, size=(16, 16), progress=fail)


@pytest.mark.parametrize("work", ["picture", "values"])
def test_ctrl_c(work: str, flakes: nacre.Paint) -> None:
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    many = np.full(5_000_000, 30.0)  # minutes
    flakes.brdf_at(0, 0, 0, [550.0])  # solved

    def long_work() -> None:
        if work == "picture":
            nacre.render("sphere", flakes, spp=LONG, size=(16, 16))
        else:
            flakes.brdf_at(many, 20, 180, [550.0])

    # Who runs the tests in the background may have them ignore the signal.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            long_work()
        timer.join()
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("work", ["delta_e_2000", "lab", "srgb", "index"])
def test_colours_of_many_let_others_work(work: str) -> None:
    many, nm = np.random.default_rng(1).uniform(0, 80, (2_000_000, 3)), np.linspace(400, 700, 31)
    spectra = np.full((200_000, 31), 0.3)
    wavelengths = np.linspace(400, 700, 10_000_000)
    mica = nacre.Material("mica")
    calls: dict[str, Callable[[], object]] = {
        "delta_e_2000": lambda: nacre.delta_e_2000(many, many[0]),
        "lab": lambda: nacre.lab(nm, spectra),
        "srgb": lambda: nacre.srgb(many),
        "index": lambda: mica.index(wavelengths),
    }
    # A call that keeps Python's lock lets others work at its beginning and at its end, however
    # often it is made; one that does not, all the time, but for a machine that is busy.
    assert any(steps_beside(calls[work]) > 50 for _ in range(20))


def steps_beside(call: Callable[[], object]) -> int:
    """The steps that another thread takes while `call` runs, ten a millisecond at most."""
    steps = 0
    done = threading.Event()

    def count() -> None:
        nonlocal steps
        while not done.is_set():
            steps += 1
            time.sleep(1e-4)

    counter = threading.Thread(target=count)
    counter.start()
    call()
    done.set()
    counter.join()
    return steps


def test_others_work_beside_a_picture(flakes: nacre.Paint) -> None:
    def picture() -> None:
        nacre.render("sphere", flakes, spp=64, size=(64, 64))

    assert any(steps_beside(picture) > 50 for _ in range(20))


def test_threads_are_bounded_and_change_nothing(flakes: nacre.Paint) -> None:
    theta = np.linspace(0, 80, 200)
    everywhere = flakes.brdf_at(30, theta, 170, [500.0])
    with nacre.threads(1):
        assert nacre._nacre.threads() == 1
        np.testing.assert_array_equal(flakes.brdf_at(30, theta, 170, [500.0]), everywhere)
        with nacre.threads(2):
            assert nacre._nacre.threads() == 2
        assert nacre._nacre.threads() == 1
    with pytest.raises(nacre.DomainError, match="threads = -1 is negative"):
        nacre.set_threads(-1)


def test_many_threads_of_python_share_a_paint(flakes: nacre.Paint) -> None:
    angles = np.linspace(0, 60, 7)
    expected = [flakes.copy().brdf_at(a, 10, 180, [450.0, 550.0]) for a in angles]
    shared = nacre.Paint(flakes.file)
    found: dict[int, object] = {}

    def ask(i: int) -> None:
        found[i] = shared.brdf_at(angles[i], 10, 180, [450.0, 550.0])

    threads = [threading.Thread(target=ask, args=(i,)) for i in range(len(angles))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for i, values in enumerate(expected):
        np.testing.assert_array_equal(found[i], values)


def test_bars(capsys: pytest.CaptureFixture[str], flakes: nacre.Paint) -> None:
    nacre.render("sphere", flakes, spp=1, size=(8, 8), progress=True)
    assert "render" in capsys.readouterr().err
    nacre.render("sphere", flakes, spp=1, size=(8, 8))
    assert capsys.readouterr().err == ""


def test_processors_that_would_not_do() -> None:
    from nacre._cpu import missing

    flags = "fpu sse4_2 avx avx2 bmi1 bmi2 f16c fma abm movbe"
    old = flags.replace(" avx2", "").replace(" fma", "")
    assert missing("x86-64-v3", f"processor : 0\nflags\t\t: {flags}\n") == set()
    assert missing("x86-64-v3", f"flags : {old}\n") == {"avx2", "fma"}
    assert missing("", f"flags : {old}\n") == set()
    assert missing("x86-64-v3", "") == set()


def test_angles_are_checked_by_their_arrays_and_not_by_their_products(flakes: nacre.Paint) -> None:
    lamps, views = np.zeros((4096, 1)), np.zeros(4096)
    lamps[-1] = 95  # behind 4095 rows of places that are right
    seconds = []
    for _ in range(3):
        start = time.perf_counter()
        with pytest.raises(nacre.SettingError, match="theta_i_deg = 95: must be in"):
            flakes.brdf_at(lamps, views, 0, [550.0])
        seconds.append(time.perf_counter() - start)
    assert min(seconds) < 0.1


def test_more_places_than_can_be_counted_are_refused_at_once(flakes: nacre.Paint) -> None:
    many = 1 << 22  # 2^66 places
    with pytest.raises(MemoryError):
        flakes.brdf_at(
            np.zeros((many, 1, 1)), np.zeros((many, 1)), np.zeros(many), [550.0], model="thin-film"
        )
