"""The embedded simulator: deterministic, in this process, no server."""
