"""Programs of Scenic 2 become programs of Scenic 3, and nothing is changed in silence."""

import pytest

from chatscene.simulate.confined.scenic_2 import rewrite

HEAD = "model scenic.simulators.carla.model\n"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("ego = Car\n", "ego = new Car\n"),
        ("ego = Car at (1, 2),\n    with behavior B()\n", "ego = new Car at (1, 2),\n    with behavior B()\n"),
        ("Truck  ahead of ego by 5  # one\n", "new Truck  ahead of ego by 5  # one\n"),
        ("spot = OrientedPoint in lane.centerline\n", "spot = new OrientedPoint in lane.centerline\n"),
        ("x = [Car at p, Cone left of ego by 1]\n", "x = [new Car at p, new Cone left of ego by 1]\n"),
        ("ego = Car with heading 90 deg\n", "ego = new Car facing 90 deg\n"),
        ("p = lane.centerline.project(q).coords[0]\n", "p = lane.centerline.project(q)\n"),
        (
            "monitor Lights:\n    wait\nego = Car\n",
            "monitor Lights():\n    wait\nego = new Car\nrequire monitor Lights()\n",
        ),
        (
            "scenario Main():\n    setup:\n        monitor M:\n            wait\n        ego = Car\n",
            "scenario Main():\n    setup:\n        monitor M():\n            wait\n        require monitor M()\n"
            "        ego = new Car\n",
        ),
        ("monitor A:\n    wait\nmonitor B:\n    wait", "monitor A():\n    wait\nmonitor B():\n    wait\nAB"),
    ],
)
def test_what_scenic_3_writes_otherwise_is_rewritten(before: str, after: str) -> None:
    after = after.replace("AB", "require monitor A()\nrequire monitor B()\n")
    done = rewrite(HEAD + before)
    assert done.source == HEAD + after
    assert rewrite(done.source).changes == ()  # it is a program of Scenic 3 now


@pytest.mark.parametrize(
    "line",
    [
        "near = withinDistanceToAnyObjs(self, Car)\n",
        "if isinstance(thing, Pedestrian):\n    pass\n",
        "name = 'Car at home'  # Car at home\n",
        "from chatscene.world.carla_model import Car\n",
        "class Tram(Bus):\n    pass\n",
        "kind = ManeuverType.LEFT_TURN\n",
        "n = Range(1, 2)\n",
        "behavior B():\n    do FollowLaneBehavior until self.lane is None\n",
        "(ego = Car\n",
        "",
    ],
)
def test_what_means_the_same_to_both_stays_as_it_is(line: str) -> None:
    done = rewrite(line)
    assert (done.source, done.changes, done.diff("x")) == (line, (), "")


def test_a_program_of_scenic_3_that_lacks_new_in_one_place_is_not_taken_for_an_older_one() -> None:
    assert rewrite("ego = new Car\nother = Car at (1, 2)\n").changes == ()


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            "way = [a, b]\nbehavior B():\n    do C() until (distance from self to way) < 1\n",
            "way = [a, b]\nbehavior B():\n    do C() until (min([distance from self to part for part in way])) < 1\n",
        ),
        (
            "way = [a, b]\nx = distance from f(ego, way) to way\n",
            "way = [a, b]\nx = min([distance from f(ego, way) to part for part in way])\n",
        ),
        ("behavior B():\n    ego.steering = -0.8\n    wait\n", "behavior B():\n    pass\n    wait\n"),
        ("part = 3\nway = [a]\nx = distance from e to way\n", "part = 3\nway = [a]\nx = min([PIECE])\n"),
        (
            "param N = Range(3, 9)\nfor _ in range(globalParameters.N):\n    wait\n",
            "param N = Range(3, 9)\nfor _ in range(int(globalParameters.N)):\n    wait\n",
        ),
        (
            "behavior B():\n    n = Range(3, 9)\n    x = range(n)\n",
            "behavior B():\n    n = Range(3, 9)\n    x = range(int(n))\n",
        ),
        (
            "n = Range(3, 9)\ndef f(k):\n    return range(n)\n",
            "n = Range(3, 9)\ndef f(k):\n    return range(int(n))\n",
        ),
        ("N = Normal(3, 9)\nx = range(N)\n", "N = Normal(3, 9)\nx = range(int(N))\n"),
        ("behavior B():\n    do SetSpeedAction(0)\n", "behavior B():\n    take SetSpeedAction(0)\n"),
    ],
)
def test_what_neither_scenic_runs_is_mended_in_programs_of_both(before: str, after: str) -> None:
    after = after.replace("PIECE", "distance from e to piece for piece in way")
    assert rewrite("x = new Car\n" + before).source == "x = new Car\n" + after
    assert rewrite(before).source == after


@pytest.mark.parametrize(
    "text",
    [
        "way = region\nx = distance from ego to way\n",
        "way = [a]\nx = distance from ego to way[0]\n",
        "way = [a]\nx = distance to way\n",
        "N = DiscreteRange(3, 9)\nfor _ in range(N):\n    wait\n",
        "N = Range(3, 9)\nfor _ in range(round(N)):\n    wait\n",
        "behavior A():\n    n = Range(3, 9)\nbehavior B(n):\n    for _ in range(n):\n        wait\n",
        "behavior A():\n    n = Range(3, 9)\ndef f():\n    n = 4\n    return range(n)\n",
        "n = Range(3, 9)\ndef f(n):\n    return range(n)\n",
        "n = Range(3, 9)\nparam n = 4\nx = range(globalParameters.n)\n",
        "ego = new Car with speed Range(3, 9), with weight f(n=Range(1, 2))\nn = 4\nx = range(n)\n",
        "behavior B():\n    do SetSpeed(0)\n",
        "goal = [10, 20]\nrequire (distance from ego to goal) > 5\n",  # a place
        "one = [a, b][0]\nrequire (distance from ego to one) > 5\n",
        "behavior B():\n    ego.speed = 3\n",  # which is known, and is refused
        "behavior B():\n    ego.tired = 3\n    take SetSpeedAction(ego.tired)\n",
        "behavior B():\n    ego.tired = counted()\n",
        "behavior B():\n    x = f(ego.tired == 3)\n",
        "behavior FollowAction(n):\n    wait\nbehavior B():\n    do FollowAction(3)\n",
    ],
)
def test_what_runs_is_not_mended(text: str) -> None:
    assert rewrite(text).changes == ()


def test_a_property_that_nothing_reads_is_told_where_it_was_set() -> None:
    done = rewrite("x = new Car\nbehavior B():\n    ego.steering = 0.5\n    self.steering = -0.8\n    wait\n")
    assert done.reasons() == (
        "lines 3, 4: no world model has .steering, and nothing reads it, so that to set it does nothing",
    )


def test_every_change_is_shown_with_its_lines_and_its_reason() -> None:
    things = "a = Car at (1, 2)\nb = Car at (3, 4)\nc = Car at (5, 6)\nd = Car with heading 1\n"
    done = rewrite(f"{HEAD}ego = Car\n{things}")
    assert done.reasons() == (
        "lines 2, 3, 4 and 2 more: Scenic 3 places things with `new`",
        "line 6: Scenic 3 turns a thing with `facing`, and its heading follows",
    )
    assert done.diff("a.scenic").splitlines()[:5] == [
        "--- a.scenic",
        "+++ a.scenic, as it is run",
        "@@ -2,5 +2,5 @@",
        "-ego = Car",
        "-a = Car at (1, 2)",
    ]
