"""The mechanisms that figures are taken of."""

from dataclasses import replace

import numpy as np

from mechanics.arrays import Floats
from mechanics.families.hexapods import gough_stewart
from mechanics.families.planar_3rrr import planar_3rrr
from mechanics.mechanism import Mechanism

POSES = 1_000_000


def free(legs: int) -> Floats:
    """Return limits of drives that have none."""
    return np.tile([-np.inf, np.inf], (legs, 1))


def planar() -> Mechanism:
    """Return the 3-RRR of Laryushkin, Glazunov and Erastova, 2016."""
    return planar_3rrr(
        base_side=0.4,
        platform_radius=0.08,
        crank_length=0.18,
        rod_length=0.18,
        limits=free(3),
        working_mode=np.ones(3),
    )


def hexapod() -> tuple[Mechanism, Floats]:
    """Return a 6-SPS and random poses, shape (poses, 6)."""
    base_angles = np.deg2rad([-10, 10, 110, 130, 230, 250])
    platform_angles = np.deg2rad([-50, 50, 70, 170, 190, 290])
    flat = np.zeros(6)
    mechanism = gough_stewart(
        base_points=np.c_[np.cos(base_angles), np.sin(base_angles), flat].tolist(),
        platform_points=(
            0.5 * np.c_[np.cos(platform_angles), np.sin(platform_angles), flat]
        ).tolist(),
        limits=free(6),
        working_mode=np.ones(6),
    )
    random = np.random.default_rng(0)
    poses = np.c_[
        random.uniform(-0.2, 0.2, (POSES, 2)),
        random.uniform(0.9, 1.2, POSES),
        random.uniform(-0.5, 0.5, (POSES, 3)),
    ]
    return mechanism, poses


def limited_hexapod(shortest: float, longest: float) -> Mechanism:
    """Return the 6-SPS with struts between two lengths. [m]"""
    mechanism, _ = hexapod()
    limits = {"lower_limit": np.full(6, shortest), "upper_limit": np.full(6, longest)}
    return replace(mechanism, legs=mechanism.legs._replace(**limits))
