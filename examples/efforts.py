"""Pictures of 2016: the planar 3-RRR and the torques of its drives."""

from pathlib import Path

import httpx
import numpy as np
from matplotlib.lines import Line2D

from examples import bodies
from examples.drawing import (
    EDGE,
    INK,
    ORANGE,
    RED,
    arrays,
    draw_legs,
    draw_region,
    page,
    plane,
    save,
    save_png,
)
from examples.links import base_joints, rrr, rrr_links
from examples.serving import ask, fetch, run_job


def effort_map(client: httpx.Client, out: Path) -> None:
    """Draw the efforts over the workspace of 2016, as the server draws them."""
    job = run_job(client, "3-RRR, efforts", bodies.effort_map(rrr(client)))
    save_png(fetch(client, job, "figure", format="png"), out / "2016_efforts.png")


def rose(client: httpx.Client, out: Path) -> None:
    """Draw figure 3 of 2016: the path in the workspace, in the paper's frame."""
    mechanism = rrr(client)
    job = run_job(client, "3-RRR, figure 3", bodies.effort_map(mechanism) | {"fields": []})
    grid = arrays(fetch(client, job, "grid"))
    # The paper's origin is the base joint on the lower left.
    corner = base_joints(mechanism)[1]
    grid["axis_x"], grid["axis_y"] = grid["axis_x"] - corner[0], grid["axis_y"] - corner[1]
    poses = np.array(bodies.rose_poses())
    figure = page(5.2, 5.0)
    axes = figure.add_subplot()
    draw_region(axes, grid)
    legs, platform = rrr_links(client, mechanism, poses[0])
    draw_legs(axes, [leg - corner for leg in legs], platform - corner)
    axes.plot(*(poses[:, :2] - corner).T, color=RED, linewidth=1.6, zorder=3)
    axes.set(xlim=(-0.1, 0.5), ylim=(-0.12, 0.42))
    plane(axes)
    labels = [Line2D([], [], color=RED), Line2D([], [], color=EDGE)]
    names = ["path of the platform's centre", "boundary of the workspace, φ = 0"]
    figure.legend(labels, names, loc="outside upper center", ncols=2)
    save(figure, out / "2016_figure_3.png")


def rose_efforts(client: httpx.Client, out: Path) -> None:
    """Draw figure 4 of 2016: the first drive's torque along the path under 10 N."""
    figure = page(6.4, 3.3)
    axes = figure.add_subplot()
    names = {
        "worst": "1: from the worst direction",
        "along x": "2: along $x$",
        "along y": "3: along $y$",
    }
    looks = {"worst": (INK, "-"), "along x": (EDGE, "--"), "along y": (ORANGE, "-.")}
    for name, request in bodies.rose_efforts(rrr(client)).items():
        torque = np.abs(np.array(ask(client, request)["effort"], dtype=float)[:, 0])
        colour, line = looks[name]
        time = np.linspace(0.0, 15.0, len(torque))
        axes.plot(time, torque, color=colour, linestyle=line, label=names[name])
    axes.set(xlim=(0, 15), xlabel="$t$, s", ylabel="$|T_1|$, N·m")
    axes.set_ylim(bottom=0)
    figure.legend(loc="outside upper center", ncols=3)
    save(figure, out / "2016_figure_4.png")
