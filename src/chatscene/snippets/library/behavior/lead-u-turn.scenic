#: description = "The car ahead brakes and makes a U-turn across the road."
#: rephrasings = [
#:   "The car in front of us slams on and flips a U-turn.",
#:   "Vehicle 2 attempted a U-turn from the travel lane in front of vehicle 1.",
#:   "Lead brakes hard, U-turn left.",
#:   "The target decelerates strongly and turns round through 180 degrees ahead of the VUT.",
#:   "It makes a big brake and is turning back the whole way on the street.",
#:   "The taxi before us sees a fare on the other side and whips around.",
#:   "The police car ahead does an about-turn right there to chase someone.",
#:   "A motorcyclist in front checks hard, then doubles back the way he came.",
#:   "The car in front dabbed the brakes and spun round to go back the way we'd come.",
#:   "The lead vehicle slowed and made a U-turn, blocking both directions of travel.",
#:   "Truck ahead slows, turns about, now facing us.",
#:   "The lead vehicle decelerates and performs a 180-degree turn across the carriageway.",
#:   "The bus before me brakes and turns around to the other direction.",
#:   "Lead in same lane flips heading by 180 and leaves in the opposite direction.",
#:   "He had forgotten something, it seemed, for he slowed, wheeled right about in front of her and headed home.",
#:   "Squad car in front is flipping around, hold back till he's facing the other way.",
#:   "he braked in front of me and pulled a full 180 across the street",
#:   "The car ahead slowed and then doubled back across both lanes.",
#:   "The leading vehicle checked its speed and, in full view of my client, put itself about to return whence it came.",
#:   "Front taxi slow down then make U-turn just like that, block whole road.",
#:   "Realises he's going the wrong way, on with the brakes and he's turning the whole shebang round in front of me.",
#:   "Direction reversal of preceding vehicle across the carriageway after braking",
#:   "GPS said TURN AROUND so he did, right in front of me",
#:   "The van in front slows and swivels about across the street.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: making a U-turn; own code"
#: [slots]
#: actions = ["u-turn"]
#: place = "road"
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it turns round"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 6.0
#: high = 7.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_DISTANCE = Range(15, 35)
param OPT_BRAKE = Range(0.6, 1)
param OPT_ADV_SPEED = Range(2.2, 3.2)
param OPT_TURN_RADIUS = Range(6, 7)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.5
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(7)
