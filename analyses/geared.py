"""From a geared mechanism on the wire to the one of `mechanics`."""

from mechanics.arrays import Floats
from mechanics.families import geared
from mechanics.mechanism import Mechanism
from schemas.geared import WristGears


def geared_decoupled(
    *, wrist: WristGears, limits: Floats, working_mode: Floats, **sizes: float
) -> Mechanism:
    """Return the mechanism, its wrist's gears multiplied up to the gains of the motors."""
    return geared.geared_decoupled(
        gain=wrist.k1 * wrist.k2 * wrist.kp,
        shared_gain=wrist.k_gamma,
        limits=limits,
        working_mode=working_mode,
        **sizes,
    )
