#: description = "The rider ahead swings out slowly round something on the road and back into line."
#: rephrasings = [
#:   "The cyclist in front jinks round a pothole and back.",
#:   "The bicyclist swerved to avoid debris and then returned to the original line of travel.",
#:   "bike ahead swerves round pothole, then straight on",
#:   "The target ahead performs a single evasive lateral displacement and resumes its line.",
#:   "The cyclist before us goes around a hole in the street and comes back.",
#:   "To dodge a car door, the biker up ahead ducks out and in again.",
#:   "The scooter veers aside for a pigeon and then keeps straight.",
#:   "Around the manhole cover and back on course goes the rider we follow.",
#:   "The cyclist in front drifted out round a drain cover, nice and leisurely, and came back in.",
#:   "The bicyclist ahead moved left gradually to avoid an object and then returned to his prior position.",
#:   "Bike ahead eases out round pothole, back to edge.",
#:   "The leading two-wheeler deviates laterally at low speed around an object and resumes its line.",
#:   "The bicycle before me goes slow around a hole and comes back.",
#:   "Lead rider makes a gentle lateral detour at low speed, no braking, no fall.",
#:   "He went round the puddle in no hurry at all, out and in again, with the whole street waiting on him.",
#:   "Moped up front's going out to get round that manhole, hold back, he'll come in again.",
#:   "bike ahead went around smth real slow then back to where he was",
#:   "The cyclist moved unhurriedly around an obstruction and resumed her course.",
#:   "He gave the object a berth, gently, and fell back into his former line.",
#:   "Cycle in front went little outside to avoid the manhole, slowly, then came back in line.",
#:   "Takes a lazy loop round a puddle, God forbid he gets his socks wet, then back in.",
#:   "Gradual lateral excursion of preceding two-wheeler around object with return to line",
#:   "CYCLIST TAKES THE SCENIC ROUTE ROUND A POTHOLE",
#:   "The scooter in front arcs lazily round something and rejoins its line.",
#:   "Bike ahead wanders gently round a branch, then falls into line.",
#:   "moped infront gives a dead badger wide berth all unhurried then tucks in",
#:   "Have the rider we follow skirt a puddle slowly and line up again.",
#:   "Lead cyclist: slow bulge outward past grating, returns to former track.",
#:   "She bikes so slow around the broken glass and back again, Mummy.",
#:   "In front of us a scooter left its line at hardly more than a trot, went about a sack in the road and resumed its old one.",
#:   "At low speed, the two-wheeled target preceding the VUT performs a lateral excursion to clear an object on the surface and regains its initial path.",
#:   "There's a sunken manhole coming up, so the cyclist in front will move out for it, take her sweet time, and settle back afterwards. Sit tight.",
#:   "The man with the bicycle before my car has made a small, slow arc because of a stone and then was again where he rode before.",
#:   "Did the motorcyclist ahead pull out for good? No, he pottered round a fallen exhaust pipe and, once past it, slipped back to his old position.",
#:   "Something lay by the kerb, a mattress perhaps; the rider ahead of the AV edged outward to clear it at a crawl, then regained his line.",
#:   "I'd been following this old boy on his sit-up-and-beg for a while. There was a big wet patch, leaves and whatnot, and he steered out round it with the dignity of an ocean liner, hardly turning the pedals, then steered in again the same way. I just waited.",
#:   "Vehicle 2, a motor scooter, was preceding Vehicle 1 near the edge of the lane. Its rider noticed roadkill and, without any abrupt movement, took the scooter outward around it at perhaps 10 km/h. Having cleared it he brought the scooter back to his original distance from the kerb.",
#:   "Proposed test: leading cyclist detours round debris. Lateral offset grows smoothly to about one and a half metres, stays for a couple of seconds and returns to zero; speed is low throughout. Please check that ego neither squeezes past on the outside in the meantime nor treats this as a turn.",
#:   "I cycle, so I'll tell you why we do it. There's a drain with slots the size of a tyre. Ahead of the red car a girl saw it in good time, and she bore out little by little, rolled by it at a snail's pace, and bore in to her line.",
#:   "From the lorry you look down on everything. The fellow on the moped in front had spied some planks; out he swung, ever so lazy, like a man stepping round a sleeping dog, then in he swung, and he puttered on along the same strip of road he'd been on before.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "slow"]
#: position = "ahead"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 2.6
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.1
#: high = 1.8
#: unit = "m"
#: meaning = "how far it swings out to the left"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 2.5
#: high = 4.0
#: unit = "s"
#: meaning = "how long it stays out"

param OPT_ADV_SPEED = Range(1.2, 2.6)
param OPT_ADV_DISTANCE = Range(0, 18)
param OPT_SWERVE = Range(1.1, 1.8)
param OPT_ADV_TIME = Range(2.5, 4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_ADV_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
