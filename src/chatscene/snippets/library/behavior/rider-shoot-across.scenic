#: description = "The rider shoots out from the side and races across the road, faster and faster."
#: rephrasings = [
#:   "A motorbike comes tearing out of the side and flies over the road in front of us.",
#:   "The motorcycle entered the roadway at an increasing rate of speed and crossed the path of Vehicle 1.",
#:   "moto darts across, full throttle",
#:   "The powered two-wheeler crosses the VUT's path under continuous acceleration.",
#:   "The bike drives over the street with full gas.",
#:   "A downhill racer pedals flat out from one pavement to the other.",
#:   "The moped screams over the carriageway, engine howling.",
#:   "Some kid on an e-bike goes hell for leather from kerb to kerb.",
#:   "A kid on a BMX came rocketing out of nowhere and tore over the road, getting quicker all the way.",
#:   "The bicyclist emerged from the side and crossed the roadway at an increasing rate of speed.",
#:   "MC out from side, straight over, still accelerating.",
#:   "The two-wheeler emerges laterally and crosses the lane of the test vehicle with continuous acceleration.",
#:   "A bicycle comes out very fast and goes over the street, always more fast.",
#:   "Crossing rider, speed ramps up during the crossing, no pause.",
#:   "She burst out between the hedges and flew over the road, pedalling harder with every turn.",
#:   "Dirt bike coming out from the side, he's gunning it straight over, don't try to beat him.",
#:   "kid on a bike flew out from the side n was still speeding up going across",
#:   "A young cyclist came hurtling from a gap and sped over the street, gathering pace all the while.",
#:   "The rider issued from the side, and so far from slowing, he went over the highway ever quicker.",
#:   "Suddenly one cycle came out from side and crossed with more and more speed.",
#:   "Out of nowhere like a cork from a bottle, and pedalling harder the further over he gets.",
#:   "Accelerating lateral dash of two-wheeler from roadside through own lane",
#:   "BMX KID FIRES ACROSS THE ROAD",
#:   "The moped whizzes out and over, gaining pace.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "accelerate", "follow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it wants to ride"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -2.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(7, 12)
param OPT_ADV_DISTANCE = Range(-2, 20)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
