#: description = "The car ahead stops abruptly, waits a moment and drives off again."
#: rephrasings = [
#:   "The car in front stops dead for no reason, thinks about it and then takes off.",
#:   "Vehicle 2 made a sudden stop, remained at rest briefly and then departed at normal speed.",
#:   "Lead stops hard, short pause, pulls away.",
#:   "The target brakes to standstill, dwells, and accelerates away from the VUT.",
#:   "He is stopping suddenly in front, waits two seconds and goes away fast.",
#:   "The courier's van ahead slams to a halt, somebody looks at the map, off it goes.",
#:   "The motorbike leading us halts without notice, then zips away.",
#:   "A fire engine before us pulls up short and presently gets going again.",
#:   "The cab in front stopped dead, sat there for a sec, then toddled off again.",
#:   "The lead vehicle made a sudden stop, remained stationary briefly, and then resumed travel.",
#:   "MC ahead: abrupt halt, short wait, moves on.",
#:   "The lead vehicle brakes to standstill, holds for a short dwell time and then moves off.",
#:   "Bus before me stops quick, waits little bit and drives again.",
#:   "Lead: stop, dwell, go; once only and no reversing.",
#:   "She nearly ran into him, for he had pulled up without cause; a moment later he was on the move again.",
#:   "He's pulled up sharp, just wait behind, give him a tick, and there he's rolling again.",
#:   "car in front stopped outta nowhere for like 2 sec then kept going",
#:   "The leading bus pulled up without warning, paused and carried on with its journey.",
#:   "The car ahead ceased moving quite suddenly, tarried briefly, and thereafter continued in the same direction.",
#:   "Front scooter stopped all of a sudden, waited small time, then went ahead.",
#:   "Stops dead to read a door number, I'm standing on my brakes, and off he swans again.",
#:   "Unanticipated transient standstill of preceding vehicle, followed by renewed forward departure",
#:   "RANDOM STOP IN FRONT OF ME, then drives on as if nothing",
#:   "The van in front jolts to a halt, lingers and moves along.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "hesitate", "accelerate"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.8
#: high = 3.0
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives afterwards"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.5, 1)
param OPT_STOP_TIME = Range(0.8, 3)
param OPT_ADV_SPEED = Range(6, 10)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
