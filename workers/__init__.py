"""Runs queued jobs: an engine, and the processes it has their tiles computed in."""
