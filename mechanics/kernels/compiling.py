"""How kernels are compiled, and where their machine code is kept.

Numba notices a change in a kernel's own file only, not in a kernel which that one calls.
The cache folder is therefore named by a digest of every kernel source and of Numba's
version: any change makes a new folder, and stale machine code is never met again.
"""

import fcntl
import hashlib
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from typing import Any, TypeVar

import numba
from numba.core.codegen import get_host_cpu_features
from numba.core.compiler_lock import global_compiler_lock
from numba.core.cpu import CPUContext

F = TypeVar("F", bound=Callable[..., Any])


def source_digest() -> str:
    """Return a digest of Numba's version and of all sources that kernels are made from."""
    digest = hashlib.sha256(numba.__version__.encode())
    here = Path(__file__).parent
    # Kernels take the legs' arrays and freeze the drives' numbers, which stand outside.
    for path in [*sorted(here.glob("*.py")), here.parent / "legs.py"]:
        digest.update(path.name.encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


def cache_folder() -> Path:
    """Return the folder of the machine code that belongs to these sources."""
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    home = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return (Path(chosen) if chosen else home / "parmech") / f"kernels-{source_digest()}"


def cpu_features() -> str:
    """Return the processor's features, told to LLVM with its whole vector registers in use.

    LLVM halves the registers on processors with AVX-512, lest a little vector code slow the clock
    for all the rest; kernels are nothing but vector code, and half again as fast without that.
    """
    features: str = get_host_cpu_features()  # type: ignore[no-untyped-call]
    return f"{features},-prefer-256-bit" if "+avx512f" in features else features


# Numba reads these when it compiles the first function, so they are set before that.
setattr(numba.config, "CACHE_DIR", str(cache_folder()))  # noqa: B010  (it has no stub)
if getattr(numba.config, "CPU_FEATURES") is None:  # noqa: B009
    setattr(numba.config, "CPU_FEATURES", cpu_features())  # noqa: B010

# Arrays made in kernels begin on a line of the cache. Numba's own start on half lines, and on the
# wrong one every load of a whole 512-bit register takes two lines: a tenth of the time, by luck.
setattr(CPUContext, "get_preferred_array_alignment", lambda context, dtype: 64)  # noqa: B010


@contextmanager
def _alone(lock: Path) -> Iterator[None]:
    """Keep other processes from what a file stands for until this one has done it."""
    lock.parent.mkdir(parents=True, exist_ok=True)
    # A thread that compiles may ask for another kernel: whoever waits for it must not hold that.
    with global_compiler_lock, lock.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        try:
            yield
        finally:
            # Closing it would not do: a process forked meanwhile has the file open too.
            fcntl.flock(file, fcntl.LOCK_UN)


def _shared(compiled: F) -> F:
    """Have processes that start together compile each kernel once: the others load what is kept.

    Kernels call each other in no circle, so that none waits for one that waits for it.
    """
    dispatcher: Any = compiled
    name, compile_own = f"{compiled.__module__}.{compiled.__qualname__}", dispatcher.compile
    # Beside the machine code, wherever Numba found that it may write.
    lock = Path(dispatcher.stats.cache_path) / f"{name}.lock"

    @wraps(compile_own)
    def compile_alone(signature: Any) -> Any:  # noqa: ANN401
        with _alone(lock):
            return compile_own(signature)

    dispatcher.compile = compile_alone
    return compiled


def kernel(function: F) -> F:
    """Compile `function` without the GIL, cached on disk; division by zero gives inf or NaN."""
    # The default error model's zero-division branch stops vectorisation.
    compiled: F = numba.njit(function, nogil=True, cache=True, error_model="numpy")
    return _shared(compiled)


def inlined(function: F) -> F:
    """Compile `function` into its callers, where the compiler sees that arrays do not overlap."""
    compiled: F = numba.njit(function, nogil=True, error_model="numpy", inline="always")
    return compiled


def spliced(function: F) -> F:
    """Compile `function` once, and have the machine code of its callers contain it.

    What `inlined` is to Numba, this is to LLVM: as fast to run where the arrays come from one
    allocation, and far faster to compile where functions call functions. Python cannot call it:
    wrappers, each of which contains all of it again, would take as long to compile as the rest.
    """
    options: dict[str, Any] = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    compiled: F = numba.njit(
        function,
        nogil=True,
        error_model="numpy",
        forceinline=True,
        fastmath={"contract", "reassoc", "nsz"},
        **options,
    )
    return compiled


def fused(function: F) -> F:
    """Compile `function` like a kernel that may round a product and a sum at once.

    Only where nothing is the same for all poses: a product taken out of a loop is rounded alone,
    and a pose's numbers would then depend on its company.
    """
    compiled: F = numba.njit(
        function, nogil=True, cache=True, error_model="numpy", fastmath={"contract"}
    )
    return _shared(compiled)
