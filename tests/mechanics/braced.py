"""Mechanisms on struts, whose drive coordinates are the rods' lengths, for tests of their modes."""

import numpy as np
import numpy.typing as npt

from mechanics.assembly.modes import Assembly, AssemblyMode
from mechanics.configuration import Configuration
from mechanics.forward import assembly_modes
from mechanics.legs import STRUT, Leg, gather
from mechanics.mechanism import Mechanism
from mechanics.motions import Motion
from tests.oracles.legs import Floats

FREE = (-np.inf, np.inf)


def on_struts(motion: Motion, base: npt.ArrayLike, platform: npt.ArrayLike) -> Mechanism:
    """Return a mechanism on struts between points, one a row; two numbers stand in the plane."""
    pairs = zip(_in_space(base), _in_space(platform), strict=True)
    legs = [Leg(STRUT, *pair) for pair in pairs]
    return Mechanism(motion, gather(legs, np.array([FREE] * len(legs)), np.ones(len(legs))))


def _in_space(points: npt.ArrayLike) -> Floats:
    rows = np.array(points, dtype=float)
    return np.hstack([rows, np.zeros((len(rows), 3 - rows.shape[1]))])


def held(mechanism: Mechanism, *poses: npt.ArrayLike) -> Floats:
    """Return the drive coordinates at poses, one a row."""
    columns = mechanism.columns(np.array(poses, dtype=float))
    return Configuration(mechanism, columns).actuators.T


def modes_of(mechanism: Mechanism, actuators: npt.ArrayLike) -> Assembly:
    return assembly_modes(mechanism, np.array([actuators], dtype=float))[0]


def places(mechanism: Mechanism, poses: Floats) -> Floats:
    """Return rotations row by row and positions, shape (poses, 12): no angle is there twice."""
    positions, rotations = mechanism.motion.place(mechanism.columns(poses))
    return np.vstack([rotations, positions]).T


def gap(mechanism: Mechanism, modes: tuple[AssemblyMode, ...], pose: npt.ArrayLike) -> float:
    """Return how far the nearest mode is from a pose. [m or -]"""
    found = places(mechanism, np.array([mode.pose for mode in modes]))
    return float(np.abs(found - places(mechanism, np.array([pose]))).max(axis=1).min())
