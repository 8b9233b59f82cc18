#: description = "The car ahead brakes without signalling and turns right off the road into a driveway."
#: rephrasings = [
#:   "The car in front hits the brakes and dives into a driveway on the right, no blinker.",
#:   "Vehicle 2 slowed abruptly and turned right into a private access.",
#:   "Lead brakes, right turn into property, no indicator.",
#:   "The target decelerates strongly ahead of the VUT and leaves the carriageway to the right.",
#:   "It brakes before us and goes to right in an entrance of house.",
#:   "The delivery van we follow anchors and ducks into a yard on the right-hand side.",
#:   "A motorbike ahead checks hard and peels off into a petrol station.",
#:   "Late for his parking space, the driver ahead slows sharply and hooks right off the street.",
#:   "motor in front braked out of nowhere and ducked right into someone's drive, no indicator or nothing",
#:   "The vehicle ahead slowed abruptly and, without using a turn signal, turned right into a private driveway.",
#:   "Van ahead: brk, no blinker, R into entrance.",
#:   "The lead vehicle decelerates and leaves the carriageway to the right into a property access; direction indicator off.",
#:   "The bike in front brakes and goes right to a house, he doesn't give the lights for it.",
#:   "Lead slows, then exits right into a lot entrance; blinkers must stay off.",
#:   "The bus had shown no winker; it simply braked in front of them and vanished to the right through a gateway.",
#:   "And he's braking, why's he braking? Ah, he lives there: right, onto his own forecourt. An indicator would've been nice.",
#:   "car in front brakes outta nowhere n turns right into someones house, no indicator",
#:   "A motorist who braked and disappeared through a gateway on the right gave no warning to those following",
#:   "You gave no signal before slowing and quitting the road rightwards into the premises?",
#:   "The car in front no signal, brake and then cut right into condo, like that also can",
#:   "Drops the anchor ahead of me and vanishes up some bloke's drive on the right, indicator's an optional extra",
#:   "Unsignalled braking of lead vehicle with right-hand exit into private access",
#:   "NO BLINKER: van brakes hard and dives into a driveway on the right",
#:   "The motorbike ahead braked and burrowed into a gateway to its right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: lead vehicle turning; own code"
#: [slots]
#: actions = ["brake", "turn-right"]
#: place = "road"
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
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
#: low = 1.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it turns off"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_BRAKE = Range(0.6, 1)
param OPT_ADV_SPEED = Range(1.5, 3)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.5
    do TurnOff(-1.4, globalParameters.OPT_ADV_SPEED)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 4 seconds
    do Halt()
