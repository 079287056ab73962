"""What the geometric method says of a workspace: the intersection of the legs' regions."""

from typing import Any

import numpy as np

from analyses.workspace_setup import WorkspaceSetup
from mechanics.errors import GeometryError, NotOfferedError
from mechanics.geometry import boxes, outlines, shells
from mechanics.geometry.leg_regions import leg_shells
from mechanics.legs import STRUT
from schemas.workspace import WorkspaceRequest
from schemas.workspace_result import Arc, Bounds, Measure

ROUNDING = 1e-12
"""How far off an area of arcs may be, as a share of the legs' own regions."""
SECONDS_OF_VOLUME = 2.0
PLANAR = ("x", "y")
AREA, VOLUME = "m²", "m³"


def geometric_errors(request: WorkspaceRequest, setup: WorkspaceSetup) -> list[tuple[str, str]]:
    """Return why the geometric method cannot answer a request; nothing if it can."""
    if request.method != "geometric":
        return []
    if request.working_mode == "any":
        return [("/working_mode", "the geometric method needs one")]
    motion = setup.mechanism.motion
    if not motion.translations:
        return [("/method", "geometric is over translations; this platform only turns")]
    plane = set(motion.translations) == set(PLANAR)
    if request.type != "constant_orientation" and (request.type != "maximal" or not plane):
        told = "of constant_orientation, and in the plane of maximal"
        return [("/method", f"geometric is {told}; the type is {request.type}")]
    if {axis.coordinate for axis in setup.grid.axes} != set(motion.translations):
        named = ", ".join(motion.translations)
        return [("/method", f"geometric needs all of {named} on the grid, and no turn")]
    apart = [c.reason for c in setup.conditions if c.reason not in ("reach", "actuator_limits")]
    if apart:
        return [("/method", f"geometric knows reach and actuator limits only, not {apart[0]}")]
    try:
        found = _prepare(request, setup)
        if isinstance(found, boxes.Reaches):
            boxes.bounding_box(found)
    except (NotOfferedError, GeometryError) as error:
        return [("/method", f"geometric is not offered: {error}")]
    return []


def geometric_seconds(request: WorkspaceRequest, setup: WorkspaceSetup) -> float:
    """Return what the method costs beside the grid. [s]"""
    spatial = set(setup.mechanism.motion.translations) != set(PLANAR)
    return SECONDS_OF_VOLUME if request.method == "geometric" and spatial else 0.0


def geometric_extent(request: WorkspaceRequest, setup: WorkspaceSetup) -> dict[str, Any]:
    """Return measure, and in the plane bounds, centroid and boundary, of the whole region."""
    if request.method != "geometric":
        return {}
    found = _prepare(request, setup)
    if isinstance(found, outlines.Outline):
        return _of_outline(found)
    if isinstance(found, shells.ShellRegion):
        return {"measure": _measure(found.volume.value, found.volume.error, VOLUME, rigorous=False)}
    bounded = boxes.bound_volume(found)
    middle = 0.5 * (bounded.lower + bounded.upper)
    return {"measure": _measure(middle, bounded.upper - middle, VOLUME, rigorous=True)}


def _prepare(
    request: WorkspaceRequest, setup: WorkspaceSetup
) -> outlines.Outline | shells.ShellRegion | boxes.Reaches:
    mechanism, pose = setup.mechanism, setup.grid.fixed
    limited = request.class_ != "theoretical"
    if request.type == "maximal":
        return outlines.maximal_bound(mechanism, limited=limited)
    if set(mechanism.motion.translations) == set(PLANAR):
        return outlines.constant_orientation(mechanism, pose, limited=limited)
    if limited and (mechanism.legs.drive == STRUT).all():
        return shells.intersect(leg_shells(mechanism, pose))
    return boxes.reaches(mechanism, pose, limited=limited)


def _of_outline(outline: outlines.Outline) -> dict[str, Any]:
    region = outline.region
    outer = [annulus.outer for annulus in outline.annuli if np.isfinite(annulus.outer)]
    slack = ROUNDING * np.pi * float(np.sum(np.square(outer)))
    extent: dict[str, Any] = {
        "measure": _measure(region.area, slack, AREA, rigorous=not outline.is_bound),
        "boundary": [
            [
                Arc.model_construct(
                    centre=[float(number) for number in arc.centre],
                    radius=float(arc.radius),
                    start=float(arc.start),
                    end=float(arc.end),
                )
                for arc in loop.arcs
            ]
            for loop in region.loops
        ],
        "bounds": [],
        "centroid": None,
        "outer_bound": outline.is_bound,
    }
    if region.bounds is not None and region.centroid is not None:
        extent["bounds"] = [
            Bounds.model_construct(
                coordinate=name, min=float(least), max=float(greatest), clipped=False
            )
            for name, least, greatest in zip(PLANAR, *region.bounds, strict=True)
        ]
        extent["centroid"] = dict(zip(PLANAR, map(float, region.centroid), strict=True))
    return extent


def _measure(value: float, error: float, unit: str, *, rigorous: bool) -> Measure:
    return Measure.model_construct(
        value=float(value), unit=unit, error_bound=float(error), rigorous=rigorous
    )
