#: description = "The parked car pulls out from the kerb and stops in the ego's lane."
#: rephrasings = [
#:   "The parked car swings out and then just stops in front of us.",
#:   "Vehicle 2 pulled away from the curb and halted in the travel lane.",
#:   "Parked veh pulls out, then stationary in our lane.",
#:   "The target leaves the parking strip and comes to standstill in the path of the VUT.",
#:   "It comes out from parking and stays standing on our way.",
#:   "The van stalls the moment it has left its bay and bars the lane.",
#:   "A bus departs from the stop and freezes with our lane full of it.",
#:   "The taxi moves off the roadside, the driver sees us and seizes up before us.",
#:   "some wally came off his parking spot into my lane and then just stood there",
#:   "V2 pulled away from the curb into the traffic lane and then halted, blocking V1.",
#:   "Parked bus -> out into our lane -> standstill.",
#:   "The target leaves the kerbside, enters the VUT's lane and brakes to a standstill in it.",
#:   "The car goes out from the parking, but in my lane he stops and does not drive.",
#:   "Parked actor enters our lane then v=0 there; it must not drive on.",
#:   "The motorcyclist had nosed off from the pavement into the lane and there, of all places, come to a halt.",
#:   "Out he comes from the parked cars, and now he's stopped bang in your lane. What was the point of that?",
#:   "parked car comes out into our lane and then just... stops?? why",
#:   "A florist's van had no sooner left its parking bay than it ground to a halt, barring the way",
#:   "You left the kerb, you entered the lane, and there you stood still; can you tell the court why?",
#:   "The bus came out from the side and then halted in our lane itself, no going forward",
#:   "He comes off the side, into my lane, and then stays put, like he's forgotten where he was going",
#:   "Departure of parked vehicle into own lane followed by stationary blockage",
#:   "Parked van pulls out and DEAD STOPS in my lane",
#:   "The parked ambulance budged out into our lane and balked.",
#:   "Moped leaves its parking space, gets in our way, and there it rests.",
#:   "The parked lorry is on the move, it's in your lane, it's stopped!",
#:   "Kerbside ambulance rolls out, then blocks the lane standing.",
#:   "Let a roadside van enter the ego's lane and park itself right there.",
#:   "That bus went out of its bay and then did not budge from before us",
#:   "hatchback that had been sat at the pavement moves off in front of me, comes fully into my lane and stops like the engine died, wtf",
#:   "The vehicle stationary at the roadside shall depart, occupy the lane of the subject vehicle and there be decelerated to standstill.",
#:   "He had waited all morning in that lay-by, and yet he chose this instant to come out, only to stop again three yards on in front of us.",
#:   "Imagine a fire engine leaving the kerb, putting itself square in the robotaxi's lane and halting there, crew climbing out with the hose.",
#:   "V2's driver stated that he'd moved away from the curb, noticed his door was open, and stopped with his vehicle wholly in the lane.",
#:   "My friend, if you come out from the parking side, at least go! This auto came out and in the lane itself he stood.",
#:   "The motorcycle was leaning by the kerb with its rider aboard. As we came near he paddled it out, got the whole machine into our lane, and then sat there at a standstill fumbling with his gloves while we bore down on him.",
#:   "Claim details: third party was parked on the nearside outside the bakery. He set off into my lane without looking, and hardly was he in it when he brought his car to a stop, leaving me with a stationary tail to stare at.",
#:   "I do this street every day with eighteen tonnes behind me and I always expect somebody to come off the kerb. What I don't expect is for him to come right out into my lane and then simply cease moving, all of him, dead in my road.",
#:   "Scenario 12 in the urban set. A parked vehicle begins to move when the AV is about thirty metres away, merges fully into the AV's lane, and then brakes until its speed is zero; it doesn't drive on and it doesn't reverse.",
#:   "The old man in the Volvo had been asleep at the side of the road, I'm sure of it. He woke, steered out from the kerb into the lane ahead of her, and there, as though the effort had worn him out, he came to a halt.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "stop"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 36.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(16, 36)
param OPT_ADV_SPEED = Range(3, 5.5)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 1.1
    do BrakeOnPath(ownLane(egoRoute), globalParameters.OPT_BRAKE)
