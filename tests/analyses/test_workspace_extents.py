"""What a workspace amounts to beside its nodes: geometric measure, inscribed shapes, histograms."""

import json
import math
from collections.abc import Iterable
from typing import Any

import numpy as np
import pytest

import analyses
from schemas.analyses import parse_request
from schemas.starters import STARTERS

RRR = {
    "kind": "planar_3rrr",
    "base_side": 0.4,
    "platform_radius": 0.08,
    "crank_length": 0.18,
    "rod_length": 0.18,
}
FIVE_BAR = {"kind": "five_bar", "base_distance": 0.1, "crank_length": 0.12, "rod_length": 0.18}
TORI = {"kind": "translational_3rrrr", "link_length": 0.3, "base_radius": 0.2}
THEORY = {"class": "theoretical", "type": "constant_orientation"}


def axes(names: Iterable[str], low: float, high: float, step: float) -> list[dict[str, Any]]:
    return [{"coordinate": name, "min": low, "max": high, "step": step} for name in names]


def asked(**fields: object) -> dict[str, Any]:
    request = parse_request(json.dumps({"analysis": "workspace", **THEORY, **fields}))
    analyses.check(request, 10**8)
    found: dict[str, Any] = json.loads(analyses.answer(request).model_dump_json(by_alias=True))
    return found


def refused(**fields: object) -> list[tuple[str, str]]:
    request = parse_request(json.dumps({"analysis": "workspace", **THEORY, **fields}))
    with pytest.raises(analyses.AnalysisError) as error:
        analyses.check(request, 10**8)
    return list(error.value.errors)


@pytest.mark.parametrize("mechanism", [RRR, FIVE_BAR], ids=["3-RRR", "five-bar"])
def test_nodes_come_to_the_exact_area(mechanism: dict[str, Any]) -> None:
    fixed = {"phi": 0.1} if mechanism is RRR else {}
    bounds = []
    for step in (0.008, 0.004, 0.002):
        request = {"mechanism": mechanism, "grid": axes("xy", -0.35, 0.35, step), "fixed": fixed}
        exact = asked(**request, method="geometric")["measure"]
        counted = asked(**request)["measure"]
        assert exact["rigorous"]
        assert exact["error_bound"] < 1e-11
        bounds.append(counted["error_bound"])
        assert abs(counted["value"] - exact["value"]) <= bounds[-1]
    # Half the step, half the bound: the boundary is as long as it is.
    assert bounds[2] < 0.3 * bounds[0]


def test_a_five_bar_is_a_lens_less_two_holes() -> None:
    found = asked(mechanism=FIVE_BAR, grid=axes("xy", -0.4, 0.4, 0.05), method="geometric")
    # Both holes, of radius 0.06 about the drives, lie within the lens and 0.1 apart.
    lost = 2.0 * math.pi * 0.06**2 - lens(0.1, 0.06)
    assert found["measure"]["value"] == pytest.approx(lens(0.1, 0.3) - lost, rel=1e-12)


def lens(apart: float, radius: float) -> float:
    """Return what two discs of one radius share."""
    half = 0.5 * apart
    return 2.0 * (radius**2 * math.acos(half / radius) - half * math.sqrt(radius**2 - half**2))


def test_the_boundary_bounds_the_area() -> None:
    found = asked(mechanism=RRR, grid=axes("xy", -0.3, 0.3, 0.1), fixed={"phi": 0.0},
                  method="geometric")  # fmt: skip
    points = []
    for arc in found["boundary"][0]:
        angles = np.linspace(arc["start"], arc["end"], 20_000)
        points.append(
            np.array(arc["centre"]) + arc["radius"] * np.c_[np.cos(angles), np.sin(angles)]
        )
    x, y = np.concatenate(points).T
    area = 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))
    assert area == pytest.approx(found["measure"]["value"], rel=1e-8)
    assert [bound["min"] for bound in found["bounds"]] == pytest.approx(
        [x.min(), y.min()], abs=1e-9
    )


def test_tori_lie_between_proven_bounds() -> None:
    request = {"mechanism": TORI, "grid": axes("xyz", -0.65, 0.65, 0.02)}
    proven = asked(**request, method="geometric")["measure"]
    counted = asked(**request)["measure"]
    assert proven["rigorous"]
    assert proven["unit"] == "m³"
    apart = abs(counted["value"] - proven["value"])
    assert apart <= proven["error_bound"] + counted["error_bound"]
    assert proven["error_bound"] < 0.03 * proven["value"]


def test_the_maximal_workspace_is_bounded_from_outside() -> None:
    grid = axes("xy", -0.3, 0.3, 0.005)
    bound = asked(mechanism=RRR, grid=grid, method="geometric", type="maximal")
    counted = asked(mechanism=RRR, grid=grid, type="maximal")
    assert bound["outer_bound"]
    assert not counted["outer_bound"]
    # Erastova and Laryushkin take the bound for the workspace; that has 0.1664 m².
    assert bound["measure"]["value"] == pytest.approx(0.1683, abs=5e-5)
    assert counted["measure"]["value"] == pytest.approx(0.1664, abs=1e-3)


def test_the_geometric_method_says_what_it_cannot_do() -> None:
    grid = axes("xy", -0.3, 0.3, 0.01)
    one_axis = refused(mechanism=RRR, grid=grid[:1], fixed={"y": 0, "phi": 0}, method="geometric")
    assert one_axis[0][0] == "/method"
    assert "x, y" in one_axis[0][1]
    bounds = {"class": "constructive", "constructive": {"min_crank_rod_angle": 0.3}}
    angle = refused(mechanism=RRR, grid=grid, fixed={"phi": 0}, method="geometric", **bounds)
    assert "crank_rod_angle" in angle[0][1]
    stops = RRR | {"actuator_limits": {"min": 0.0, "max": 1.0}}
    limits = refused(
        mechanism=stops,
        grid=grid,
        fixed={"phi": 0},
        method="geometric",
        **{"class": "constructive"},
    )
    assert limits[0][0] == "/method"
    assert "leg 0" in limits[0][1]


def test_the_geometric_method_is_not_of_platforms_that_only_turn() -> None:
    wire = STARTERS["spherical_3rrr"].model_dump(exclude_none=True)
    grid = axes(("rx", "ry"), -0.5, 0.5, 0.25)
    told = refused(mechanism=wire, grid=grid, fixed={"rz": 0.0}, method="geometric")
    assert told == [("/method", "geometric is over translations; this platform only turns")]


def test_inscribed_shapes_lie_within_the_exact_annuli() -> None:
    found = asked(
        mechanism=RRR, grid=axes("xy", -0.3, 0.3, 0.002), fixed={"phi": 0.0}, inscribed=True
    )["inscribed"]
    centres = 0.4 / math.sqrt(3.0) * np.exp(1j * np.deg2rad([90, 210, 330]))
    centres -= 0.08 * np.exp(1j * np.deg2rad([90, 210, 330]))
    ball, box = found["ball"], found["box"]
    middle = complex(ball["centre"]["x"], ball["centre"]["y"])
    assert np.abs(middle - centres).max() + ball["radius"] <= 0.36
    # The machine is symmetric: the exact disc stands about the origin.
    assert ball["radius"] >= 0.36 - abs(centres[0]) - 3 * 0.002
    corners = [complex(x, y) for x in (box["min"]["x"], box["max"]["x"])
               for y in (box["min"]["y"], box["max"]["y"])]  # fmt: skip
    assert max(abs(corner - centre) for corner in corners for centre in centres) <= 0.36


def test_shapes_are_looked_for_only_when_asked() -> None:
    grid = axes("xy", -0.3, 0.3, 0.05)
    assert asked(mechanism=RRR, grid=grid, fixed={"phi": 0.0})["inscribed"] is None


def test_histograms_count_every_value_once() -> None:
    request = {
        "mechanism": RRR,
        "grid": axes("xy", -0.3, 0.3, 0.01),
        "fixed": {"phi": 0.0},
        "fields": ["effort", "determinant"],
        "effective": {"load": {"force": 1.0, "moment": 0.1}},
    }
    plain = asked(**request)
    assert plain["fields"]["effort"]["histogram"] is None
    found = asked(**request, histograms=True)
    for name, width in (("effort", 3), ("determinant", 1)):
        summary = found["fields"][name]
        counts = summary["histogram"]
        assert sum(counts["counts"]) + counts["undefined"] == width * found["inside"]
        assert counts["edges"][0] == summary["min"]
        assert counts["edges"][-1] == summary["max"]
