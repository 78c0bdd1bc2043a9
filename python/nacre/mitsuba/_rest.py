"""Where the flakes of a shape lie still."""

from __future__ import annotations

from typing import Any

import mitsuba as mi
import numpy as np


def rest_of(shape: Any) -> Any:
    """From the world to the shape before it was turned and moved, but not before it was scaled.

    Of shapes that keep their transformation, which meshes do not: theirs is the world.
    """
    params = mi.traverse(shape)
    if "to_world" not in params:
        return mi.ScalarTransform4f()
    matrix = np.array(params["to_world"].matrix, dtype=np.float64).reshape(4, 4, -1)[..., 0]
    # The nearest rotation, by the polar decomposition.                     [higham-1986]
    u, _, vt = np.linalg.svd(matrix[:3, :3])
    turn = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ vt))]) @ vt
    inverse = np.eye(4)
    inverse[:3, :3] = turn.T
    inverse[:3, 3] = -turn.T @ matrix[:3, 3]
    return mi.ScalarTransform4f(inverse)


def is_same_rest(a: Any, b: Any) -> bool:
    """Whether two transformations are equal to rounding; Mitsuba finds none equal, nor unequal."""
    return np.allclose(np.array(a.matrix), np.array(b.matrix), rtol=0, atol=1e-5)
