"""Lets a process end with the one that started it, even when that one was killed.

A parent's death cannot be forbidden, but it closes its pipes: a thread that waits for the end of
a pipe hears of it at once, whatever the main thread computes.
"""

import os
import signal
import threading
from collections.abc import Callable
from multiprocessing import parent_process
from multiprocessing.connection import wait

# Set for a child whose standard input is the supervisor's pipe.
SUPERVISED = "PARMECH_SUPERVISED"

_STDIN = 0


def watch(grace_seconds: float = 1.5) -> None:
    """End this process soon after the supervisor closed our standard input or died.

    The process gets SIGTERM, as if it was asked to stop, and is ended for good if it is still
    there after the grace. Does nothing in a process that no supervisor started.

    Parameters
    ----------
    grace_seconds : float
        Time to stop in good order. [s]
    """
    if os.environ.pop(SUPERVISED, None) is not None:
        _start("lifeline", lambda: _end_after_stdin(grace_seconds))


def watch_parent() -> None:
    """End this `multiprocessing` child at once when its parent has died."""
    parent = parent_process()
    if parent is not None:
        _start("lifeline", lambda: _end_after_sentinel(parent.sentinel))


def _start(name: str, body: Callable[[], None]) -> None:
    threading.Thread(target=body, name=name, daemon=True).start()


def _end_after_stdin(grace_seconds: float) -> None:
    # Not sys.stdin: its buffer is locked while we wait, and Python's shutdown would want it.
    while os.read(_STDIN, 4096):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    threading.Event().wait(grace_seconds)
    os._exit(1)


def _end_after_sentinel(sentinel: int) -> None:
    wait([sentinel])
    os._exit(1)
