#: description = "The car moves over in front of the ego and then drives very slowly."
#: rephrasings = [
#:   "Someone slides in ahead of us from the next lane and then just dawdles.",
#:   "Vehicle 2 changed lanes in front of vehicle 1 and proceeded at well below the traffic speed.",
#:   "Adjacent veh cuts in, then slow travel.",
#:   "The target merges ahead of the VUT and continues with a low constant speed.",
#:   "It comes in our lane before us and goes like a snail after.",
#:   "A tractor unit noses across our bonnet and trundles on.",
#:   "The bus wanders over from beside and then holds us all up.",
#:   "A motorcyclist slots in before us only to potter along.",
#:   "so this bus shoves its way in ahead of me and then trundles along at a dead slow pace, cheers mate",
#:   "V2 merged into V1's lane immediately ahead, after which it traveled at an unreasonably slow speed.",
#:   "Truck changes into our lane, then dawdles 5 km/h. No halt.",
#:   "Following its lane change ahead of the VUT, the target continues at a residual speed of 10 km/h.",
#:   "The car comes in my lane before me and after he is slow like a tractor.",
#:   "Actor merges ahead, then holds a creeping velocity so the SUT gets stuck behind a moving plug.",
#:   "The patrol car slid across before them and then, having won its place, ambled on at the speed of a funeral.",
#:   "Typical: fights to get in front of you and, now he's there, he potters. Just dawdling along at walking speed.",
#:   "he pushes in front of us and THEN decides to go 3mph, make it make sense",
#:   "Having elbowed its way to the front, the bus then held up the line at a stroll, witnesses said",
#:   "You were in haste to get before him, Mr Cole, and yet once there you practically stood still, though you kept moving?",
#:   "Cut already then drive like bullock cart in front, what is this man",
#:   "He's desperate to be in front of me and once he's there he's got all day, dawdling like he's window shopping",
#:   "Lane intrusion ahead with persistent low residual speed",
#:   "Truck squeezes in, then goes SLOWER THAN WALKING",
#:   "The motorbike muscled in and loitered along.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "UN R157 cut-in; own code"
#: [slots]
#: actions = ["cut-in", "slow"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 4.0
#: high = 12.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.8
#: high = 3.3
#: unit = "m/s"
#: meaning = "how fast it drives in the ego's lane"

param OPT_ADV_DISTANCE = Range(-10, 25)
param OPT_ADV_AHEAD = Range(4, 12)
param OPT_ADV_SPEED = Range(1.8, 3.3)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED)
