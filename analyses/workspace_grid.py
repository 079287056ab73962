"""A workspace's dense arrays and its picture, made from runs when someone fetches them."""

from collections.abc import Iterator
from functools import partial

import numpy as np
from numpy.typing import NDArray

from analyses.analysis import Stretches
from analyses.errors import AnalysisError
from analyses.grids import DenseGrid, GridColumn
from analyses.mechanisms import build
from analyses.pictures import PictureAxis, PictureField, Skeleton, WorkspacePicture
from analyses.units import coordinate_units
from analyses.workspace import field_width
from analyses.workspace_home import of_component, region_of
from analyses.workspace_setup import WorkspaceSetup, field_units, set_up
from mechanics.arrays import Floats
from mechanics.configuration import Configuration
from mechanics.kernels.codes import INSIDE
from mechanics.mechanism import Mechanism
from mechanics.regions import Region
from mechanics.skeletons import joints
from schemas.workspace import WorkspaceRequest

LIMIT_OF_FIELD = {
    "effort": "max_effort",
    "effort_max": "max_effort",
    "condition_number": "max_condition_number",
    "pressure_angle": "max_pressure_angle",
}
"""The effective bound on what a field shows."""

TYPES = {
    "constant_orientation": "constant orientation",
    "orientation": "orientations",
    "maximal": "at some orientation",
    "inclusive_orientation": "at some orientation of a range",
    "orientation_range": "at every orientation of a range",
    "full": "at every orientation",
}

PICTURE_NODES = 1500
"""Most nodes along one side of a picture: more are not seen."""


def dense_grid(request: WorkspaceRequest, stretches: Stretches) -> DenseGrid:
    """Return the dense arrays, piece by piece; fields are NaN outside the workspace."""
    setup = set_up(request)
    stretches = of_component(request, setup, stretches)
    shape = setup.grid.shape
    units = field_units(request, setup.mechanism)
    drives = setup.mechanism.drive_count
    columns = [
        GridColumn("inside", np.dtype(bool), shape, "", partial(_inside, stretches)),
        GridColumn("reason", np.dtype(np.uint8), shape, "", partial(_reasons, stretches)),
    ]
    for name, unit in units.items():
        own = (drives,) if field_width(name, drives) == drives else ()
        columns.append(
            GridColumn(
                name, np.dtype(np.float64), shape + own, unit, partial(_field, stretches, name)
            )
        )
    return DenseGrid({a.coordinate: a.nodes for a in setup.grid.axes}, tuple(columns))


def _reasons(stretches: Stretches) -> Iterator[NDArray[np.uint8]]:
    for arrays in stretches():
        yield np.repeat(arrays["codes"], arrays["lengths"])


def _inside(stretches: Stretches) -> Iterator[NDArray[np.bool_]]:
    for codes in _reasons(stretches):
        yield codes == INSIDE


def _field(stretches: Stretches, name: str) -> Iterator[Floats]:
    for arrays in stretches():
        inside = np.repeat(arrays["codes"], arrays["lengths"]) == INSIDE
        values = arrays[f"field_{name}"]
        dense = np.full((inside.size, *values.shape[1:]), np.nan)
        dense[inside] = values
        yield dense


def picture(request: WorkspaceRequest, stretches: Stretches, field: str | None) -> WorkspacePicture:
    """Return what a figure of the workspace shows, thinned where nodes outnumber pixels.

    Parameters
    ----------
    field : a field of the request, or for a field with one number per leg `<name>_<leg>`
        (the bare name: the greatest over the legs); None: the greatest effort where kept.

    Raises
    ------
    AnalysisError : as `check_picture`.
    """
    setup = set_up(request)
    stretches = of_component(request, setup, stretches)
    chosen = check_picture(request, field)
    strides = [-(-n // PICTURE_NODES) for n in setup.grid.shape]
    inside, values = _thinned(stretches, setup, strides, chosen)
    region = region_of(setup, stretches())
    return WorkspacePicture(
        title=f"{request.class_.capitalize()} workspace, {TYPES[request.type]}",
        subtitle=_subtitle(request, region),
        axes=_axes(setup, strides),
        inside=inside,
        field=None if chosen is None else _shown(request, setup.mechanism, chosen, values),
        skeleton=_skeleton(setup, region),
    )


def check_picture(request: WorkspaceRequest, field: str | None) -> tuple[str, int | None] | None:
    """Return the field, and the leg, that a picture shows as colours; None: none.

    Raises
    ------
    AnalysisError : the field was not kept, or the grid has more than two axes.
    """
    if len(request.grid) > 2:
        raise AnalysisError(("/grid", "a figure shows one or two axes; fetch the grid instead"))
    mechanism = build(request.mechanism)
    if field is None:
        preferred = [f for f in ("effort_max", "effort") if f in request.fields]
        return (preferred[0], None) if preferred else None
    drives = mechanism.drive_count
    allowed: dict[str, tuple[str, int | None]] = {f: (f, None) for f in request.fields}
    for name in request.fields:
        if field_width(name, drives) == drives:
            allowed |= {f"{name}_{drive}": (name, drive) for drive in range(drives)}
    if field not in allowed:
        known = ", ".join(allowed) or "none was kept"
        raise AnalysisError(("?field", f"given {field!r}; allowed: {known}"))
    return allowed[field]


def _thinned(
    stretches: Stretches,
    setup: WorkspaceSetup,
    strides: list[int],
    chosen: tuple[str, int | None] | None,
) -> tuple[NDArray[np.bool_], Floats]:
    inside, values, first = [], [], 0
    for arrays in stretches():
        codes = np.repeat(arrays["codes"], arrays["lengths"])
        indices = np.unravel_index(np.arange(first, first + codes.size), setup.grid.shape)
        picked = np.logical_and.reduce(
            [i % stride == 0 for i, stride in zip(indices, strides, strict=True)]
        )
        within = codes == INSIDE
        inside.append(within[picked])
        dense = np.full(codes.size, np.nan)
        if chosen is not None:
            dense[within] = _one_number(arrays[f"field_{chosen[0]}"], chosen[1])
        values.append(dense[picked])
        first += codes.size
    shape = [-(-n // stride) for n, stride in zip(setup.grid.shape, strides, strict=True)]
    return np.concatenate(inside).reshape(shape), np.concatenate(values).reshape(shape)


def _one_number(values: Floats, leg: int | None) -> Floats:
    if values.ndim == 1:
        return values
    return np.max(values, axis=1, initial=-np.inf) if leg is None else values[:, leg]


def _shown(
    request: WorkspaceRequest, mechanism: Mechanism, chosen: tuple[str, int | None], values: Floats
) -> PictureField:
    name, leg = chosen
    texts = {
        "effort": "Greatest effort of any drive",
        "effort_max": "Greatest effort of any drive",
        "determinant": "det Jx",
        "condition_number": "Condition number",
        "pressure_angle": "Greatest pressure angle of any drive",
        "actuators": "Greatest drive coordinate",
        "free_orientation": "Free range of orientation",
    }
    one_leg = {"effort": "Greatest effort of drive", "actuators": "Coordinate of drive"}
    label = texts[name] if leg is None else f"{one_leg[name]} {leg}"
    # Blocks of a higher class than the one asked are not applied, so their bounds say nothing.
    applied = request.effective if request.class_ == "effective" else None
    limit = getattr(applied, LIMIT_OF_FIELD.get(name, ""), None)
    shown_limit = limit if isinstance(limit, float) else None
    return PictureField(label, field_units(request, mechanism)[name], values, shown_limit)


def _axes(setup: WorkspaceSetup, strides: list[int]) -> tuple[PictureAxis, ...]:
    motion = setup.mechanism.motion
    units = dict(zip(motion.coordinates, coordinate_units(motion), strict=True))
    return tuple(
        PictureAxis(axis.coordinate, units[axis.coordinate], axis.nodes[::stride])
        for axis, stride in zip(setup.grid.axes, strides, strict=True)
    )


def _subtitle(request: WorkspaceRequest, region: Region) -> str:
    fixed = [f"{name} = {value:g}" for name, value in request.fixed.items()]
    name = request.mechanism.name if request.mechanism.kind != "stored" else None
    count = f"{region.nodes:,} of {region.grid.size:,} nodes inside"
    return ", ".join([name or request.mechanism.kind, *fixed, count])


def _skeleton(setup: WorkspaceSetup, region: Region) -> Skeleton | None:
    """Return the mechanism at the node nearest to the largest part's centroid, seen along z."""
    names = [axis.coordinate for axis in setup.grid.axes]
    if set(names) != {"x", "y"} or not region.components:
        return None
    node = region.node_nearest(region.components[0].centroid)
    if node is None:
        return None
    found = joints(Configuration(setup.mechanism, setup.grid.poses(node, node + 1)))
    plane = [0, 1] if names == ["x", "y"] else [1, 0]
    legs = np.stack([found.base, found.elbow, found.platform], axis=1)[:, :, plane, 0]
    return Skeleton(tuple(legs), np.unique(legs[:, 2].round(12), axis=0))
