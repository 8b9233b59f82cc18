"""How likely values are under an exposure, as densities in the unit cube of a program's parameters."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError
from scipy import stats

from chatscene.errors import SettingsError
from chatscene.search.samplers.unit_cube import UnitCube
from chatscene.terms.exposure import Density, Shape
from chatscene.terms.snippet import ParameterRange

Array = NDArray[np.float64]
LEAST_INSIDE = 0.01  # of a density, in the declared range: with less, the scenario is of something else


class _Uniform(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)
    shape: Literal["uniform"]
    source: str = Field(min_length=1)


class _Normal(BaseModel):
    model_config = ConfigDict(extra="forbid")
    shape: Literal["normal"]
    mean: float = Field(allow_inf_nan=False)
    deviation: float = Field(gt=0, allow_inf_nan=False)
    source: str = Field(min_length=1)


class _Lognormal(BaseModel):
    model_config = ConfigDict(extra="forbid")
    shape: Literal["lognormal"]
    median: float = Field(gt=0, allow_inf_nan=False)
    log_deviation: float = Field(gt=0, allow_inf_nan=False)
    source: str = Field(min_length=1)


_Table = Annotated[_Uniform | _Normal | _Lognormal, Field(discriminator="shape")]
_FILE: TypeAdapter[dict[str, _Table]] = TypeAdapter(dict[str, _Table])


def read_exposure(path: Path) -> tuple[Density, ...]:
    """The densities of a TOML file: a table per parameter with ``shape``, its numbers, and a ``source``.

    Raises:
        SettingsError: There is no such file, it is no TOML, or a table is not as it should be.
    """
    try:
        tables = _FILE.validate_python(tomllib.loads(path.read_text(encoding="utf-8-sig")))
    except OSError as error:
        raise SettingsError(f"the exposure {path} cannot be read: {error.strerror or error}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise SettingsError(f"the exposure {path} is not TOML: {error}") from error
    except ValidationError as error:
        first = error.errors()[0]
        told = "".join(f"{field}: " for field in first["loc"][2:]) + first["msg"]
        raise SettingsError(
            f"the exposure {path} has a table {first['loc'][0]!r} that is not a density ({told}); one is "
            'shape = "normal" with mean and deviation, "lognormal" with median and log_deviation, or "uniform", '
            "and says its source"
        ) from error
    return tuple(_density(name, table) for name, table in tables.items())


def _density(name: str, table: _Uniform | _Normal | _Lognormal) -> Density:
    shape = Shape(table.shape)
    if isinstance(table, _Normal):
        return Density(parameter=name, shape=shape, middle=table.mean, spread=table.deviation, source=table.source)
    if isinstance(table, _Lognormal):
        return Density(
            parameter=name, shape=shape, middle=table.median, spread=table.log_deviation, source=table.source
        )
    return Density(parameter=name, shape=shape, source=table.source)


@dataclass(frozen=True, slots=True)
class Exposure:
    """The densities of all parameters that can vary, as one over the unit cube of their declared ranges."""

    cube: UnitCube
    densities: tuple[Density, ...]

    def density(self, points: Array) -> Array:
        """(N,) of points, (N, dimensions): 1 everywhere if all are uniform."""
        found = np.ones(len(points))
        for column, (one, p) in enumerate(zip(self.densities, self.cube.free, strict=True)):
            if one.shape is not Shape.UNIFORM:
                width = p.high - p.low
                law = _law(one)
                found *= law.pdf(p.low + points[:, column] * width) * width / _share(law, p)
        return found

    def draw(self, count: int, rng: np.random.Generator) -> Array:
        """(count, dimensions) points."""
        points = rng.random((count, len(self.densities)))
        for column, (one, p) in enumerate(zip(self.densities, self.cube.free, strict=True)):
            if one.shape is not Shape.UNIFORM:
                law = _law(one)
                values = law.ppf(law.cdf(p.low) + points[:, column] * _share(law, p))
                points[:, column] = np.clip((values - p.low) / (p.high - p.low), 0.0, 1.0)
        return points

    def inside(self) -> dict[str, float]:
        """What share of each density that is not uniform lies in the declared range, by the parameter's name."""
        both = zip(self.densities, self.cube.free, strict=True)
        return {p.name: _share(_law(one), p) for one, p in both if one.shape is not Shape.UNIFORM}


def exposure_of(parameters: Sequence[ParameterRange], densities: Sequence[Density] = ()) -> Exposure:
    """The exposure of a program's parameters; one of which no density tells is uniform.

    Raises:
        SettingsError: A density is of no parameter of the program, or hardly any of it lies in the declared range.
    """
    cube, told = UnitCube(tuple(parameters)), {one.parameter: one for one in densities}
    if strangers := sorted(set(told) - {p.name for p in parameters}):
        have = ", ".join(p.name for p in cube.free) or "none"
        raise SettingsError(f"the exposure has {', '.join(strangers)}, and the program does not; it has {have}")
    found = Exposure(cube, tuple(told.get(p.name, Density(parameter=p.name)) for p in cube.free))
    for name, share in found.inside().items():
        if share < LEAST_INSIDE:
            p = next(p for p in cube.free if p.name == name)
            raise SettingsError(
                f"the exposure of {name} lies outside the range that the program declares, {p.low:g} to {p.high:g} "
                f"{p.unit}: {share:.2%} of it are inside; see whether the units are the same"
            )
    return found


def _law(one: Density) -> Any:
    if one.shape is Shape.NORMAL:
        return stats.norm(one.middle, one.spread)
    return stats.lognorm(one.spread, scale=one.middle)


def _share(law: Any, p: ParameterRange) -> float:
    return float(law.cdf(p.high) - law.cdf(p.low))


def as_rows(exposure: Exposure) -> list[Mapping[str, Any]]:
    """Each parameter with its density, for a file."""
    inside = exposure.inside()
    return [
        {
            "parameter": one.parameter,
            "shape": str(one.shape),
            "middle": one.middle,
            "spread": one.spread,
            "source": one.source,
            "inside": inside.get(one.parameter, 1.0),
        }
        for one in exposure.densities
    ]
