"""What every sampler owes; see `chatscene.search.sampler.Sampler`."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from chatscene.program.sample import scene_seed
from chatscene.search.sampler import Proposal, Sampler, load_sampler
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange
from chatscene.testing.contract import maker, require

_DECLARED = (
    ParameterRange(name="OPT_SPEED", low=0.0, high=5.0, unit="m/s"),
    ParameterRange(name="OPT_OFFSET", low=-10.0, high=10.0, unit="m"),
    ParameterRange(name="OPT_DELAY", low=1.0, high=3.0, unit="s"),
)
_AWKWARD = (
    ParameterRange(name="OPT_LONG", low=-0.12345678, high=0.87654321, unit="rad"),  # bounds finer than the rounding
    ParameterRange(name="OPT_FIXED", low=2.5, high=2.5, unit="m"),
    ParameterRange(name="OPT_NARROW", low=7.0, high=7.0000004, unit="m"),  # narrower than the rounding
    ParameterRange(name="OPT_WIDE", low=-1000.0, high=1e6, unit="m"),
)
_SHAPES = {
    "three parameters": _DECLARED,
    "awkward ranges": _AWKWARD,
    "one parameter": _DECLARED[:1],
    "a fixed parameter": _AWKWARD[1:2],
    "no parameters": (),
}
Values = dict[str, float]


def check_sampler(sampler: str | Callable[[], Sampler]) -> None:
    """Hold a sampler to the contract of all.

    Args:
        sampler: Its name, ``package.module:factory``, or what makes one.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        SettingsError: There is none of that name.
        MissingExtra: Its package is missing.
    """
    make = maker(sampler, load_sampler)
    for shape, declared in _SHAPES.items():
        _check_values(make, declared, shape)
    _check_history(make)
    _check_blocks(make)


def _check_values(make: Callable[[], Sampler], declared: tuple[ParameterRange, ...], shape: str) -> None:
    found = _searched(make, declared, [10, 7, 10])
    for values in (outcome.values for block in found for outcome in block):
        named = list(values) == [p.name for p in declared]
        require(named, f"a value stands for every parameter, in their order ({shape})", list(values))
        for p in declared:
            value = values[p.name]
            inside = type(value) is float and p.low <= value <= p.high
            require(inside, f"every value is a float in its declared range ({shape})", (p, value))
            rounded = value in (p.low, p.high) or value == round(value, 6)
            require(rounded, f"every value has at most six decimals, or is a bound ({shape})", value)
    again = _searched(make, declared, [10, 7, 10])
    require(found == again, f"the same input gives the same output ({shape})")
    ranges = make().propose(declared, [], count=10, seed=0).ranges
    names = [p.name for p in ranges] == [p.name for p in declared]
    require(names, f"the ranges of a proposal are those of the parameters ({shape})", ranges)


def _check_history(make: Callable[[], Sampler]) -> None:
    sizes = [10, 10, 0, 3, 10]
    whole = _searched(make, _DECLARED, sizes)
    for cut in range(1, len(sizes)):
        rest = _searched(make, _DECLARED, sizes, done=whole[:cut])
        require(rest == whole, "a search that was cut goes on as if it had not been", f"another after block {cut}")
    before = [list(block) for block in whole]
    _drawn(make().propose(_DECLARED, whole, count=10, seed=1), 5, 10)
    require(whole == before, "a proposal leaves the outcomes alone")


def _check_blocks(make: Callable[[], Sampler]) -> None:
    for sizes in ([0, 10], [0, 0, 0, 10], [1, 10], [10, 1, 0, 10]):
        last = _searched(make, _DECLARED, sizes)[-1]
        require(len(last) == 10, "blocks in which little could be placed stop no search", sizes)
    for count in (1, 2, 3):
        drawn = _drawn(make().propose(_DECLARED, [], count=count, seed=0), 0, count)
        require(len(drawn) == count, "a block can be small", count)
    for blocks in (0, 1, 4):
        done = _searched(make, _DECLARED, [10] * blocks)
        drawn = _drawn(make().propose(_DECLARED, done, count=10, seed=5), blocks, 40)
        others = len({tuple(values.values()) for values in drawn})
        # It may come back to a bound.
        require(others > 30, "a scene that cannot be placed is followed by another", f"{others} of 40 differ")
    for every in (2, 3):
        found: list[list[Outcome]] = []
        for block in range(4):  # of so many draws, one can be placed
            proposal = make().propose(_DECLARED, found, count=10, seed=scene_seed(0, f"block-{block}"))
            found.append([_outcome(values) for values in _drawn(proposal, block, 10 * every)[every - 1 :: every]])
        others = len({tuple(outcome.values.values()) for block in found for outcome in block})
        rule = "a block does not draw again what was drawn before, where some draws could not be placed"
        how = "a sampler that walks a sequence goes on by chatscene.search.samplers.unit_cube.walk_on"
        require(others > 30, rule, f"of 40 scenes {others} differ; {how}")


def _searched(
    make: Callable[[], Sampler],
    declared: Sequence[ParameterRange],
    sizes: Sequence[int],
    done: Sequence[Sequence[Outcome]] = (),
) -> list[list[Outcome]]:
    """A search in which so many scenes of each block could be placed; `done` of its blocks are taken as given."""
    history = [list(block) for block in done]
    for block in range(len(done), len(sizes)):
        proposal = make().propose(declared, history, count=10, seed=scene_seed(0, f"block-{block}"))
        history.append([_outcome(values) for values in _drawn(proposal, block, 10)[: sizes[block]]])
    return history


def _drawn(proposal: Proposal, block: int, count: int) -> list[Values]:
    return [proposal.draw(scene_seed(0, f"block-{block}/scene-{index}")) for index in range(count)]


def _outcome(values: Values) -> Outcome:
    """Something that follows from the values, whatever their ranges."""
    gap = abs(sum(values.values())) % 7.0
    return Outcome(values=values, collided=gap < 2.0, distance=gap, impact_speed=2.0 * gap, completion=gap / 7.0)
