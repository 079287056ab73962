"""Workspaces, a node of their grids, against NumPy over the whole grid."""

from functools import partial

import numpy as np
from numpy.typing import NDArray

from benchmarks import rivals
from benchmarks.measuring import compare
from benchmarks.mechanisms import limited_hexapod, planar
from mechanics import fields as kept_fields
from mechanics.arrays import Floats
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.effort import Effort
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.reach import Reach
from mechanics.families.delta import delta_linear
from mechanics.grid import Axis, Grid
from mechanics.loads import Load
from mechanics.orientations import Orientations, Question, scan_orientations
from mechanics.turns import Turn
from mechanics.workspace import Scan, scan

SHORTEST, LONGEST = 0.9, 1.5
"""Between which lengths the struts of the hexapod may be. [m]"""


def scan_of_reach() -> None:
    """Compare a scan of the theoretical workspace, a node, with NumPy over the whole grid."""
    mechanism = planar()
    axes = (Axis("x", -0.3, 0.3, 0.0005), Axis("y", -0.3, 0.3, 0.0005))
    grid = Grid(axes, (0, 1), np.zeros(3))
    base, platform = mechanism.legs.base_point[:, :2], mechanism.legs.platform_point[:, :2]
    x, y = (axis.nodes for axis in axes)

    def ours() -> Scan:
        return scan(mechanism, [Reach(mechanism)], grid, {}, 0, grid.size)

    def theirs() -> NDArray[np.bool_]:
        return rivals.reach_grid(base, platform, 0.0, 0.36, x, y)

    _agree("reach", ours(), theirs())
    compare("3-RRR reach by lines, a node", ours, grid.size, "NumPy, annuli", theirs)


def _agree(name: str, found: Scan, expected: NDArray[np.bool_], most: int = 3) -> None:
    """Raise AssertionError if more nodes differ than rounding explains, or what is looked for."""
    inside = np.repeat(found.codes == 0, found.lengths)
    differing = np.count_nonzero(inside != expected.ravel())
    assert differing <= most, f"{name}: {differing} nodes differ"


def rails() -> None:
    """Compare whole lines of three limited rail legs with NumPy, and with half the step."""
    mechanism = delta_linear(
        rail_radius=0.328,
        platform_radius=0.1,
        carriage_arm=0.0,
        rod_length=0.37,
        tool_offset=0.0,
        limits=np.tile([-0.1, 0.35], (3, 1)),
        working_mode=np.ones(3),
    )
    offsets = mechanism.legs.base_point - mechanism.legs.platform_point
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]

    def grid(count: int) -> Grid:
        step = 2.1 / (count - 1)
        return Grid(tuple(Axis(c, -1.1, 1.0, step) for c in "xyz"), (0, 1, 2), np.zeros(3))

    coarse, fine = grid(211), grid(421)
    nodes = [axis.nodes for axis in coarse.axes]

    def ours(of: Grid) -> Scan:
        return scan(mechanism, conditions, of, {}, 0, of.size)

    def theirs() -> NDArray[np.bool_]:
        return rivals.rails_grid(offsets, 0.37, -0.1, 0.35, *nodes)

    _agree("rails", ours(coarse), theirs())
    name, rival = "three rails, limits, by lines, a node", "NumPy, slabs of 211 x 211"
    compare(name, partial(ours, coarse), coarse.size, rival, theirs)
    name, rival = "the same, the whole grid", "the same at half the step"
    compare(name, partial(ours, coarse), 1, rival, partial(ours, fine))


def above_base(count: int) -> Grid:
    """Return a cube of nodes, so many a side, over which the hexapod's platform moves upright."""
    step = 2.0 / (count - 1)
    axes = (Axis("x", -1.0, 1.0, step), Axis("y", -1.0, 1.0, step), Axis("z", 0.0, 2.0, step))
    return Grid(axes, (0, 1, 2), np.zeros(6))


def struts() -> None:
    """Compare whole lines of six limited struts with NumPy."""
    mechanism = limited_hexapod(SHORTEST, LONGEST)
    grid = above_base(200)
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    centres = mechanism.legs.base_point - mechanism.legs.platform_point
    nodes = [axis.nodes for axis in grid.axes]

    def ours() -> Scan:
        return scan(mechanism, conditions, grid, {}, 0, grid.size)

    def theirs() -> NDArray[np.bool_]:
        return rivals.struts_grid(centres, SHORTEST, LONGEST, *nodes)

    _agree("struts", ours(), theirs())
    name = "6-SPS, limits, by lines, a node"
    compare(name, ours, grid.size, "NumPy, slabs of 200 x 200", theirs)


def orientations() -> None:
    """Compare all angles of a turning platform, a node, with 360 of them in NumPy."""
    mechanism = planar()
    axes = (Axis("x", -0.3, 0.3, 0.001), Axis("y", -0.3, 0.3, 0.001))
    grid = Grid(axes, (0, 1), np.zeros(3))
    turn = Turn(mechanism.motion, "phi", 2, -np.pi, np.pi, np.deg2rad(2.0))
    around = Orientations(Grid((), (), np.zeros(3)), turn, 2.0 * np.pi)
    base, platform = mechanism.legs.base_point[:, :2], mechanism.legs.platform_point[:, :2]
    x, y = (axis.nodes for axis in axes)

    def ours(every: bool) -> Scan:
        question = Question(mechanism, [Reach(mechanism)], grid, around, every, measured=False)
        return scan_orientations(question, 0, grid.size)

    def sampled(every: bool) -> NDArray[np.bool_]:
        return rivals.sampled_orientations(base, platform, 0.36, x, y, 360, every=every)

    for name, every in (("3-RRR maximal, a node", False), ("3-RRR full, a node", True)):
        # Among 361 201 nodes, sampling misses some that hold between two of its angles.
        _agree(name, ours(every), sampled(every), most=200)
        compare(
            name,
            partial(ours, every),
            grid.size,
            "NumPy, 360 angles",
            partial(sampled, every),
        )


def fields() -> None:
    """Compare a 6-SPS with two fields, a node, with batched inversion in NumPy."""
    mechanism = limited_hexapod(SHORTEST, LONGEST)
    grid = above_base(100)
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    kept = {"effort": kept_fields.effort_max(Load(1.0, 0.1)), "angle": kept_fields.pressure_angle}
    positions = np.ascontiguousarray(grid.poses(0, grid.size)[:3].T)
    legs = mechanism.legs

    def ours() -> Scan:
        return scan(mechanism, conditions, grid, kept, 0, grid.size)

    def theirs() -> tuple[NDArray[np.bool_], Floats, Floats]:
        return rivals.strut_fields(
            positions, legs.base_point, legs.platform_point, SHORTEST, LONGEST
        )

    found, (inside, efforts, _) = ours(), theirs()
    assert np.array_equal(np.repeat(found.codes == 0, found.lengths), inside)
    usual = np.median(efforts)
    differing = np.abs(found.fields["effort"] - efforts)[efforts < 100.0 * usual].max()
    assert differing < 1e-9 * usual, f"fields: efforts differ by {differing} N"
    compare("6-SPS with two fields, a node", ours, grid.size, "NumPy, blocks of 4096", theirs)


def effective() -> None:
    """Compare a 6-SPS with bounds on effort and pressure angle, a node, with NumPy's inversion."""
    mechanism = limited_hexapod(SHORTEST, LONGEST)
    most, steepest = 0.95, np.deg2rad(50.0)
    conditions = [
        Reach(mechanism),
        ActuatorLimits(mechanism),
        Effort(mechanism, Load(1.0, 0.1), np.full(6, most)),
        PressureAngle(mechanism, steepest),
    ]
    coarse, fine = above_base(100), above_base(200)
    positions = np.ascontiguousarray(coarse.poses(0, coarse.size)[:3].T)
    legs = mechanism.legs

    def ours(of: Grid) -> Scan:
        return scan(mechanism, conditions, of, {}, 0, of.size)

    def theirs() -> NDArray[np.bool_]:
        held, efforts, angles = rivals.strut_fields(
            positions, legs.base_point, legs.platform_point, SHORTEST, LONGEST
        )
        held[held] = (efforts <= most) & (angles <= steepest)
        return held

    found = ours(coarse)
    assert np.array_equal(np.repeat(found.codes == 0, found.lengths), theirs())
    name, rival = "6-SPS, effective, a node", "NumPy, blocks of 4096"
    compare(name, partial(ours, fine), fine.size, rival, theirs, rival_items=coarse.size)
