#: description = "The truck ahead swings wide to the left and then turns right off the road."
#: rephrasings = [
#:   "The artic in front of us swings way out left and then hooks right.",
#:   "Vehicle 1, a heavy truck, moved left to gain room before making a right turn into an access.",
#:   "Lead truck swings out left, turns right off road.",
#:   "The target heavy vehicle makes a lateral offset to the left and then turns right across the path of the VUT.",
#:   "The big truck makes first to left and then it turns to right, we think it lets us pass.",
#:   "A coach ahead fakes left to get its tail round and sweeps right into the yard.",
#:   "The bus we follow takes a wide arc, out to the left and back across to the right.",
#:   "Looking as if it pulled left, the long lorry suddenly comes round to the right.",
#:   "The artic in front went miles out to the left before hauling itself round to the right.",
#:   "The tractor-trailer ahead moved left to make a wide right turn off the roadway.",
#:   "Semi ahead: out left, then R turn off road.",
#:   "The heavy goods vehicle ahead displaces to the left prior to performing a right turn and leaving the carriageway.",
#:   "Long bus before me goes first to the left side and then turns right.",
#:   "Long lead takes a wide arc, left offset first, then exits right, so don't undertake it.",
#:   "It leaned away to the left so far that he thought it was making room, and then its whole length folded off to the right.",
#:   "Don't go up his inside, that bus needs room, he's swinging out left so he can make the right.",
#:   "the truck ahead went way left and i thought he was going left and then he turned RIGHT",
#:   "A long lorry veered out to the left before sweeping right into a turning, surprising those behind.",
#:   "In order to go right, the bus first bore out to the left, and my client was deceived by it.",
#:   "Trailer in front go all the way left first then turn right, cannot trust.",
#:   "Big rig takes half of Kent to get round, shoves out left and then folds himself off to the right.",
#:   "Leftward off-tracking of preceding long vehicle prior to right turn-off",
#:   "SEMI FAKES LEFT, GOES RIGHT - wide turn close call",
#:   "The long bus balloons out leftward and then bends off to the right.",
#:   "Artic up front: bulges out left, then peels off hard right.",
#:   "Bus ahead needs the whole road: left a bit, now right, gone.",
#:   "I want the lorry before us to arc leftward, then exit the road right.",
#:   "Daddy, the long truck leaned that way first, then went in on the right!",
#:   "Primero the truck ahead opens to left, después it goes inside on the right.",
#:   "The coach we'd been trailing bowed away to the left, as if to oblige us, and then its front came round and it left the road rightward.",
#:   "To line itself up for the factory gate on the right, the low-loader in front had to steer out well over to the left beforehand.",
#:   "Never fill the hole on a big vehicle's right when he's eased over to the left in front of you: watch him now crank it round into that entrance.",
#:   "A heavy goods vehicle preceding the VUT shifts laterally by approximately 2 m to the left before commencing a tight right-hand turn out of the carriageway.",
#:   "It disappeared into the lane on our right in the end, the cattle truck we'd been following, although it had started by heading off towards the left kerb.",
#:   "Did V2, the semi in front, not first go out to its left before it came about to the right and quit the highway for the truck stop?",
#:   "When the truck ahead of me wandered to the left, I thought he was making way, so I started to come up the inside on my motorbike. Luckily I looked at his front wheels. They were already on full right lock, and the entire rig then came sweeping round into a side entrance.",
#:   "Ticket for the sim team: articulated lead vehicle, low speed. It has to displace to the left by most of a lane so the trailer won't clip the corner, after which it makes the right-hander into the depot. Our intent module reads the first half as a lane change left. It isn't.",
#:   "I've driven buses out of that garage for thirty years, and every day some car gets caught. You take her out to the left, as far as the other fellow will let you, and then you bring her round right into the yard, and there's always one behind you who only believed the first bit.",
#:   "The plaintiff was travelling in the wake of the defendant's tractor-trailer. That vehicle, needing room, deviated to the left by some six feet; it then described a broad curve to the right and passed out of the road through the quarry entrance, closing the space in which the plaintiff found himself.",
#:   "Mirrors, everyone! So the clip from this week shows a dustcart ahead of the cammer going for what looks like the left side of the street, and the comments are all \"he's turning left\". Nope, after that little detour he rolls it round to the right and off the street he goes.",
#: ]
#: adversaries = ["truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "turn-right"]
#: place = "road"
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far out to the left it swings"

param OPT_ADV_DISTANCE = Range(8, 30)
param OPT_BRAKE = Range(0.4, 0.9)
param OPT_ADV_SPEED = Range(2, 3.5)
param OPT_SWERVE = Range(1.2, 2.2)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) until offsetFrom(advTrajectory, self) > 0.8 * globalParameters.OPT_SWERVE
    do TurnOff(-1.4, globalParameters.OPT_ADV_SPEED, 7)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 5 seconds
    do Halt()
