"""Types of workspaces: how many orientations must hold, against every orientation tried alone."""

import json
import math
from itertools import pairwise, product
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from scipy.spatial.transform import Rotation

import analyses
from analyses.workspace_setup import set_up
from mechanics.workspace import reason_codes
from schemas.analyses import parse_request
from schemas.starters import STARTERS
from schemas.workspace import WorkspaceRequest
from tests.oracles.draws import DRAWS

TURNING = ["planar_3rrr", "custom_planar", "delta_linear_4dof", "custom_schoenflies"]
SPATIAL = ["gough_stewart", "hexa_rotary"]
LOW, HIGH = -0.2, 0.4
MANY = {
    "full": {},
    "orientation_range": {"min": LOW, "max": HIGH},
    "inclusive_orientation": {"min": LOW, "max": HIGH},
    "maximal": {},
}


def asked(**fields: object) -> WorkspaceRequest:
    request = parse_request(json.dumps({"analysis": "workspace", **fields}, default=float))
    analyses.check(request, 10**9)
    assert isinstance(request, WorkspaceRequest)
    return request


def reasons(request: WorkspaceRequest, cuts: list[int] | None = None) -> npt.NDArray[np.uint8]:
    size = analyses.plan(request, 1.0).items
    bounds = cuts or [0, size]
    tiles = [analyses.compute(request, start, stop) for start, stop in pairwise(bounds)]
    return np.concatenate([np.repeat(t["codes"], t["lengths"]) for t in tiles])


def body(name: str, seed: int, cls: str = "constructive") -> dict[str, Any]:
    """Return a request's mechanism, class and grid, with stops and an effort limit that bite."""
    random = np.random.default_rng(seed)
    draw = DRAWS[name](random)
    request: dict[str, Any] = {"mechanism": draw.wire, "class": cls}
    names = places_of(draw.wire)
    wide = 1.5 * (draw.most - draw.least)[: len(names)]
    middle = 0.5 * (draw.most + draw.least)[: len(names)]
    request["grid"] = [
        {"coordinate": c, "min": m - w, "max": m + w, "step": w / 4.01}
        for c, m, w in zip(names, middle, wide, strict=True)
    ]
    if cls == "effective":
        request["effective"] = {
            "load": {"force": 1.0, "moment": 0.1},
            "max_effort": [3.0] * len(draw.wire.get("legs", [])) or [3.0] * legs_of(draw.wire),
        }
    return request


def turns_of(wire: dict[str, Any]) -> list[str]:
    kinds = {"planar_3rrr": ["phi"], "delta_linear_4dof": ["theta"]}
    motions = {"planar": ["phi"], "schoenflies": ["theta"]}
    return kinds.get(wire["kind"], motions.get(wire.get("motion", ""), ["rx", "ry", "rz"]))


def places_of(wire: dict[str, Any]) -> list[str]:
    planar = wire["kind"] == "planar_3rrr" or wire.get("motion") == "planar"
    return ["x", "y"] if planar else ["x", "y", "z"]


def legs_of(wire: dict[str, Any]) -> int:
    return {"planar_3rrr": 3, "delta_linear_4dof": 4}.get(wire["kind"], 6)


def alone(
    request: WorkspaceRequest, document: dict[str, Any], angles: npt.NDArray[np.float64]
) -> npt.NDArray[np.uint8]:
    """Return the codes, shape (orientations, nodes), of each orientation asked for by itself."""
    names = set_up(request).mechanism.motion.turns
    rows = []
    for orientation in angles:
        fixed = dict(zip(names, orientation, strict=True))
        rows.append(reasons(asked(**document, type="constant_orientation", fixed=fixed)))
    return np.array(rows)


def told(request: WorkspaceRequest, codes: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    """Return what the definition makes of the codes at all orientations."""
    conditions = set_up(request).conditions
    meaning = reason_codes(conditions)
    names = [condition.reason for condition in conditions]
    rank = np.array([len(names), *(names.index(entry.reason) for entry in meaning)])
    if request.type in ("full", "orientation_range"):
        worst: npt.NDArray[np.uint8] = np.where(codes == 0, 255, codes).min(axis=0)
        return np.where(worst == 255, 0, worst).astype(np.uint8)
    best = rank[codes].max(axis=0)
    farthest: npt.NDArray[np.uint8] = np.where(rank[codes] == best, codes, 255).min(axis=0)
    return farthest.astype(np.uint8)


RANGES = {"full": (-math.pi, math.pi), "maximal": (-math.pi, math.pi)}
TRIED = 121


def known(request: WorkspaceRequest) -> npt.NDArray[np.int64]:
    """Return how many conditions hold before the one of each code fails."""
    conditions = set_up(request).conditions
    names = [condition.reason for condition in conditions]
    return np.array([len(names), *(names.index(e.reason) for e in reason_codes(conditions))])


@pytest.mark.parametrize("cls", ["constructive", "effective"])
@pytest.mark.parametrize("kind", MANY)
@pytest.mark.parametrize("name", TURNING)
def test_all_angles_of_one_turn_count(name: str, kind: str, cls: str) -> None:
    document = body(name, 3, cls)
    ranged = [
        {"coordinate": turn, "step": 0.05, **MANY[kind]} for turn in turns_of(document["mechanism"])
    ]
    request = asked(**document, type=kind, orientation_range=ranged)
    low, high = RANGES.get(kind, (LOW, HIGH))
    codes = alone(request, document, np.linspace(low, high, TRIED)[:, None])
    found, expected = reasons(request), told(request, codes)
    size = codes.shape[1]
    assert np.array_equal(reasons(request, [0, 7, size // 2, size]), found)
    rank = known(request)
    if kind in ("full", "orientation_range"):
        # What angle by angle breaks is broken, by that reason or one that they stepped over.
        assert np.all(np.where(found == 0, 255, found) <= np.where(expected == 0, 255, expected))
    else:
        assert np.all(rank[found] >= rank[expected])
        same = rank[found] == rank[expected]
        assert np.all(found[same] <= expected[same])
    # Few nodes show more between the angles than at them.
    assert np.mean(found != expected) < 0.1


@pytest.mark.parametrize("cls", ["constructive", "effective"])
@pytest.mark.parametrize("name", TURNING)
def test_free_orientation_is_the_share_that_holds(name: str, cls: str) -> None:
    document = body(name, 1, cls)
    ranged = [{"coordinate": turns_of(document["mechanism"])[0], "step": 0.05}]
    request = asked(
        **document, type="maximal", orientation_range=ranged, fields=["free_orientation"]
    )
    count = 240
    angles = (np.arange(count) + 0.5) * 2.0 * math.pi / count - math.pi
    codes = alone(request, document, angles[:, None])
    sizes = np.zeros(codes.shape[1])
    inside = reasons(request) == 0
    sizes[inside] = analyses.compute(request, 0, inside.size)["field_free_orientation"]
    changes = np.sum((codes == 0) != (np.roll(codes, 1, axis=0) == 0), axis=0)
    sampled = np.sum(codes == 0, axis=0) * 2.0 * math.pi / count
    # An end of an arc lies anywhere between two angles; an arc between them shows in neither.
    assert np.all(np.abs(sizes - sampled) <= (0.5 * changes + 1.0) * 2.0 * math.pi / count)
    assert analyses.answer(request).model_dump()["orientations"][0]["all_angles"]


@pytest.mark.parametrize("kind", ["orientation_range", "inclusive_orientation"])
@pytest.mark.parametrize("name", SPATIAL)
def test_a_grid_of_three_turns(name: str, kind: str) -> None:
    document = body(name, 5, "effective")
    ranged = [{"coordinate": t, "min": -0.1, "max": 0.2, "step": 0.2} for t in ("rx", "ry", "rz")]
    request = asked(**document, type=kind, orientation_range=ranged)
    angles = np.array(list(product([-0.1, 0.05, 0.2], repeat=3)))
    assert np.array_equal(reasons(request), told(request, alone(request, document, angles)))


@pytest.mark.parametrize("kind", ["orientation_range", "inclusive_orientation"])
@pytest.mark.parametrize("name", SPATIAL)
def test_of_three_turns_the_last_is_all_round(name: str, kind: str) -> None:
    document = body(name, 5)
    ranged = [{"coordinate": t, "min": -0.1, "max": 0.2, "step": 0.2} for t in ("rx", "ry", "rz")]
    request = asked(**document, type=kind, orientation_range=ranged)
    turns = np.linspace(-0.1, 0.2, 31)
    angles = np.array(list(product([-0.1, 0.05, 0.2], [-0.1, 0.05, 0.2], turns)))
    found, expected = reasons(request), told(request, alone(request, document, angles))
    rank = known(request)
    if kind == "orientation_range":
        assert np.all(np.where(found == 0, 255, found) <= np.where(expected == 0, 255, expected))
    else:
        assert np.all(rank[found] >= rank[expected])
    assert np.mean(found != expected) < 0.1


@pytest.mark.parametrize("name", TURNING)
def test_types_lie_within_each_other(name: str) -> None:
    for seed in range(3):
        for cls in ("theoretical", "constructive", "effective"):
            document = body(name, seed, cls)
            turn = turns_of(document["mechanism"])[0]
            inside = {
                kind: reasons(
                    asked(**document, type=kind, orientation_range=[{"coordinate": turn, **ends}])
                )
                == 0
                for kind, ends in MANY.items()
            }
            fixed = {turn: 0.5 * (LOW + HIGH)}
            constant = reasons(asked(**document, type="constant_orientation", fixed=fixed)) == 0
            chain = [
                inside["full"],
                inside["orientation_range"],
                constant,
                inside["inclusive_orientation"],
                inside["maximal"],
            ]
            for inner, outer in pairwise(chain):
                assert not np.any(inner & ~outer)


def test_a_spherical_platform_spins_about_its_own_axis() -> None:
    draw = DRAWS["spherical_3rrr"](np.random.default_rng(2))
    tilts = np.linspace(-1.0, 1.0, 9)
    grid = [{"coordinate": c, "min": -1.0, "max": 1.0, "step": 0.25} for c in ("rx", "ry")]
    document = {"mechanism": draw.wire, "class": "constructive", "grid": grid, "fixed": {"rz": 0.3}}
    spins = Rotation.from_euler("z", np.linspace(LOW, HIGH, 61)[:, None])
    held = np.array(
        [
            holds_at(document, Rotation.from_euler("xyz", [rx, ry, 0.3]) * spins)
            for rx, ry in product(tilts, tilts)
        ]
    )
    for kind, expected in (
        ("inclusive_orientation", held.any(axis=1)),
        ("orientation_range", held.all(axis=1)),
    ):
        ranged = [{"coordinate": "spin", "min": LOW, "max": HIGH}]
        found = reasons(asked(**document, type=kind, orientation_range=ranged)) == 0
        assert 0 < np.sum(found) < found.size
        assert np.mean(found != expected) < 0.03


def holds_at(document: dict[str, Any], places: Rotation) -> npt.NDArray[np.bool_]:
    body = {
        "analysis": "inverse_kinematics",
        "mechanism": document["mechanism"],
        "poses": places.as_euler("xyz").tolist(),
    }
    answer = analyses.answer(parse_request(json.dumps(body, default=float)))
    return np.array(answer.model_dump()["reachable"])


def test_orientations_stand_on_the_grid() -> None:
    document = body("planar_3rrr", 1)
    grid = [{"coordinate": "phi", "min": -1.0, "max": 1.0, "step": 0.1}]
    request = asked(**document | {"grid": grid}, type="orientation", fixed={"x": 0.0, "y": 0.0})
    found = reasons(request)
    for k, phi in enumerate(np.arange(21) * 0.1 - 1.0):
        here = [{"coordinate": c, "min": 0.0, "max": 0.0, "step": 1.0} for c in "xy"]
        one = document | {"grid": here}
        assert reasons(asked(**one, type="constant_orientation", fixed={"phi": phi}))[0] == found[k]


def turn(**fields: object) -> dict[str, Any]:
    return {"orientation_range": [{"coordinate": "phi", **fields}]}


HELD = {"type": "constant_orientation", "fixed": {"phi": 0.0}}
RANGE = {"type": "orientation_range"}
WIDE = [{"coordinate": c, "min": -0.3, "max": 0.3, "step": 0.003} for c in "xy"]
LOADED = {"class": "effective", "effective": {"load": {"force": 1.0}, "max_effort": 3.0}}


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"type": "maximal", "fixed": {"phi": 0.0}}, "/fixed/phi"),
        ({"type": "full"} | turn(coordinate="x"), "/orientation_range/0/coordinate"),
        ({"type": "full"} | turn(min=0.0, max=1.0), "/orientation_range/0"),
        ({"type": "inclusive_orientation"}, "/orientation_range"),
        (RANGE | turn(step=0.1), "/orientation_range/0"),
        (RANGE | turn(min=1.0, max=0.0), "/orientation_range/0/max"),
        ({"type": "maximal", "fields": ["determinant"]}, "/fields/0"),
        (HELD | {"fields": ["free_orientation"]}, "/fields/0"),
        (HELD | turn(), "/orientation_range"),
        ({"type": "maximal", "component": "home", "home": [0.0, 0.0, 0.0]}, "/component"),
        ({"type": "full", "method": "geometric"}, "/method"),
        (LOADED | {"type": "maximal"} | turn(step=1e-11), "/orientation_range"),
        (LOADED | {"type": "maximal"} | turn(step=1e-4) | {"grid": WIDE}, "/grid"),
        (RANGE | turn(min=0.0, max=7.0), "/orientation_range/0/max"),
        ({"type": "orientation", "fixed": {"phi": 0.0}}, "/grid/0/coordinate"),
    ],
)
def test_what_makes_no_sense_is_refused(changes: dict[str, Any], place: str) -> None:
    with pytest.raises(analyses.AnalysisError) as error:
        asked(**body("planar_3rrr", 1) | changes)
    assert place in [pointer for pointer, _ in error.value.errors]


@pytest.mark.parametrize(
    ("mechanism", "kind"),
    [("five_bar", "maximal"), ("translational_3rrrr", "orientation")],
)
def test_types_need_their_motion(mechanism: str, kind: str) -> None:
    draw = DRAWS[mechanism](np.random.default_rng(0))
    grid = [{"coordinate": "x", "min": 0, "max": 1, "step": 1}]
    with pytest.raises(analyses.AnalysisError) as error:
        asked(mechanism=draw.wire, type=kind, grid=grid, **{"class": "theoretical"})
    assert "/type" in [pointer for pointer, _ in error.value.errors]


def many_one_by_one() -> WorkspaceRequest:
    """Return a request for 625 nodes at thousands of orientations, each tried by itself."""
    return asked(
        **{"class": "effective", "type": "maximal", "fixed": {"z": 0.7}},
        mechanism=STARTERS["gough_stewart"].model_dump(mode="json"),
        grid=[{"coordinate": c, "min": -0.12, "max": 0.12, "step": 0.01} for c in "xy"],
        effective={"load": {"force": 10.0}, "max_effort": 40.0},
    )


def test_orientations_tried_one_by_one_are_not_tried_again_for_every_few_nodes() -> None:
    assert analyses.plan(many_one_by_one(), 1.0).items_per_tile == 625


def test_orientations_tried_one_by_one_are_not_answered_at_once() -> None:
    assert analyses.estimate(many_one_by_one(), 0.5).mode == "job"
