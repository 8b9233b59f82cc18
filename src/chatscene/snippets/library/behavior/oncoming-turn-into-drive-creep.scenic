#: description = "The oncoming car turns left across the ego's lane into a driveway at walking pace."
#: rephrasings = [
#:   "he crawls across us into the driveway, taking his sweet time",
#:   "Vehicle 2, oncoming, turned slowly left across the lane of Vehicle 1 into a parking lot.",
#:   "opposing veh, left into driveway, crawling over our lane",
#:   "The oncoming target turns left off the carriageway across the path of the VUT at less than 13 km/h.",
#:   "The bus from front enters in the yard on the left side very slow.",
#:   "A cyclist coming the other way ambles over our lane toward a gate.",
#:   "A lorry eases itself off the road through our half, inch by inch.",
#:   "Unhurriedly, a car facing us noses left into the forecourt.",
#:   "The old dear coming towards me turned across into her driveway at about two miles an hour.",
#:   "Opposing vehicle made a slow left turn across Unit 1's lane into a private drive.",
#:   "Oncoming van, L into driveway, dead slow, over our lane.",
#:   "The opposing vehicle turns left over the test vehicle's lane at walking speed to enter a property access.",
#:   "From the front a bus turns very slow over my lane to go in an entrance of a house.",
#:   "Opp. actor crosses our lane at ~5 km/h into a mid-block property entrance, no junction involved.",
#:   "He was nearly home, and he eased over the road into his yard as though nobody else were on it.",
#:   "The delivery truck facing you is going into that drive on your side, and he's taking all day about it.",
#:   "this car facing me turned into someones driveway at like zero mph, blocking my lane",
#:   "An oncoming motorist inched across the lane to reach the entrance of a house.",
#:   "At the pace of a man walking, he passed left before my client in order to gain his own gateway.",
#:   "Opposite car turned slowly slowly into the house gate, my whole lane he blocked.",
#:   "Going home for his tea, he is, and taking all day to get across me into his drive.",
#:   "Protracted blocking of own lane by opposing vehicle turning left at crawl into property entrance",
#:   "SLOWEST DRIVEWAY TURN EVER, across my lane",
#:   "The oncoming car noses leisurely over our lane into a garage entrance.",
#:   "Oncoming dustcart swings left over us into a gateway, inch by weary inch.",
#:   "Cyclist facing you dribbles over your lane and into a house entrance.",
#:   "Let an oncoming coach trickle left through our lane into a hotel drive.",
#:   "The vis-à-vis car turns links to a garage, slow like a snail.",
#:   "bus coming towards me took FOREVER turning left into the school driveway",
#:   "Mrs Hartley was coming the other way, and home she turned, over my lane and in between her gateposts, at a pace that would've shamed a tortoise.",
#:   "The subject vehicle's lane was obstructed for nine seconds while a box truck from the opposite direction negotiated a left turn into a loading yard at walking speed.",
#:   "We all had to wait for the removal lorry that met us there, as it was squeezing itself left through our half of the road into somebody's drive.",
#:   "Opposing target: on reaching the trigger gap, leave the carriageway to the left via the property access, crossing the ego lane at 4 km/h throughout.",
#:   "Slow down for the lady on the bike opposite, she's going left into that farm entrance, and she's crossing in front of you at barely a totter.",
#:   "Into the petrol station he went, the driver who'd been facing us, going left over our lane so leisurely that I had time to read his whole number plate aloud.",
#:   "I deliver in that street, so I know the house. The owner comes up from the opposite end in his vintage Bentley, and because he's terrified for his paintwork he takes it left over the oncoming lane, mine, and up onto the drive at the pace of a man pushing a pram.",
#:   "Witness B, a dog walker, says the minibus was approaching the grey car from the front. It bore left across the grey car's lane with the intention of entering the care-home driveway, and it did so, in her words, \"no faster than my old Labrador\", with never a break in its movement.",
#:   "Regression for long conflict-zone occupancy, mid-block: the opposing actor leaves its lane with a left turn into a driveway. Speed during the turn is capped at that of somebody walking, so a robotaxi that expects a normal turn will arrive while half the actor is still in our lane.",
#:   "There was this truck with a horse box, right, coming towards us, and the horses must've been made of glass. He had to get to a stable gate on his left, over our lane, and he crept round and through it so slowly my sister managed to finish her entire sandwich.",
#:   "On my way back from the allotment a gentleman on a tricycle was coming the opposite way. He wished to go in at his own gate, which lay on his left, beyond my lane, and he pedalled across so very gently that I switched off the wireless and waved him home.",
#: ]
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "slow"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.8
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "distance to the ego at which it turns"

param OPT_ADV_SPEED = Range(1.8, 3.5)
param OPT_ADV_DISTANCE = Range(12, 40)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do TurnOff(1.4, globalParameters.OPT_ADV_SPEED, 6)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
