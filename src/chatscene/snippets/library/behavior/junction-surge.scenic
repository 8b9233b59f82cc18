#: description = "The car goes through the intersection in bursts of throttle and brake."
#: rephrasings = [
#:   "A vehicle crosses the junction with a pace that keeps rising and falling.",
#:   "The adversary accelerates, brakes, and accelerates again on the crossroads.",
#:   "The crossing driver cannot settle on a speed.",
#:   "Jerking forward and checking itself, the car passes before the ego.",
#:   "The other car alternates gas and brake while it crosses.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["accelerate", "brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.0
#: high = 2.0
#: unit = "s"
#: meaning = "how long each phase lasts"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.6, 1)
param OPT_BRAKE = Range(0.4, 1)
param OPT_ADV_PERIOD = Range(1, 2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_ADV_PERIOD seconds
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for 0.5 * globalParameters.OPT_ADV_PERIOD seconds
