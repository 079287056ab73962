"""The part of a workspace around a home pose, in place of the whole of it."""

from collections.abc import Iterable, Iterator

import numpy as np

from analyses.analysis import Arrays, Stretches
from analyses.errors import pointer
from analyses.workspace_setup import WorkspaceSetup
from mechanics.arrays import Bytes, Floats, Integers
from mechanics.mechanism import Mechanism
from mechanics.parts import home_part, kept, signs_of
from mechanics.regions import Region
from mechanics.workspace import reason_codes
from schemas.workspace import WorkspaceRequest

SAME_POSE = 1e-9
"""How far home may be off a coordinate that is held fixed. [m or rad]"""


def home_errors(request: WorkspaceRequest, mechanism: Mechanism) -> list[tuple[str, str]]:
    """Return why a request's home makes no sense; nothing if it does."""
    if (request.component == "home") != (request.home is not None):
        given = "missing" if request.home is None else "given"
        return [("/home", f"goes with component home, and only with that; it is {given}")]
    if request.home is None:
        return []
    if request.working_mode == "any":
        return [("/working_mode", "component home needs one: modes meet at singularities only")]
    if request.method == "geometric":
        return [("/method", "geometric measures the whole region; component home needs the grid")]
    coordinates = mechanism.motion.coordinates
    if len(request.home) != len(coordinates):
        names = ", ".join(coordinates)
        return [("/home", f"must be a pose of {names}; given {len(request.home)} numbers")]
    return _misplaced(request, dict(zip(coordinates, request.home, strict=True)))


def _misplaced(request: WorkspaceRequest, home: dict[str, float]) -> list[tuple[str, str]]:
    errors = []
    axes = {axis.coordinate: axis for axis in request.grid}
    for k, (name, value) in enumerate(home.items()):
        axis = axes.get(name)
        if axis is not None and not axis.min - axis.step <= value <= axis.max + axis.step:
            detail = f"{name} is off the grid, from {axis.min} to {axis.max}; given {value}"
            errors.append((pointer("home", k), detail))
        elif axis is None and abs(value - request.fixed.get(name, value)) > SAME_POSE:
            detail = f"{name} is fixed at {request.fixed[name]}; given {value}"
            errors.append((pointer("home", k), detail))
    return errors


def region_of(setup: WorkspaceSetup, stretches: Iterable[Arrays]) -> Region:
    """Return the runs of all stretches."""
    runs = [(arrays["codes"], arrays["lengths"]) for arrays in stretches]
    codes, lengths = (np.concatenate(parts) for parts in zip(*runs, strict=True))
    return Region(setup.grid, codes, lengths)


def component_code(setup: WorkspaceSetup) -> int:
    """Return the reason code of nodes that home cannot reach: the one after the conditions'."""
    return len(reason_codes(setup.conditions)) + 1


def of_component(
    request: WorkspaceRequest, setup: WorkspaceSetup, stretches: Stretches
) -> Stretches:
    """Return the stretches with only the component that was asked for inside."""
    if request.home is None:
        return stretches
    region = region_of(setup, stretches())
    signs = np.concatenate([signs_of(arrays["field_determinant"]) for arrays in stretches()])
    code = component_code(setup)
    part = home_part(region, signs, _node(setup, request.home), code)
    chosen = kept(part, code)
    ends = np.cumsum(part.lengths)

    def again() -> Iterator[Arrays]:
        node = used = 0
        for arrays in stretches():
            last = node + int(arrays["lengths"].sum())
            inside = int(arrays["lengths"][arrays["codes"] == 0].sum())
            own = chosen[used : used + inside]
            cut_codes, cut_lengths = _cut(part.codes, ends, node, last)
            yield {
                "codes": cut_codes,
                "lengths": cut_lengths,
                **{key: array[own] for key, array in arrays.items() if key.startswith("field_")},
            }
            node, used = last, used + inside

    return again


def _cut(codes: Bytes, ends: Integers, first: int, last: int) -> tuple[Bytes, Integers]:
    """Return the runs, that end at `ends`, of the nodes from first up to last."""
    one, other = np.searchsorted(ends, [first, last - 1], side="right")
    stops = np.minimum(ends[one : other + 1], last)
    return codes[one : other + 1], np.diff(stops, prepend=first)


def _node(setup: WorkspaceSetup, home: list[float]) -> int:
    position: Floats = np.array([home[column] for column in setup.grid.columns])
    minima = np.array([axis.minimum for axis in setup.grid.axes])
    steps = np.array([axis.step for axis in setup.grid.axes])
    shape = setup.grid.shape
    indices = np.clip(np.rint((position - minima) / steps), 0, np.array(shape) - 1).astype(np.int64)
    return int(np.ravel_multi_index(tuple(indices), shape))
