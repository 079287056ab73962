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


def test_kernels_contain_no_functions_of_their_own() -> None:
    """Numba (0.68) takes out what is dead after it has put a comprehension in place.

    Or any other function that is made in a kernel. For dead it takes, too, what is written to an
    array that stands in a tuple: `pair.first[i] = 1` does nothing there if the kernel made the
    pair, nor does `first, _ = pair; first[i] = 1` if it was handed on.
    """
    inner = ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp, ast.Lambda, ast.FunctionDef
    found = [
        f"{path.name}:{function.lineno}"
        for path in sorted(Path(compiling.__file__).parent.glob("*.py"))
        for function in ast.walk(ast.parse(path.read_text()))
        if isinstance(function, ast.FunctionDef) and function.decorator_list
        if path.name not in ("compiling.py", "arithmetic.py")
        if any(isinstance(node, inner) for part in function.body for node in ast.walk(part))
    ]
    assert found == []


def test_kernels_make_no_array_of_a_list() -> None:
    """Where a loop has filled the list, Numba takes out what is dead, as after comprehensions."""
    found = [
        f"{path.name}:{call.lineno}"
        for path in sorted(Path(compiling.__file__).parent.glob("*.py"))
        for function in ast.walk(ast.parse(path.read_text()))
        if isinstance(function, ast.FunctionDef) and function.decorator_list
        for call in ast.walk(function)
        if isinstance(call, ast.Call) and ast.unparse(call.func) in ("np.array", "np.asarray")
        if not isinstance(call.args[0], ast.List)
    ]
    assert found == []
