#: adversaries = ["bicycle", "motorcycle"]
#: origin = "own code"
#: [slots]
#: position = "ahead"
#: maneuver = "straight"
#: place = "road"
#: [variants]
#: rider-turn-left-unsignalled = { actions = ["brake", "swerve", "turn-left"], adv_speed = [1.6, 2.4], adv_distance = [-20, 5], react_distance = [12, 22], turn_radius = [2.5, 4], angle = 1.5 }
#: rider-turn-round-ahead      = { actions = ["brake", "u-turn", "oncoming"], adv_speed = [1.8, 2.6], adv_distance = [-20, 5], react_distance = [20, 32], turn_radius = [1.8, 2.4], angle = 3.1 }
#: [descriptions]
#: rider-turn-left-unsignalled = "The rider ahead suddenly brakes and turns off to the left across the road without a hand signal."
#: rider-turn-round-ahead      = "The rider ahead brakes, whips round in a U-turn and comes back past the ego."

param OPT_ADV_SPEED = Range$adv_speed  #: [m/s] how fast it turns
param OPT_ADV_DISTANCE = Range$adv_distance  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts at the latest
param OPT_REACT_DISTANCE = Range$react_distance  #: [m] how far behind it the ego is when it acts
param OPT_TURN_RADIUS = Range$turn_radius  #: [m] the radius of its turn

behavior AdvBehavior():
    # It keeps right, as if to let the ego pass.
    do DrivePath(advTrajectory, 5, -1.9) until self.pose[3] > 4.4 and (headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE or distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE)
    do BrakeOnPath(advTrajectory, 0.5, -1.9) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do TurnOff($angle, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
