"""The analyses that have a picture, and what it shows."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from analyses import friction_figures, workspace_grid
from analyses.analysis import Stretches
from analyses.friction_torque import FrictionTorque
from analyses.pictures import Picture
from analyses.workspace import Workspace
from schemas.analyses import Request


class Illustration(NamedTuple):
    """How one analysis comes to its picture.

    Parameters
    ----------
    check : raises AnalysisError if a request's answer has no such picture.
    picture : returns the picture of a request from its stretches.
    """

    check: Callable[[Any, str | None], object]
    picture: Callable[[Any, Stretches, str | None], Picture]


ILLUSTRATIONS: Mapping[str, Illustration] = MappingProxyType(
    {
        Workspace.name: Illustration(workspace_grid.check_picture, workspace_grid.picture),
        FrictionTorque.name: Illustration(friction_figures.check_picture, friction_figures.picture),
    }
)


def has_figure(analysis: str) -> bool:
    """Return whether an analysis has a picture."""
    return analysis in ILLUSTRATIONS


def check_picture(request: Request, field: str | None) -> None:
    """Raise AnalysisError if a request's answer has no such picture.

    Parameters
    ----------
    request : of an analysis that has a picture.
    field : what is to be shown; None for what is shown by default.
    """
    ILLUSTRATIONS[request.analysis].check(request, field)


def picture(request: Request, stretches: Stretches, field: str | None) -> Picture:
    """Return what a figure of a request's answer shows.

    Parameters
    ----------
    request : of an analysis that has a picture.
    stretches : of the answer.
    field : what is to be shown; None for what is shown by default.

    Raises
    ------
    AnalysisError : as `check_picture`.
    """
    return ILLUSTRATIONS[request.analysis].picture(request, stretches, field)
