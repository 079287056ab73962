"""What we are measured against: the same questions in NumPy, and bare loops as floors."""

import math
from collections.abc import Callable, Iterable
from typing import TypeVar

import numba
import numpy as np
from basic_robotics.general import tm
from basic_robotics.kinematics.sp_model import SP
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

Floats = NDArray[np.float64]
Item = TypeVar("Item")


def reach_grid(
    base: Floats, platform: Floats, near: float, far: float, x: Floats, y: Floats
) -> NDArray[np.bool_]:
    """Return which nodes every planar leg reaches at phi = 0: annuli about base - platform."""
    inside = np.ones((x.size, y.size), dtype=bool)
    for centre in base - platform:
        squares = (x[:, None] - centre[0]) ** 2 + (y[None, :] - centre[1]) ** 2
        inside &= (squares <= far * far) & (squares >= near * near)
    return inside


def rails_grid(
    offsets: Floats, rod: float, low: float, high: float, x: Floats, y: Floats, z: Floats
) -> NDArray[np.bool_]:
    """Return which nodes upright rails between their stops hold, slab by slab along x."""
    inside = np.empty((x.size, y.size, z.size), dtype=bool)
    for i, value in enumerate(x):
        within = np.ones((y.size, z.size), dtype=bool)
        for centre in offsets:
            squares = rod * rod - (value - centre[0]) ** 2 - (y - centre[1]) ** 2
            with np.errstate(invalid="ignore"):
                drive = z[None, :] + np.sqrt(squares)[:, None]
            within &= (drive >= low) & (drive <= high)
        inside[i] = within
    return inside


def struts_grid(
    centres: Floats, low: float, high: float, x: Floats, y: Floats, z: Floats
) -> NDArray[np.bool_]:
    """Return which nodes all struts hold at constant orientation, slab by slab along x."""
    inside = np.empty((x.size, y.size, z.size), dtype=bool)
    heights = (z[None, :] - centres[:, 2:3]) ** 2
    for i, value in enumerate(x):
        within = np.ones((y.size, z.size), dtype=bool)
        for centre, height in zip(centres, heights, strict=True):
            flat = (value - centre[0]) ** 2 + (y - centre[1]) ** 2
            length = np.sqrt(flat[:, None] + height)
            within &= (length >= low) & (length <= high)
        inside[i] = within
    return inside


def sampled_orientations(
    base: Floats, platform: Floats, far: float, x: Floats, y: Floats, angles: int, *, every: bool
) -> NDArray[np.bool_]:
    """Return which nodes all planar legs reach at some, or at every, of so many angles."""
    inside = np.full((x.size, y.size), every)
    for phi in -np.pi + 2.0 * np.pi * np.arange(angles) / angles:
        c, s = np.cos(phi), np.sin(phi)
        within = np.ones_like(inside)
        for joint, b in zip(base, platform, strict=True):
            across = (x + c * b[0] - s * b[1] - joint[0]) ** 2
            along = (y + s * b[0] + c * b[1] - joint[1]) ** 2
            within &= across[:, None] + along <= far * far
        inside = inside & within if every else inside | within
    return inside


def strut_fields(
    positions: Floats, base: Floats, platform: Floats, low: float, high: float, block: int = 4096
) -> tuple[NDArray[np.bool_], Floats, Floats]:
    """Return which positions a level platform's struts hold, and two fields where they do.

    The greatest effort of any drive under 1 N and 0.1 N m, and the greatest pressure angle, by
    batched inversion of the Jacobians of what is inside.
    """
    parts = []
    for first in range(0, len(positions), block):
        spans = positions[first : first + block, None, :] + platform - base
        lengths = np.sqrt(np.einsum("nkj,nkj->nk", spans, spans))
        inside = np.all((lengths >= low) & (lengths <= high), axis=1)
        u = spans[inside] / lengths[inside, :, None]
        arms = np.broadcast_to(platform, u.shape)
        inverses = np.linalg.inv(np.concatenate([u, np.cross(arms, u)], axis=2))
        forces = np.linalg.norm(inverses[:, :3], axis=1)
        moments = np.linalg.norm(inverses[:, 3:], axis=1)
        efforts = np.max(forces + 0.1 * moments, axis=1)
        moves = np.moveaxis(inverses[:, :3], 2, 1) + np.cross(
            np.moveaxis(inverses[:, 3:], 2, 1), arms
        )
        along = np.abs(np.einsum("nkj,nkj->nk", moves, u))
        angles = np.arccos(np.minimum(along / np.linalg.norm(moves, axis=2), 1.0))
        parts.append((inside, efforts, np.max(angles, axis=1)))
    held, efforts, angles = (np.concatenate(column) for column in zip(*parts, strict=True))
    return held, efforts, angles


def worst_efforts(jacobians: Floats, force: float, moment: float, split: int) -> Floats:
    """Return greatest efforts, shape (poses, drives), by batched inversion of ready Jacobians.

    The first `split` columns of J are translations, the others turns.
    """
    inverses = np.linalg.inv(jacobians)
    forces = np.linalg.norm(inverses[:, :split, :], axis=1)
    moments = np.linalg.norm(inverses[:, split:, :], axis=1)
    efforts: Floats = force * forces + moment * moments
    return efforts


def strut_lengths(poses: Floats, base: Floats, platform: Floats, block: int = 4096) -> Floats:
    """Return the strut lengths, shape (poses, 6), block by block so that all stays in cache."""
    lengths = np.empty((len(poses), 6))
    for first in range(0, len(poses), block):
        rows = poses[first : first + block]
        position = rows[:, :3].T
        sx, sy, sz = np.sin(rows[:, 3:].T)
        cx, cy, cz = np.cos(rows[:, 3:].T)
        rotation = (
            (cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx),
            (sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx),
            (-sy, cy * sx, cy * cx),
        )
        squares = np.zeros((6, len(rows)))
        for j in range(3):
            span = sum(np.multiply.outer(platform[:, k], rotation[j][k]) for k in range(3))
            span = span + position[j] - base[:, j : j + 1]
            squares += span * span
        lengths[first : first + block] = np.sqrt(squares).T
    return lengths


@numba.njit(error_model="numpy")
def roots(numbers: Floats, written: Floats) -> None:
    """Write bare square roots, shape as given: the floor of any inverse in that layout."""
    for k in range(numbers.shape[0]):
        for i in range(numbers.shape[1]):
            written[k, i] = math.sqrt(numbers[k, i] * numbers[k, i] + 1.0)


def transformations(rows: Floats) -> list[tm]:
    """Return poses, shape (poses, 6), as basic-robotics takes them."""
    matrices = np.tile(np.eye(4), (len(rows), 1, 1))
    matrices[:, :3, :3] = Rotation.from_euler("xyz", rows[:, 3:]).as_matrix()
    matrices[:, :3, 3] = rows[:, :3]
    return [tm(matrix) for matrix in matrices]


def _basic_robotics(base: Floats, platform: Floats) -> SP:
    start = tm([0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    model = SP(base.T.copy(), platform.T.copy(), tm(), start, 0.1, 10.0, 0.0, 0.0, "hexapod")
    model.IK(start, protect=True)
    return model


def basic_robotics_inverse(base: Floats, platform: Floats) -> Callable[[tm], Floats]:
    """Return the strut lengths' function, shape (6,), of basic-robotics' Stewart platform."""
    model = _basic_robotics(base, platform)
    # Protected: without the checks of the pose that it makes otherwise.
    return lambda pose: np.ravel(model.IK(pose, protect=True)[0])


def basic_robotics_forward(base: Floats, platform: Floats) -> Callable[[Floats], Floats]:
    """Return the function from strut lengths, shape (6,), to a position, of basic-robotics.

    Its own Newton iteration, compiled by Numba, from the pose that it found last.
    """
    model = _basic_robotics(base, platform)
    return lambda lengths: model.FK(lengths.reshape(6, 1), protect=True, fk_mode=1)[0].gTM()[:3, 3]


def for_each(function: Callable[[Item], Floats], items: Iterable[Item]) -> None:
    """Call the function for item after item."""
    for item in items:
        function(item)
