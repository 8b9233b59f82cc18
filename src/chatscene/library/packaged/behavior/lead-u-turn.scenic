#: description = "The car ahead brakes and makes a U-turn across the road."
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: making a U-turn; own code"
#: [slots]
#: actions = ["u-turn"]
#: position = "ahead"
#: place = "road"

param OPT_ADV_DISTANCE = Range(15, 35)  #: [m] how far before the start of its manoeuvre the ego is when the adversary acts
param OPT_BRAKE = Range(0.6, 1)  #: [1] how hard it brakes
param OPT_ADV_SPEED = Range(2.2, 3.2)  #: [m/s] how fast it turns round
param OPT_TURN_RADIUS = Range(6, 7)  #: [m] the radius of its turn

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.5
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(7)
