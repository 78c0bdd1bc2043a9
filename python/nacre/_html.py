"""Colour chips and small curves for notebooks, as HTML and SVG without any package."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from ._arrays import Floats


def css(srgb: Floats) -> str:
    """`#rrggbb` of encoded sRGB in [0, 1]."""
    levels = np.rint(255 * np.clip(np.nan_to_num(srgb), 0, 1)).astype(int)
    return "#" + "".join(f"{level:02x}" for level in levels)


def chips(srgb: Floats, labels: Sequence[str]) -> str:
    """A row of coloured squares with a label below each."""
    cells = "".join(
        f'<div style="display:inline-block;margin:2px;text-align:center;font:11px sans-serif">'
        f'<div style="width:56px;height:56px;background:{css(colour)}"></div>{escape(label)}</div>'
        for colour, label in zip(srgb, labels, strict=True)
    )
    return f"<div>{cells}</div>"


def chip_pairs(srgb: Floats, labels: Sequence[str], notes: Sequence[str]) -> str:
    """Two colours (N, 2, 3) each that touch, with a label above and a note below."""
    cells = "".join(
        '<div style="display:inline-block;margin:2px;text-align:center;font:11px sans-serif">'
        f"{escape(label)}"
        + "".join(
            f'<div style="width:56px;height:28px;margin:auto;background:{css(colour)}"></div>'
            for colour in pair
        )
        + f"{escape(note)}</div>"
        for pair, label, note in zip(srgb, labels, notes, strict=True)
    )
    return f"<div>{cells}</div>"


def table(header: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    def cell(value: object) -> str:
        return f"{value:.4g}" if isinstance(value, float) else escape(str(value))

    head = "".join(f"<th>{escape(name)}</th>" for name in header)
    body = "".join(
        "<tr>" + "".join(f"<td>{cell(value)}</td>" for value in row) + "</tr>" for row in rows
    )
    return f"<table><tr>{head}</tr>{body}</table>"


@dataclass(frozen=True)
class Line:
    name: str
    """shown where the pointer rests"""
    x: Floats
    y: Floats
    colour: str
    dashed: bool = False


_WIDTH, _HEIGHT, _LEFT, _RIGHT, _BELOW = 360, 150, 44, 14, 32
_FEW = 12  # points that are marked


def ticks(low: float, high: float) -> list[float]:
    """Three to six multiples of 1, 2 or 5 times a power of ten, within these ends."""
    raw = (high - low) / 5
    power = 10.0 ** np.floor(np.log10(raw))
    step = next(power * m for m in (1, 2, 5, 10) if power * m >= raw * (1 - 1e-9))
    first = np.ceil(low / step - 1e-9)
    return [float(step * n) + 0.0 for n in np.arange(first, high / step + 1e-9)]


def plot(lines: Iterable[Line], x_label: str, y_label: str) -> str:
    """Lines as SVG, with ticks; y begins at 0 unless it is below. Lines with a gap are left out."""
    shown = [line for line in lines if line.x.size > 1 and np.isfinite(line.y).all()]
    if not shown:
        return ""
    left = min(float(line.x.min()) for line in shown)
    right = max(float(line.x.max()) for line in shown)
    bottom = min([0.0, *(float(line.y.min()) for line in shown)])
    top = max([bottom + 1e-12, *(float(line.y.max()) for line in shown)])
    if not left < right:
        return ""

    def across(x: float) -> float:
        return _LEFT + (x - left) / (right - left) * (_WIDTH - _LEFT - _RIGHT)

    def down(y: float) -> float:
        return 6 + (top - y) / (top - bottom) * (_HEIGHT - 6)

    text = 'font-size="10" font-family="sans-serif" fill="currentColor"'
    parts = [
        f'<svg width="{_WIDTH}" height="{_HEIGHT + _BELOW}">',
        f'<rect x="{_LEFT}" y="6" width="{_WIDTH - _LEFT - _RIGHT}" height="{_HEIGHT - 6}" '
        'fill="none" stroke="#999"/>',
    ]
    for tick in ticks(left, right):
        x = across(tick)
        parts.append(
            f'<path d="M{x:.1f} {_HEIGHT}v4" stroke="#999"/>'
            f'<text x="{x:.1f}" y="{_HEIGHT + 14}" text-anchor="middle" {text}>{tick:g}</text>'
        )
    for tick in ticks(bottom, top):
        y = down(tick)
        parts.append(
            f'<path d="M{_LEFT} {y:.1f}h-4" stroke="#999"/>'
            f'<text x="{_LEFT - 6}" y="{y + 3:.1f}" text-anchor="end" {text}>{tick:g}</text>'
        )
    for line in shown:
        points = sorted(zip(line.x.tolist(), line.y.tolist(), strict=True))
        at = [(across(x), down(y)) for x, y in points]
        way = " ".join(f"{a:.1f},{b:.1f}" for a, b in at)
        dashes = ' stroke-dasharray="4 3"' if line.dashed else ""
        marks = "".join(
            f'<circle cx="{a:.1f}" cy="{b:.1f}" r="2.5" fill="{line.colour}"/>'
            for a, b in (at if len(at) <= _FEW else [])
        )
        parts.append(
            f'<g><title>{escape(line.name)}</title><polyline points="{way}" fill="none" '
            f'stroke="{line.colour}" stroke-width="2"{dashes}/>{marks}</g>'
        )
    parts.append(
        f'<text x="{_WIDTH / 2}" y="{_HEIGHT + 28}" text-anchor="middle" {text}>'
        f"{escape(y_label)} by {escape(x_label)}</text></svg>"
    )
    return "".join(parts)


def spectra(
    nm: Floats, rows: Floats, names: Iterable[str], colours: Iterable[str], what: str
) -> str:
    """A plot of rows (N, W)."""
    lines = [Line(*line) for line in zip(names, [nm] * len(rows), rows, colours, strict=True)]
    return plot(lines, "wavelength, nm", what)
