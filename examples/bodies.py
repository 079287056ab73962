"""What is asked of the server for each picture: request bodies, nothing else."""

import math
from typing import Any

Json = dict[str, Any]

# The size of the rose is not printed; petals of 0.1 m stay clear of singularities.
ROSE = 0.1
# Of any position; the paper's is not printed.
ELSEWHERE = {"x": 0.12, "y": 0.08}
BOTH_ENDS = {"max_crank_rod_angle": math.radians(160), "max_rod_rod_angle": math.radians(175)}


def axis(coordinate: str, least: float, most: float, step: float) -> Json:
    """Return an axis of a grid."""
    return {"coordinate": coordinate, "min": least, "max": most, "step": step}


def workspace(mechanism: Json, class_: str, type_: str, grid: list[Json], **more: Any) -> Json:  # noqa: ANN401
    """Return the request for a workspace."""
    return {
        "analysis": "workspace",
        "mechanism": mechanism,
        "class": class_,
        "type": type_,
        "grid": grid,
        **more,
    }


def effort_map(mechanism: Json) -> Json:
    """Return the request of 2016: every millimetre at phi = 0, under 10 N from anywhere."""
    return workspace(
        mechanism,
        "theoretical",
        "constant_orientation",
        [axis("x", -0.3, 0.3, 0.001), axis("y", -0.3, 0.3, 0.001)],
        fixed={"phi": 0.0},
        effective={"load": {"force": 10.0}},
        fields=["effort_max"],
    )


def rose_poses(count: int = 1501) -> list[list[float]]:
    """Return poses of the 3-RRR along a three-petalled rose, drawn once."""
    turns = [math.pi * i / (count - 1) for i in range(count)]
    return [
        [ROSE * math.cos(3 * t) * math.cos(t), ROSE * math.cos(3 * t) * math.sin(t), 0.0]
        for t in turns
    ]


def rose_efforts(mechanism: Json) -> dict[str, Json]:
    """Return the requests of the three curves of 2016's figure 4, each 10 N along the rose."""
    body = {"analysis": "effort", "mechanism": mechanism, "poses": rose_poses()}
    return {
        "worst": {**body, "load": {"force": 10.0}},
        "along x": {**body, "known_load": {"force": [10.0, 0.0, 0.0]}},
        "along y": {**body, "known_load": {"force": [0.0, 10.0, 0.0]}},
    }


def geometric(mechanism: Json, type_: str) -> Json:
    """Return the request for the intersection of the legs' regions."""
    grid = [axis("x", -0.45, 0.45, 0.005), axis("y", -0.45, 0.45, 0.005)]
    return workspace(mechanism, "theoretical", type_, grid, method="geometric")


def types_of_3rrr(mechanism: Json) -> dict[str, Json]:
    """Return the requests of 2017's figure 4, and the maximal workspace."""
    plane = [axis("x", -0.3, 0.3, 0.001), axis("y", -0.3, 0.3, 0.001)]
    turns = [axis("phi", -math.pi, math.pi, math.radians(0.5))]

    def ask(type_: str, grid: list[Json], **more: Any) -> Json:  # noqa: ANN401
        return workspace(mechanism, "theoretical", type_, grid, **more)

    quarter = [{"coordinate": "phi", "min": 0.0, "max": math.pi / 2}]
    return {
        "phi = 0": ask("constant_orientation", plane, fixed={"phi": 0.0}),
        "phi = pi/4": ask("constant_orientation", plane, fixed={"phi": math.pi / 4}),
        "centre": ask("orientation", turns, fixed={"x": 0.0, "y": 0.0}),
        "elsewhere": ask("orientation", turns, fixed=ELSEWHERE),
        "full": ask("full", plane),
        "quarter": ask("inclusive_orientation", plane, orientation_range=quarter),
        "maximal": ask("maximal", plane),
    }


def printer(mechanism: Json, **more_bounds: float) -> Json:
    """Return the request for the constructive workspace of 2017's five-bar, with torques."""
    return workspace(
        mechanism,
        "constructive",
        "constant_orientation",
        [axis("x", -0.4, 0.4, 0.0005), axis("y", 0.0, 0.4, 0.0005)],
        constructive={
            "min_crank_rod_angle": math.radians(20),
            "min_rod_rod_angle": math.radians(5),
            **more_bounds,
        },
        effective={"load": {"force": 1.0}},
        fields=["effort_max"],
    )


def straight_down(mechanism: Json) -> Json:
    """Return the five-bar whose cranks stop at the switches and, inside, pointing down."""
    left, right = mechanism["actuator_limits"]
    down = math.radians(-90), math.radians(270)
    limits = [{"min": down[0], "max": left["max"]}, {"min": right["min"], "max": down[1]}]
    return {**mechanism, "actuator_limits": limits}


def unlimited(mechanism: Json) -> Json:
    """Return the mechanism without stops."""
    return {**mechanism, "actuator_limits": None}


def delta(mechanism: Json) -> Json:
    """Return the request for the 4-DOF Delta of 2019 with its platform level."""
    sides = axis("x", -0.24, 0.24, 0.0015), axis("y", -0.16, 0.3, 0.0015)
    grid = [*sides, axis("z", -0.06, 0.5, 0.005)]
    fixed = {"theta": 0.0}
    return workspace(mechanism, "constructive", "constant_orientation", grid, fixed=fixed)


# Only the rods of 0.37 m are printed. A horizontal offset of 0.228 m between the joints of each
# follows from the printed rates; 0.4 m of travel are taken, and k1, k2 and kp so that their
# product is the k of the printed rates. The tool's point is the wrist's centre here.
GEARED = {
    "kind": "geared_decoupled",
    "rail_radius": 0.328,
    "carriage_arm": 0.02,
    "platform_radius": 0.08,
    "rod_length": 0.37,
    "tool_offset": 0.0,
    "wrist": {"k1": 0.9, "k2": 1.0, "kp": 0.87, "k_gamma": 1.4},
    "actuator_limits": [*[{"min": 0.0, "max": 0.4}] * 3, None, None, None],
}


def geared() -> Json:
    """Return the request for the geared mechanism of 2022 on its printed grid."""
    return _geared([axis(name, -1.1, 1.0, 0.01) for name in "xyz"])


def geared_closer() -> Json:
    """Return the same on a finer grid around the workspace, for smooth outlines."""
    sides = axis("x", -0.19, 0.19, 0.001), axis("y", -0.16, 0.22, 0.001)
    return _geared([*sides, axis("z", -0.32, 0.14, 0.005)])


def _geared(grid: list[Json]) -> Json:
    fixed = {"rx": 0.0, "ry": 0.0, "rz": 0.0}
    return workspace(GEARED, "constructive", "constant_orientation", grid, fixed=fixed)
