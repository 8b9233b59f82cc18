"""Behaviors every snippet may build on. None names a simulator; all act through the actions of the world model.

Speeds are in m/s, distances in m, angles in rad. A `path` is a line in driving order (`egoRoute`,
`advTrajectory`, `adjacentLane`, `oppositeLane`); beyond its end it goes straight on.
"""

import math

from chatscene.world.actions import DriveAction, SlideAction, WalkAction
from chatscene.world.control import pedals
from chatscene.world.places import distanceLeft, followingSpeed, headingLine, laneLine, progressOn, trackerFor

## Vehicles and two-wheelers

behavior DrivePath(path, speed, left=0):
    """Follow a path at a speed, `left` beside it, slower in curves. Never ends."""
    tracker = trackerFor(self, path, left)
    while True:
        take DriveAction(*tracker.controls(self.pose, speed))

behavior FollowLaneBehavior(target_speed=10, laneToFollow=None):
    """Follow a lane and the straightest lanes after it; Scenic's behavior of this name, but able to brake."""
    network = simulation().scene.workspace.network
    do DrivePath(laneLine(laneToFollow or network.laneAt(self.position)), target_speed)

behavior BrakeOnPath(path, brake=1.0, left=0):
    """Brake to a standstill along a path, and stay."""
    tracker = trackerFor(self, path, left)
    while True:
        tracker.allowed(self.pose, 0)
        take DriveAction(0, brake, tracker.steer(self.pose))

behavior ThrottleOnPath(path, throttle, left=0, top=17):
    """Follow a path with the pedal held down, heedless of curves, up to a `top` speed. Never ends."""
    tracker = trackerFor(self, path, left)
    while True:
        pose = self.pose
        tracker.allowed(pose, top)
        take DriveAction(throttle if pose[3] < top else 0, 0, tracker.steer(pose))

behavior SwerveOnPath(path, speed, left):
    """Leave the line of a path abruptly, to `left` beside it (negative: right), heedless of curves."""
    tracker = trackerFor(self, path, left)
    while True:
        pose = self.pose
        tracker.allowed(pose, speed)
        take DriveAction(*pedals(pose[3], speed), tracker.steer(pose))

behavior WeaveOnPath(path, speed, amplitude, period):
    """Swing about a path from side to side."""
    tracker = trackerFor(self, path, 0)
    start = simulation().currentTime
    while True:
        time = (simulation().currentTime - start) * simulation().timestep
        take DriveAction(*tracker.controls(self.pose, speed, amplitude * math.sin(2 * math.pi * time / period)))

behavior PaceOnPath(path, other, ahead=0, top=25, least=0):
    """Keep `ahead` in front of another actor, measured along a path beside it, between two speeds."""
    tracker = trackerFor(self, path, 0)
    near = None
    while True:
        along, near = progressOn(path, other, near)
        tracker.allowed(self.pose, top)
        wish = max(least, other.pose[3] + 0.8 * (along + ahead - tracker.along))
        take DriveAction(*tracker.controls(self.pose, min(wish, top)))

behavior KeepStation(path, other, least=5):
    """Hold the present distance to another actor along a path, as traffic in the next lane does."""
    do PaceOnPath(path, other, progressOn(path, self)[0] - progressOn(path, other)[0], least=least)

behavior FollowTraffic(path, speed):
    """Follow a path at a speed as a careful driver: keeps its distance from whoever is ahead on it. Never ends."""
    tracker = trackerFor(self, path, 0)
    others = [other for other in simulation().objects if other.body is not self.body]
    while True:
        wish = followingSpeed(path, self, others, speed)
        take DriveAction(*tracker.controls(self.pose, wish))

behavior WaitFor(other, way, speed):
    """Stand before a junction until the ego, the `other`, has passed it, then drive on with the traffic."""
    while distanceLeft(other.route, other, other.route.exitAt) > -8:
        take DriveAction(0, 1, 0)
    do FollowTraffic(way, speed)

behavior ReverseStraight(speed):
    """Drive straight backwards."""
    while True:
        take DriveAction(*pedals(-self.pose[3], speed), 0, True)

behavior ReverseTurning(speed, steer):
    """Drive backwards with the wheel turned: `steer` in [-1, 1], positive to the right. Never ends."""
    while True:
        take DriveAction(*pedals(-self.pose[3], speed), steer, True)

behavior TurnOff(angle, speed, radius=6):
    """Turn by an angle (positive: to the left) on a circle, as into a drive or round to go back, and end."""
    steer = -math.copysign(min(1, math.atan(self.wheelbase / radius) / self.wheelAngle), angle)
    before, turned = self.pose[2], 0
    while abs(turned) < abs(angle):
        take DriveAction(*pedals(self.pose[3], speed), steer)
        turned, before = turned + math.remainder(self.pose[2] - before, 2 * math.pi), self.pose[2]

behavior Slide(spin, brake):
    """Lose grip: slide straight on, turning by `spin` for each metre (positive: to the left), to a standstill."""
    while True:
        take SlideAction(spin, brake)

behavior Park():
    """Stand still with the brake on."""
    while True:
        take DriveAction(0, 1, 0)

## Anyone: walkers and riders

behavior MoveAhead(speed, turn=0):
    """Go straight on, `turn` to the left of where the actor faces now. Never ends."""
    x, y, heading, _ = self.pose
    if self.isWalker:
        while True:
            take WalkAction(heading + turn, speed)
    else:
        do DrivePath(headingLine(x, y, heading + turn), speed)

behavior Halt():
    """Stop as fast as the actor can, and stay."""
    if self.isWalker:
        while True:
            take WalkAction(self.pose[2], 0)
    else:
        do Park()
