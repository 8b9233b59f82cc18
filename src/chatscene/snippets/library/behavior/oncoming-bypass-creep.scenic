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
#:   "As we swing round the skip, an oncoming bus dribbles toward us.",
#:   "Oncoming lorry at a snail's pace while the AV clears the blockage.",
#:   "Bike opposite barely moves; our car is mid-pass round roadworks.",
#:   "Slow, slow, slow, the van facing us as we skirt the breakdown.",
#:   "Have the opposing car inch up while the ego rounds the obstruction.",
#:   "We had to go out past the broken-down tractor, and from the other end a coach was approaching with so little speed that you could have walked beside it.",
#:   "During the VUT's manoeuvre around the stationary object, an opposing vehicle advances in the adjacent lane at a constant speed not exceeding walking pace.",
#:   "theres a tree down on ur side so your going round it and the taxi comming the other way is only creeping which makes the timing a pain",
#:   "Vehicle 1 had moved left to clear a dumpster, and Vehicle 2, approaching from the opposite direction, was traveling at barely five miles per hour and did not stop.",
#:   "I want a pickup that comes from the front, dead slow the whole time, just when our robotaxi has to leave its lane because of a blocked one.",
#:   "De vrachtwagen, so the lorry, was coming against us like a turtle when we were driving around the hole in the road, and he never went faster.",
#:   "It was the gas people again with their barrier across my half of the road. I went out to get by it, and down the hill towards me came an old Volvo, hardly turning its wheels, and neither of us knew who would be at the pinch point first.",
#:   "Planner note: the obstacle in our lane requires borrowing the opposing one. Opposing actor is on the map at 1.5 m/s, steady, headed for us. It does not yield, it does not speed up, it takes forever; a gap estimate based on typical speeds is way off.",
#:   "I was the cyclist. I'd got shopping on both handlebars so I was pedalling as gently as can be, and here's this car coming out round the parked removal van on its side, straight into the bit I was trundling along. I didn't stop or hurry, I just kept trundling.",
#:   "You told the court that my client was passing the fallen scaffold at the time. And the bus, which came from the opposite direction, how was it moving? Like a hearse, you said? So it was still coming on, only extremely slowly?",
#:   "The fog had taken the far end of the street. While she steered out and around the heap of gravel, two dim lamps were coming to meet her, growing so gradually that she could not at first believe they moved; it was a lorry, advancing at a foot's pace.",
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
