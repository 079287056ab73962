"""Answers requests: schema in, schema out; estimates them; cuts them into tiles."""

from analyses.analysis import Arrays
from analyses.desk import (
    answer,
    assemble,
    check,
    compute,
    estimate,
    has_grid,
    offered_kind,
    offered_kinds,
    parse,
    plan,
    warm,
)
from analyses.errors import AnalysisError, pointer
from analyses.illustrations import check_picture, has_figure, picture
from analyses.mechanisms import check_mechanism
from analyses.plan import Plan
from analyses.workspace_grid import dense_grid

__all__ = [
    "AnalysisError",
    "Arrays",
    "Plan",
    "answer",
    "assemble",
    "check",
    "check_mechanism",
    "check_picture",
    "compute",
    "dense_grid",
    "estimate",
    "has_figure",
    "has_grid",
    "offered_kind",
    "offered_kinds",
    "parse",
    "picture",
    "plan",
    "pointer",
    "warm",
]
