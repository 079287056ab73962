"""What a call that did not return means for its job."""

import signal

import storage
from workers.executors import Died, Raised, TimedOut
from workers.tiles import Refused


def to_job_error(failure: Refused | Raised | TimedOut | Died) -> storage.JobError:
    """Return the error that a job ends with."""
    match failure:
        case Refused(detail, errors):
            faults = tuple(storage.Fault(*fault) for fault in errors)
            return storage.JobError(storage.ErrorKind.USER, detail, faults)
        case Raised(detail, memory=True):
            told = f"a worker process may not use more memory: {detail}"
            return storage.JobError(storage.ErrorKind.MEMORY, told)
        case Raised(detail):
            return storage.JobError(storage.ErrorKind.SYSTEM, detail)
        case TimedOut(seconds):
            told = f"a part of the work took longer than {seconds:g} s"
            return storage.JobError(storage.ErrorKind.TIMEOUT, told)
        case Died(exit_code):
            told = f"the worker process died again and again, last with {_ending(exit_code)}"
            return storage.JobError(storage.ErrorKind.SYSTEM, told)


def _ending(exit_code: int | None) -> str:
    if exit_code is None or exit_code >= 0:
        return f"exit code {exit_code}"
    return signal.Signals(-exit_code).name
