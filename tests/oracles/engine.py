"""Machines in a multibody engine, exudyn, which solves for the drive forces.

Cranks and carriages are links of kinematic trees, rods are distances, the platform is a rigid
body; motions that it lacks are locked, unless pairs of rods (parallelograms) take them away. Only
drive coordinates are handed in; the solution shows by how much they would move the platform.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

import exudyn
import numpy as np
from exudyn.itemInterface import (
    CoordinateConstraint,
    DistanceConstraint,
    MarkerBodyPosition,
    MarkerKinematicTreeRigid,
    MarkerNodeCoordinate,
    NodeGenericODE2,
    NodePointGround,
    ObjectGround,
    ObjectKinematicTree,
)

# This module also gives the engine's systems their `Create...` functions.
from exudyn.utilities import InertiaCuboid

from tests.oracles.machines import Floats, Leg, Machine, frame_about, placement

Vector = Sequence[float] | Floats


class Solution(NamedTuple):
    """Drive forces and torques that hold the load, and how far the platform had to move.

    `shift` is the greatest change of the platform's position and orientation from the pose
    asked for, to where the drive coordinates put it. [m or -]
    """

    efforts: Floats
    shift: float


LOCKED: Mapping[str, list[int]] = MappingProxyType(
    {
        "planar_translation": [0, 0, 1, 1, 1, 1],
        "planar": [0, 0, 1, 1, 1, 0],
        "translation": [0, 0, 0, 1, 1, 1],
        "schoenflies": [0, 0, 0, 1, 1, 0],
        "spherical": [1, 1, 1, 0, 0, 0],
        "spatial": [0, 0, 0, 0, 0, 0],
    }
)
"""What a motion lacks: translations, then turns, in a frame whose z is a single turn's axis."""


class Engine:
    """A machine at a pose as a system of the engine, its drives at the given coordinates."""

    def __init__(self, machine: Machine, pose: Vector, actuators: Floats) -> None:
        self._container = exudyn.SystemContainer()
        self._system = self._container.AddSystem()
        self._position, self._rotation = placement(machine.motion, machine.axis, pose)
        self._ground = self._system.AddObject(ObjectGround())
        fixed = self._system.AddNode(NodePointGround())
        self._fixed = self._mark(MarkerNodeCoordinate(nodeNumber=fixed, coordinate=0))
        self._platform = self._system.CreateRigidBody(
            referencePosition=self._position,
            referenceRotationMatrix=self._rotation,
            inertia=InertiaCuboid(density=1000.0, sideLengths=[0.1, 0.1, 0.1]),
        )
        self._lock(machine)
        self._drives = [
            (self._strut if leg.drive == "strut" else self._driven)(leg, float(drive))
            for leg, drive in zip(machine.legs, actuators, strict=True)
        ]

    def solve(self, force: Vector, moment: Vector) -> Solution:
        """Return what the drives bear under a force on the reference point and a moment."""
        system = self._system
        system.CreateForce(itemNumber=self._platform, loadVector=list(force))
        system.CreateTorque(itemNumber=self._platform, loadVector=list(moment))
        system.Assemble()
        if not system.SolveStatic(_settings()):
            raise ArithmeticError("the engine found no equilibrium")
        kind = exudyn.OutputVariableType
        efforts = [float(system.GetObjectOutput(item, kind.Force)) for item in self._drives]
        position = system.GetObjectOutputBody(self._platform, kind.Position)
        rotation = system.GetObjectOutputBody(self._platform, kind.RotationMatrix)
        moved = np.abs(np.array(position) - self._position).max()
        turned = np.abs(np.array(rotation).reshape(3, 3) - self._rotation).max()
        return Solution(np.array(efforts), float(max(moved, turned)))

    def _mark(self, marker: object) -> Any:  # noqa: ANN401
        return self._system.AddMarker(marker)

    def _on_platform(self, point: Floats) -> Any:  # noqa: ANN401
        return self._mark(MarkerBodyPosition(bodyNumber=self._platform, localPosition=point))

    def _lock(self, machine: Machine) -> None:
        locked = LOCKED[machine.motion]
        if machine.pairs or not any(locked):
            return
        single = machine.motion in ("planar", "schoenflies")
        self._system.CreateGenericJoint(
            itemNumbers=[self._ground, self._platform],
            position=self._position,
            rotationMatrixAxes=frame_about(machine.axis) if single else np.eye(3),
            constrainedAxes=locked,
        )

    def _strut(self, leg: Leg, drive: float) -> Any:  # noqa: ANN401
        """A distance's force is positive where it pushes its ends apart, as a drive's is."""
        foot = MarkerBodyPosition(bodyNumber=self._ground, localPosition=leg.base)
        ends = [self._mark(foot), self._on_platform(leg.rods[0].end)]
        return self._system.AddObject(DistanceConstraint(markerNumbers=ends, distance=drive))

    def _driven(self, leg: Leg, drive: float) -> Any:  # noqa: ANN401
        node = self._system.AddNode(
            NodeGenericODE2(
                numberOfODE2Coordinates=1,
                referenceCoordinates=[0.0],
                initialCoordinates=[drive],
                initialCoordinates_t=[0.0],
            )
        )
        kinds = exudyn.JointType
        link = self._system.AddObject(
            ObjectKinematicTree(
                nodeNumber=node,
                jointTypes=[kinds.RevoluteZ if leg.drive == "crank" else kinds.PrismaticZ],
                linkParents=[-1],
                jointTransformations=exudyn.Matrix3DList([leg.frame]),
                jointOffsets=exudyn.Vector3DList([leg.base]),
                linkInertiasCOM=exudyn.Matrix3DList([np.eye(3)]),
                linkCOMs=exudyn.Vector3DList([np.zeros(3)]),
                linkMasses=[1.0],
            )
        )
        for rod in leg.rods:
            tip = MarkerKinematicTreeRigid(objectNumber=link, linkNumber=0, localPosition=rod.tip)
            ends = [self._mark(tip), self._on_platform(rod.end)]
            self._system.AddObject(DistanceConstraint(markerNumbers=ends, distance=rod.length))
        moving = self._mark(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        held = CoordinateConstraint(markerNumbers=[self._fixed, moving], offset=drive)
        return self._system.AddObject(held)


def _settings() -> Any:  # noqa: ANN401
    settings = exudyn.SimulationSettings()
    settings.solution.file.write = False
    settings.staticSolver.newton.relativeTolerance = 1e-12
    settings.staticSolver.newton.absoluteTolerance = 1e-12
    settings.staticSolver.stabilizerODE2term = 0.0
    settings.staticSolver.verboseMode = 0
    return settings


def solve(
    machine: Machine,
    pose: Vector,
    actuators: Floats,
    load: tuple[Vector, Vector],
) -> Solution:
    """Return the efforts of a machine at a pose under a force and a moment."""
    return Engine(machine, pose, actuators).solve(*load)
