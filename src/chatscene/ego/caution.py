"""What the driver that looks ahead weighs its ways by."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Caution:
    """What the ways are weighed by.

    Found by CMA-ES over drives on kept scenes of routes that train (decision 0023): crashes, and half as much what was
    not completed.

    Attributes:
        speed: Wanted speed [m/s].
        crash: What a crash costs for each m/s of its impact …
        graze: … beside so many m/s that every crash has.
        patience: After so many seconds a crash that is expected weighs less by e [s].
        braking: Deceleration that others may begin with [m/s²], and what that is believed.
        starting: Acceleration, likewise.
        stepping: Speed at which somebody who stands may set out for the route [m/s], and what that is believed.
        crossing: What is believed of somebody who crosses the route: that he keeps straight where the route bends.
        room: Kept free ahead and behind [m].
        side: Kept free beside [m] …
        widening: … and so much more for each second ahead [m/s].
        berth: Beyond that, room that is better not passed fast [m] …
        haste: … and what each metre in it costs.
        offset: What a second costs one metre beside the route, growing with the square.
        astray: What each metre beyond two costs besides.
        jerk: What acceleration costs, growing with the square.
        resolve: What each metre sideways costs.
        agility: Sideways speed for each m/s ahead.
        drift: Largest sideways speed [m/s].
    """

    speed: float = 4.8
    crash: float = 22.0
    graze: float = 0.09
    patience: float = 1.44
    braking: tuple[float, float] = (4.6, 0.81)
    starting: tuple[float, float] = (0.91, 0.23)
    stepping: tuple[float, float] = (1.26, 0.17)
    crossing: float = 0.0
    room: float = 0.85
    side: float = 0.25
    widening: float = 0.07
    berth: float = 1.04
    haste: float = 1.19
    offset: float = 0.052
    astray: float = 0.15
    jerk: float = 0.023
    resolve: float = 0.12
    agility: float = 0.88
    drift: float = 1.34


HARDENED = Caution(
    speed=7.63, crash=11.3, graze=0.0781, patience=1.71, braking=(5.57, 0.205), starting=(0.721, 0.946),
    stepping=(1.53, 0.0311), crossing=1.0, room=2.23, side=0.0765, widening=0.223, berth=0.533, haste=8.47,
    offset=0.0429, astray=0.118, jerk=0.0655, resolve=0.109, agility=0.99, drift=1.79,
)  # fmt: skip
"""Found by CMA-ES against adversaries that were searched for again after each round (decision 0106), but for
`crossing`, which came after (decision 0110)."""

HARDENED_AT_SPEED = Caution(
    crash=14.5, graze=0.0915, patience=2.7, braking=(4.52, 0.384), starting=(1.42, 2.0), stepping=(0.995, 0.0562),
    crossing=1.73, room=3.01, side=0.0537, widening=0.479, berth=0.181, haste=16.0, offset=0.0411, astray=0.124,
    jerk=0.0375, resolve=0.0926, agility=0.344, drift=1.57,
)  # fmt: skip
"""Found likewise at the speed of traffic, 50 to 110 km/h, where its speed is what is wanted (decision 0128)."""
