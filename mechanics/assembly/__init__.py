"""Assembly modes: where the platform can be while the drives stand still, one way a file."""
