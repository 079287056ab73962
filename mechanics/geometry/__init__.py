"""The geometric method: workspaces as exact intersections of the regions that the legs reach."""
