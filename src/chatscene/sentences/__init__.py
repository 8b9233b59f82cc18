"""Sentences about dangerous traffic situations, written from base scenarios and from what was read."""
