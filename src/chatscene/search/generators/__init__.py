"""Generators of scenarios: ours, the baselines of the paper, and programs of a user."""
