"""Random mechanisms with a pose in reach, each beside its oracle."""

import math
from dataclasses import dataclass, replace

import numpy as np
from hypothesis import assume, settings
from hypothesis import strategies as st

from mechanics.configuration import Configuration
from mechanics.families.five_bar import five_bar
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.mechanism import Mechanism
from tests.oracles import planar

MODEST = settings(max_examples=40, deadline=None)
FREE = (-math.inf, math.inf)


@dataclass(frozen=True)
class Sample:
    """A five-bar (`radius` None) or a 3-RRR, and a pose that all its legs reach."""

    base: float
    radius: float | None
    crank: float
    rod: float
    signs: tuple[int, ...]
    pose: tuple[float, ...]
    limits: tuple[tuple[float, float], ...] = ()

    @property
    def legs(self) -> int:
        return len(self.signs)

    @property
    def mechanism(self) -> Mechanism:
        limits = np.array(self.limits or [FREE] * self.legs)
        mode = np.array(self.signs, dtype=float)
        if self.radius is None:
            return five_bar(
                base_distance=self.base,
                crank_length=self.crank,
                rod_length=self.rod,
                limits=limits,
                working_mode=mode,
            )
        return planar_3rrr(
            base_side=self.base,
            platform_radius=self.radius,
            crank_length=self.crank,
            rod_length=self.rod,
            limits=limits,
            working_mode=mode,
        )

    @property
    def oracle(self) -> planar.PlanarMechanism:
        if self.radius is None:
            return planar.five_bar(self.base, self.crank, self.rod, self.signs)
        return planar.planar_3rrr(self.base, self.radius, self.crank, self.rod, self.signs)

    @property
    def row(self) -> planar.Floats:
        """The pose as one row."""
        return np.array([self.pose])

    @property
    def block(self) -> Configuration:
        return Configuration(self.mechanism, np.array(self.pose)[:, None].copy())

    def scaled(self, factor: float) -> "Sample":
        """Return the same with all lengths times a factor."""
        x, y, *turn = self.pose
        return replace(
            self,
            base=self.base * factor,
            radius=None if self.radius is None else self.radius * factor,
            crank=self.crank * factor,
            rod=self.rod * factor,
            pose=(x * factor, y * factor, *turn),
        )

    @property
    def wire(self) -> dict[str, object]:
        """The mechanism as a request writes it."""
        lengths = {"crank_length": self.crank, "rod_length": self.rod}
        mode = {"working_mode": list(self.signs)}
        if self.radius is None:
            return {"kind": "five_bar", "base_distance": self.base, **lengths, **mode}
        size = {"base_side": self.base, "platform_radius": self.radius}
        return {"kind": "planar_3rrr", **size, **lengths, **mode}


def numbers(least: float, greatest: float) -> st.SearchStrategy[float]:
    """Return ordinary numbers: six decimals, no denormals."""
    return st.floats(least, greatest).map(lambda value: round(value, 6) + 0.0)


@st.composite
def samples(draw: st.DrawFn, *, clear: float = 0.05, radii: bool | None = None) -> Sample:
    """Draw base, platform and pose, then links that reach with room to spare.

    With D the distances to be bridged, r + L > max D and |r - L| < min D.
    """
    turning = draw(st.booleans()) if radii is None else radii
    base = draw(numbers(0.1, 2.0))
    radius = draw(numbers(0.02, 1.0)) if turning else None
    signs = tuple(draw(st.lists(st.sampled_from([1, -1]), min_size=3, max_size=3)))
    signs = signs if turning else signs[:2]
    pose: tuple[float, ...] = (draw(numbers(-1.0, 1.0)), draw(numbers(-1.0, 1.0)))
    if turning:
        pose = (*pose, draw(numbers(-3.2, 3.2)))
    draft = Sample(base, radius, 1.0, 1.0, signs, pose)
    spans = planar.spans(draft.oracle, draft.row)
    assume(spans.min() > 0.05)
    total = float(spans.max()) * (1 + draw(numbers(clear, 1.0)))
    excess = float(spans.min()) * draw(numbers(clear - 1, 1 - clear))
    # Where all spans are one, the rod may come out as nothing.
    assume(total - excess > 1e-3)
    return replace(draft, crank=(total + excess) / 2, rod=(total - excess) / 2)


def away_from_type_2(sample: Sample, greatest: float = 1e3) -> None:
    """Drop the example if the platform is hardly held."""
    assume(float(planar.spread(sample.oracle, sample.row)[0]) < greatest)
