"""The catalogue: which blueprints there are, how large they are, and which of our kinds each moves like.

Ids and sizes are those that Scenic's interface knows of CARLA 0.9.16, read from the installed package; attributes
are what clients ask for.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from carla_stand_in.wire import VERSION
from chatscene.terms.actors import AdversaryKind, Manner

_BOOL, _INT, _FLOAT, _STRING, _COLOUR = 1, 2, 3, 4, 5
_VAN = "van"  # CARLA's other types of vehicles are called as our kinds are
_BASES = (*(kind.value for kind in AdversaryKind if kind.row.manner in (Manner.DRIVES, Manner.RIDES)), _VAN)
_EMERGENCY = {"vehicle.ford.ambulance", "vehicle.carlamotors.firetruck"}
_SIRENS = ("ambulance", "police", "firetruck")
_WALKER = (0.38, 0.38, 1.86)  # [m], length, width, height of most of CARLA's grown pedestrians
_SMALL = (0.2, 0.2, 0.2)  # [m], of what has no size of its own

Attribute = list[Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Blueprint:
    """What can be spawned.

    Attributes:
        id: Such as ``vehicle.lincoln.mkz_2017``.
        kind: The road user of ours that it moves like (`chatscene.terms.actors.LIMITS`); empty for what stands.
        size: Length, width, height [m].
        mass: [kg]; of what stands, 0, which stands for more than any other.
        attributes: As they go over the wire: id, type, value, recommended, modifiable, restricted.
    """

    id: str
    kind: str = ""
    size: tuple[float, float, float] = _SMALL
    mass: float = 0.0
    attributes: list[Attribute] = field(default_factory=list[Attribute])

    @property
    def group(self) -> str:
        """The first word of the id: vehicle, walker, static, sensor, controller, traffic or spectator."""
        return self.id.split(".", 1)[0]

    @property
    def extent(self) -> list[float]:
        """Half of length, width and height [m]."""
        return [side / 2 for side in self.size]

    @property
    def lifted(self) -> float:
        """How far above its origin the middle of its box lies [m]: a walker's origin is its middle."""
        return 0.0 if self.group == "walker" else self.extent[2]

    @property
    def box(self) -> list[Any]:
        """Its bounding box as it goes over the wire."""
        return [[0.0, 0.0, self.lifted], self.extent, [0.0, 0.0, 0.0]]

    @property
    def solid(self) -> bool:
        """Whether others can touch it; dirt on the road is driven over."""
        return self.group in ("vehicle", "walker") or (
            self.id.startswith("static.prop") and not self.id.startswith("static.prop.dirtdebris")
        )


@lru_cache(maxsize=1)
def catalogue() -> dict[str, Blueprint]:
    """All blueprints by id."""
    from scenic.simulators.carla import _blueprintData as of_scenic  # its public names go by the installed wheel

    ids: dict[str, list[str]] = getattr(of_scenic, "_IDS")[VERSION]  # noqa: B009
    sizes: dict[str, dict[str, float]] = getattr(of_scenic, "_DIMS")[VERSION]  # noqa: B009

    def size(name: str, otherwise: tuple[float, float, float] = _SMALL) -> tuple[float, float, float]:
        of = sizes.get(name)
        found = otherwise if of is None else (of["length"], of["width"], of["height"])
        return found if min(found) > 0.0 else otherwise

    made = [
        _vehicle(name, base, size(name))
        for base in _BASES
        for name in ids.get(f"{base}Models", ())
        if name.startswith("vehicle.")
    ]
    made += [_walker(name, size(name, _WALKER)) for name in ids["walkerModels"]]
    named = {blueprint.id for blueprint in made}
    props = sorted({*sizes, *(name for names in ids.values() for name in names)} - named)
    made += [
        Blueprint(
            id=name, size=size(name), attributes=[_role("prop"), _attribute("size", _STRING, "medium", fixed=True)]
        )
        for name in props
        if name.startswith("static.")
    ]
    made += _sensors()
    made += [
        Blueprint(id="controller.ai.walker", attributes=[_role("")]),
        Blueprint(
            id="static.trigger.friction",
            attributes=[
                _role(""),
                _attribute("friction", _FLOAT, "3.5"),
                *(_attribute(f"extent_{axis}", _FLOAT, "1.0") for axis in "xyz"),
            ],
        ),
        Blueprint(id="spectator"),
        Blueprint(id="traffic.traffic_light"),
    ]
    return {blueprint.id: blueprint for blueprint in made}


def definitions() -> list[list[Any]]:
    """The catalogue as it goes over the wire."""
    return [
        [number, blueprint.id, ",".join(blueprint.id.split(".")), blueprint.attributes]
        for number, blueprint in enumerate(catalogue().values(), start=1)
    ]


def _attribute(name: str, kind: int, value: str, choices: tuple[str, ...] = (), *, fixed: bool = False) -> Attribute:
    return [name, kind, value, list(choices), not fixed, False]


def _role(value: str, *choices: str) -> Attribute:
    return _attribute("role_name", _STRING, value, choices or (value,))


def _vehicle(name: str, base: str, size: tuple[float, float, float]) -> Blueprint:
    kind = (
        AdversaryKind.EMERGENCY_VEHICLE
        if name in _EMERGENCY
        else AdversaryKind.CAR
        if base == _VAN
        else AdversaryKind(base)
    )
    special = "emergency" if any(word in name for word in _SIRENS) else "taxi" if "taxi" in name else ""
    wheels = "2" if kind.row.manner is Manner.RIDES else "4"
    return Blueprint(
        id=name,
        kind=kind.row.scenic,
        size=size,
        mass=kind.row.mass,
        attributes=[
            _role("autopilot", "autopilot", "scenario", "ego_vehicle", "hero"),
            _attribute("color", _COLOUR, "17,37,103", ("17,37,103", "137,0,0", "190,190,190")),
            _attribute("number_of_wheels", _INT, wheels, fixed=True),
            _attribute("sticky_control", _BOOL, "true"),
            _attribute("object_type", _STRING, "", fixed=True),
            _attribute("base_type", _STRING, base, fixed=True),
            _attribute("special_type", _STRING, special, fixed=True),
            _attribute("generation", _INT, "1", fixed=True),
            _attribute("has_lights", _BOOL, "true", fixed=True),
            _attribute("has_dynamic_doors", _BOOL, "false", fixed=True),
        ],
    )


def _walker(name: str, size: tuple[float, float, float]) -> Blueprint:
    return Blueprint(
        id=name,
        kind="Pedestrian",
        size=size,
        mass=AdversaryKind.PEDESTRIAN.row.mass,
        attributes=[
            _role("pedestrian"),
            _attribute("is_invincible", _BOOL, "true"),
            _attribute("gender", _STRING, "female", fixed=True),
            _attribute("age", _STRING, "adult", fixed=True),
            _attribute("generation", _INT, "2", fixed=True),
            _attribute("speed", _FLOAT, "0.0", ("0.0", "1.4", "2.8")),
            _attribute("can_use_wheelchair", _BOOL, "false", fixed=True),
            _attribute("use_wheelchair", _BOOL, "false"),
        ],
    )


# What clients set of sensors and has no effect here: lenses and noise, with CARLA's names and defaults of its manual.
_LENS = {
    "lens_circle_falloff": "5.0", "lens_circle_multiplier": "0.0", "lens_k": "-1.0", "lens_kcube": "0.0",
    "lens_x_size": "0.08", "lens_y_size": "0.08",
}  # fmt: skip
_FILM = {
    "bloom_intensity": "0.675", "fstop": "1.4", "iso": "100.0", "gamma": "2.2", "lens_flare_intensity": "0.1",
    "shutter_speed": "200.0", "min_fstop": "1.2", "exposure_compensation": "0.0", "exposure_min_bright": "10.0",
    "exposure_max_bright": "12.0", "exposure_speed_up": "3.0", "exposure_speed_down": "1.0",
    "calibration_constant": "16.0", "focal_distance": "1000.0", "blur_amount": "1.0", "blur_radius": "0.0",
    "motion_blur_intensity": "0.45", "motion_blur_max_distortion": "0.35",
    "motion_blur_min_object_screen_size": "0.1", "slope": "0.88", "toe": "0.55", "shoulder": "0.26",
    "black_clip": "0.0", "white_clip": "0.04", "temp": "6500.0", "tint": "0.0",
    "chromatic_aberration_intensity": "0.0", "chromatic_aberration_offset": "0.0",
}  # fmt: skip
_DROPPED = {
    "atmosphere_attenuation_rate": "0.004", "dropoff_general_rate": "0.45", "dropoff_intensity_limit": "0.8",
    "dropoff_zero_intensity": "0.4", "noise_stddev": "0.0",
}  # fmt: skip
_NOISE = {
    "sensor.other.gnss": [f"noise_{part}_{kind}" for part in ("alt", "lat", "lon") for kind in ("bias", "stddev")],
    "sensor.other.imu": [
        f"noise_{kind}_{axis}" for kind in ("accel_stddev", "gyro_bias", "gyro_stddev") for axis in "xyz"
    ],
}
_SEED = _attribute("noise_seed", _INT, "0")


def _sensors() -> list[Blueprint]:
    tick = _attribute("sensor_tick", _FLOAT, "0.0")
    picture = [
        _attribute("image_size_x", _INT, "800"),
        _attribute("image_size_y", _INT, "600"),
        _attribute("fov", _FLOAT, "90.0"),
        *(_attribute(name, _FLOAT, value) for name, value in _LENS.items()),
        tick,
        _role("front"),
    ]
    film = [
        *(_attribute(name, _FLOAT, value) for name, value in _FILM.items()),
        _attribute("blade_count", _INT, "5"),
        _attribute("exposure_mode", _STRING, "histogram"),
        _attribute("enable_postprocess_effects", _BOOL, "true"),
    ]
    angles = {"upper_fov": "10.0", "lower_fov": "-30.0", "horizontal_fov": "360.0"}
    rays = [
        *(_attribute(name, _FLOAT, value) for name, value in {"range": "10.0", "rotation_frequency": "10.0"}.items()),
        *(_attribute(name, _FLOAT, value) for name, value in angles.items()),
        _attribute("channels", _INT, "32"),
        _attribute("points_per_second", _INT, "56000"),
        *(_attribute(name, _FLOAT, value) for name, value in _DROPPED.items()),
        _SEED,
        tick,
        _role("front"),
    ]
    beams = [
        *(_attribute(f"{way}_fov", _FLOAT, "30.0") for way in ("horizontal", "vertical")),
        _attribute("range", _FLOAT, "100.0"),
        _attribute("points_per_second", _INT, "1500"),
        _SEED,
        tick,
        _role("front"),
    ]
    reach = [
        _attribute("distance", _FLOAT, "5.0"),
        _attribute("hit_radius", _FLOAT, "0.5"),
        _attribute("only_dynamics", _BOOL, "false"),
        _attribute("debug_linetrace", _BOOL, "false"),
    ]
    cameras = ("depth", "semantic_segmentation", "instance_segmentation", "optical_flow", "dvs")
    return [
        Blueprint(id="sensor.camera.rgb", attributes=[*picture, *film]),
        *(Blueprint(id=f"sensor.camera.{name}", attributes=picture) for name in cameras),
        Blueprint(id="sensor.lidar.ray_cast", attributes=rays),
        Blueprint(id="sensor.lidar.ray_cast_semantic", attributes=rays),
        Blueprint(id="sensor.other.radar", attributes=beams),
        Blueprint(id="sensor.other.obstacle", attributes=[*reach, tick, _role("front")]),
        *(
            Blueprint(id=f"sensor.other.{name}", attributes=[tick, _role("front")])
            for name in ("collision", "lane_invasion")
        ),
        *(
            Blueprint(
                id=sensor,
                attributes=[*(_attribute(name, _FLOAT, "0.0") for name in names), _SEED, tick, _role("front")],
            )
            for sensor, names in _NOISE.items()
        ),
    ]
