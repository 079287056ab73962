"""What is kept: mechanisms, jobs with their tiles and results, signs of life."""

from storage.arrays import Arrays, pack_arrays, unpack_arrays
from storage.database import Database, open_database
from storage.errors import (
    DatabaseUnavailable,
    DatabaseUnsupported,
    IdempotencyConflict,
    JobNotFound,
    JobStillRunning,
    LeaseLost,
    MechanismNotFound,
    QueueFull,
    StorageRefusal,
)
from storage.heartbeats import Heartbeats
from storage.jobs import Jobs
from storage.mechanisms import Mechanisms
from storage.queue import Queue
from storage.records import (
    Cursor,
    ErrorKind,
    Fault,
    Job,
    JobError,
    JobState,
    NewJob,
    StoredMechanism,
)
from storage.upgrade import migrate

__all__ = [
    "Arrays",
    "Cursor",
    "Database",
    "DatabaseUnavailable",
    "DatabaseUnsupported",
    "ErrorKind",
    "Fault",
    "Heartbeats",
    "IdempotencyConflict",
    "Job",
    "JobError",
    "JobNotFound",
    "JobState",
    "JobStillRunning",
    "Jobs",
    "LeaseLost",
    "MechanismNotFound",
    "Mechanisms",
    "NewJob",
    "Queue",
    "QueueFull",
    "StorageRefusal",
    "StoredMechanism",
    "migrate",
    "open_database",
    "pack_arrays",
    "unpack_arrays",
]
