"""The behaviors of Scenic's model for CARLA, beside those of its driving domain."""

from scenic.domains.driving.actions import *

from chatscene.world.carla_actions import SetAutopilotAction, SetWalkAction

behavior AutopilotBehavior(enabled=True, **options):
    """Drive by itself from now on."""
    take SetAutopilotAction(enabled=enabled, **options)

behavior WalkForwardBehavior(speed=0.5):
    """Walk the way it faces; ends at once, and the walk goes on."""
    take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)

behavior WalkBehavior(maxSpeed=1.4):
    """Walk by itself from now on."""
    take SetWalkAction(True, maxSpeed)

behavior CrossingBehavior(reference_actor, min_speed=1, threshold=10, final_speed=None):
    """Cross the way of another, so as to meet it.

    Waits until the other is nearer than `threshold`; then goes straight on, as fast as it must to be in the other's
    way when the other comes, though never slower than `min_speed`; at `final_speed` once the other has passed.
    """
    while (distance from self to reference_actor) > threshold:
        wait
    while True:
        seen = (self.position - reference_actor.position).rotatedBy(-reference_actor.heading)
        if seen.y <= 0:
            break
        speed = max(min_speed, seen.x * reference_actor.speed / seen.y)
        if self.isWalker:
            take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(speed)
        else:
            take SetSpeedAction(speed)
    if self.isWalker:
        take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(final_speed or min_speed)
    else:
        take SetSpeedAction(final_speed or min_speed)
