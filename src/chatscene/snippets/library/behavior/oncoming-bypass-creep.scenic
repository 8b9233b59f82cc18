#: description = "The oncoming car crawls toward the ego while it goes around the obstacle."
#: rephrasings = [
#:   "the one coming the other way is just crawling and we can't get past",
#:   "Vehicle 2 approached in the opposing lane at very low speed while Vehicle 1 was passing an obstruction.",
#:   "opposing veh at walking pace in the gap",
#:   "The oncoming target moves at less than 13 km/h in the lane that the VUT has to use.",
#:   "A bus comes very slowly from the other side and occupies the free lane.",
#:   "A cyclist pedals gently toward us in the lane we need.",
#:   "The lorry opposite inches along and leaves us hanging out there.",
#:   "A slowcoach facing us plods through the narrow bit.",
#:   "There was stuff in the road on his side, and he was inching round it towards me at a crawl.",
#:   "The opposing vehicle proceeded slowly around the obstruction in the direction of Unit 1.",
#:   "Oncoming truck bypassing blockage, dead slow, toward ego.",
#:   "The oncoming target circumvents the obstruction at very low speed while approaching the VUT.",
#:   "A bicycle comes against me very slowly because he must go around the thing on the road.",
#:   "Opposite actor detours round the blocked lane at 1-2 m/s, nose toward us; we need to wait it out.",
#:   "It came on at a snail's crawl, feeling its way past the heap in the road and toward her all the while.",
#:   "He's picking his way round that skip, ever so slow, coming at you; hold back and let him finish.",
#:   "the bus coming at us was going suuuper slow round the thing in the road",
#:   "A lorry picked its way at a crawl past the blockage, head to head with approaching traffic.",
#:   "The opposing vehicle was skirting the obstacle, and it did so very slowly, in my client's direction?",
#:   "Opposite van is coming slowly slowly from the side of the block, taking his own sweet time.",
#:   "There's a skip on his side and he's tiptoeing round it at me as if it might bite.",
#:   "Very slow detour of oncoming vehicle past obstruction in ego direction.",
#:   "ONCOMING CAR TAKES FOREVER TO GET PAST OBSTACLE",
#:   "The oncoming cyclist tiptoed round the blockage toward us.",
#: ]
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "slow"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(1.5, 3.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
