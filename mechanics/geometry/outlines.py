"""Workspaces in the plane by the geometric method."""

from dataclasses import dataclass

from mechanics.arrays import Floats
from mechanics.errors import NotOfferedError
from mechanics.geometry.annuli import Annulus, intersect
from mechanics.geometry.arcs import ArcRegion
from mechanics.geometry.leg_regions import leg_annuli, leg_annuli_at_any_turn
from mechanics.mechanism import Mechanism


@dataclass(frozen=True)
class Outline:
    """A workspace in the plane.

    Parameters
    ----------
    annuli : the region of each leg.
    region : what they have in common.
    is_bound : whether the workspace may be smaller than the region.
    """

    annuli: tuple[Annulus, ...]
    region: ArcRegion
    is_bound: bool


def constant_orientation(mechanism: Mechanism, pose: Floats, *, limited: bool) -> Outline:
    """Return the workspace at the pose's orientation, exactly.

    Parameters
    ----------
    mechanism, pose, limited : as for `leg_regions.leg_annuli`.

    Raises
    ------
    NotOfferedError : a leg's region is no annulus, or no leg bounds the workspace.
    PoseError : `pose` has another number of coordinates than the motion.
    """
    return _outline(leg_annuli(mechanism, pose, limited=limited), is_bound=False)


def maximal_bound(mechanism: Mechanism, *, limited: bool) -> Outline:
    """Return a region that holds the maximal workspace; without a turn it is the workspace.

    Parameters
    ----------
    mechanism, limited : as for `leg_regions.leg_annuli`.

    Raises
    ------
    NotOfferedError : a leg's region is no annulus, or no leg bounds the workspace.
    """
    annuli = leg_annuli_at_any_turn(mechanism, limited=limited)
    return _outline(annuli, is_bound=bool(mechanism.motion.turns))


def _outline(annuli: tuple[Annulus, ...], *, is_bound: bool) -> Outline:
    if all(annulus.outer == float("inf") for annulus in annuli):
        raise NotOfferedError("no leg bounds the workspace")
    return Outline(annuli, intersect(annuli), is_bound)
