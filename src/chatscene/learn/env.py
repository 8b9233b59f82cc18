"""A Gymnasium environment over routes and scenes: what an ego learns to drive in.

One drive at a time per process (Scenic's rule): whatever else is simulated in the same process takes the drive away
from an environment, which has to be reset then. In the simulator ``native`` Scenic places a scene and is done with it,
so that there any number of drives go on side by side. `vector_env` makes several environments of either kind.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.observation import ALLOWED, OBSERVATIONS, check_preset
from chatscene.ego.policy import FAR, PEDALS, TURNED, controls, is_cut_off, tell_cut_off
from chatscene.errors import EgoError, MissingExtra, SettingsError, no_such
from chatscene.learn.reward import DESIRED_SPEED, REWARDS, Moment, total
from chatscene.maps.drawing import map_drawing
from chatscene.maps.loading import load_roads
from chatscene.maps.network import resolve_map
from chatscene.maps.picture import NEAR, Camera, draw_frame, draw_ground
from chatscene.program.ordinary import Course, ordinary_courses
from chatscene.settings import MANY, SPEEDS, SimulationSettings, finite, whole
from chatscene.simulate.native.simulator import COLLIDED, Together
from chatscene.simulate.simulator import Session, Simulator, load_simulator
from chatscene.terms.episode import Ending, Episode
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene

try:
    import gymnasium
    from gymnasium import spaces
except ImportError as error:
    raise MissingExtra("the driving environment needs gymnasium", extra="gym") from error

Array = NDArray[np.float32]
BOUND = 2000.0  # [m], [m/s]: farther or faster than anything gets within a drive
OBSERVED, REWARDED = "safebench", "progress"  # if nothing else is asked for
TRIES = 100  # draws of a scene that cannot be placed before a course is given up


class DrivingEnv(gymnasium.Env[Array, Array]):
    """Drive courses: programs on their routes, with scenes drawn from the programs' ranges.

    Observation: a preset of `chatscene.ego.observation`, float32.
    Action: acceleration and steering in [-1, 1], mapped by one of `PEDALS`.
    Reward: the sum of the terms of one of `REWARDS`; ``info["reward"]`` has each by name.
    Terminated: the ego collided. Truncated: anything else that ends a drive. To arrive is no failure and no goal of
    its own — the route ends, driving does not — so a learner must bootstrap from the last observation there.

    ``info`` at the end of a drive has ``ending``, ``completion`` (share of the route, [0, 1]), ``collision`` and
    ``scene`` (its id).

    Args:
        courses: What to drive; the ordinary drives of the map if None.
        map_name: As on the command line.
        ego_observation: What the ego sees, a preset of `chatscene.ego.observation`.
        pedals: The mapping of actions.
        reward: The reward.
        speed: What the ego is to drive at [km/h] on ordinary drives, within the limits of the roads, and everybody in
            proportion; None for those of before. Courses that are given say it themselves.
        settings: Step and limits.
        simulator: Where programs run; that of the settings on the map if None.
        render_mode: ``rgb_array``, and `render` gives a picture of the ego and what is around it; or None.

    Raises:
        SettingsError: A preset, mapping or reward of that name does not exist, or there is nothing to drive.
        MapError: The map is missing or broken.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}  # noqa: RUF012 - Gymnasium's attribute

    def __init__(
        self,
        courses: Sequence[Course] | None = None,
        *,
        map_name: str | Path = "town",
        ego_observation: str = OBSERVED,
        pedals: str = "safebench",
        reward: str = REWARDED,
        speed: float | None = None,
        settings: SimulationSettings | None = None,
        simulator: Simulator | None = None,
        render_mode: str | None = None,
    ) -> None:
        for what, name, known in (("pedals", pedals, PEDALS), ("reward", reward, REWARDS)):
            if name not in known:
                raise SettingsError(no_such(what, name, known))
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise SettingsError(no_such("render mode", str(render_mode), self.metadata["render_modes"]))
        self.render_mode = render_mode
        self._preset = check_preset(ego_observation)
        self._pedals = pedals
        self._reward = REWARDS[reward]
        self._map_path = resolve_map(str(map_name))
        self._simulator = simulator or load_simulator(self._map_path, settings or SimulationSettings())
        wanted = None if speed is None else finite("speed", speed, *SPEEDS) / 3.6
        self.courses = tuple(courses) if courses is not None else ordinary_courses(self._simulator, wanted)
        if not self.courses:
            raise SettingsError("there is nothing to drive: give at least one course")
        size = OBSERVATIONS[ego_observation]
        self.observation_space = spaces.Box(-BOUND, BOUND, (size,), np.float32)
        self.action_space = spaces.Box(-1.0, 1.0, (2,), np.float32)
        # A model that is saved keeps its spaces, and with them what its actions mean (`chatscene.ego.files`).
        setattr(self.observation_space, "preset", ego_observation)  # noqa: B010 - no attribute of Gymnasium's
        setattr(self.action_space, "pedals", pedals)  # noqa: B010 - no attribute of Gymnasium's
        self._drive: Session | None = None
        self._scene_id = ""
        self._wanted: float | None = None
        self._route: Route
        self._drawing: dict[str, Any] | None = None

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Start a drive.

        Args:
            seed: Of everything that is drawn from now on.
            options: ``course``: the index of the one to drive, else one is drawn; ``values``: the scene's parameter
                values, else they are those of the course, or drawn if it has none.

        Raises:
            SettingsError: There is no such course, or none of `TRIES` scenes could be placed.
        """
        super().reset(seed=seed)
        options = options or {}
        index = options.get("course")
        if index is None:
            index = int(self.np_random.integers(len(self.courses)))
        index = whole("course", index, 0, len(self.courses) - 1)
        course = self.courses[index]
        values: Mapping[str, float] | None = options.get("values", course.values)
        self.close()
        reason = ""
        for _ in range(TRIES if values is None else 1):
            scene = self._scene(course, values)
            drive = self._simulator.open(course.program, scene, observation=self._preset, pedals=self._pedals)
            if not isinstance(drive, Rejected):
                self._drive = drive
                self._scene_id = scene.id
                self._wanted = course.program.wanted_speed
                self._route = self._simulator.route_in(course.program, scene)
                self._drawing = None
                return self._shown(drive), {"scene": scene.id, "values": dict(scene.values)}
            reason = drive.reason
        raise SettingsError(f"no scene of course {index} ({course.program.scenario_id}) could be placed: {reason}")

    def _scene(self, course: Course, values: Mapping[str, float] | None) -> Scene:
        program = course.program
        drawn = {p.name: round(float(self.np_random.uniform(p.low, p.high)), 6) for p in program.parameters}
        return Scene(
            id=f"{program.scenario_id}/route-{course.route:02d}/drive",
            scenario_id=program.scenario_id,
            route=course.route,
            block=0,
            seed=0,
            values=drawn if values is None else dict(values),
        )

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Drive one step of 0.1 s.

        Raises:
            EgoError: The action is not two finite numbers, no drive is in progress, or something else was
                simulated in this process meanwhile.
        """
        drive = self._going_on()
        before, desired = drive.along, self._desired(drive)
        drive.step(action)
        if is_cut_off(action):
            tell_cut_off("the policy", action)
        ended = drive.ending
        moment = Moment(
            collided=ended is Ending.COLLISION,
            speed=drive.speed,
            lateral=drive.offset,
            steer=controls(action)[2],
            progress=drive.along - before,
            desired=desired,
        )
        terms = self._reward(moment)
        info: dict[str, Any] = {"reward": terms}
        terminated, truncated = moment.collided, False
        if ended is not None or drive.rejection:
            truncated = not terminated
            info |= self.ended()
        return self._shown(drive), float(total(terms)), terminated, truncated, info

    def ended(self) -> dict[str, Any]:
        """What ``info`` has at the end of a drive.

        Raises:
            EgoError: There is no drive in progress.
        """
        drive = self._in_progress()
        ending = drive.ending
        return {
            "ending": str(ending) if ending is not None else "rejected",
            "completion": 1.0 if ending is Ending.ARRIVED else min(max(drive.along / self._route.length, 0.0), 1.0),
            "collision": ending is Ending.COLLISION,
            "scene": self._scene_id,
        }

    def _shown(self, drive: Session) -> Array:
        """What the ego is shown now; as the speed allowed at most what is wanted of it, as to any network."""
        seen = drive.observation.astype(np.float32)
        seen[ALLOWED:] = np.minimum(seen[ALLOWED:], self.wanted)
        return seen

    @property
    def drive(self) -> Session | None:
        """The drive in progress, if there is one."""
        return self._drive

    @property
    def wanted(self) -> float:
        """The speed [m/s] that the ego is not to exceed, as far as its program says it."""
        return DESIRED_SPEED if self._wanted is None else self._wanted

    def _desired(self, drive: Session) -> float:
        """The speed [m/s] that the ego is not to exceed: what its program wants, and no more than it is shown."""
        shown = self._shown(drive)[ALLOWED:].tolist() if OBSERVATIONS[self._preset] > ALLOWED else ()
        return min([self.wanted, *shown])

    def _going_on(self) -> Session:
        drive = self._in_progress()
        if drive.ending is not None:
            raise EgoError("no drive is in progress: call reset first")
        return drive

    def _in_progress(self) -> Session:
        if self._drive is None:
            raise EgoError("no drive is in progress: call reset first")
        return self._drive

    def render(self) -> NDArray[np.uint8] | None:  # pyright: ignore[reportIncompatibleMethodOverride]
        """The ego and what is around it, now: (360, 640, 3), red, green, blue; None without a `render_mode`.

        Raises:
            EgoError: There is no drive in progress.
        """
        if self.render_mode is None:
            return None
        episode = self.episode("")
        if self._drawing is None:
            points = self._route.line.points
            (west, south), (east, north) = points.min(axis=0) - NEAR, points.max(axis=0) + NEAR
            self._drawing = map_drawing(load_roads(self._map_path), (west, south, east, north))
        x, y = float(episode.ego_track.x[-1]), float(episode.ego_track.y[-1])
        camera = Camera.around(x, y)
        frame = draw_frame(camera, draw_ground(camera, self._drawing), episode, len(episode.ego_track.x) - 1)
        return np.asarray(frame)

    def episode(self, ego: str) -> Episode:
        """The drive in progress, as far as it came, with its tracks and events.

        Raises:
            EgoError: There is none.
        """
        return self._in_progress().episode(self._scene_id, ego)

    def close(self) -> None:
        """End the drive in progress."""
        if self._drive is not None:
            self._drive.close()
            self._drive = None


class SideBySide(gymnasium.vector.SyncVectorEnv):
    """Environments whose drives the engine steps in one call, each as it would be alone.

    Where the engine does not cover the drive of one, all are stepped one after the other; so is one that is alone.
    """

    def __init__(self, made: Sequence[Callable[[], DrivingEnv]], *, preset: str, reward: str) -> None:
        super().__init__(made)
        self._reward, self._size = REWARDS[reward], OBSERVATIONS[preset]
        self._driving: list[Any] = list(self.envs)
        self._together = Together(len(made), self._size)
        self._drives: list[Session | None] = [None] * len(made)  # that are in their places in it
        self._wanted = np.full(len(made), DESIRED_SPEED)

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Drive one step in each whose drive goes on, and begin anew in the others; as `SyncVectorEnv`.

        Raises:
            EgoError: As for `DrivingEnv.step`.
        """
        self._take_up()
        given, places = np.asarray(actions, np.float64), np.flatnonzero(~self._autoreset_envs)
        right = given.shape == (self.num_envs, 2) and bool(np.isfinite(given).all())
        if self.num_envs == 1 or not right or not self._together.there[places].all():
            return super().step(actions)
        self._rewards[:], self._terminations[:], self._truncations[:] = 0.0, False, False
        infos: dict[str, Any] = {}
        for place in np.flatnonzero(self._autoreset_envs).tolist():
            self._observations[place], info = self._driving[place].reset()
            infos = self._add_info(infos, info, place)
        if places.size:
            infos = self._step(places, given[places], infos)
        self._autoreset_envs = self._terminations | self._truncations
        seen = self._observations.copy() if self.copy else self._observations
        return seen, self._rewards.copy(), self._terminations.copy(), self._truncations.copy(), infos

    def _take_up(self) -> None:
        """Put into its place each drive that began since the last step, whoever began it."""
        drives = [env.drive for env in self._driving]
        if drives == self._drives:
            return
        for place, (drive, before) in enumerate(zip(drives, self._drives, strict=True)):
            if drive is not before:
                self._together.put(place, drive)
                self._wanted[place] = self._driving[place].wanted
        self._drives = drives

    def _step(self, places: NDArray[np.int64], actions: NDArray[np.float64], infos: dict[str, Any]) -> dict[str, Any]:
        """Drive one step in some; what there is to tell of it beside what is told."""
        desired = self._wanted[places]
        if self._size > ALLOWED:
            desired = np.minimum(desired, self._observations[places, ALLOWED])
        made = self._together.step(places, actions)
        far = np.flatnonzero((np.abs(actions) > FAR).any(axis=1))
        if far.size:
            tell_cut_off("the policy", actions[far[0]])
        collided = made.ending == COLLIDED
        terms = self._reward(
            Moment(
                collided=collided,
                speed=made.speed,
                lateral=made.offset,
                steer=TURNED * actions[:, 1].clip(-1.0, 1.0),
                progress=made.along - made.before,
                desired=desired,
            )
        )
        seen = made.seen.astype(np.float32)
        seen[:, ALLOWED:] = np.minimum(seen[:, ALLOWED:], self._wanted[places, None])
        self._observations[places] = seen
        self._rewards[places] = total(terms)
        self._terminations[places], self._truncations[places] = collided, (made.ending != 0) & ~collided
        there = np.zeros(self.num_envs, np.bool_)
        there[places] = True
        told: dict[str, Any] = {}
        for name, values in terms.items():
            told[name], told[f"_{name}"] = np.zeros(self.num_envs), there.copy()
            told[name][places] = values
        infos |= {"reward": told, "_reward": there}
        for place in places[made.ending != 0].tolist():
            infos = self._add_info(infos, self._driving[place].ended(), place)
        return infos


def vector_env(
    count: int,
    *,
    map_name: str | Path = "town",
    speed: float | None = None,
    settings: SimulationSettings | None = None,
    **arguments: Any,
) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
    """Several environments, each of which is to the bit what it would be alone.

    In the simulator ``native`` they live side by side in this process and share what it compiled; in any other each has
    a process of its own. An environment whose drive ended begins anew with the next step, as Gymnasium has it
    (``AutoresetMode.NEXT_STEP``).

    Args:
        count: How many.
        map_name: As of `DrivingEnv`.
        speed: As of `DrivingEnv`.
        settings: As of `DrivingEnv`.
        arguments: What else `DrivingEnv` takes, but a simulator.

    Raises:
        SettingsError: As for `DrivingEnv`, or there is to be none.
    """
    settings = settings or SimulationSettings()
    count = whole("count", count, *MANY)
    if settings.simulator != "native":
        made = partial(DrivingEnv, map_name=map_name, speed=speed, settings=settings, **arguments)
        return gymnasium.vector.AsyncVectorEnv([made] * count, context="spawn")
    simulator = load_simulator(resolve_map(str(map_name)), settings)
    if (courses := arguments.pop("courses", None)) is None:  # each knows them; to find them is work
        wanted = None if speed is None else finite("speed", speed, *SPEEDS) / 3.6
        courses = ordinary_courses(simulator, wanted)
    made = partial(DrivingEnv, courses, map_name=map_name, simulator=simulator, **arguments)
    preset, reward = arguments.get("ego_observation", OBSERVED), arguments.get("reward", REWARDED)
    return SideBySide([made] * count, preset=preset, reward=reward)
