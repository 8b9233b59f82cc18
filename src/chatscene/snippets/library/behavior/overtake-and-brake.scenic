#: description = "The car overtakes the ego and then brakes hard in its own lane."
#: rephrasings = [
#:   "He gets past us and then drops anchor in the lane next door.",
#:   "Vehicle 2 passed vehicle 1 and decelerated rapidly without changing lanes.",
#:   "Passes, stays in lane, hard brake.",
#:   "The target overtakes the VUT and performs strong braking in the adjacent lane.",
#:   "He overtakes, doesn't come in, but brakes very much.",
#:   "The bus goes by and screeches to a stop beside our front.",
#:   "A motorbike rushes past and then sits up and hauls on the brakes.",
#:   "Once by, the van slams to a halt one lane over.",
#:   "He flew past in the next lane and then chucked out the anchors, without even coming over.",
#:   "Unit 2 passed Unit 1 and braked severely while remaining in the adjacent lane.",
#:   "MC overtakes us, stays in own lane, hard brake.",
#:   "The target vehicle overtakes in the neighbouring lane and applies strong braking there, with no lane change.",
#:   "The car goes past me and then brakes very strong, but in its own lane.",
#:   "Passer does not cut in; it decelerates hard one lane over so we fly by it again.",
#:   "It swept by on the outside, and no sooner was it ahead than it dug its heels in where it was.",
#:   "Ambulance going by on your left, he's past, and he's braking hard over there in his lane.",
#:   "he passed me then hit the brakes hard but stayed in his lane, like why even",
#:   "A car went by in the next lane and thereupon braked fiercely, though it never changed lanes.",
#:   "You overhauled my client, kept to your own lane, and there braked with great force; for what purpose?",
#:   "He overtook me in side lane and put full brake there itself, did not come to my lane.",
#:   "Has to be first, doesn't he, whizzes by and then stands it on its nose over in his own lane.",
#:   "Severe deceleration of passing vehicle within the adjacent lane",
#:   "PASSES ME JUST TO SLAM HIS BRAKES (next lane)",
#:   "The motorbike overhauls us and digs in on its own side.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: place = "road"
#: actions = ["overtake", "brake"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 6.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_SPEED = Range(11.5, 15)
param OPT_ADV_AHEAD = Range(6, 14)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE)
