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
#:   "Gets by us one lane across, then anchors up over there.",
#:   "Biker zips past, then sheds speed savagely, no lane change.",
#:   "Let a hatchback pass the AV, then decelerate brutally without merging.",
#:   "No cut-in: overtaking cab, hard braking in its own lane afterwards.",
#:   "SUV leaves us behind, then stamps on it in the adjacent lane.",
#:   "The convertible went sailing past on the other strip of tarmac and, without ever moving over, put its brakes on as hard as they'd go.",
#:   "First the motorcycle makes an overtaking of me, then it brakes very heavy, but always in the lane from the side.",
#:   "Upon gaining a defined lead over the subject vehicle in the neighbouring lane, the passing vehicle shall execute emergency braking while remaining there.",
#:   "He's come up alongside, he's past you, now his nose has gone down, hard braking, but see, he hasn't come into your lane.",
#:   "Would someone explain the pickup that went round me in the outside lane only to jam its brakes on out there?",
#:   "The brake lights I saw belonged to a saloon in the next lane, which had only just drawn ahead of me at some speed.",
#:   "A young woman in a sports car was in a terrible hurry and left me standing. She stayed out in her lane, and a little farther up she must have seen the camera, for the car practically knelt down under its brakes.",
#:   "V2 passed V1 in the number two lane. When approximately sixty feet ahead, V2 was subjected to maximum braking for reasons unknown; at no time did it enter the number one lane, in which V1 was traveling.",
#:   "What happens with our following-distance logic if somebody goes by in the lane beside ours and then throws out everything he has? He mustn't merge. I want to see that the robotaxi doesn't brake along for nothing.",
#:   "The motorbike came up behind his shoulder like a wasp, droned by on the far side of the dashed line, and was in front. There, still on its own side, it suddenly reared back on its brakes with a shriek of rubber.",
#:   "Yesterday on ring road one car has overtaken me from the side lane with good speed. After going ahead he has applied brakes full force in his same lane, luggage falling and all, and I passed him comfortably.",
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
