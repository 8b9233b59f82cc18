"""What each kind of road user can do: sizes, accelerations, steering.

Sizes are those of typical road users, accelerations mid-size production figures; the car is CARLA's Lincoln MKZ
2017. Walkers: sprint starts reach about 4 m/s²; 8 m/s is a fast adult's sprint.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """What a kind of body can do.

    Attributes:
        length: [m].
        width: [m].
        throttle: Acceleration at full throttle and standstill [m/s²].
        brake: Deceleration at full brake [m/s²].
        top_speed: [m/s]; throttle fades linearly towards it.
        wheelbase: [m]; 0 for walkers and things.
        wheel_angle: Largest wheel angle [rad].
        wheel_rate: Largest rate of the wheel angle [rad/s].
        lateral: Largest lateral acceleration [m/s²]; beyond it the turn widens.
        drag: Deceleration when coasting [m/s²] at standstill; grows with speed squared.
    """

    length: float
    width: float
    throttle: float = 0.0
    brake: float = 0.0
    top_speed: float = 0.0
    wheelbase: float = 0.0
    wheel_angle: float = 0.0
    wheel_rate: float = 0.0
    lateral: float = 0.0
    drag: float = 0.2


LIMITS: dict[str, Limits] = {
    "Car": Limits(length=4.9, width=2.13, throttle=4.5, brake=8.0, top_speed=50.0, wheelbase=2.85,
                  wheel_angle=1.22, wheel_rate=2.4, lateral=7.0),
    "Truck": Limits(length=7.8, width=2.5, throttle=2.2, brake=6.0, top_speed=30.0, wheelbase=4.5,
                    wheel_angle=0.8, wheel_rate=1.0, lateral=4.0),
    "Bus": Limits(length=11.5, width=2.5, throttle=1.8, brake=5.5, top_speed=28.0, wheelbase=6.0,
                  wheel_angle=0.8, wheel_rate=1.0, lateral=3.5),
    "EmergencyVehicle": Limits(length=5.9, width=2.1, throttle=3.5, brake=7.5, top_speed=40.0, wheelbase=3.7,
                               wheel_angle=1.0, wheel_rate=2.0, lateral=6.0),
    "Motorcycle": Limits(length=2.2, width=0.8, throttle=6.0, brake=8.0, top_speed=50.0, wheelbase=1.45,
                         wheel_angle=0.8, wheel_rate=2.5, lateral=7.0),
    "Bicycle": Limits(length=1.8, width=0.6, throttle=1.8, brake=4.5, top_speed=12.0, wheelbase=1.05,
                      wheel_angle=0.8, wheel_rate=2.5, lateral=4.0),
    "Pedestrian": Limits(length=0.6, width=0.6, throttle=4.0, brake=5.0, top_speed=8.0),
}  # fmt: skip


def kind_of(thing: object) -> str:
    """The kind of road user that a thing is: the nearest of its classes in `LIMITS`; else its own class."""
    names = [cls.__name__ for cls in type(thing).__mro__]
    return next((name for name in names if name in LIMITS), names[0])
