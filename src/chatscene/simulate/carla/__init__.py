"""CARLA: what speaks its protocol."""
