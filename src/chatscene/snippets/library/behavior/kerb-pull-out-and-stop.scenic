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
#:   "Milk lorry leaves the kerb, takes our lane, dies there.",
#:   "Off the pavement edge, into my lane, and there it stuck, motionless.",
#:   "Bus quits its stop, plugs our lane, zero km/h, end of message.",
#:   "If you give up a parking space, at least drive away; this Skoda moved out as far as the lane in front of us and went to sleep.",
#:   "The hitherto stationary kerbside target departs, becomes fully aligned with the VUT's lane and is decelerated to rest therein.",
#:   "He had been parked by the baker, he drove himself into my lane, and in this lane he made standing, with motor running.",
#:   "Set up a police car at the roadside that comes away from the kerb, gets itself right into the ego's lane and halts there for good.",
#:   "From a parked position at the east curb, V2 moved into the southbound lane and was stationary in that lane when struck in the rear by V1.",
#:   "A scooter that had been leaning on its stand was walked out, mounted and ridden into our lane, only to be stopped there while its rider checked a message.",
#:   "I saw the front wheels turn out from the kerb and I thought, fair enough, he'll be up to speed before I get to him. Up to speed! By the time I got to him there was a camper van standing right in my lane, with the handbrake on for all I know.",
#:   "The reason my shopping is all over the footwell is a blue Corsa. It had been minding its own business at the side of the road; then it came out, it filled the lane that I was in, and there it ceased to do anything whatever.",
#:   "It's not the leaving that gets you, it's what comes after. Fellow lifts off the kerb in his flatbed with you thirty yards back, all well and good, he's in your lane now. And he's stopped. Not slowed, stopped, square in the middle of it.",
#:   "The removal truck's indicator winked, the truck drew out from the row of parked cars, and we eased off to let it get away. It did not get away. When the whole of it was in front of us, straight in the lane, it gave a shudder and stayed where it was.",
#:   "A hundred and twelve parking departures are in our data, and all but one end with the departing vehicle driving off. In the remaining one it comes fully into the subject vehicle's lane from the kerb, brakes until it's at rest and remains there as an obstruction.",
#:   "What would you do here? There was an ambulance waiting at the side, it's moved off, it's ahead of you in the lane. Now look at its wheels. They aren't going round, are they, so neither should ours be.",
#:   "Mr Okafor's taxi had stood outside the hotel since noon. At ten past one it rolled from the kerb into the path of a delivery car, whose driver expected it to accelerate; it came instead to a complete halt in the lane, because a guest was running after it.",
#:   "I'm on two wheels and I look for exhaust smoke along the parked cars, so I wasn't surprised when the hatchback came off the kerb. I was surprised when I found it at a dead stop in the lane with a grey saloon behind it, nose down and hooting.",
#:   "The old lady next door says the devil gets into that bus. It stands at the stop for ever with nobody getting on, then out it lurches just as somebody's coming, all the way into the road, and then it stands there again, only this time in your way.",
#:   "We'd hardly any warning. There was a line of parked vehicles; one of them was no longer in the line but in the lane; and a second after that its brake lights were on and it wasn't going anywhere, so neither was the robotaxi, which had pulled up a yard behind.",
#:   "Why always before me? From parking side one Innova came out, fully in my lane he came, I thought he will go. But there itself he stopped, opened glass and started to talk to the coconut seller, and I was standing behind like his servant.",
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
