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
#:   "From the kerbside a bin lorry slowly emerges and ambles ahead of us.",
#:   "Moped eases off the roadside, then potters at 10 in our lane.",
#:   "Parked van comes out very gradual and stays like a tortoise before me.",
#:   "Ambulance pulls away from the kerb gently; remains a slow leader.",
#:   "Let a parked bus dribble out, then hold us up.",
#:   "With its indicator going for an eternity, the camper rolled away from the pavement into my lane and went ahead of me no faster than a hearse.",
#:   "An elderly gentleman left his parking place by inches in front of the robotaxi and after that could not be induced to exceed a jog.",
#:   "The stationary target leaves the kerb at a low constant speed and keeps to that speed as the lead vehicle in the VUT's lane.",
#:   "We'd have lost no time had the truck not slipped out so sluggishly from the side of the road and rumbled on ahead at a walk.",
#:   "What I need: a parked car that joins our lane gingerly, never stops, never picks up, and makes the AV tail it at bicycle speed.",
#:   "Traffic news: a loaded coach has drawn out from the roadside at a crawl and is leading everyone along Mill Lane at ten miles an hour.",
#:   "You can see him in the mirror of the shop window, the driver of that parked police car, looking for his sunglasses. So of course he drifts off the kerb into our lane ever so softly, and then he strolls along before us as though nobody else had anywhere to go.",
#:   "Unit 2 had been legally parked. It was edged from the curb into the lane of Unit 1 and continued in that lane at approximately eight miles per hour, with Unit 1 behind it. At no time did Unit 2 halt or make any appreciable gain in speed.",
#:   "My gran drives like that. She lets the handbrake off, the car comes away from the pavement like a boat from a jetty, out into everybody's way, and off she goes in front of them all at the speed of her shopping trolley, quite content.",
#:   "The motorcyclist had sat astride his parked machine for a time. He slid it out into her lane in no hurry whatever, and for the rest of the street there was nothing for her to do but look at his back while he chugged along.",
#:   "I'm on my bike behind a car that's behind this removals lorry, and he only came off the kerb a minute ago, at about the pace you'd push a wardrobe. He hasn't sped up since, he's still lumbering along and all of us are stacked up behind.",
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
