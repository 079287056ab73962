"""Errors on the wire: RFC 9457 problem details."""

from pydantic import Field

from schemas.quantities import Model


class FieldProblem(Model):
    """What is wrong with one field."""

    pointer: str = Field(description="JSON pointer into the request's body, or the parameter.")
    detail: str


class Problem(Model):
    """An error, as application/problem+json."""

    type: str
    title: str
    status: int
    detail: str
    errors: list[FieldProblem] = Field(default_factory=list)
