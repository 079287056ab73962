"""Stands in for the package `analyses` in engines that tests start.

A request is `{"log": file, "seconds": per tile, "do": {"start of a tile": what}}`.
"""

import json
import os
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np


class AnalysisError(ValueError):
    def __init__(self, *errors: tuple[str, str]) -> None:
        super().__init__("refused")
        self.errors = errors
        self.detail = "refused"


class Model:
    def __init__(self, values: dict[str, Any]) -> None:
        self.values = values

    def model_dump_json(self) -> str:
        return json.dumps(self.values)


def warm(*, backwards: bool = False) -> None:
    """Need nothing."""


def parse(text: str) -> dict[str, Any]:
    request: dict[str, Any] = json.loads(text)
    return request


def compute(request: dict[str, Any], start: int, stop: int) -> dict[str, np.ndarray]:
    log = Path(request["log"])
    earlier = log.read_text().split() if log.exists() else []
    with log.open("a") as file:
        file.write(f"{start}:{os.getpid()}\n")
    time.sleep(request.get("seconds", 0.0))
    tries = sum(line.startswith(f"{start}:") for line in earlier)
    _misbehave(request.get("do", {}).get(str(start)), tries)
    return {"items": np.arange(start, stop)}


def assemble(
    request: dict[str, Any], stretches: Callable[[], Iterable[dict[str, np.ndarray]]]
) -> Model:
    time.sleep(request.get("assembling_seconds", 0.0))
    return Model({"items": [int(item) for arrays in stretches() for item in arrays["items"]]})


def _misbehave(what: str | None, tries: int) -> None:
    if what == "refuse":
        raise AnalysisError(("/grid", "too fine"))
    if what == "raise":
        raise ZeroDivisionError("by zero")
    if what == "hang":
        time.sleep(3600)
    if what == "allocate":
        bytearray(2**40)
    if what == "die" or (what == "die once" and tries == 0):
        os._exit(7)
