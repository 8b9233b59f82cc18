#: description = "The parked car creeps out from the kerb and trundles along in front of the ego."
#: rephrasings = [
#:   "A parked lorry oozes out into our lane at a snail's pace.",
#:   "Vehicle 2 departed the curb and proceeded in the lane at very low speed.",
#:   "Parked veh pulls out, crawling.",
#:   "The target leaves the parking strip and travels at walking speed ahead of the VUT.",
#:   "It goes out from the side very slowly and stays slow.",
#:   "The overloaded bus heaves itself from its stop and dawdles off.",
#:   "A learner inches away from the roadside and plods on before us.",
#:   "The old motorbike wobbles out of its parking space and barely moves.",
#:   "An old boy eased off from the side of the road at a snail's pace and then pottered along in front of me.",
#:   "The parked vehicle slowly entered the lane of travel and continued at well below the posted limit ahead of Unit 1.",
#:   "Parked bus eases out, plods on ahead of ego, low spd.",
#:   "The parked target leaves the kerb at low speed and proceeds ahead of the VUT at low speed.",
#:   "The truck at the side comes slow, slow on the road and drives slow before me.",
#:   "Kerbside actor merges gently and never speeds up; becomes a slow lead, no hard brake.",
#:   "Inch by inch it came away from the pavement, and having got out it ambled along before her as if on a Sunday outing.",
#:   "That delivery van's easing out, and he's in no hurry, so we'll be stuck behind him dawdling along.",
#:   "grandma pulled out of her parking spot at 0.5 mph and stayed that slow",
#:   "A street-sweeping lorry left the roadside gently and trailed along at the head of a growing queue.",
#:   "She left the kerb slowly and continued slowly, with my client obliged to travel in her wake?",
#:   "Bus slowly came out from the side and going ahead of me like bullock cart.",
#:   "Sunday driver slides off the kerb under my nose and then it's a funeral procession all the way.",
#:   "Low-speed kerbside departure and continued slow travel ahead of ego.",
#:   "SLOWEST PARKING EXIT OF ALL TIME, NOW I'M STUCK BEHIND HIM",
#:   "A parked truck oozed off the kerb and lumbered ahead.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "slow"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.6
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(18, 40)
param OPT_ADV_SPEED = Range(1.6, 3)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
