#: description = "The parked car backs out of its parking space into the ego's lane."
#: rephrasings = [
#:   "The parked car backs out right in front of us.",
#:   "Vehicle 2 was backing from a parking space into the travel lane.",
#:   "Parked veh reverses out into lane.",
#:   "The target moves rearward out of the parking strip into the path of the VUT.",
#:   "It goes backwards out of the parking and doesn't see us.",
#:   "A delivery van's tail swings out of the bay at us.",
#:   "The lorry shunts off the roadside in reverse, rear first into our lane.",
#:   "Someone shifts to R and rolls out of his spot before our bonnet.",
#:   "Someone came backing out of a bay straight into me, didn't even look round.",
#:   "Unit 2 was backing from a parking stall and entered the travel lane occupied by Unit 1.",
#:   "Parked van, R gear, tail into our lane.",
#:   "The parked target leaves its space rearward, its tail entering the lane of the test vehicle.",
#:   "Car comes out from the parking with its back first, into my street.",
#:   "Stationary actor at the edge moves out tail-first; white lights on, only negative speed.",
#:   "The boot of the thing came sliding out of the row of parked cars into their way.",
#:   "Truck's backing out of that space, he can't see you, give him the horn.",
#:   "some lady backed out of her spot right into my lane w/o looking",
#:   "A pickup came tail-first out of its bay and into the path of moving traffic.",
#:   "You emerged rearwards from the parking place, madam, and so into the lane where my client was driving.",
#:   "Car parked at side took reverse straight into my lane, not even seeing the mirror.",
#:   "Bum first out of the parking spot, straight into my lane, eyes in the back of his head, has he?",
#:   "Tail-first emergence of parked vehicle from its bay into own lane",
#:   "BACKS OUT BLIND from parking spot",
#:   "The parked van butts out rear first.",
#:   "Van emerges boot first from its parking bay, into our way.",
#:   "Parked pickup backs off the roadside and plugs my lane.",
#:   "Let a parked ambulance reverse out in front of the ego.",
#:   "Reversing lights on, out of the space, right across me.",
#:   "Daddy, that parked car is coming out with its bottom first!",
#:   "Nobody was visible at the wheel, yet the parked estate crept backward from its slot between two others until its rear end lay in our lane.",
#:   "A vehicle stationary in a roadside bay engages reverse and steers its rear into the lane of the approaching test vehicle, where it ends up.",
#:   "If you see white lamps in a row of parked cars, cover the brake. Look, that SUV is coming out to you stern first this very moment.",
#:   "The front of my car hit the tail-lift of a lorry because its driver was reversing from the place where he had been parked into the carriageway.",
#:   "The taxi was staying in the parking and he made marche arrière without regarding, so his back part arrived in my lane just before me.",
#:   "Fire engine that had been parked up by the shops is now backing itself off the kerb and into live traffic, can someone get a banksman there?",
#:   "I'd only popped out for milk, Officer. A big four-by-four in one of those slanting bays began to back up, and I hooted, but on it came till the whole rear half stuck out in the lane I was using and I was up against its spare wheel.",
#:   "Observation by the perception team: parked car detected as static clutter, class \"parked\", until its motion flips sign. It leaves its bay backwards and ends with its rear inside the ego lane, blocking us. Tracker took 0.8 s to accept negative speed. Please re-run with the longer box truck as well.",
#:   "Vehicle 2 had been parked at the eastern kerb. Its driver, intending to depart and being unable to go forward on account of a skip, selected reverse and moved out in that direction, so that the trunk entered the lane in which Vehicle 1 was travelling.",
#:   "The trouble with vans is that they've no back window. This one had been parked the entire morning, and then just when I came riding up behind the AV out poked its rear doors, further and further, steering blind into the lane until the AV had nowhere to go.",
#:   "On tonight's episode we ask why anyone would still park nose-in. Exhibit A: a saloon in a roadside space, a driver who can't see a thing, and a rear bumper that comes swinging out backwards into the lane just as our listener arrives there at thirty.",
#: ]
#: adversaries = ["car", "truck", "emergency-vehicle"]
#: requires = ["advKerb", "advRoom", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: backing up into another vehicle; own code"
#: [slots]
#: actions = ["reverse"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 2.0
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_STOP_OFFSET"
#: low = 1.0
#: high = 2.4
#: unit = "m"
#: meaning = "how far from the middle of the lane it stops"

param OPT_ADV_DISTANCE = Range(8, 34)
param OPT_ADV_BACK_SPEED = Range(2, 3.8)
param OPT_STOP_OFFSET = Range(1, 2.4)

behavior AdvBehavior():
    start = progressOn(advKerb, self)[0]
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do ReverseTurning(globalParameters.OPT_ADV_BACK_SPEED, -0.75 if offsetFrom(advKerb, ego) > 0 else 0.75) until abs(offsetFrom(ownLane(egoRoute), self)) < globalParameters.OPT_STOP_OFFSET or distanceLeft(advKerb, self, start) > advRoom
    do Halt()
