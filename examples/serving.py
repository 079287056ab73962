"""A server for the examples, and the few calls that they make of it."""

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx

PARMECH = Path(sys.executable).parent / "parmech"

Json = dict[str, Any]


@contextmanager
def server() -> Iterator[httpx.Client]:
    """Yield a client of a server that runs on a free port until the end."""
    with tempfile.TemporaryDirectory() as data:
        command = [str(PARMECH), "serve", "--port", "0", "--data", data]
        # Settings of another server on this machine are not for ours.
        own = {name: value for name, value in os.environ.items() if "PARMECH_" not in name}
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=own)
        try:
            print("starting the server; the first start compiles kernels, later ones load them")
            with httpx.Client(base_url=_address(process), timeout=120.0) as client:
                yield client
        finally:
            process.terminate()
            process.wait(timeout=30)


def _address(process: subprocess.Popen[str]) -> str:
    assert process.stdout is not None
    for line in process.stdout:
        found = re.search(r"ready at (http://\S+)", line)
        if found:
            return found.group(1)
    raise SystemExit("the server did not start")


def run_job(client: httpx.Client, name: str, request: Json) -> Json:
    """Run a job, show its progress under a name, and return it when it has succeeded."""
    job: Json = client.post("/v1/jobs", json=request).raise_for_status().json()
    while job["state"] in ("accepted", "running"):
        wait = client.get(job["links"]["self"], params={"wait": 0.2})
        job = wait.raise_for_status().json()
        _show_progress(name, job)
    print()
    if job["state"] != "successful":
        raise SystemExit(f"{name}: {job['state']}: {job['error']}")
    return job


def _show_progress(name: str, job: Json) -> None:
    fraction = job["progress"]["fraction"]
    bar = "#" * round(30 * fraction)
    print(f"\r{name:36} [{bar:30}] {fraction:4.0%} {job['state']}", end="", flush=True)


def fetch(client: httpx.Client, job: Json, link: str, **options: str) -> bytes:
    """Return what a job has made: its `result`, `grid` or `figure`."""
    return client.get(job["links"][link], params=options).raise_for_status().content


def result_of(client: httpx.Client, job: Json) -> Json:
    """Return the result of a job."""
    result: Json = client.get(job["links"]["result"]).raise_for_status().json()
    return result


def ask(client: httpx.Client, request: Json) -> Json:
    """Return the answer to a light request."""
    answer: Json = client.post("/v1/analyses", json=request).raise_for_status().json()
    return answer


def preset(client: httpx.Client, kind: str, name: str) -> Json:
    """Return the mechanism of a preset."""
    presets = client.get(f"/v1/kinds/{kind}").raise_for_status().json()["presets"]
    mechanism: Json = next(p["mechanism"] for p in presets if p["name"] == name)
    return mechanism
