"""The inside of one local worker process."""

import resource
import signal
import traceback
from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.reduction import ForkingPickler

import lifeline
from workers.executors.interface import Outcome, Raised, Returned

# First message of a worker that is ready to compute.
READY = "ready"


def serve(pipe: Connection, warm: Callable[[], None], memory_bytes: int | None) -> None:
    """Answer calls from the pipe until it closes."""
    # Ctrl-C reaches the whole terminal; the engine decides when its workers stop.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    lifeline.watch_parent()
    if memory_bytes is not None:
        resource.setrlimit(resource.RLIMIT_AS, (memory_bytes, memory_bytes))
    warm()
    pipe.send(READY)
    while True:
        try:
            function, arguments = pipe.recv()
        except EOFError:
            return
        pipe.send_bytes(_answer(function, arguments))


def _answer(function: Callable[..., object], arguments: tuple[object, ...]) -> bytes:
    outcome: Outcome
    try:
        # Pickled here: what cannot travel, or has no memory to, is the call's failure.
        return bytes(ForkingPickler.dumps(Returned(function(*arguments))))
    except MemoryError as error:
        outcome = Raised(str(error) or "out of memory", "", memory=True)
    except Exception as error:
        detail = f"{type(error).__name__}: {error}"
        outcome = Raised(detail, traceback.format_exc(), memory=False)
    return bytes(ForkingPickler.dumps(outcome))
