"""What makes no sense is refused with a pointer to the field, and nothing is stored."""

import re
from typing import Any

import pytest

from tests.service.bodies import EFFORT, FIVE_BAR, INVERSE, PLANAR_3RRR, WORKSPACE, grid
from tests.service.services import Service, assert_problem

PATHS = ["/v1/analyses", "/v1/estimates", "/v1/jobs"]


def limited(limits: Any) -> dict[str, Any]:  # noqa: ANN401
    return FIVE_BAR | {"actuator_limits": limits}


def without(body: dict[str, Any], name: str) -> dict[str, Any]:
    return {key: value for key, value in body.items() if key != name}


def on(body: dict[str, Any], **mechanism: Any) -> dict[str, Any]:  # noqa: ANN401
    return body | {"mechanism": FIVE_BAR | mechanism}


EFFECTIVE = WORKSPACE | {"class": "effective"}
CONSTRUCTIVE = WORKSPACE | {"class": "constructive"}
TURNED = WORKSPACE | {"mechanism": PLANAR_3RRR}
TURN_AXIS = {"coordinate": "phi", "min": 0.0, "max": 1.0, "step": 0.1}

UP = [0, 0, 1]
MIXED = WORKSPACE | {
    "mechanism": {
        "kind": "custom",
        "motion": "planar_translation",
        "legs": [
            {
                "drive": "crank",
                "base_point": [-0.3, 0, 0],
                "axis": UP,
                "zero_direction": [1, 0, 0],
                "crank_length": 0.5,
                "rod_length": 0.5,
                "platform_point": [0, 0, 0],
            },
            {"drive": "strut", "base_point": [0.3, 0, 0], "platform_point": [0, 0, 0]},
        ],
    }
}


def built(**bounds: Any) -> dict[str, Any]:  # noqa: ANN401
    return CONSTRUCTIVE | {"constructive": bounds}


def bounded(**bounds: Any) -> dict[str, Any]:  # noqa: ANN401
    return EFFECTIVE | {"effective": {"load": {"force": 1}, "max_effort": 1.0, **bounds}}


# What is wrong, the body, and where the problem must point.
ANALYSES: dict[str, tuple[dict[str, Any], list[str]]] = {
    "a length of 0": (on(INVERSE, rod_length=0), ["/mechanism/rod_length"]),
    "a length below 0": (on(INVERSE, crank_length=-0.5), ["/mechanism/crank_length"]),
    "a length of null": (on(INVERSE, base_distance=None), ["/mechanism/base_distance"]),
    "a length that is a list": (on(INVERSE, rod_length=[0.5]), ["/mechanism/rod_length"]),
    "a length that is a text": (on(INVERSE, rod_length="0.5"), ["/mechanism/rod_length"]),
    "a length that is a truth": (on(INVERSE, rod_length=True), ["/mechanism/rod_length"]),
    "two bad lengths": (
        on(INVERSE, crank_length=0, rod_length=0),
        ["/mechanism/crank_length", "/mechanism/rod_length"],
    ),
    "a length missing": (
        INVERSE | {"mechanism": without(FIVE_BAR, "rod_length")},
        ["/mechanism/rod_length"],
    ),
    "a field that a mechanism lacks": (on(INVERSE, colour="red"), ["/mechanism/colour"]),
    "a field that a request lacks": (INVERSE | {"posez": []}, ["/posez"]),
    "an unknown kind": (on(INVERSE, kind="hexapod"), ["/mechanism/kind"]),
    "no kind": (INVERSE | {"mechanism": without(FIVE_BAR, "kind")}, ["/mechanism/kind"]),
    "an unknown analysis": (INVERSE | {"analysis": "guess"}, ["/analysis"]),
    "no analysis": (without(INVERSE, "analysis"), ["/analysis"]),
    "no mechanism": (without(INVERSE, "mechanism"), ["/mechanism"]),
    "a mechanism that is a text": (INVERSE | {"mechanism": "five_bar"}, ["/mechanism"]),
    "a mechanism that is not there": (
        INVERSE | {"mechanism": {"kind": "stored", "id": "m_" + 32 * "0"}},
        ["/mechanism/id"],
    ),
    "an id of another form": (
        INVERSE | {"mechanism": {"kind": "stored", "id": "../m_0"}},
        ["/mechanism/id"],
    ),
    "limits the wrong way round": (
        INVERSE | {"mechanism": limited({"min": 1.0, "max": -1.0})},
        ["/mechanism/actuator_limits/max"],
    ),
    "limits of one leg the wrong way round": (
        INVERSE | {"mechanism": limited([None, {"min": 1.0, "max": -1.0}])},
        ["/mechanism/actuator_limits/1/max"],
    ),
    "limits of another number of legs": (
        INVERSE | {"mechanism": limited([None] * 3)},
        ["/mechanism/actuator_limits"],
    ),
    "a working mode of another number of legs": (
        on(INVERSE, working_mode=[1, 1, 1]),
        ["/mechanism/working_mode"],
    ),
    "a working mode of other signs": (
        on(INVERSE, working_mode=[1, 0]),
        ["/mechanism/working_mode/1"],
    ),
    "a requested working mode of another number of legs": (
        EFFORT | {"working_mode": [1]},
        ["/working_mode"],
    ),
    "all working modes of an effort": (EFFORT | {"working_mode": "all"}, ["/working_mode"]),
    "no pose": (INVERSE | {"poses": []}, ["/poses"]),
    "a pose of too few coordinates": (INVERSE | {"poses": [[0, 0.9], [0]]}, ["/poses/1"]),
    "a pose of too many coordinates": (EFFORT | {"poses": [[0, 0.9, 0]]}, ["/poses/0"]),
    "a pose of no coordinates": (EFFORT | {"poses": [[]]}, ["/poses/0"]),
    "a pose with null": (INVERSE | {"poses": [[0, None]]}, ["/poses/0/1"]),
    "a pose with a text": (INVERSE | {"poses": [[0, "0.9"]]}, ["/poses/0/1"]),
    "a pose with a truth": (INVERSE | {"poses": [[0, True]]}, ["/poses/0/1"]),
    "a pose that is no list": (INVERSE | {"poses": [0, 0.9]}, ["/poses/0", "/poses/1"]),
    "a load below 0": (EFFORT | {"load": {"force": -1}}, ["/load/force"]),
    "a moment below 0": (EFFORT | {"load": {"moment": -1}}, ["/load/moment"]),
    "a known load of two numbers": (
        EFFORT | {"known_load": {"force": [1, 2]}},
        ["/known_load/force"],
    ),
    "known loads of other poses": (
        EFFORT | {"known_load": {"moment": [[0, 0, 1]] * 2}},
        ["/known_load/moment"],
    ),
    "an unknown axis": (
        WORKSPACE | {"grid": [*WORKSPACE["grid"], TURN_AXIS]},
        ["/grid/2/coordinate"],
    ),
    "an axis twice": (
        WORKSPACE | {"grid": WORKSPACE["grid"] + WORKSPACE["grid"][:1]},
        ["/grid/2/coordinate"],
    ),
    "an axis that turns": (
        TURNED | {"grid": [*WORKSPACE["grid"], TURN_AXIS]},
        ["/grid/2/coordinate"],
    ),
    "no axis": (WORKSPACE | {"grid": []}, ["/grid"]),
    "min above max": (WORKSPACE | {"grid": grid(0.5, min=2.0)}, ["/grid/1/max"]),
    "a step of 0": (WORKSPACE | {"grid": grid(0.5, step=0)}, ["/grid/1/step"]),
    "a step below 0": (WORKSPACE | {"grid": grid(0.5, step=-0.5)}, ["/grid/1/step"]),
    "no step": (
        WORKSPACE | {"grid": [*WORKSPACE["grid"][:1], without(WORKSPACE["grid"][1], "step")]},
        ["/grid/1/step"],
    ),
    "too many nodes": (WORKSPACE | {"grid": grid(1e-9)}, ["/grid"]),
    "a fixed coordinate missing": (TURNED, ["/fixed/phi"]),
    "a fixed coordinate that is unknown": (WORKSPACE | {"fixed": {"z": 0}}, ["/fixed/z"]),
    "a fixed coordinate with signs of pointers": (
        WORKSPACE | {"fixed": {"a/b~c": 0}},
        ["/fixed/a~1b~0c"],
    ),
    "a fixed coordinate on the grid": (WORKSPACE | {"fixed": {"x": 0}}, ["/fixed/x"]),
    "an unknown class": (WORKSPACE | {"class": "practical"}, ["/class"]),
    "an unknown type": (WORKSPACE | {"type": "dreamt"}, ["/type"]),
    "an unknown field": (WORKSPACE | {"fields": ["mass"]}, ["/fields/0"]),
    "an effort field without load": (WORKSPACE | {"fields": ["effort"]}, ["/effective/load"]),
    "an effective class without bound": (EFFECTIVE, ["/effective"]),
    "a bound of effort without load": (
        EFFECTIVE | {"effective": {"max_effort": 1.0}},
        ["/effective/max_effort"],
    ),
    "a bound of effort of 0": (
        EFFECTIVE | {"effective": {"load": {"force": 1}, "max_effort": 0}},
        ["/effective/max_effort"],
    ),
    "bounds of effort of other legs": (
        EFFECTIVE | {"effective": {"load": {"force": 1}, "max_effort": [1.0]}},
        ["/effective/max_effort"],
    ),
    "a load of a workspace below 0": (
        WORKSPACE | {"effective": {"load": {"force": -1}}},
        ["/effective/load/force"],
    ),
    "an angle above pi": (
        CONSTRUCTIVE | {"constructive": {"min_crank_rod_angle": 4}},
        ["/constructive/min_crank_rod_angle"],
    ),
    "angles the wrong way round": (
        CONSTRUCTIVE | {"constructive": {"min_rod_rod_angle": 2, "max_rod_rod_angle": 1}},
        ["/constructive/max_rod_rod_angle"],
    ),
    "an angle between rods that share no joint": (
        TURNED | {"fixed": {"phi": 0}, "constructive": {"min_rod_rod_angle": 0.1}},
        ["/constructive/min_rod_rod_angle"],
    ),
    "a cone without axes": (
        built(max_base_joint_angle=0.5),
        ["/constructive/base_joint_axes"],
    ),
    "a platform's cone without axes": (
        built(max_platform_joint_angle=0.5),
        ["/constructive/platform_joint_axes"],
    ),
    "axes without a cone": (
        built(base_joint_axes=[UP] * 2),
        ["/constructive/max_base_joint_angle"],
    ),
    "a platform's axes without a cone": (
        built(platform_joint_axes=[UP] * 2),
        ["/constructive/max_platform_joint_angle"],
    ),
    "a cone above pi": (
        built(max_base_joint_angle=4, base_joint_axes=[UP] * 2),
        ["/constructive/max_base_joint_angle"],
    ),
    "a platform's cone below 0": (
        built(max_platform_joint_angle=-0.1, platform_joint_axes=[UP] * 2),
        ["/constructive/max_platform_joint_angle"],
    ),
    "axes of other legs": (
        built(max_base_joint_angle=0.5, base_joint_axes=[UP] * 3),
        ["/constructive/base_joint_axes"],
    ),
    "a platform's axes of other legs": (
        built(max_platform_joint_angle=0.5, platform_joint_axes=[UP]),
        ["/constructive/platform_joint_axes"],
    ),
    "an axis without direction": (
        built(max_base_joint_angle=0.5, base_joint_axes=[UP, [0, 0, 0]]),
        ["/constructive/base_joint_axes/1"],
    ),
    "a platform's axis of two numbers": (
        built(max_platform_joint_angle=0.5, platform_joint_axes=[[1, 0], UP]),
        ["/constructive/platform_joint_axes/0"],
    ),
    "a distance of rods that share a joint": (
        built(min_rod_distance=0.01),
        ["/constructive/min_rod_distance"],
    ),
    "a distance of 0": (
        TURNED | {"fixed": {"phi": 0}, "constructive": {"min_rod_distance": 0}},
        ["/constructive/min_rod_distance"],
    ),
    "a pressure angle above pi": (bounded(max_pressure_angle=4), ["/effective/max_pressure_angle"]),
    "a determinant of 0": (bounded(min_abs_determinant=0), ["/effective/min_abs_determinant"]),
    "a condition number below 1": (
        bounded(max_condition_number=0.5),
        ["/effective/max_condition_number"],
    ),
    "a condition number that is a text": (
        bounded(max_condition_number="5"),
        ["/effective/max_condition_number"],
    ),
    "drive speeds without a platform's": (
        bounded(max_actuator_speed=1.0),
        ["/effective/platform_speed"],
    ),
    "a platform's speed without the drives'": (
        bounded(platform_speed={"linear": 1.0}),
        ["/effective/max_actuator_speed"],
    ),
    "a platform's speed below 0": (
        bounded(max_actuator_speed=1.0, platform_speed={"linear": -1.0}),
        ["/effective/platform_speed/linear"],
    ),
    "a platform's angular speed that is a text": (
        bounded(max_actuator_speed=1.0, platform_speed={"angular": "1"}),
        ["/effective/platform_speed/angular"],
    ),
    "a drive speed of 0": (
        bounded(max_actuator_speed=0, platform_speed={"linear": 1.0}),
        ["/effective/max_actuator_speed"],
    ),
    "drive speeds of other legs": (
        bounded(max_actuator_speed=[1.0, 1.0, 1.0], platform_speed={"linear": 1.0}),
        ["/effective/max_actuator_speed"],
    ),
    "one drive speed for cranks and rails": (
        MIXED | {"effective": {"max_actuator_speed": 1.0, "platform_speed": {"linear": 1.0}}},
        ["/effective/max_actuator_speed"],
    ),
}

MECHANISMS: dict[str, tuple[dict[str, Any], list[str]]] = {
    "a length of 0": (FIVE_BAR | {"rod_length": 0}, ["/rod_length"]),
    "a length below 0": (PLANAR_3RRR | {"base_side": -1}, ["/base_side"]),
    "a length that is a text": (FIVE_BAR | {"rod_length": "0.5"}, ["/rod_length"]),
    "a length that is a truth": (FIVE_BAR | {"rod_length": True}, ["/rod_length"]),
    "a length missing": (without(FIVE_BAR, "rod_length"), ["/rod_length"]),
    "an unknown field": (FIVE_BAR | {"colour": "red"}, ["/colour"]),
    "an unknown kind": (FIVE_BAR | {"kind": "hexapod"}, ["/kind"]),
    "no kind": (without(FIVE_BAR, "kind"), ["/kind"]),
    "a reference": ({"kind": "stored", "id": "m_" + 32 * "0"}, ["/kind"]),
    "limits the wrong way round": (limited({"min": 1, "max": -1}), ["/actuator_limits/max"]),
    "limits of another number of legs": (limited([None]), ["/actuator_limits"]),
    "a limit that is a text": (limited({"min": "1"}), ["/actuator_limits/min"]),
    "a working mode of other signs": (FIVE_BAR | {"working_mode": [1, 2]}, ["/working_mode/1"]),
    "a working mode of truths": (FIVE_BAR | {"working_mode": [True, -1]}, ["/working_mode/0"]),
    "a name that is a number": (FIVE_BAR | {"name": 5}, ["/name"]),
    "a name too long": (FIVE_BAR | {"name": "n" * 201}, ["/name"]),
}


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("what", ANALYSES)
def test_an_analysis_is_refused(refusing: Service, path: str, what: str) -> None:
    body, pointers = ANALYSES[what]
    before = refusing.rows()
    assert_problem(refusing.post(path, body), 422, *pointers)
    assert refusing.rows() == before


@pytest.mark.parametrize("what", MECHANISMS)
def test_a_mechanism_is_refused(refusing: Service, what: str) -> None:
    body, pointers = MECHANISMS[what]
    before = refusing.rows()
    assert_problem(refusing.post("/v1/mechanisms", body), 422, *pointers)
    assert refusing.rows() == before


def test_an_effort_without_any_load_is_refused(refusing: Service) -> None:
    answer = refusing.post("/v1/analyses", without(EFFORT, "load"))
    assert_problem(answer, 422)
    assert "known_load" in answer.json()["detail"]


def test_what_was_given_and_what_is_allowed_is_said(refusing: Service) -> None:
    axis = WORKSPACE["grid"][0] | {"coordinate": "elevation"}
    answer = refusing.post("/v1/jobs", WORKSPACE | {"grid": [axis, WORKSPACE["grid"][1]]})
    first, *_ = answer.json()["errors"]
    assert first["pointer"] == "/grid/0/coordinate"
    assert "'elevation'" in first["detail"]
    assert "allowed: x, y" in first["detail"]


def test_a_job_refused_with_a_key_leaves_the_key_free(api: Service) -> None:
    refused = api.post("/v1/jobs", WORKSPACE | {"grid": grid(1e-9)}, Idempotency_Key="one")
    assert refused.status_code == 422
    assert api.post("/v1/jobs", WORKSPACE, Idempotency_Key="one").status_code == 201


GRIDS: list[list[dict[str, Any]]] = [
    grid(1e-6),
    grid(1e-9, step=1e-3),
    grid(1e-5, min=0.1234567, max=0.9876543, step=3.3e-7),
    grid(1e-10, min=1.0),
    grid(2.3e-5, step=3.7e-5),
    [{"coordinate": "x", "min": 0.0, "max": 1e12, "step": 1e-12}, WORKSPACE["grid"][1]],
]


def coarser(refusing: Service, axes: list[dict[str, Any]]) -> list[float]:
    """Return the steps that the refusal of a grid says would fit."""
    (fault,) = refusing.post("/v1/jobs", WORKSPACE | {"grid": axes}).json()["errors"]
    return [
        float(re.search(rf"\b{axis['coordinate']}: ([-+.e\d]*\d)", fault["detail"])[1])  # type: ignore[index]
        for axis in axes
    ]


def estimate_status(refusing: Service, axes: list[dict[str, Any]], steps: list[float]) -> int:
    chosen = [axis | {"step": step} for axis, step in zip(axes, steps, strict=True)]
    return refusing.post("/v1/estimates", WORKSPACE | {"grid": chosen}).status_code


def test_a_grid_with_too_many_nodes_names_the_limit(refusing: Service) -> None:
    answer = refusing.post("/v1/jobs", WORKSPACE | {"grid": grid(1e-6)})
    assert str(refusing.settings.node_limit) in answer.json()["detail"]


@pytest.mark.timeout(20)
@pytest.mark.parametrize("axes", GRIDS, ids=range(len(GRIDS)))
def test_the_steps_that_are_said_to_fit_do(refusing: Service, axes: list[dict[str, Any]]) -> None:
    assert estimate_status(refusing, axes, coarser(refusing, axes)) == 200


@pytest.mark.timeout(20)
@pytest.mark.parametrize("axes", GRIDS, ids=range(len(GRIDS)))
def test_much_finer_steps_would_not_fit(refusing: Service, axes: list[dict[str, Any]]) -> None:
    steps = [0.99 * step for step in coarser(refusing, axes)]
    assert estimate_status(refusing, axes, steps) == 422


def test_a_grid_of_just_the_limit_is_allowed(refusing: Service) -> None:
    axes = [
        {"coordinate": "x", "min": 0, "max": 19_999, "step": 1},
        {"coordinate": "y", "min": 0, "max": 99_999, "step": 1},
    ]
    answer = refusing.post("/v1/estimates", WORKSPACE | {"grid": axes})
    assert answer.json()["nodes"] == refusing.settings.node_limit == 2_000_000_000


def test_a_grid_of_one_node_more_is_not(refusing: Service) -> None:
    line = [{"coordinate": "x", "min": 0, "max": 2_000_000_000, "step": 1}]
    answer = refusing.post("/v1/estimates", WORKSPACE | {"grid": line, "fixed": {"y": 0}})
    assert_problem(answer, 422, "/grid")
