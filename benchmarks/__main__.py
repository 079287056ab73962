"""`python -m benchmarks`: prints each figure as a ratio, both sides measured in this run."""

import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from analyses.analysis import POSES_PER_BLOCK
from benchmarks import rivals
from mechanics import effort
from mechanics import fields as kept_fields
from mechanics.arrays import Floats
from mechanics.assembly.braked import BrakedLegs
from mechanics.assembly.guess import Convergence, close_nearby
from mechanics.conditions.actuator_limits import ActuatorLimits
from mechanics.conditions.effort import Effort
from mechanics.conditions.pressure_angle import PressureAngle
from mechanics.conditions.reach import Reach
from mechanics.configuration import Configuration
from mechanics.families.delta import delta_linear
from mechanics.families.hexapods import gough_stewart
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.grid import Axis, Grid
from mechanics.kernels import batches
from mechanics.loads import Load
from mechanics.mechanism import Mechanism
from mechanics.orientations import Orientations, scan_orientations
from mechanics.turns import Turn
from mechanics.workspace import Scan, scan

REPEATS = 9
POSES = 1_000_000


def compare(
    name: str,
    ours: Callable[[], object],
    items: int,
    rival: str,
    theirs: Callable[[], object],
    rival_items: int | None = None,
) -> None:
    """Print one line; a ratio above 1 says how many times faster we are, an item.

    Both run in turns, since other work on a machine slows it for seconds at a time; what counts
    is the shortest time of each.
    """
    times = []
    ours(), theirs()
    for _ in range(REPEATS):
        times.append([_seconds(ours) / items, _seconds(theirs) / (rival_items or items)])
    mine, other = 1e9 * np.min(times, axis=0)
    print(f"{name:42} {mine:8.1f} ns  {rival:40} {other:8.1f} ns  ratio {other / mine:7.2f}")


def _seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def free(legs: int) -> Floats:
    """Return limits of drives that have none."""
    return np.tile([-np.inf, np.inf], (legs, 1))


def planar() -> Mechanism:
    """Return the 3-RRR of Laryushkin, Glazunov and Erastova, 2016."""
    return planar_3rrr(
        base_side=0.4,
        platform_radius=0.08,
        crank_length=0.18,
        rod_length=0.18,
        limits=free(3),
        working_mode=np.ones(3),
    )


def hexapod() -> tuple[Mechanism, Floats]:
    """Return a 6-SPS and random poses, shape (poses, 6)."""
    base_angles = np.deg2rad([-10, 10, 110, 130, 230, 250])
    platform_angles = np.deg2rad([-50, 50, 70, 170, 190, 290])
    flat = np.zeros(6)
    mechanism = gough_stewart(
        base_points=np.c_[np.cos(base_angles), np.sin(base_angles), flat].tolist(),
        platform_points=(
            0.5 * np.c_[np.cos(platform_angles), np.sin(platform_angles), flat]
        ).tolist(),
        limits=free(6),
        working_mode=np.ones(6),
    )
    random = np.random.default_rng(0)
    poses = np.c_[
        random.uniform(-0.2, 0.2, (POSES, 2)),
        random.uniform(0.9, 1.2, POSES),
        random.uniform(-0.5, 0.5, (POSES, 3)),
    ]
    return mechanism, poses


def scan_of_reach() -> None:
    """Compare a scan of the theoretical workspace, a node, with NumPy over the whole grid."""
    mechanism = planar()
    axes = (Axis("x", -0.3, 0.3, 0.0005), Axis("y", -0.3, 0.3, 0.0005))
    grid = Grid(axes, (0, 1), np.zeros(3))
    base, platform = mechanism.legs.base_point[:, :2], mechanism.legs.platform_point[:, :2]
    x, y = (axis.nodes for axis in axes)
    compare(
        "3-RRR reach by lines, a node",
        lambda: scan(mechanism, [Reach(mechanism)], grid, {}, 0, grid.size),
        grid.size,
        "NumPy, annuli",
        lambda: rivals.reach_grid(base, platform, 0.0, 0.36, x, y),
    )


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
    expected = rivals.rails_grid(offsets, 0.37, -0.1, 0.35, *nodes)
    found = scan(mechanism, conditions, coarse, {}, 0, coarse.size)
    inside = np.repeat(found.codes == 0, found.lengths)
    assert np.count_nonzero(inside != expected.ravel()) <= 3, "rails: more than rounding differs"

    def ours(of: Grid) -> Callable[[], object]:
        return lambda: scan(mechanism, conditions, of, {}, 0, of.size)

    name = "three rails, limits, by lines, a node"
    compare(
        name,
        ours(coarse),
        coarse.size,
        "NumPy, slabs of 211 x 211",
        lambda: rivals.rails_grid(offsets, 0.37, -0.1, 0.35, *nodes),
    )
    compare("the same, the whole grid", ours(coarse), 1, "the same at half the step", ours(fine))


def struts() -> None:
    """Compare whole lines of six limited struts with NumPy."""
    free_platform, _ = hexapod()
    limits = {"lower_limit": np.full(6, 0.9), "upper_limit": np.full(6, 1.5)}
    mechanism = replace(free_platform, legs=free_platform.legs._replace(**limits))
    step = 2.0 / 199
    axes = (Axis("x", -1.0, 1.0, step), Axis("y", -1.0, 1.0, step), Axis("z", 0.0, 2.0, step))
    grid = Grid(axes, (0, 1, 2), np.zeros(6))
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    centres = mechanism.legs.base_point - mechanism.legs.platform_point
    nodes = [axis.nodes for axis in axes]
    compare(
        "6-SPS, limits, by lines, a node",
        lambda: scan(mechanism, conditions, grid, {}, 0, grid.size),
        grid.size,
        "NumPy, slabs of 200 x 200",
        lambda: rivals.struts_grid(centres, 0.9, 1.5, *nodes),
    )


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
        return scan_orientations(
            mechanism,
            [Reach(mechanism)],
            grid,
            around,
            0,
            grid.size,
            every=every,
            measured=False,
        )

    def sampled(every: bool) -> NDArray[np.bool_]:
        return rivals.sampled_orientations(base, platform, 0.36, x, y, 360, every=every)

    for name, every in (("3-RRR maximal, a node", False), ("3-RRR full, a node", True)):
        found, expected = ours(every), sampled(every)
        inside = np.repeat(found.codes == 0, found.lengths)
        differing = np.count_nonzero(inside != expected.ravel())
        assert differing < 200, f"{name}: sampling differs at {differing} nodes"
        compare(
            name,
            partial(ours, every),
            grid.size,
            "NumPy, 360 angles",
            partial(sampled, every),
        )


def fields() -> None:
    """Compare a 6-SPS with two fields, a node, with batched inversion in NumPy."""
    free_platform, _ = hexapod()
    limits = {"lower_limit": np.full(6, 0.9), "upper_limit": np.full(6, 1.5)}
    mechanism = replace(free_platform, legs=free_platform.legs._replace(**limits))
    step = 2.0 / 99
    axes = (Axis("x", -1.0, 1.0, step), Axis("y", -1.0, 1.0, step), Axis("z", 0.0, 2.0, step))
    grid = Grid(axes, (0, 1, 2), np.zeros(6))
    conditions = [Reach(mechanism), ActuatorLimits(mechanism)]
    kept = {"effort": kept_fields.effort_max(Load(1.0, 0.1)), "angle": kept_fields.pressure_angle}
    positions = np.ascontiguousarray(grid.poses(0, grid.size)[:3].T)
    legs = mechanism.legs

    def ours() -> Scan:
        return scan(mechanism, conditions, grid, kept, 0, grid.size)

    def theirs() -> tuple[NDArray[np.bool_], Floats, Floats]:
        return rivals.strut_fields(positions, legs.base_point, legs.platform_point, 0.9, 1.5)

    found, (inside, efforts, _) = ours(), theirs()
    assert np.array_equal(np.repeat(found.codes == 0, found.lengths), inside)
    usual = np.median(efforts)
    differing = np.abs(found.fields["effort"] - efforts)[efforts < 100.0 * usual].max()
    assert differing < 1e-9 * usual, f"fields: efforts differ by {differing} N"
    compare("6-SPS with two fields, a node", ours, grid.size, "NumPy, blocks of 4096", theirs)


def effective() -> None:
    """Compare a 6-SPS with bounds on effort and pressure angle, a node, with NumPy's inversion."""
    free_platform, _ = hexapod()
    limits = {"lower_limit": np.full(6, 0.9), "upper_limit": np.full(6, 1.5)}
    mechanism = replace(free_platform, legs=free_platform.legs._replace(**limits))
    most, steepest = 0.95, np.deg2rad(50.0)
    conditions = [
        Reach(mechanism),
        ActuatorLimits(mechanism),
        Effort(mechanism, Load(1.0, 0.1), np.full(6, most)),
        PressureAngle(mechanism, steepest),
    ]

    def grid(count: int) -> Grid:
        step = 2.0 / (count - 1)
        lows = zip("xyz", (-1.0, -1.0, 0.0), strict=True)
        return Grid(tuple(Axis(c, low, low + 2.0, step) for c, low in lows), (0, 1, 2), np.zeros(6))

    coarse, fine = grid(100), grid(200)
    positions = np.ascontiguousarray(coarse.poses(0, coarse.size)[:3].T)
    legs = mechanism.legs

    def ours(of: Grid) -> Scan:
        return scan(mechanism, conditions, of, {}, 0, of.size)

    def theirs() -> NDArray[np.bool_]:
        held, efforts, angles = rivals.strut_fields(
            positions, legs.base_point, legs.platform_point, 0.9, 1.5
        )
        held[held] = (efforts <= most) & (angles <= steepest)
        return held

    found = ours(coarse)
    assert np.array_equal(np.repeat(found.codes == 0, found.lengths), theirs())
    name, rival = "6-SPS, effective, a node", "NumPy, blocks of 4096"
    compare(name, partial(ours, fine), fine.size, rival, theirs, rival_items=coarse.size)


def inverse_of_struts() -> None:
    """Compare the inverse of a 6-SPS, a pose, with bare roots, NumPy and basic-robotics."""
    mechanism, rows = hexapod()
    poses = np.ascontiguousarray(rows.T)
    lengths = np.empty_like(poses)
    base, platform = mechanism.legs.base_point, mechanism.legs.platform_point

    def ours() -> None:
        batches.actuators(mechanism.motion.kernel, mechanism.legs, poses, lengths)

    name = "6-SPS inverse, a pose"
    roots, roots_by_pose = np.empty_like(poses), np.empty_like(rows)
    compare(name, ours, POSES, "six roots, by coordinate", lambda: rivals.roots(poses, roots))
    compare(name, ours, POSES, "six roots, by pose", lambda: rivals.roots(rows, roots_by_pose))
    numpy = partial(rivals.strut_lengths, rows, base, platform)
    compare(name, ours, POSES, "NumPy, blocks of 4096", numpy)
    inverse = rivals.basic_robotics_inverse(base, platform)
    asked = rivals.transformations(rows[:200])
    difference = np.abs([inverse(pose) for pose in asked] - lengths[:, :200].T).max()
    assert difference < 1e-12, f"basic-robotics and we differ by {difference} m"
    loop = partial(rivals.for_each, inverse, asked)
    compare(name, ours, POSES, "basic-robotics, IK", loop, rival_items=200)


def forward_of_struts() -> None:
    """Compare Newton's iteration from a guess, a pose, with basic-robotics' forward kinematics.

    What is compared is where guesses lead; the determinant and sign of each mode come on top.
    """
    mechanism, rows = hexapod()
    rows = np.ascontiguousarray(rows[:100_000] * [1.0, 1.0, 1.0, 0.3, 0.3, 0.3])
    poses = np.ascontiguousarray(rows.T)
    lengths = np.empty((6, len(rows)))
    batches.actuators(mechanism.motion.kernel, mechanism.legs, poses, lengths)
    starts = range(0, len(rows), POSES_PER_BLOCK)
    blocks = [np.ascontiguousarray(lengths[:, a : a + POSES_PER_BLOCK]) for a in starts]
    guesses = np.repeat([[0.0], [0.0], [1.0], [0.0], [0.0], [0.0]], POSES_PER_BLOCK, axis=1)

    def ours() -> list[Convergence]:
        legs = [BrakedLegs(mechanism, block) for block in blocks]
        return [close_nearby(some, guesses[:, : some.actuators.shape[1]]) for some in legs]

    found = np.concatenate([one.poses for one in ours()], axis=1)
    assert all(one.converged.all() for one in ours()), "some guesses did not converge"
    assert np.abs(found - poses).max() < 1e-9
    joints = mechanism.legs.base_point, mechanism.legs.platform_point
    forward = rivals.basic_robotics_forward(*joints)
    asked = lengths[:, :50].T.copy()
    difference = np.abs([forward(row) for row in asked] - poses[:3, :50].T).max()
    assert difference < 1e-3, f"basic-robotics and we differ by {difference} m"
    loop = partial(rivals.for_each, forward, asked)
    name = "6-SPS from a guess, a pose"
    compare(name, ours, len(rows), "basic-robotics, FK", loop, rival_items=50)


def efforts(name: str, mechanism: Mechanism, rows: Floats) -> None:
    """Compare worst-direction efforts from poses with batched inversion of ready Jacobians."""
    poses = np.ascontiguousarray(rows.T)
    ready = Configuration(mechanism, poses)
    jacobians = ready.platform_jacobians / ready.rods[1][:, None, :]
    matrices = np.ascontiguousarray(np.moveaxis(jacobians, 2, 0))
    split = len(mechanism.motion.translations)
    load = Load(10.0, 2.0)
    starts = range(0, len(rows), POSES_PER_BLOCK)
    blocks = [np.ascontiguousarray(poses[:, a : a + POSES_PER_BLOCK]) for a in starts]
    compare(
        name,
        lambda: [effort.worst_efforts(Configuration(mechanism, block), load) for block in blocks],
        len(rows),
        "numpy.linalg.inv + norms, J given",
        lambda: rivals.worst_efforts(matrices, 10.0, 2.0, split),
    )


if __name__ == "__main__":
    scan_of_reach()
    rails()
    struts()
    orientations()
    fields()
    effective()
    inverse_of_struts()
    forward_of_struts()
    random_poses = np.random.default_rng(0).uniform(-0.05, 0.05, (200_000, 3))
    efforts("3-RRR efforts from poses, a pose", planar(), random_poses)
    efforts("6-SPS efforts from poses, a pose", *hexapod())
