"""The part of a workspace that home reaches, against labelled masks."""

import json
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from scipy.ndimage import label

import analyses
from schemas.analyses import parse_request
from schemas.workspace import WorkspaceRequest

# At this orientation singular curves cut the workspace into parts.
BODY = {
    "analysis": "workspace",
    "mechanism": {
        "kind": "planar_3rrr",
        "base_side": 0.4,
        "platform_radius": 0.12,
        "crank_length": 0.2,
        "rod_length": 0.16,
    },
    "class": "theoretical",
    "type": "constant_orientation",
    "grid": [
        {"coordinate": "x", "min": -0.3, "max": 0.3, "step": 0.005},
        {"coordinate": "y", "min": -0.3, "max": 0.3, "step": 0.005},
    ],
    "fixed": {"phi": 0.4},
    "fields": ["determinant", "actuators"],
}


def asked(**changes: object) -> WorkspaceRequest:
    request = parse_request(json.dumps(BODY | changes))
    analyses.check(request, 10**6)
    assert isinstance(request, WorkspaceRequest)
    return request


def grid_of(request: WorkspaceRequest, cuts: list[int]) -> dict[str, npt.NDArray[Any]]:
    tiles = [analyses.compute(request, start, stop) for start, stop in pairwise(cuts)]
    dense = analyses.dense_grid(request, lambda: iter(tiles))
    return {
        column.name: np.concatenate(list(column.chunks())).reshape(column.shape)
        for column in dense.columns
    }


@pytest.mark.parametrize("cuts", [[0, 14641], [0, 50, 1000, 1001, 9000, 14641]])
@pytest.mark.parametrize("home", [[0.0, 0.0, 0.4], [0.1, 0.1, 0.4], [0.0, 0.12, 0.4]])
def test_home_keeps_its_own_part(home: list[float], cuts: list[int]) -> None:
    every = grid_of(asked(), cuts)
    found = grid_of(asked(component="home", home=home), cuts)
    signs = np.sign(np.nan_to_num(every["determinant"]))
    node = tuple(round((value + 0.3) / 0.005) for value in home[:2])
    parts, _ = label(every["inside"] & (signs == signs[node]))
    mine = (parts == parts[node]) & every["inside"][node]
    assert np.array_equal(found["inside"], mine)
    assert np.array_equal(np.isfinite(found["actuators"][..., 0]), mine)
    assert np.array_equal(found["determinant"][mine], every["determinant"][mine])
    left = every["inside"] & ~mine
    assert np.unique(found["reason"][left]).size <= 1
    assert np.array_equal(found["reason"][~every["inside"]], every["reason"][~every["inside"]])


def test_the_parts_are_several_here() -> None:
    # Or the test above would show nothing.
    whole, part = (
        analyses.answer(asked()),
        analyses.answer(asked(component="home", home=[0, 0, 0.4])),
    )
    told = part.model_dump()["excluded"][-1]
    assert told["reason"] == "component"
    assert told["leg"] is None
    inside = part.model_dump()["inside"]
    assert 0 < inside < whole.model_dump()["inside"]
    assert inside + told["nodes"] == whole.model_dump()["inside"]
    assert "determinant" in part.model_dump()["fields"]
    bare = analyses.answer(asked(component="home", home=[0, 0, 0.4], fields=[]))
    assert bare.model_dump()["fields"] == {}
    assert bare.model_dump()["inside"] == inside


def test_a_home_outside_has_no_part() -> None:
    assert (
        analyses.answer(asked(component="home", home=[0.3, 0.3, 0.4])).model_dump()["inside"] == 0
    )


@pytest.mark.parametrize(
    ("changes", "place"),
    [
        ({"component": "home"}, "/home"),
        ({"home": [0.0, 0.0, 0.4]}, "/home"),
        ({"component": "home", "home": [0.0, 0.0]}, "/home"),
        ({"component": "home", "home": [0.0, 0.5, 0.4]}, "/home/1"),
        ({"component": "home", "home": [0.0, 0.0, 0.0]}, "/home/2"),
        ({"component": "home", "home": [0.0, 0.0, 0.4], "method": "geometric"}, "/method"),
    ],
)
def test_a_home_that_makes_no_sense_is_refused(changes: dict[str, Any], place: str) -> None:
    with pytest.raises(analyses.AnalysisError) as error:
        asked(**changes)
    assert [pointer for pointer, _ in error.value.errors] == [place]
