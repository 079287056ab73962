"""A changed kernel is never answered from machine code of the kernel that it was.

Numba itself notices a change in the file of the kernel that is called first. The danger is an
inner kernel in another file, so the copy of the package gets an outer kernel of its own.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import mechanics

OUTER = '''
"""A kernel that calls one of another file."""

from mechanics.kernels.compiling import kernel
from mechanics.kernels.turns import sine_and_cosine


@kernel
def sine(angle: float) -> float:
    return sine_and_cosine(angle)[0]
'''
PROGRAM = """
import sys
import mechanics
from mechanics.kernels.outer import sine

assert mechanics.__file__.startswith(sys.argv[1]), mechanics.__file__
print(sine(0.3), sum(sine.stats.cache_misses.values()))
"""
SINE = 0.29552020666133955
INNER = "    s = multiply_add(r * z, p, r)"
EDITED = "    s = 2.0 * multiply_add(r * z, p, r)"


class Copy:
    """A copy of the package whose processes share one folder of machine code."""

    def __init__(self, root: Path) -> None:
        self.root = root
        source = Path(next(iter(mechanics.__path__)))
        ignored = shutil.ignore_patterns("__pycache__")
        shutil.copytree(source, root / "mechanics", ignore=ignored)
        (root / "mechanics" / "kernels" / "outer.py").write_text(OUTER)

    def edit(self, old: str, new: str) -> None:
        """Change a line of the inner kernel."""
        path = self.root / "mechanics" / "kernels" / "turns.py"
        text = path.read_text()
        assert text.count(old) == 1
        path.write_text(text.replace(old, new))

    def compute(self) -> float:
        """Return what a new process answers."""
        return self.compute_at_once(1)[0][0]

    def compute_at_once(self, count: int) -> list[tuple[float, int]]:
        """Return what processes answer that start together, and how often each compiled."""
        environment = {
            **os.environ,
            "NUMBA_CACHE_DIR": str(self.root / "cache"),
            "PYTHONPATH": str(self.root),
        }
        command = [sys.executable, "-c", PROGRAM, str(self.root)]
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        started = [
            subprocess.Popen(command, cwd=self.root, env=environment, **pipes)  # type: ignore[call-overload]
            for _ in range(count)
        ]
        answers = []
        for process in started:
            output, error = process.communicate()
            assert process.returncode == 0, error
            value, compilations = output.split()
            answers.append((float(value), int(compilations)))
        return answers

    def machine_code(self) -> dict[Path, int]:
        """Return the cached files with the time of their last change."""
        files = (self.root / "cache").rglob("*.nb?")
        return {path: path.stat().st_mtime_ns for path in files}


@pytest.fixture
def copy(tmp_path: Path) -> Copy:
    return Copy(tmp_path)


def test_machine_code_is_kept_and_used_again(copy: Copy) -> None:
    copy.compute()
    kept = copy.machine_code()
    assert kept
    copy.compute()
    assert copy.machine_code() == kept


def test_a_changed_inner_kernel_is_seen(copy: Copy) -> None:
    assert copy.compute() == pytest.approx(SINE)
    copy.edit(INNER, EDITED)
    assert copy.compute() == pytest.approx(2 * SINE)


def test_the_former_kernel_is_seen_when_it_returns(copy: Copy) -> None:
    copy.compute()
    copy.edit(INNER, EDITED)
    copy.compute()
    copy.edit(EDITED, INNER)
    assert copy.compute() == pytest.approx(SINE)


def test_of_processes_that_start_together_one_compiles(copy: Copy) -> None:
    answers = copy.compute_at_once(3)
    assert [value for value, _ in answers] == pytest.approx([SINE] * 3)
    assert sum(compilations for _, compilations in answers) == 1


def test_a_cache_folder_that_cannot_be_made_is_done_without(copy: Copy) -> None:
    (copy.root / "cache").write_text("a file in its place")
    assert copy.compute() == pytest.approx(SINE)
