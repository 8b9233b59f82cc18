#: description = "The parked car pulls out and wobbles from side to side in the ego's lane."
#: rephrasings = [
#:   "Straight from the pub he pulls out and wobbles along ahead of us.",
#:   "Vehicle 2 departed the curb and swerved repeatedly in the lane.",
#:   "Parked veh out, then snaking.",
#:   "The target leaves the parking strip and oscillates laterally in front of the VUT.",
#:   "It comes out and goes like a snake.",
#:   "A tipsy scooter rider wavers off the roadside and on down our lane.",
#:   "The overloaded van lurches out and rocks left and right.",
#:   "A driver fumbling with his belt pulls away and meanders.",
#:   "Someone came off the kerb in front of me and then wandered all over my lane like he'd had a few.",
#:   "The vehicle departed its parked position and was observed drifting left and right within the travel lane; possible DUI.",
#:   "Parked moto leaves kerb, then zigzags ahead of ego.",
#:   "After leaving the kerbside the target oscillates laterally in the VUT's lane.",
#:   "The parked car goes out and then drives like snake before me.",
#:   "Pull-out actor isn't stable afterwards: sinusoidal path in our lane, side to side.",
#:   "He wobbled it out from the pavement and then couldn't keep it straight, now towards the gutter, now towards the line.",
#:   "He's pulled away from the kerb and he's snaking about in front of you, so don't try to pass.",
#:   "car pulled out from the side and was swaying all over like drunk af",
#:   "A motorist suspected of drinking left his parking place and meandered from edge to edge of the lane.",
#:   "After leaving the kerb, the motorcycle did not hold a straight course, but strayed to and fro ahead of my client?",
#:   "The parked bike came out and then shaking shaking left and right in my lane.",
#:   "Off the kerb he comes and then he's drawing snakes in my lane, three sheets to the wind I reckon.",
#:   "Lateral instability of vehicle following kerbside departure in ego lane.",
#:   "PARKED CAR PULLS OUT AND CAN'T DRIVE STRAIGHT",
#:   "The parked car came out and meandered ahead of us.",
#:   "Leaves the parking bay, then can't keep it straight in our lane.",
#:   "Parked scooter sets off and teeters left, right, left before us.",
#:   "Ambulance departs kerbside, then slaloms within VUT lane.",
#:   "Who parks up, sets off again and staggers down my lane like that?",
#:   "Off the roadside it comes, and sways along our lane.",
#:   "Let the saloon that was parked by the pavement move off into the ego's lane and keep swinging gently to either side as it drives on.",
#:   "The hatchback had been stationary outside the off-licence; it joined the lane ahead of the robotaxi and thereafter never stopped yawing about.",
#:   "The moto was standing at the trottoir, it enters in my lane and then it dances, one time left, one time right.",
#:   "V2 entered the travel lane from a curbside space and was seen to drift repeatedly from one edge of that lane to the other.",
#:   "Control, that stolen Corsa has just left the kerb on Park Street and it's rolling all over the lane, left and right, can't steer.",
#:   "A new rider, you see: he's got himself off the kerb into our lane, and now the bars are shaking and he's wavering about.",
#:   "It was ten past one, chucking-out time. A chap I'd seen fumbling with his keys got into the Vectra by the kerb, moved out in front of me, and then all along Church Road he was touching the centre line, touching the gutter, touching the line.",
#:   "Before the collision, Vehicle 2 was legally parked. Its driver, later found to be unwell, steered it into the traffic lane and continued in it, but not in a straight line: over a hundred metres the tracks show five alternate deflections to left and right.",
#:   "You think the hard bit's done once the parked car has come out and you've braked for it. Not with this fella. There was a wardrobe on his roof, and as soon as he was in the lane it began to swing, and the car swung with it.",
#:   "Actor timeline: parked at the right edge; on trigger it leaves the bay and takes up our lane; from then on its lateral position follows a periodic curve around the lane centre, so that neither side leaves enough space to get past.",
#:   "When they found the fire engine's steering had been tampered with, it was too late, for it was already out of its place by the kerb and lumbering ahead of us down the lane, leaning to this side and then to that with its ladder waving.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "weave"]
#: side = "right"
#: position = "kerb"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.9
#: high = 1.3
#: unit = "m"
#: meaning = "how far it swings to either side"

param OPT_ADV_DISTANCE = Range(14, 34)
param OPT_ADV_SPEED = Range(2.5, 4.5)
param OPT_ADV_AMPLITUDE = Range(0.9, 1.3)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1
    do WeaveOnPath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3)
