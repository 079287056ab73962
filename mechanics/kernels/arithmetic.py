"""Arithmetic that the language lacks."""

from typing import TYPE_CHECKING

from numba.core import types
from numba.extending import intrinsic

if TYPE_CHECKING:

    def multiply_add(a: float, b: float, c: float) -> float:
        """Return a b + c, rounded once: one step of a vector unit, the same bits everywhere."""
else:

    @intrinsic
    def multiply_add(typing, a, b, c):  # noqa: ANN001, ANN201
        """Return a b + c, rounded once: one step of a vector unit, the same bits everywhere."""

        def generate(context, builder, signature, arguments):  # noqa: ANN001, ANN202
            return builder.fma(*arguments)

        return types.float64(types.float64, types.float64, types.float64), generate
