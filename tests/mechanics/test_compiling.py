"""How kernels are compiled."""

import ast
from pathlib import Path

import numpy as np

from mechanics.kernels import compiling
from mechanics.kernels.compiling import kernel


@kernel
def first_bytes(count: int) -> int:
    """Return in which bytes of a cache line arrays of many sizes begin, one bit each."""
    found, kept = 0, [np.empty(1)]
    for size in range(1, count):
        made = np.empty(size)
        kept.append(made)
        found |= 1 << (made.ctypes.data % 64)
    return found


def test_arrays_made_in_kernels_begin_on_a_cache_line() -> None:
    """Else every load of a whole register takes two lines, as chance will have it."""
    assert first_bytes(300) == 1


def test_kernels_contain_no_comprehension() -> None:
    """Numba (0.68) takes out what is dead after it has put a comprehension in place.

    For dead it takes, too, what is written to an array that stands in a tuple made in the same
    kernel: `pair.first[i] = 1` does nothing there.
    """
    comprehensions = ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.Lambda
    found = [
        f"{path.name}:{function.lineno}"
        for path in sorted(Path(compiling.__file__).parent.glob("*.py"))
        for function in ast.walk(ast.parse(path.read_text()))
        if isinstance(function, ast.FunctionDef) and function.decorator_list
        if path.name != "compiling.py"
        if any(isinstance(node, comprehensions) for node in ast.walk(function))
    ]
    assert found == []
