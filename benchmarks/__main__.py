"""`python -m benchmarks`: prints each figure as a ratio, both sides measured in this run."""

import numpy as np

from benchmarks import poses, workspaces
from benchmarks.mechanisms import hexapod, planar

if __name__ == "__main__":
    workspaces.scan_of_reach()
    workspaces.rails()
    workspaces.struts()
    workspaces.orientations()
    workspaces.fields()
    workspaces.effective()
    poses.inverse_of_struts()
    poses.forward_of_struts()
    random_poses = np.random.default_rng(0).uniform(-0.05, 0.05, (200_000, 3))
    poses.efforts("3-RRR efforts from poses, a pose", planar(), random_poses)
    poses.efforts("6-SPS efforts from poses, a pose", *hexapod())
