"""Colour chips and small curves for notebooks, as HTML and SVG without any package."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
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


def table(header: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    def cell(value: object) -> str:
        return f"{value:.4g}" if isinstance(value, float) else escape(str(value))

    head = "".join(f"<th>{escape(name)}</th>" for name in header)
    body = "".join(
        "<tr>" + "".join(f"<td>{cell(value)}</td>" for value in row) + "</tr>" for row in rows
    )
    return f"<table><tr>{head}</tr>{body}</table>"


def curves(x: Floats, ys: Floats, colours: Sequence[str], label: str) -> str:
    """Lines over x, one a row of ys, as SVG; the vertical axis starts at 0."""
    width, height, left, below = 360, 140, 40, 18
    finite = ys[np.isfinite(ys)]
    if x.size < 2 or finite.size == 0:
        return ""
    top = max(float(finite.max()), 1e-12)
    px = left + (x - x[0]) / (x[-1] - x[0]) * (width - left)
    lines = ""
    for y, colour in zip(ys, colours, strict=True):
        if not np.isfinite(y).all():
            continue
        py = height * (1 - np.clip(y / top, 0, 1))
        points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(px, py, strict=True))
        lines += f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>'
    text = 'font-size="10" font-family="sans-serif" fill="currentColor"'
    return (
        f'<svg width="{width}" height="{height + below}">'
        f'<rect x="{left}" width="{width - left}" height="{height}" fill="none" stroke="#999"/>'
        f'{lines}<text x="0" y="10" {text}>{top:.3g}</text>'
        f'<text x="{left}" y="{height + 12}" {text}>{x[0]:g} nm</text>'
        f'<text x="{width}" y="{height + 12}" text-anchor="end" {text}>{x[-1]:g} nm</text>'
        f'<text x="{width / 2}" y="{height + 12}" text-anchor="middle" {text}>'
        f"{escape(label)}</text>"
        "</svg>"
    )
