"""Legs of any drive under a platform of any motion, worked out anew in plain NumPy.

Nothing of the product is used here: a mechanism is read from the words of a request, its joints
are placed by hand, and one pose is looked at at a time.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

X, Y, Z = np.eye(3)
COORDINATES = {
    "planar_translation": 2,
    "planar": 3,
    "translation": 3,
    "schoenflies": 4,
    "spherical": 3,
    "spatial": 6,
}


@dataclass(frozen=True)
class Leg:
    """A drive (crank, rail, strut or arc) at `base` and a platform joint at `point`.

    Of an arc `crank` and `rod` are its two angles, `axis` the base axis, `point` the platform's.
    """

    drive: str
    base: Floats
    point: Floats
    axis: Floats
    zero: Floats
    crank: float
    rod: float

    @property
    def quarter(self) -> Floats:
        return np.cross(self.axis, self.zero)


@dataclass(frozen=True)
class Machine:
    motion: str
    legs: tuple[Leg, ...]
    axis: Floats

    @property
    def size(self) -> float:
        """The rms distance of the platform's joints from the reference point, or 1."""
        size = math.sqrt(np.mean([leg.point @ leg.point for leg in self.legs]))
        return size if size > 0 else 1.0

    @property
    def turns(self) -> int:
        """How many of the coordinates are angles."""
        return {"planar": 1, "schoenflies": 1, "spherical": 3, "spatial": 3}.get(self.motion, 0)


def unit(vector: Any) -> Floats:  # noqa: ANN401
    array = np.asarray(vector, dtype=float)
    made: Floats = array / np.linalg.norm(array)
    return made


def about(axis: Floats, angle: float) -> Floats:
    """Return the rotation about a unit axis, after Rodrigues."""
    x, y, z = axis
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    turned: Floats = np.eye(3) + math.sin(angle) * skew + (1 - math.cos(angle)) * (skew @ skew)
    return turned


def angles_of(rotation: Floats) -> Floats:
    """Return rx, ry, rz of Rz Ry Rx."""
    r = rotation
    level = math.hypot(r[0, 0], r[1, 0])
    return np.array(
        [math.atan2(r[2, 1], r[2, 2]), math.atan2(-r[2, 0], level), math.atan2(r[1, 0], r[0, 0])]
    )


def place(machine: Machine, pose: Floats) -> tuple[Floats, Floats]:
    """Return the reference point and the rotation of the platform."""
    moved, turned = pose[: len(pose) - machine.turns], pose[len(pose) - machine.turns :]
    point = np.zeros(3)
    point[: len(moved)] = moved
    if len(turned) == 3:
        rx, ry, rz = turned
        return point, about(Z, rz) @ about(Y, ry) @ about(X, rx)
    return point, about(machine.axis, turned[0] if len(turned) else 0.0)


def basis(machine: Machine) -> Floats:
    """Return the unit twists of the motion as columns."""
    columns = np.eye(6)
    turn = np.concatenate([np.zeros(3), machine.axis])[:, None]
    chosen: Floats = {
        "planar_translation": columns[:, :2],
        "planar": np.hstack([columns[:, :2], turn]),
        "translation": columns[:, :3],
        "schoenflies": np.hstack([columns[:, :3], turn]),
        "spherical": columns[:, 3:],
        "spatial": columns,
    }[machine.motion]
    return chosen


def rate_matrix(machine: Machine, pose: Floats) -> Floats:
    """Return the matrix from rates of the coordinates to rates along the unit twists.

    R = Rz Ry Rx, so that w = z rz' + Rz y ry' + Rz Ry x rx'.
    """
    matrix = np.eye(len(pose))
    if machine.turns == 3:
        _, ry, rz = pose[-3:]
        upright = about(Z, rz)
        matrix[-3:, -3:] = np.column_stack([upright @ about(Y, ry) @ X, upright @ Y, Z])
    return matrix


def joints(machine: Machine, pose: Floats) -> list[Floats]:
    """Return the platform joints; of an arc the platform axis."""
    point, rotation = place(machine, pose)
    return [point + rotation @ leg.point for leg in machine.legs]


def arms(machine: Machine, pose: Floats) -> list[Floats]:
    """Return the platform joints as seen from the reference point."""
    _, rotation = place(machine, pose)
    return [rotation @ leg.point for leg in machine.legs]


def driven(leg: Leg, psi: float) -> tuple[Floats, Floats]:
    """Return the point that the drive moves, and its rate; of an arc the intermediate axis."""
    outward = leg.zero * math.cos(psi) + leg.quarter * math.sin(psi)
    across = leg.quarter * math.cos(psi) - leg.zero * math.sin(psi)
    if leg.drive == "crank":
        return leg.base + leg.crank * outward, leg.crank * across
    if leg.drive == "arc":
        sine = math.sin(leg.crank)
        return leg.axis * math.cos(leg.crank) + sine * outward, sine * across
    if leg.drive == "rail":
        return leg.base + psi * leg.axis, leg.axis
    return leg.base, np.zeros(3)


def residual(leg: Leg, joint: Floats, psi: float) -> float:
    """Return by how much the leg's equation fails, relative to its largest term."""
    moved, _ = driven(leg, psi)
    if leg.drive == "arc":
        return float(moved @ joint - math.cos(leg.rod))
    span = joint - moved
    length = psi if leg.drive == "strut" else leg.rod
    across = joint - leg.base
    scale = max(float(span @ span), float(across @ across), length**2, leg.crank**2)
    return float((span @ span - length**2) / scale)


def rod(leg: Leg, joint: Floats, psi: float) -> Floats:
    """Return the line of force: the rod's direction; of an arc along the great circle."""
    moved, _ = driven(leg, psi)
    if leg.drive == "arc":
        return unit((moved @ joint) * joint - moved)
    return unit(joint - moved)


def leg_rows(machine: Machine, pose: Floats, psi: Floats) -> tuple[Floats, Floats]:
    """Return Jx in the unit twists, and the diagonal of Jpsi."""
    rows: list[Floats] = []
    levers: list[float] = []
    for leg, joint, arm, drive in zip(
        machine.legs, joints(machine, pose), arms(machine, pose), psi, strict=True
    ):
        moved, rate = driven(leg, drive)
        if leg.drive == "arc":
            rows.append(np.concatenate([np.zeros(3), np.cross(moved, joint)]))
            levers.append(float(rate @ joint))
            continue
        force = rod(leg, joint, drive)
        rows.append(np.concatenate([force, np.cross(arm, force)]))
        levers.append(1.0 if leg.drive == "strut" else float(force @ rate))
    return np.array(rows) @ basis(machine), np.array(levers)


def transmission(machine: Machine, pose: Floats, psi: Floats) -> Floats:
    """Return each leg's Jpsi relative to its greatest: the sine of the elbow, for a crank."""
    _, levers = leg_rows(machine, pose, psi)
    greatest = [
        leg.crank
        if leg.drive == "crank"
        else abs(math.sin(leg.crank) * math.sin(leg.rod))
        if leg.drive == "arc"
        else 1.0
        for leg in machine.legs
    ]
    relative: Floats = np.abs(levers) / np.array(greatest)
    return relative


def at_size(machine: Machine, rows: Floats) -> Floats:
    """Return Jx with turns measured at the platform's size."""
    scale = np.ones(rows.shape[1])
    scale[rows.shape[1] - machine.turns :] = 1 / machine.size
    scaled: Floats = rows * scale
    return scaled


def spread(machine: Machine, pose: Floats, psi: Floats) -> float:
    """Return the condition number of the platform's balance."""
    rows, _ = leg_rows(machine, pose, psi)
    return float(np.linalg.cond(at_size(machine, rows)))


def effort_rows(machine: Machine, pose: Floats, psi: Floats) -> Floats:
    """Return J^-T as wrench rows (drives, 6): Jpsi Jx^-T E^T."""
    rows, levers = leg_rows(machine, pose, psi)
    made: Floats = levers[:, None] * np.linalg.solve(rows.T, basis(machine).T)
    return made


def read(document: Mapping[str, Any]) -> Machine:
    """Return the machine of an inline specification."""
    kind = str(document["kind"])
    if kind == "custom":
        return _custom(document)
    makers = {
        "five_bar": ("planar_translation", _five_bar),
        "planar_3rrr": ("planar", _planar_3rrr),
        "translational_3rrrr": ("translation", _translational_3rrrr),
        "delta_rotary": ("translation", _delta_rotary),
        "delta_linear": ("translation", _upright_rails),
        "delta_linear_4dof": ("schoenflies", _delta_linear_4dof),
        "hexa_linear": ("spatial", _hexa_linear),
        "gough_stewart": ("spatial", _gough_stewart),
        "hexa_rotary": ("spatial", _hexa_rotary),
        "spherical_3rrr": ("spherical", _spherical_3rrr),
    }
    motion, legs = makers[kind]
    return Machine(motion, tuple(legs(document)), Y if motion == "schoenflies" else Z)


def _crank(base: Floats, axis: Any, zero: Any, lengths: Any, point: Floats) -> Leg:  # noqa: ANN401
    crank, length = lengths
    return Leg("crank", base, point, unit(axis), unit(zero), crank, length)


def _rail(base: Floats, direction: Any, length: float, point: Floats) -> Leg:  # noqa: ANN401
    return Leg("rail", base, point, unit(direction), np.zeros(3), 0.0, length)


def _strut(base: Floats, point: Floats) -> Leg:
    return Leg("strut", base, point, np.zeros(3), np.zeros(3), 0.0, 0.0)


def _spokes() -> list[Floats]:
    return [np.array([math.cos(a), math.sin(a), 0.0]) for a in np.deg2rad([90.0, 210.0, 330.0])]


def _links(document: Mapping[str, Any]) -> tuple[float, float]:
    return document["crank_length"], document["rod_length"]


def _five_bar(document: Mapping[str, Any]) -> list[Leg]:
    half = document["base_distance"] / 2
    nothing = np.zeros(3)
    return [_crank(side * half * X, Z, X, _links(document), nothing) for side in (-1.0, 1.0)]


def _planar_3rrr(document: Mapping[str, Any]) -> list[Leg]:
    base, radius = document["base_side"] / math.sqrt(3), document["platform_radius"]
    return [_crank(base * s, Z, X, _links(document), radius * s) for s in _spokes()]


def _translational_3rrrr(document: Mapping[str, Any]) -> list[Leg]:
    radius, link = document["base_radius"], document["link_length"]
    return [
        _crank(radius * after, axis, after, (link, link), np.zeros(3))
        for axis, after in ((X, Y), (Y, Z), (Z, X))
    ]


def _delta_rotary(document: Mapping[str, Any]) -> list[Leg]:
    base, radius = document["base_radius"], document["platform_radius"]
    return [_crank(base * s, np.cross(s, Z), s, _links(document), radius * s) for s in _spokes()]


def _upright_rails(document: Mapping[str, Any]) -> list[Leg]:
    inner = document["rail_radius"] - document["carriage_arm"]
    radius, offset = document["platform_radius"], document["tool_offset"]
    return [_rail(inner * s, Z, document["rod_length"], radius * s + offset * Z) for s in _spokes()]


def _delta_linear_4dof(document: Mapping[str, Any]) -> list[Leg]:
    arm, half = document["carriage_arm"], document["rod_spacing"] / 2
    aside, back = document["rail_x"] - arm, document["rail_y"] - arm
    wide, deep = document["platform_arm"], document["rod_arm"]
    offset, length = document["tool_offset"] * Z, document["rod_length"]
    ends = [
        (aside * X, wide * X),
        (half * X + back * Y, half * X + deep * Y),
        (-half * X + back * Y, -half * X + deep * Y),
        (-aside * X, -wide * X),
    ]
    return [_rail(base, Z, length, point + offset) for base, point in ends]


def _points(document: Mapping[str, Any], *names: str) -> list[tuple[Floats, ...]]:
    columns = [np.array(document[name], dtype=float) for name in names]
    return list(zip(*columns, strict=True))


def _gough_stewart(document: Mapping[str, Any]) -> list[Leg]:
    return [_strut(a, c) for a, c in _points(document, "base_points", "platform_points")]


def _hexa_linear(document: Mapping[str, Any]) -> list[Leg]:
    names = ("base_points", "rail_directions", "platform_points")
    return [_rail(a, s, document["rod_length"], c) for a, s, c in _points(document, *names)]


def _hexa_rotary(document: Mapping[str, Any]) -> list[Leg]:
    names = ("base_points", "crank_axes", "crank_zero_directions", "platform_points")
    return [_crank(a, n, e, _links(document), c) for a, n, e, c in _points(document, *names)]


def _spherical_3rrr(document: Mapping[str, Any]) -> list[Leg]:
    base, platform = document["base_cone"], document["platform_cone"]
    return [
        Leg(
            "arc",
            np.zeros(3),
            math.sin(platform) * s + math.cos(platform) * Z,
            math.sin(base) * s + math.cos(base) * Z,
            math.cos(base) * s - math.sin(base) * Z,
            document["proximal_arc"],
            document["distal_arc"],
        )
        for s in _spokes()
    ]


def _custom(document: Mapping[str, Any]) -> Machine:
    legs = []
    for leg in document["legs"]:
        base, point = np.array(leg["base_point"]), np.array(leg["platform_point"])
        if leg["drive"] == "crank":
            legs.append(_crank(base, leg["axis"], leg["zero_direction"], _links(leg), point))
        elif leg["drive"] == "rail":
            legs.append(_rail(base, leg["direction"], leg["rod_length"], point))
        else:
            legs.append(_strut(base, point))
    axis = document.get("axis")
    return Machine(str(document["motion"]), tuple(legs), Z if axis is None else unit(axis))
