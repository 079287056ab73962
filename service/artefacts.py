"""Files made from results when they are first fetched, and kept until the job is deleted."""

import shutil
from collections.abc import Callable
from pathlib import Path


class Artefacts:
    """A folder with one subfolder a job."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def fetch(self, job_id: str, name: str, make: Callable[[Path], None]) -> Path:
        """Return the file of a job, made by `make` (whole or not at all) if it is not there."""
        path = self._folder / job_id / name
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            make(path)
        return path

    def drop(self, job_id: str) -> None:
        """Remove all files of a job."""
        shutil.rmtree(self._folder / job_id, ignore_errors=True)
