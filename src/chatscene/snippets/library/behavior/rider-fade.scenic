#: description = "The cyclist ahead sprints off, tires and slows to a crawl."
#: rephrasings = [
#:   "The bike in front stands on the pedals, runs out of puff and crawls.",
#:   "The bicyclist accelerated and subsequently slowed to a very low speed ahead of Vehicle 1.",
#:   "cyclist ahead sprints, then fades to crawl",
#:   "The bicyclist target accelerates and then drops to low speed ahead of the VUT.",
#:   "The cyclist before us goes first fast and then has no power any more.",
#:   "A schoolboy pedals like mad until his legs give out.",
#:   "The weekend racer we follow blows up and dawdles.",
#:   "Her chain slips after a spurt and the bike ahead barely moves.",
#:   "the cyclist in front went off like Bradley Wiggins and then ran out of puff and was barely turning the pedals",
#:   "The bicyclist ahead of V1 sprinted, became fatigued, and slowed to a very low speed.",
#:   "Cyclist ahead: sprint, out of breath, then snail's pace.",
#:   "The bicyclist ahead of the VUT accelerates strongly and then falls progressively to minimum speed.",
#:   "The cycle man in front goes very fast, then he has no more power and goes very slow.",
#:   "Bike lead with exhaustion profile: peak speed first, gradual decay down to just-upright pace, never zero.",
#:   "He had stood on the pedals and flown ahead of them, but his legs gave out and soon he was barely turning them.",
#:   "He's giving it some welly on that bike... and he's blown up, legs have gone, he's just about staying upright ahead of you.",
#:   "cyclist in front went turbo mode then ran out of battery lol now its so slow",
#:   "A pensioner on a bicycle put on a burst before flagging to little more than walking pace",
#:   "You set off vigorously, then tired, so that those behind you were barely moving?",
#:   "Front cyclist first go so fast like race, after that no stamina, slow until like walking",
#:   "He's off like Bradley Wiggins for fifty yards, then his legs go and I'm stuck behind him wheezing",
#:   "Initial sprint of leading cyclist followed by fatigue-related decline to very low speed",
#:   "Cyclist sprints... then COMPLETELY runs out of steam",
#:   "The cyclist ahead surged, wilted and plodded.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "slow"]
#: position = "ahead"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 6.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it sprints"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 1.5
#: high = 3.0
#: unit = "s"
#: meaning = "how long it sprints"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.0
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it crawls"

param OPT_ADV_SPRINT = Range(6, 8)
param OPT_ADV_TIME = Range(1.5, 3)
param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_SLOW_SPEED = Range(1, 2.4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT) for globalParameters.OPT_ADV_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
