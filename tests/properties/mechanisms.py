"""Random mechanisms of every kind and motion with a pose in reach, as requests write them."""

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from hypothesis import HealthCheck, Phase, assume, settings
from hypothesis import strategies as st

import analyses
from analyses.mechanisms import build
from mechanics.configuration import Configuration
from mechanics.mechanism import Mechanism
from schemas.mechanisms import parse_spec
from tests.oracles import legs
from tests.oracles.legs import Floats, Machine

Document = dict[str, Any]
Draw = st.DrawFn

# Poses in reach are found by construction or by rejection: that is not an unhealthy search.
# A geometry of a hundred numbers takes minutes to shrink and is no clearer for it.
FEW = settings(
    max_examples=3,
    deadline=None,
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)


def refuse(constant: str) -> None:
    raise AssertionError(f"{constant} on the wire")


def ask(document: Mapping[str, object]) -> Document:
    """Return the checked answer to a request, read back from strict JSON."""
    request = analyses.parse(json.dumps(document))
    analyses.check(request, 10**6)
    text = analyses.answer(request).model_dump_json()
    answer: Document = json.loads(text, parse_constant=refuse)
    return answer


@dataclass(frozen=True)
class Case:
    """A mechanism as a request writes it, and a pose that all its legs reach."""

    document: Document
    pose: tuple[float, ...]
    kind: str = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "kind", self.document["kind"])

    @property
    def row(self) -> Floats:
        return np.array(self.pose)

    @cached_property
    def machine(self) -> Machine:
        return legs.read(self.document)

    @cached_property
    def mechanism(self) -> Mechanism:
        return build(parse_spec(json.dumps(self.document)))

    @cached_property
    def block(self) -> Configuration:
        return self.at(self.row)

    @cached_property
    def actuators(self) -> Floats:
        return self.block.actuators[:, 0]

    @property
    def drives(self) -> list[str]:
        return [leg.drive for leg in self.machine.legs]

    def hinge(self, leg: int) -> Floats:
        """The first passive axis at a leg's elbow where the drive is at 0; a choice, not a fact."""
        axis: Floats = self.mechanism.legs.hinge[leg]
        return axis

    @property
    def twists(self) -> Floats:
        """The unit twists of the motion as columns."""
        return legs.basis(self.machine)

    @cached_property
    def reach(self) -> float:
        """The shortest of what a leg spans: the length over which its rates change."""
        lengths = []
        for leg, joint, psi in zip(
            self.machine.legs,
            legs.joints(self.machine, self.row),
            self.actuators,
            strict=True,
        ):
            if leg.drive == "arc":
                lengths += [abs(math.sin(leg.crank)), abs(math.sin(leg.rod))]
                continue
            moved, _ = legs.driven(leg, psi)
            lengths.append(float(np.linalg.norm(joint - moved)))
            if leg.drive == "crank":
                turning = joint - leg.base
                away = turning - (turning @ leg.axis) * leg.axis
                lengths += [leg.crank, float(np.linalg.norm(away))]
        return min(lengths)

    def at(self, *rows: Floats) -> Configuration:
        """Return the mechanism at some poses."""
        return Configuration(self.mechanism, np.ascontiguousarray(np.array(rows).T))

    def request(self, analysis: str, **more: object) -> Document:
        poses = [list(self.pose)]
        return {"analysis": analysis, "mechanism": self.document, "poses": poses, **more}


def well_held(case: Case, greatest: float = 100.0, least: float = 0.1) -> Case:
    """Drop the example if a leg is nearly stretched or the platform hardly held."""
    assume(not np.isnan(case.actuators).any())
    assume(legs.transmission(case.machine, case.row, case.actuators).min() > least)
    assume(legs.spread(case.machine, case.row, case.actuators) < greatest)
    return case


def numbers(least: float, greatest: float) -> st.SearchStrategy[float]:
    """Return ordinary numbers: six decimals, no denormals."""
    return st.floats(least, greatest).map(lambda value: round(value, 6) + 0.0)


def vectors(size: float = 1.0, *, flat: bool = False) -> st.SearchStrategy[list[float]]:
    """Return vectors of three numbers, in the plane z = 0 if `flat`; one draw, so that it is quick.

    The numbers are the digits of a whole number to the base 2001, in thousandths of the size.
    """

    def decode(code: int) -> list[float]:
        digits = [code % 2001, code // 2001 % 2001, 1000 if flat else code // 2001**2]
        return [size * (digit - 1000) / 1000 for digit in digits]

    return st.integers(0, 2001**3 - 1).map(decode)


@st.composite
def axes(draw: Draw, *, flat: bool = False) -> list[float]:
    axis = draw(vectors(flat=flat))
    assume(math.hypot(*axis) > 0.1)
    return axis


def across(axis: list[float], hint: list[float]) -> list[float]:
    """Return the part of a vector perpendicular to an axis."""
    along = legs.unit(axis)
    part = np.array(hint) - (along @ np.array(hint)) * along
    assume(float(np.linalg.norm(part)) > 0.1)
    return [float(number) for number in part]


@st.composite
def poses(draw: Draw, motion: str) -> tuple[float, ...]:
    count, turns = legs.COORDINATES[motion], legs.Machine(motion, (), legs.Z).turns
    shifts = [draw(numbers(-1.0, 1.0)) for _ in range(count - turns)]
    angles = [draw(numbers(-3.2, 3.2)) for _ in range(turns)]
    return (*shifts, *angles)


def signs(count: int) -> st.SearchStrategy[list[int]]:
    return st.lists(st.sampled_from([1, -1]), min_size=count, max_size=count)


@st.composite
def custom_legs(
    draw: Draw, drive: str, *, flat: bool, machine: Machine, pose: Floats
) -> tuple[Document, int]:
    """Draw a leg and where its drive stands; the rod is what then joins drive and platform."""
    base, point = draw(vectors(flat=flat)), draw(vectors(0.5, flat=flat))
    _, rotation = legs.place(machine, pose)
    joint = legs.place(machine, pose)[0] + rotation @ np.array(point)
    leg: Document = {"drive": drive, "base_point": base, "platform_point": point}
    if drive == "strut":
        assume(float(np.linalg.norm(joint - np.array(base))) > 0.1)
        return leg, 1
    sign = draw(st.sampled_from([1, -1]))
    if drive == "rail":
        leg["direction"] = draw(axes(flat=flat))
        stand = draw(numbers(-1.0, 1.0))
        moved = np.array(base) + stand * legs.unit(leg["direction"])
    else:
        leg["axis"] = [0.0, 0.0, draw(st.sampled_from([1.0, -2.0]))] if flat else draw(axes())
        leg["zero_direction"] = across(leg["axis"], draw(vectors(flat=flat)))
        leg["crank_length"] = draw(numbers(0.1, 1.0))
        shape = legs._crank(
            np.array(base), leg["axis"], leg["zero_direction"], (leg["crank_length"], 1.0), joint
        )
        moved, _ = legs.driven(shape, draw(numbers(-3.0, 3.0)))
    leg["rod_length"] = float(np.linalg.norm(joint - moved))
    assume(leg["rod_length"] > 0.1)
    return leg, sign


@st.composite
def customs(draw: Draw, motion: str, drives: tuple[str, ...] | None = None) -> Case:
    """Draw a mechanism of freely mixed drives and a pose that it reaches by construction."""
    pose = draw(poses(motion))
    document: Document = {"kind": "custom", "motion": motion, "legs": []}
    axis = draw(axes()) if motion == "schoenflies" else None
    if axis is not None:
        document["axis"] = axis
    machine = Machine(motion, (), legs.Z if axis is None else legs.unit(axis))
    count, flat = legs.COORDINATES[motion], motion.startswith("planar")
    kinds = drives or tuple(
        draw(st.lists(st.sampled_from(["crank", "rail", "strut"]), min_size=count, max_size=count))
    )
    mode = []
    for drive in kinds:
        leg, sign = draw(custom_legs(drive, flat=flat, machine=machine, pose=np.array(pose)))
        document["legs"].append(leg)
        mode.append(sign)
    document["working_mode"] = mode
    return Case(document, pose)


def _two_links(draw: Draw, spans: Floats, greatest: float = math.inf) -> tuple[float, float]:
    """Return links with |r - L| below all spans and r + L above them, with room to spare."""
    assume(spans.min() > 0.05)
    room = draw(numbers(0.05, 0.9))
    total = float(spans.max()) + room * min(float(spans.max()), greatest - float(spans.max()))
    excess = float(spans.min()) * draw(numbers(-0.9, 0.9))
    return (total + excess) / 2, (total - excess) / 2


def _spans(document: Document, pose: tuple[float, ...]) -> Floats:
    """Return how far each leg must reach; about its base axis, of an arc."""
    machine = legs.read(document)
    ends = legs.joints(machine, np.array(pose))
    return np.array(
        [
            math.atan2(float(np.linalg.norm(np.cross(leg.axis, end))), float(leg.axis @ end))
            if leg.drive == "arc"
            else float(np.linalg.norm(end - leg.base))
            for leg, end in zip(machine.legs, ends, strict=True)
        ]
    )


def _with_links(draw: Draw, document: Document, pose: tuple[float, ...]) -> Case:
    crank, rod = _two_links(draw, _spans({**document, "crank_length": 1, "rod_length": 1}, pose))
    return Case({**document, "crank_length": crank, "rod_length": rod}, pose)


@st.composite
def five_bars(draw: Draw) -> Case:
    document: Document = {"kind": "five_bar", "base_distance": draw(numbers(0.1, 2.0))}
    return _with_links(
        draw, {**document, "working_mode": draw(signs(2))}, draw(poses("planar_translation"))
    )


@st.composite
def planar_3rrrs(draw: Draw) -> Case:
    document: Document = {
        "kind": "planar_3rrr",
        "base_side": draw(numbers(0.1, 2.0)),
        "platform_radius": draw(numbers(0.02, 1.0)),
        "working_mode": draw(signs(3)),
    }
    return _with_links(draw, document, draw(poses("planar")))


def _around_axes(document: Document, pose: tuple[float, ...]) -> tuple[Floats, Floats]:
    """Return each platform joint's distance from its crank's axis, and along that axis."""
    machine = legs.read(document)
    away = [
        end - leg.base
        for leg, end in zip(machine.legs, legs.joints(machine, np.array(pose)), strict=True)
    ]
    along = np.array([leg.axis @ d for leg, d in zip(machine.legs, away, strict=True)])
    radial = np.array([float(np.linalg.norm(d)) for d in away]) ** 2 - along**2
    return np.sqrt(np.maximum(radial, 0.0)), along


@st.composite
def translational_3rrrrs(draw: Draw) -> Case:
    """A leg of equal links reaches iff (rho - l)^2 + z^2 <= l^2."""
    document: Document = {
        "kind": "translational_3rrrr",
        "base_radius": draw(numbers(0.1, 1.0)),
        "link_length": 1.0,
        "working_mode": draw(signs(3)),
    }
    pose = draw(poses("translation"))
    radius, along = _around_axes(document, pose)
    assume(radius.min() > 0.05)
    least = float(((radius**2 + along**2) / (2 * radius)).max())
    return Case({**document, "link_length": least * draw(numbers(1.05, 2.0))}, pose)


@st.composite
def delta_rotaries(draw: Draw) -> Case:
    """The rods reach if L^2 is between (rho - r)^2 + z^2 and (rho + r)^2 + z^2 at all legs."""
    document: Document = {
        "kind": "delta_rotary",
        "base_radius": draw(numbers(0.1, 0.6)),
        "platform_radius": draw(numbers(0.02, 0.3)),
        "crank_length": draw(numbers(0.3, 1.0)),
        "rod_length": 1.0,
        "working_mode": draw(signs(3)),
    }
    x, y, z = draw(numbers(-0.3, 0.3)), draw(numbers(-0.3, 0.3)), draw(numbers(-1.2, -0.3))
    radius, along = _around_axes(document, (x, y, z))
    crank = document["crank_length"]
    least = float(np.hypot(radius - crank, along).max())
    most = float(np.hypot(radius + crank, along).min())
    assume(least < most)
    share = draw(numbers(0.05, 0.95))
    return Case({**document, "rod_length": least + share * (most - least)}, (x, y, z))


def _on_rails(draw: Draw, document: Document, pose: tuple[float, ...]) -> Case:
    """Return the case with rods that reach from every platform joint to its rail."""
    radius, _ = _around_axes({**document, "rod_length": 1.0}, pose)
    longest = float(radius.max())
    assume(longest > 0.02)
    return Case({**document, "rod_length": longest * draw(numbers(1.05, 3.0))}, pose)


@st.composite
def upright_deltas(draw: Draw) -> Case:
    document: Document = {
        "kind": "delta_linear",
        "rail_radius": draw(numbers(0.1, 1.0)),
        "platform_radius": draw(numbers(0.02, 0.5)),
        "carriage_arm": draw(numbers(0.0, 0.1)),
        "tool_offset": draw(numbers(-0.3, 0.3)),
        "working_mode": draw(signs(3)),
    }
    return _on_rails(draw, document, draw(poses("translation")))


@st.composite
def delta_linear_4dofs(draw: Draw) -> Case:
    document: Document = {
        "kind": "delta_linear_4dof",
        "rail_x": draw(numbers(0.1, 0.5)),
        "rail_y": draw(numbers(0.1, 0.5)),
        "carriage_arm": draw(numbers(0.0, 0.08)),
        "platform_arm": draw(numbers(0.02, 0.3)),
        "rod_arm": draw(numbers(0.0, 0.2)),
        "rod_spacing": draw(numbers(0.05, 0.3)),
        "tool_offset": draw(numbers(-0.2, 0.2)),
        "working_mode": draw(signs(4)),
    }
    return _on_rails(draw, document, draw(poses("schoenflies")))


def _six(draw: Draw, size: float) -> list[list[float]]:
    return [draw(vectors(size)) for _ in range(6)]


@st.composite
def gough_stewarts(draw: Draw) -> Case:
    document = {
        "kind": "gough_stewart",
        "base_points": _six(draw, 1.0),
        "platform_points": _six(draw, 0.5),
    }
    pose = draw(poses("spatial"))
    assume(_spans(document, pose).min() > 0.1)
    return Case(document, pose)


@st.composite
def hexa_linears(draw: Draw) -> Case:
    document = {
        "kind": "hexa_linear",
        "base_points": _six(draw, 1.0),
        "rail_directions": [draw(axes()) for _ in range(6)],
        "platform_points": _six(draw, 0.5),
        "working_mode": draw(signs(6)),
    }
    return _on_rails(draw, document, draw(poses("spatial")))


@st.composite
def hexa_rotaries(draw: Draw) -> Case:
    """Base points follow from a platform, rods and cranks of drawn directions."""
    pose = draw(poses("spatial"))
    point, rotation = legs.place(Machine("spatial", (), legs.Z), np.array(pose))
    crank, rod = draw(numbers(0.1, 1.0)), draw(numbers(0.2, 1.0))
    document: Document = {
        "kind": "hexa_rotary",
        "base_points": [],
        "crank_axes": [draw(axes()) for _ in range(6)],
        "crank_zero_directions": [],
        "crank_length": crank,
        "rod_length": rod,
        "platform_points": _six(draw, 0.5),
        "working_mode": draw(signs(6)),
    }
    for axis, end in zip(document["crank_axes"], document["platform_points"], strict=True):
        zero = across(axis, draw(vectors()))
        turned = legs.about(legs.unit(axis), draw(numbers(-3.0, 3.0))) @ legs.unit(zero)
        # Rods lean towards the elbow's path, so that few legs are nearly stretched.
        ahead = np.cross(legs.unit(axis), turned)
        direction = legs.unit(ahead + 0.8 * legs.unit(draw(axes())))
        elbow = point + rotation @ np.array(end) - rod * direction
        document["crank_zero_directions"].append(zero)
        document["base_points"].append([float(n) for n in elbow - crank * turned])
    return Case(document, pose)


@st.composite
def spherical_3rrrs(draw: Draw) -> Case:
    """Arcs meet if they bridge the angles between base and platform axes on the sphere."""
    document: Document = {
        "kind": "spherical_3rrr",
        "base_cone": draw(numbers(0.2, 2.9)),
        "platform_cone": draw(numbers(0.2, 2.9)),
        "proximal_arc": 1.0,
        "distal_arc": 1.0,
        "working_mode": draw(signs(3)),
    }
    pose = draw(poses("spherical"))
    spans = _spans(document, pose)
    proximal, distal = _two_links(draw, spans, 2 * math.pi - float(spans.max()))
    assume(max(proximal, distal) < 3.0)
    return Case({**document, "proximal_arc": proximal, "distal_arc": distal}, pose)


FAMILIES: Mapping[str, Callable[[], st.SearchStrategy[Case]]] = {
    "five_bar": five_bars,
    "planar_3rrr": planar_3rrrs,
    "translational_3rrrr": translational_3rrrrs,
    "delta_rotary": delta_rotaries,
    "delta_linear": upright_deltas,
    "delta_linear_4dof": delta_linear_4dofs,
    "hexa_linear": hexa_linears,
    "gough_stewart": gough_stewarts,
    "hexa_rotary": hexa_rotaries,
    "spherical_3rrr": spherical_3rrrs,
}
ALL: Mapping[str, st.SearchStrategy[Case]] = {
    **{name: make() for name, make in FAMILIES.items()},
    **{f"custom {motion}": customs(motion) for motion in legs.COORDINATES},
}
NAMES = tuple(ALL)


def cases(data: st.DataObject, name: str) -> Case:
    """Draw a case of a family, or of a motion with freely mixed drives."""
    return data.draw(ALL[name], label=name)


def well_held_cases(data: st.DataObject, name: str) -> Case:
    return well_held(cases(data, name))
