"""Two published studies, asked over HTTP as any client would.

Starts a server on a free port, runs the jobs, writes grids and pictures to `out/`, and prints
the published figures beside the computed ones. Exits 1 if one of them is wrong.
"""

import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import numpy as np

from examples.serving import ask, fetch, preset, result_of, run_job, server

OUT = Path("out")

# Laryushkin, Glazunov, Erastova, 2016: every node of a 1 mm grid at phi = 0.
PUBLISHED_NODES = 160_725
# Erastova, Laryushkin, 2017: torques do not pass 200 N mm anywhere in the workspace. The force
# is not printed; 1 N fits, and on the paper's link angles bounded at both ends it gives:
TORQUE_AT_LEAST, TORQUE_AT_MOST = 0.2015, 0.204


@dataclass(frozen=True)
class Finding:
    """A published figure beside the computed one."""

    what: str
    published: str
    computed: str
    right: bool


def run(client: httpx.Client, name: str, request: dict[str, Any]) -> dict[str, Any]:
    """Run a workspace job, write its grid and figure, return its result."""
    job = run_job(client, name, request)
    (OUT / f"{name}.npz").write_bytes(fetch(client, job, "grid"))
    (OUT / f"{name}.png").write_bytes(fetch(client, job, "figure", format="png"))
    return result_of(client, job)


def planar_3rrr(client: httpx.Client) -> list[Finding]:
    """Return the findings on the 3-RRR: its nodes, and efforts from grid and direct answer."""
    mechanism = preset(client, "planar_3rrr", "planar_3rrr_2016")
    name = "planar_3rrr_theoretical"
    result = run(
        client,
        name,
        {
            "analysis": "workspace",
            "mechanism": mechanism,
            "class": "theoretical",
            "type": "constant_orientation",
            "grid": [_axis("x", -0.3, 0.3), _axis("y", -0.3, 0.3)],
            "fixed": {"phi": 0.0},
            "effective": {"load": {"force": 10.0}},
            "fields": ["effort", "effort_max"],
        },
    )
    with np.load(OUT / f"{name}.npz") as grid:
        stored = int(np.count_nonzero(grid["inside"]))
        at_centre = grid["effort"][300, 300].tolist()
    request = {
        "analysis": "effort",
        "mechanism": mechanism,
        "poses": [[-0.3 + 300 * 0.001, -0.3 + 300 * 0.001, 0.0]],
        "load": {"force": 10.0},
    }
    direct = ask(client, request)["effort"][0]
    return [
        Finding(
            "3-RRR, phi = 0, 1 mm: nodes inside",
            str(PUBLISHED_NODES),
            str(result["inside"]),
            result["inside"] == stored == PUBLISHED_NODES,
        ),
        Finding(
            "3-RRR: effort at the centre, grid and direct answer",
            "the same number",
            f"{at_centre[0]:.15g}, {direct[0]:.15g} N·m",
            at_centre == direct,
        ),
    ]


def five_bar(client: httpx.Client) -> list[Finding]:
    """Return the findings on the five-bar in its three workspace classes."""
    mechanism = preset(client, "five_bar", "five_bar_printer_2017")
    request = {
        "analysis": "workspace",
        "mechanism": mechanism,
        "type": "constant_orientation",
        "grid": [_axis("x", -0.4, 0.4), _axis("y", 0.0, 0.4)],
        "constructive": {
            "min_crank_rod_angle": math.radians(20),
            "max_crank_rod_angle": math.radians(160),
            "min_rod_rod_angle": math.radians(5),
            "max_rod_rod_angle": math.radians(175),
        },
        "effective": {"load": {"force": 1.0}, "max_effort": 0.2},
    }
    results = {}
    for name in ("theoretical", "constructive", "effective"):
        fields = [] if name == "theoretical" else ["effort_max"]
        asked = {**request, "class": name, "fields": fields}
        results[name] = run(client, f"five_bar_{name}", asked)
    torque = results["constructive"]["fields"]["effort_max"]["max"]
    inside = [results[name]["inside"] for name in ("effective", "constructive", "theoretical")]
    return [
        Finding(
            "five-bar: greatest torque under 1 N",
            f"0.2 N·m (recomputed {TORQUE_AT_LEAST}..{TORQUE_AT_MOST})",
            f"{torque:.4f} N·m",
            TORQUE_AT_LEAST <= torque <= TORQUE_AT_MOST,
        ),
        Finding(
            "five-bar: effective, constructive, theoretical nodes",
            "nested",
            ", ".join(map(str, inside)),
            0 < inside[0] < inside[1] < inside[2],
        ),
    ]


def _axis(coordinate: str, least: float, most: float) -> dict[str, Any]:
    return {"coordinate": coordinate, "min": least, "max": most, "step": 0.001}


def main() -> int:
    """Run both studies and return the exit status."""
    OUT.mkdir(exist_ok=True)
    with server() as client:
        findings = planar_3rrr(client) + five_bar(client)
    print(f"\n{'':60}{'published':38}computed")
    for f in findings:
        print(f"{'ok ' if f.right else 'BAD'} {f.what:56}{f.published:38}{f.computed}")
    print(f"\ngrids and pictures are in {OUT.resolve()}")
    return 0 if all(f.right for f in findings) else 1


if __name__ == "__main__":
    sys.exit(main())
