"""The world models that programs are written for, and ours that stands in for each."""

from __future__ import annotations

from chatscene.terms.scene import OWN_MODEL

_DRIVING = "chatscene.world.driving"

STANDS_IN: dict[str, str] = {
    OWN_MODEL: OWN_MODEL,
    "scenic.domains.driving.model": _DRIVING,
    "scenic.simulators.newtonian.driving_model": _DRIVING,
    "scenic.simulators.metadrive.model": _DRIVING,
    "scenic.simulators.carla.model": "chatscene.world.carla_model",
}
"""By what a program's `model` line says: the model of ours that is loaded in its place."""
