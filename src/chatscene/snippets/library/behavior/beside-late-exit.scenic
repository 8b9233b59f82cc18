#: description = "The car cuts across in front of the ego at the last moment and leaves the road to the right."
#: rephrasings = [
#:   "He remembers his exit too late and slices right across us to make it.",
#:   "Vehicle 2 crossed the lane of vehicle 1 from left to right in order to leave the roadway.",
#:   "Late exit: crosses our lane and off to the right.",
#:   "The target cuts through the path of the VUT and turns out of the carriageway on the right-hand side.",
#:   "He wanted to go out right but he is too left, so he crosses us quickly.",
#:   "A van shoots over our bow into the petrol station.",
#:   "The bus nearly misses its turning and carves across our lane for it.",
#:   "A motorcyclist dives from the fast lane over ours and off the road.",
#:   "Silly sod in the next lane left it till the last second for his turning and dived across my nose to get off on the right.",
#:   "Unit 2 made an abrupt right exit from the left lane, crossing directly ahead of Unit 1.",
#:   "Truck alongside misses turn-off nearly, slices over ego's bow, off to R.",
#:   "The adjacent target crosses the VUT's path at minimal TTC in order to take the right-hand exit.",
#:   "He was in other lane, very late he sees his exit and passes before my nose to go out right.",
#:   "Neighbour-lane actor takes a last-moment right exit through our lane, doesn't stay in it; short TTC, then clears.",
#:   "He had nearly missed the slip road, and so he swept over right under her bonnet and disappeared down it.",
#:   "Watch the van next to you, he's just spotted his exit on the right and he's going to chop straight across us to make it.",
#:   "omg she nearly missed her exit n just yeeted across me to the right",
#:   "A van driver who almost overshot his turn-off sliced past the nose of a family car to make the ramp on the right.",
#:   "You realised you were about to miss your exit to the right, and you drove across the front of the plaintiff to reach it, correct?",
#:   "Aiyo, last minute then he want to exit right, cut my front and go off like that.",
#:   "Remembers his turning at the death, don't he, and comes straight over my front wheels for the right-hand slip.",
#:   "Eleventh-hour departure to the right across ego's front by vehicle from adjacent lane.",
#:   "TRUCK ALMOST MISSES EXIT, CROSSES MY NOSE TO MAKE IT",
#:   "The car alongside lunged for the right-hand exit under our nose.",
#: ]
#: adversaries = ["car", "motorcycle", "truck", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute", "leftLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "turn-right"]
#: side = "left"
#: leader = false
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 4.0
#: high = 11.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it turns off"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_AHEAD = Range(4, 11)
param OPT_ADV_SPEED = Range(5, 6.5)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(leftLane, ego, self) > 2
    do TurnOff(-0.9, globalParameters.OPT_ADV_SPEED, 9)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 3 seconds
    do Halt()
