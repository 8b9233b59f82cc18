#: description = "The car keeps pace with the ego and then shoots ahead."
#: rephrasings = [
#:   "He matches us side by side and, the second we want over, guns it.",
#:   "Vehicle 2 travelled abreast of vehicle 1 and subsequently accelerated past it.",
#:   "Abreast, then full throttle.",
#:   "The target runs parallel at equal speed and then accelerates in the adjacent lane.",
#:   "He goes same as us and then gives a lot of gas when we want to change.",
#:   "The motorbike idles alongside and then catapults itself forward.",
#:   "A van level with our doors suddenly surges and closes the hole.",
#:   "Cheek by jowl until the other driver drops a gear and rushes on.",
#:   "This bloke sat alongside me for ages, door to door, then put his foot down and was gone.",
#:   "Vehicle 2 traveled abreast of Unit 1 for some distance, then sped up and pulled away.",
#:   "Bike level w/ us, same speed, then zooms off fwd.",
#:   "The adjacent vehicle holds the same longitudinal speed as the test vehicle, after which it accelerates and leaves it behind.",
#:   "Truck drives next to me same speed some time, after that it goes fast away to front.",
#:   "Neighbour-lane actor speed-matches, then full throttle and clears forward.",
#:   "He stayed at her shoulder as if they were tied together, and then all at once he bolted and left her standing.",
#:   "He's staying right next to you, ambulance on your side, let him be; there, he's hit the gas and taken off.",
#:   "he was driving right next to me matching my speed and then yeeted off",
#:   "The second car kept abreast for several hundred metres before surging clear.",
#:   "They travelled wing to wing, members of the jury, until the defendant chose to open up and leave my client in his wake.",
#:   "This van uncle drive same speed beside me so long, then suddenly zoom go front.",
#:   "Sits at my window like he wants a chat, then off he goes like a greyhound.",
#:   "Prolonged parallel running by adjacent vehicle, ending in a sudden gain of speed and departure ahead",
#:   "BMW matches my speed then VANISHES",
#:   "The rider shadows our flank and then rockets clear.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -8.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -10.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(-8, 15)
param OPT_ADV_AHEAD = Range(-10, 1)
param OPT_THROTTLE = Range(0.6, 1)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 2.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, globalParameters.OPT_THROTTLE)
