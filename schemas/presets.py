"""Machines with published dimensions."""

import math

from schemas.kinds import Preset
from schemas.mechanisms import ActuatorLimit, FiveBar, Planar3RRR

PAPER_2016 = (
    "Laryushkin P.A., Glazunov V.A., Erastova K.G. Computation of the maximal actuation efforts "
    "in parallel manipulators at a specified value of external load. Mechanical Engineering and "
    "Engineering Education, 2016, no. 2(47), pp. 40-46."
)
PAPER_2017 = (
    "Erastova K.G., Laryushkin P.A. Workspaces of parallel mechanisms and methods of determining "
    "their shape and size. 2017, no. 8, pp. 78-87, doi:10.18698/0536-1044-2017-8-78-87."
)

# The limit switches stand at (-+0.11, -0.05) m and are 5 mm in size: seen from the base joint,
# sqrt(0.05^2 + 0.05^2) m away, a crank stops this much before 45 degrees below the base line.
# The other end is the stand's, whose place is not printed: the switch's mirror image is taken.
_SWITCH = math.asin(0.005 / math.hypot(0.05, 0.05))

PRESETS = (
    Preset(
        name="five_bar_printer_2017",
        title="Five-bar of a 3-D printer with limit switches",
        source=PAPER_2017,
        mechanism=FiveBar(
            kind="five_bar",
            name="Five-bar of Erastova and Laryushkin, 2017",
            base_distance=0.12,
            crank_length=0.16,
            rod_length=0.22,
            actuator_limits=[
                ActuatorLimit(min=-0.25 * math.pi + _SWITCH, max=1.25 * math.pi - _SWITCH),
                ActuatorLimit(min=-0.25 * math.pi + _SWITCH, max=1.25 * math.pi - _SWITCH),
            ],
        ),
    ),
    Preset(
        name="planar_3rrr_2016",
        title="Planar 3-RRR of an effort study",
        source=PAPER_2016,
        mechanism=Planar3RRR(
            kind="planar_3rrr",
            name="3-RRR of Laryushkin et al., 2016",
            base_side=0.4,
            platform_radius=0.08,
            crank_length=0.18,
            rod_length=0.18,
        ),
    ),
)
