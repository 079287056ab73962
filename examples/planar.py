"""Pictures of 2017: workspaces of the five-bar and the planar 3-RRR."""

import math
from pathlib import Path

import httpx
import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Arc, Circle, PathPatch, Polygon
from matplotlib.path import Path as Outline

from examples import bodies
from examples.drawing import (
    EDGE,
    FAINT,
    FILL,
    INK,
    ORANGE,
    RED,
    Floats,
    Grid,
    arrays,
    draw_legs,
    draw_region,
    page,
    plane,
    save,
)
from examples.links import base_joints, leg_points, leg_reach, rrr
from examples.serving import Json, ask, fetch, preset, result_of, run_job


def by_geometry(client: httpx.Client, out: Path) -> None:
    """Draw figure 2 of 2017: what the legs' regions have in common."""
    figure = page(7.2, 3.7)
    left, right = figure.subplots(1, 2)
    _five_bar_by_geometry(client, left)
    _rrr_by_geometry(client, right)
    save(figure, out / "2017_figure_2.png")


def _five_bar_by_geometry(client: httpx.Client, axes: Axes) -> None:
    mechanism = bodies.unlimited(preset(client, "five_bar", "five_bar_printer_2017"))
    result = _result(
        client, "five-bar, figure 2", bodies.geometric(mechanism, "constant_orientation")
    )
    half, reach = mechanism["base_distance"] / 2, leg_reach(mechanism)
    _draw_boundary(axes, result)
    for x in (-half, half):
        axes.add_patch(Circle((x, 0), reach, fill=False, edgecolor=FAINT, linestyle="--"))
        axes.plot(x, 0, "^", color=INK, markersize=5)
    area = result["measure"]["value"]
    axes.set_title(f"(a) five-bar: {area:.4f} m²")
    axes.set(xlim=(-0.47, 0.47), ylim=(-0.47, 0.47))
    plane(axes)


def _rrr_by_geometry(client: httpx.Client, axes: Axes) -> None:
    mechanism = rrr(client)
    bound = _result(client, "3-RRR, figure 2", bodies.geometric(mechanism, "maximal"))
    job = run_job(client, "3-RRR, maximal", bodies.types_of_3rrr(mechanism)["maximal"])
    true = result_of(client, job)["measure"]["value"]
    reach = leg_reach(mechanism) + mechanism["platform_radius"]
    _draw_boundary(axes, bound, facecolor="#f6c9a8")
    draw_region(axes, arrays(fetch(client, job, "grid")))
    for x, y in base_joints(mechanism):
        axes.add_patch(Circle((x, y), reach, fill=False, edgecolor=FAINT, linestyle="--"))
        axes.plot(x, y, "^", color=INK, markersize=5)
    axes.set_title(f"(b) 3-RRR: bound {bound['measure']['value']:.4f} m², true {true:.4f} m²")
    axes.set(xlim=(-0.45, 0.45), ylim=(-0.4, 0.5))
    plane(axes)


def _draw_boundary(axes: Axes, result: Json, facecolor: str = FILL) -> None:
    """Draw the arcs of an exact boundary; holes turn the other way, so they stay white."""
    loops = [np.concatenate([_arc_points(arc) for arc in loop]) for loop in result["boundary"]]
    codes = [[Outline.MOVETO] + [Outline.LINETO] * (len(loop) - 1) for loop in loops]
    outline = Outline(np.concatenate(loops), np.concatenate(codes))
    axes.add_patch(PathPatch(outline, facecolor=facecolor, edgecolor=EDGE, linewidth=1.1))


def _arc_points(arc: Json) -> Floats:
    turns = np.linspace(arc["start"], arc["end"], 200)
    points: Floats = np.array(arc["centre"]) + arc["radius"] * np.column_stack(
        [np.cos(turns), np.sin(turns)]
    )
    return points


def types(client: httpx.Client, out: Path) -> None:
    """Draw figure 4 of 2017: workspaces of several types of one mechanism."""
    mechanism = rrr(client)
    grids, shares = {}, {}
    for name, request in bodies.types_of_3rrr(mechanism).items():
        if name == "maximal":
            continue  # It is no panel of this figure.
        job = run_job(client, f"3-RRR, figure 4, {name}", request)
        grids[name] = arrays(fetch(client, job, "grid"))
        shares[name] = result_of(client, job)["measure"]["value"]
    figure = page(6.4, 9.2)
    panels = figure.subplots(3, 2, sharex=True, sharey=True)
    regions = {
        "phi = 0": (panels[0, 0], "(a) φ = 0"),
        "phi = pi/4": (panels[0, 1], "(a) φ = π/4"),
        "full": (panels[2, 0], "(c) full"),
        "quarter": (panels[2, 1], "(d) some φ in [0, π/2]"),
    }
    for name, (axes, title) in regions.items():
        draw_region(axes, grids[name])
        axes.set_title(f"{title}: {shares[name]:.4f} m²")
    _draw_turns(panels[1, 0], grids["centre"], {"x": 0.0, "y": 0.0})
    _draw_turns(panels[1, 1], grids["elsewhere"], bodies.ELSEWHERE)
    for axes in panels.flat:
        base = base_joints(mechanism)
        axes.add_patch(Polygon(base, fill=False, edgecolor=FAINT, linestyle=":"))
        axes.plot(*base.T, "^", color=INK, markersize=5)
        axes.set(xlim=(-0.3, 0.3), ylim=(-0.27, 0.33))
        axes.set_aspect("equal")
    for axes in panels[2]:
        axes.set_xlabel("$x$, m")
    for axes in panels[:, 0]:
        axes.set_ylabel("$y$, m")
    save(figure, out / "2017_figure_4.png")


def _draw_turns(axes: Axes, grid: Grid, position: dict[str, float]) -> None:
    """Draw the end of a vector from the platform's centre at every orientation it can have."""
    inside, angles = grid["inside"], np.degrees(grid["axis_phi"])
    x, y = position["x"], position["y"]
    size = 0.08
    free = angles[inside]
    where = f"({x:g}, {y:g})"
    if inside.all():
        axes.set_title(f"(b) {where}: every φ")
    else:
        span = f"φ from {free[0]:.1f}° to {free[-1]:.1f}°"
        axes.set_title(f"(b) {where}: {span}".replace("-", "−"))
        for edge in np.radians([90 + free[0], 90 + free[-1]]):
            tip = size * math.cos(edge), size * math.sin(edge)
            axes.plot([x, x + tip[0]], [y, y + tip[1]], color=FAINT, linewidth=0.8)
    axes.add_patch(Circle((x, y), size, fill=False, edgecolor=FAINT, linewidth=0.7))
    ends = 90 + free[0], 90 + free[-1]
    arc = Arc((x, y), 2 * size, 2 * size, theta1=ends[0], theta2=ends[1], edgecolor=EDGE, lw=3)
    axes.add_patch(arc)
    arrow = {"arrowstyle": "-|>", "color": RED, "linewidth": 1.4, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", (x, y + size), (x, y), arrowprops=arrow)
    axes.text(x + 0.008, y + 0.35 * size, "$\\mathbf{h}$", color=RED)
    axes.plot(x, y, "o", color=INK, markersize=3)


def printer(client: httpx.Client, out: Path) -> None:
    """Draw figure 8 of 2017: constructive workspace and torques of the five-bar."""
    mechanism = preset(client, "five_bar", "five_bar_printer_2017")
    asked = {
        "printed": bodies.printer(mechanism),
        "down": bodies.printer(bodies.straight_down(mechanism)),
        "both": bodies.printer(mechanism, **bodies.BOTH_ENDS),
    }
    grids, torques = {}, {}
    for name, body in asked.items():
        job = run_job(client, f"five-bar, figure 8, {name}", body)
        grids[name] = arrays(fetch(client, job, "grid"))
        torques[name] = 1000 * result_of(client, job)["fields"]["effort_max"]["max"]
    figure = page(6.0, 8.6)
    upper, lower = figure.subplots(2, 1)
    _draw_built(client, upper, mechanism, grids)
    _draw_torques(lower, grids, torques)
    for axes in (upper, lower):
        axes.set(xlim=(-400, 400), ylim=(-80, 520))
        plane(axes, "$x$, mm", "$y$, mm")
    save(figure, out / "2017_figure_8.png")


def _draw_built(client: httpx.Client, axes: Axes, mechanism: Json, grids: dict[str, Grid]) -> None:
    draw_region(axes, grids["printed"], 1000.0)
    draw_region(axes, grids["down"], 1000.0, fill=False, edgecolor=ORANGE, linestyle="--")
    request = {"analysis": "inverse_kinematics", "mechanism": mechanism, "poses": [[0.0, 0.22]]}
    angles = ask(client, request)["actuators"][0]
    half, crank = mechanism["base_distance"] / 2, mechanism["crank_length"]
    base = np.array([[-half, 0.0], [half, 0.0]])
    legs = [
        leg_points(foot, crank, a, np.array([0.0, 0.22]))
        for foot, a in zip(base, angles, strict=True)
    ]
    draw_legs(axes, legs, scale=1000.0)
    axes.plot([-110, 110], [-50, -50], "s", color=RED, markersize=5)
    labels = [
        Line2D([], [], color=EDGE),
        Line2D([], [], color=ORANGE, linestyle="--"),
        Line2D([], [], color=RED, marker="s", linestyle="none"),
    ]
    names = ["stops: switch and its mirror image", "stops: switch and straight down", "switches"]
    axes.legend(labels, names, loc="upper left")
    axes.set_title("(a) constructive workspace")


def _draw_torques(axes: Axes, grids: dict[str, Grid], torques: dict[str, float]) -> None:
    grid = grids["printed"]
    x, y = 1000 * grid["axis_x"], 1000 * grid["axis_y"]
    torque = 1000 * np.ma.masked_invalid(grid["effort_max"]).T
    extent = (x[0], x[-1], y[0], y[-1])
    image = axes.imshow(torque, extent=extent, origin="lower", cmap="viridis", vmin=100, vmax=240)
    draw_region(axes, grid, 1000.0, fill=False)
    axes.contour(x, y, torque, levels=[200.0], colors=RED, linewidths=1.0)
    draw_region(axes, grids["both"], 1000.0, fill=False, edgecolor="white", linestyle="--", lw=0.9)
    assert axes.figure is not None
    bar = axes.figure.colorbar(
        image, ax=axes, extend="min", location="bottom", aspect=35, shrink=0.75
    )
    bar.set_label("greatest torque of a drive, N·mm")
    bar.ax.axvline(200, color=RED)
    labels = [Line2D([], [], color=RED), Line2D([], [], color="#9aa7b4", linestyle="--")]
    names = [
        f"200 N·mm (greatest: {torques['printed']:.0f})",
        f"link angles bounded above too (greatest: {torques['both']:.0f})",
    ]
    axes.legend(labels, names, loc="upper left")
    axes.set_title("(b) torques under 1 N from the worst direction")


def _result(client: httpx.Client, name: str, request: Json) -> Json:
    return result_of(client, run_job(client, name, request))
