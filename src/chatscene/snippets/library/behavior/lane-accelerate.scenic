#: description = "The car suddenly accelerates and closes the gap."
#: rephrasings = [
#:   "A vehicle speeds up so that the ego cannot move in.",
#:   "The adversary puts its foot down without warning.",
#:   "The neighbouring car surges forward beside the ego.",
#:   "The driver next door floors it and shuts the opening.",
#:   "The motorbike rushes ahead at full throttle.",
#:   "The moment we want over, he puts the hammer down.",
#:   "Vehicle 2 increased its speed considerably in the adjacent lane.",
#:   "It gives much gas and then there is no more hole for us.",
#:   "I went to move over and the bloke floored it to shut the door on me.",
#:   "Unit 2 sped up without warning, eliminating the space available to Unit 1.",
#:   "Truck in next lane, sudden gas, gap gone.",
#:   "The target vehicle abruptly increases its speed such that the available gap diminishes to zero.",
#:   "The bus goes suddenly faster, and there is no more place for me.",
#:   "Gap-closing actor: a > 0 as soon as we go for the slot, denies the merge.",
#:   "There had been room enough, but the rider opened the throttle and swallowed it up before she could take it.",
#:   "You had your gap there and he's just put his foot down and stolen it, so stay where you are.",
#:   "i had the gap n then he just sped up so i couldnt get in, so petty",
#:   "A driver picked up speed all at once and denied the other car the space it was making for.",
#:   "The opening was there, and you, sir, by quickening your pace, extinguished it.",
#:   "I wanted to filter, then the lorry purposely chiong to close the space.",
#:   "Moment I fancy that slot he perks up and plugs it, never fails.",
#:   "Loss of available gap owing to sudden speed-up of neighbouring vehicle",
#:   "SEES MY BLINKER, SPEEDS UP",
#:   "The bus quickens and squashes the gap.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: leader = false
#: actions = ["accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_THROTTLE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
