"""Geared wrists: motors that turn a platform about a centre which the legs only move.

A wrist is a linear map between the platform's angles rx, ry, rz and its motors. What it says of
angular velocities and moments goes through the matrix E that makes an angular velocity of the
angles' rates; E is singular where ry is a right angle, as of every wrist of three axes.
"""

from dataclasses import dataclass

import numpy as np

from mechanics.arrays import Booleans, Floats


@dataclass(frozen=True)
class Wrist:
    """Three motors between the part that the legs carry, which does not turn, and the platform.

    Parameters
    ----------
    gains : array, shape (3, 3), regular: turns of the motors, one a row, for turns rx, ry, rz.
    tool : array, shape (3,): the platform's reference point from the wrist's centre, in the
        platform's frame. [m]
    joints : array, shape (legs, 3): the legs' joints on what they carry, from the centre. [m]
    lower_limit, upper_limit : arrays, shape (3,), of the motors. [rad]
    geared : array, shape (3,): which motors drive through a train of gears.
    """

    gains: Floats
    tool: Floats
    joints: Floats
    lower_limit: Floats
    upper_limit: Floats
    geared: Booleans

    @property
    def idle_turns(self) -> tuple[str, ...]:
        """The turns that leave the wrist's centre where it is: rx, if the tool is along x."""
        return () if self.tool[1:].any() else ("rx",)

    def motors(self, angles: Floats) -> Floats:
        """Return the motors' coordinates at angles rx, ry, rz, shape (3, poses) each. [rad]

        Angles are taken as they are: one more turn of the platform is another place of a motor.
        """
        first, second, third = self.gains.T[:, :, None]
        # A product of matrices would be summed in another order for one pose than for many.
        turned: Floats = first * angles[0] + second * angles[1] + third * angles[2]
        return turned

    def angles(self, motors: Floats) -> Floats:
        """Return the angles rx, ry, rz that the motors hold, shape (3, poses). [rad]"""
        held: Floats = np.linalg.inv(self.gains) @ motors
        return held

    def centres(self, positions: Floats, rotations: Floats) -> Floats:
        """Return the wrist's centres, shape (3, poses), of placed platforms. [m]"""
        centres: Floats = positions - self._tools(rotations)
        return centres

    def positions(self, centres: Floats, rotations: Floats) -> Floats:
        """Return the platform's reference points, shape (3, poses), of placed centres. [m]"""
        positions: Floats = centres + self._tools(rotations)
        return positions

    def carried_twists(self, rotations: Floats, twists: Floats) -> Floats:
        """Return the twists, shape (6, poses), of what the legs carry: its centre's, no turn."""
        centres = twists[:3] - np.cross(twists[3:], self._tools(rotations), axis=0)
        return np.concatenate([centres, np.zeros_like(centres)])

    def turns(self, angles: Floats) -> Floats:
        """Return E gains^-1: the angular velocities, one a column, of each motor's unit rate.

        Shape (3, 3, poses): component, motor, pose. The same numbers transposed are what a moment
        asks of the motors.
        """
        turns: Floats = np.einsum("jan,ai->jin", angle_turns(angles), np.linalg.inv(self.gains))
        return turns

    def rates(self, angles: Floats) -> tuple[Floats, Floats]:
        """Return the motors' rates for angular velocities as rows, and what divides them all.

        Shapes (3, 3, poses), motor before component, and (poses,): gains E^-1 with the
        determinant of E, which vanishes where ry is a right angle, kept apart.
        """
        cofactors, determinants = angle_rates(angles)
        return np.einsum("ia,ajn->ijn", self.gains, cofactors), determinants

    def pressure_angles(self, angles: Floats) -> Floats:
        """Return the motors' pressure angles, shape (3, poses), within [0, pi/2]. [rad]

        With all other drives braked a motor turns the platform about one axis, and about another
        one acts the moment that it bears alone; the angle is between these two.
        """
        turned = np.moveaxis(self.turns(angles), 1, 0)
        pushed = self.rates(angles)[0]
        across = np.linalg.norm(np.cross(turned, pushed, axis=1), axis=1)
        between: Floats = np.arctan2(across, np.abs(np.sum(turned * pushed, axis=1)))
        return between

    def _tools(self, rotations: Floats) -> Floats:
        """Return the arms from centre to reference point, shape (3, poses). [m]"""
        arms: Floats = np.einsum("jkn,k->jn", rotations.reshape(3, 3, -1), self.tool)
        return arms


def angle_turns(angles: Floats) -> Floats:
    """Return E, shape (3, 3, poses): the angular velocity of each angle's unit rate, a column.

    R = Rz(rz) Ry(ry) Rx(rx), so rx turns about Rz Ry x, ry about Rz y and rz about z.
    """
    _, ry, rz = angles
    c, s, none, one = np.cos(rz), np.sin(rz), np.zeros_like(rz), np.ones_like(rz)
    return np.array(
        [
            [c * np.cos(ry), -s, none],
            [s * np.cos(ry), c, none],
            [-np.sin(ry), none, one],
        ]
    )


def angle_rates(angles: Floats) -> tuple[Floats, Floats]:
    """Return det E times E^-1, shape (3, 3, poses), and det E = cos ry, shape (poses,)."""
    _, ry, rz = angles
    c, s, none = np.cos(rz), np.sin(rz), np.zeros_like(rz)
    level, rise = np.cos(ry), np.sin(ry)
    rows = [[c, s, none], [-s * level, c * level, none], [c * rise, s * rise, level]]
    return np.array(rows), level
