"""How bodies move with a delay: the physics ``lagged``.

The same bicycle within the same limits as in `chatscene.simulate.embedded.dynamics`, and besides:

*Build-up.* Drive and brake follow the pedals as first-order lags. UN R157 gives 0.6 s from the first touch to full
braking; a linear ramp of that length loses as much speed as a first-order lag of 0.3 s, which is a car's here. EU
regulation 2015/68, annex III, like UN R13, annex 6, allows 0.6 s from a pedal pressed within 0.2 s to 75 % of the
brakes' pressure, which a lag of 0.6 s / ln 4 = 0.43 s just meets: that of trucks and buses. Studies of platoons take
0.1 s (Ploeg et al., ITSC 2011) to 0.5 s (Rajamani, "Vehicle Dynamics and Control") for a drive, two figures quoted at
second hand; a car's 0.3 s is our choice between them, a heavy vehicle's 0.6 s one beyond them. Brakes of two-wheelers
and of ambulances are taken for a car's.

*Understeer.* The wheel's gain falls with the speed as 1 / (1 + (v / v_ch)²), the steady state of the linear
single-track model. Characteristic speeds of passenger cars are given as 65 to 100 km/h (EUROmotor's course on
driving dynamics); ours is 22 m/s = 79 km/h, for heavy vehicles too, for want of a figure. Two-wheelers
have none: their wheel angle stands for leaning.

*Yaw lag.* The yaw rate follows the wheel as a first-order lag, whose time constant in the single-track model is
J v / (a² C_f + b² C_r), so proportional to the speed. CommonRoad's BMW 320i has 0.09 s at 20 m/s; ours is 0.1 s. Heavy
vehicles have 0.2 s, since their tyres are about half as stiff for their load, and two-wheelers 0.2 s, since they must
lean first: both our choice.

*Friction circle.* Acceleration along and across together never exceed what the road gives; if more is asked, both are
reduced in the same proportion, as with anti-lock brakes and stability control.

Walkers and things are those of the kinematic physics: a walker's acceleration is bounded there already.
"""

from __future__ import annotations

import math

from chatscene.simulate.embedded.dynamics import VehicleBody
from chatscene.terms.actors import AIR_DRAG, REVERSE_SPEED, Limits
from chatscene.terms.surroundings import DRY, GRAVITY

LAG_SPEED = 20.0  # [m/s], at which `Limits.yaw_lag` holds


class LaggedVehicle(VehicleBody):
    """A bicycle that takes time to push, to brake and to turn.

    Args:
        x: Centre [m], map frame.
        y: Centre [m], map frame.
        heading: [rad, 0 = +x, counter-clockwise].
        limits: What its kind can do.
        speed: [m/s].
        friction: Coefficient of the road.

    Attributes:
        drive: What the engine gives [m/s²], along the heading.
        braking: What the brakes give [m/s²], against the motion.
        yaw_rate: [rad/s].
    """

    __slots__ = ("braking", "drive", "yaw_rate")

    def __init__(
        self, x: float, y: float, heading: float, limits: Limits, speed: float = 0.0, friction: float = DRY
    ) -> None:
        super().__init__(x, y, heading, limits, speed)
        self.drive = 0.0
        self.braking = 0.0
        self.yaw_rate = 0.0
        self.grip = friction * GRAVITY

    def step(self, dt: float) -> None:
        """Advance by `dt` [s]."""
        if self.spin is not None:
            self._slide(self.spin, dt)
            return
        limits = self.limits
        old = self.before = self.speed
        asked = -(1.0 if self.steer > 1.0 else -1.0 if self.steer < -1.0 else self.steer) * limits.wheel_angle
        most = limits.wheel_rate * dt
        turn = asked - self.wheel
        self.wheel += most if turn > most else -most if turn < -most else turn

        drive_asked, brake_asked = self._asked()
        drive, self.drive = build_up(self.drive, drive_asked, limits.drive_lag, dt)
        braking, self.braking = build_up(self.braking, brake_asked, limits.brake_lag, dt)
        forward = old > 0.0 or (old == 0.0 and drive >= 0.0)
        along = (drive if forward else -drive) - braking  # what the tyres do [m/s²], with the motion
        speed = self._rolled(forward, along, dt)
        mean = 0.5 * (old + speed)
        yaw_rate = self._turned(mean, dt)

        together = math.hypot(along, mean * yaw_rate)
        if together > self.grip:
            share = self.grip / together
            across = mean * yaw_rate * share
            speed = self._rolled(forward, along * share, dt)
            mean = 0.5 * (old + speed)
            yaw_rate = across / mean if mean else 0.0
            self.yaw_rate *= share
        if self.target_speed is not None and (self.target_speed - old) * (self.target_speed - speed) <= 0.0:
            # A speed that was asked for is reached and held: whoever asks for speeds has no foot on a pedal.
            speed = self.target_speed
            mean = 0.5 * (old + speed)
            self.drive = self.braking = 0.0
        self._move(mean, yaw_rate, dt)
        self.speed = speed

    def _asked(self) -> tuple[float, float]:
        """Drive along the heading and braking [m/s²] that the pedals, or a wished speed, ask for."""
        limits, speed, target = self.limits, self.speed, self.target_speed
        if target is not None:
            if target == speed:
                return 0.0, 0.0
            if abs(target) > abs(speed):
                return (limits.throttle if target > speed else -limits.throttle), 0.0
            return 0.0, limits.brake
        fade = 1.0 - abs(speed) / limits.top_speed
        throttle = 0.0 if self.throttle < 0.0 else 1.0 if self.throttle > 1.0 else self.throttle
        brake = 0.0 if self.brake < 0.0 else 1.0 if self.brake > 1.0 else self.brake
        push = limits.throttle * throttle * (fade if fade > 0.0 else 0.0)
        return (-push if self.reverse else push), limits.brake * brake

    def _rolled(self, forward: bool, along: float, dt: float) -> float:
        """The speed [m/s] after `dt` under `along` [m/s²] with the motion; never through standstill."""
        old = self.speed
        rolling = (old if forward else -old) + (along - self.limits.drag - AIR_DRAG * old * old) * dt
        if rolling <= 0.0:
            return 0.0
        rolling = rolling if forward != self.backs or rolling < REVERSE_SPEED else REVERSE_SPEED
        return rolling if forward else -rolling

    def _turned(self, speed: float, dt: float) -> float:
        """The mean yaw rate [rad/s] over `dt` at a speed [m/s]; it follows what the wheel asks for."""
        if self.wheel == 0.0 and self.yaw_rate == 0.0:
            return 0.0
        limits, square = self.limits, speed * speed
        if square < 1e-12:
            self.yaw_rate = 0.0
            return 0.0
        understeer = 1.0 + square / (limits.characteristic_speed * limits.characteristic_speed)
        curvature = math.tan(self.wheel) / (limits.wheelbase * understeer)
        tightest = limits.lateral / square
        curvature = tightest if curvature > tightest else -tightest if curvature < -tightest else curvature
        # The curvature is the rear axle's; the centre is half a wheelbase ahead and a little faster.
        half = 0.5 * limits.wheelbase * curvature
        asked = speed * curvature / math.sqrt(1.0 + half * half)
        mean, self.yaw_rate = build_up(self.yaw_rate, asked, limits.yaw_lag * abs(speed) / LAG_SPEED, dt)
        return mean

    def _move(self, speed: float, yaw_rate: float, dt: float) -> None:
        """Move the centre along its arc by `dt` at a speed [m/s] and a yaw rate [rad/s]."""
        if yaw_rate == 0.0 or speed == 0.0:
            self.x += speed * self.cos * dt
            self.y += speed * self.sin * dt
            return
        slip = 0.5 * self.limits.wheelbase * yaw_rate / speed
        slip = -slip if self.backs else slip
        turned = yaw_rate * dt
        course = self.heading + math.asin(1.0 if slip > 1.0 else -1.0 if slip < -1.0 else slip) + 0.5 * turned
        self.x += speed * math.cos(course) * dt
        self.y += speed * math.sin(course) * dt
        self.heading += turned
        self.cos = math.cos(self.heading)
        self.sin = math.sin(self.heading)


def build_up(now: float, asked: float, lag: float, dt: float) -> tuple[float, float]:
    """A first-order lag over one step, exactly.

    Args:
        now: Value at the beginning.
        asked: What it tends to.
        lag: Time constant [s].
        dt: Length of the step [s].

    Returns:
        Its mean over the step, and its value at the end.
    """
    if now == asked:
        return asked, asked
    missing = now - asked
    left = missing * math.exp(-dt / lag)
    return asked + (missing - left) * lag / dt, asked + left
