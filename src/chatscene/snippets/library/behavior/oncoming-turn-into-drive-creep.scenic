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
#:   "Coach facing us going left into the hotel, at toddler speed.",
#:   "old guy opposite crossing my lane into his drive, took about a year",
#:   "Tricycle from ahead: left over us, garden gate, pace of a snail.",
#:   "He'd been coming up the road towards me, and now his tractor-sized lorry was all over my half, being eased inch-wise leftward into a scrapyard entrance.",
#:   "Opposing actor exits to the left over our lane, destination private access, no junction nearby; velocity during the whole of it does not exceed that of a walker.",
#:   "What the school bus wants, coming towards you like that, is the gates on your side, and it'll be a good long while before the last of it's through them.",
#:   "The cyclist who met us wished to go in by the nursery gate; she bore left over our lane, so unhurriedly that a snail could've kept her company.",
#:   "Our bonnet stopped short of the opposing minibus because it took its left into the clinic's entrance at a pace that gave us half a minute to react.",
#:   "Make it a removal van from the opposite direction, taking the left into number 40 through the robotaxi's lane, slowly enough that a child could walk beside it.",
#:   "It was the length of the thing. The low-loader had been approaching us on its own side, and the builder's entrance was on ours. Round came the cab to its left, at about the rate you'd push a full barrow; then a great deal of trailer; then some more trailer. All that while there was no lane for us to have.",
#:   "I got to know the side of that car rather well. There's a dent on the rear door. There's a sticker about badgers. It had been facing me only a moment before, but its owner lived on my side, and he took it left in front of me and up between his gateposts with the caution of a man carrying soup.",
#:   "I am crossing myself each time I think of it. The bus comes from the front. No crossing is here, no lamp. But on my side of the road there is the yard where the buses sleep, and he goes to bed, slowly, slowly, to the left through my lane, like an old cow to the stable. I am standing with smoking tyres.",
#:   "Long-occupancy case B. An opposing vehicle deflects to its left some twenty metres before us, through our lane, towards a garage forecourt. Since it's doing about 1.2 m/s, the time between its front bumper entering and its rear bumper leaving our lane comes to nearly eight seconds. There's no pause; the slowness itself is the hazard.",
#:   "Mrs Petrov, 91, is a careful woman and wishes that put on record. She was driving home, in the opposite direction to the constable. Her bungalow is on the side he was using. She steered over his lane and onto her own crazy paving in first gear, \"so as not to wake the cat\", and she cannot see what his siren was for.",
#:   "Before the hedge was cut, there was just a voice from the telly saying the AV would always yield. Well, it did. A grocery van came up the lane from the other end, meaning to deliver at the Grange. It put itself across the AV's path, leftwards, to get in at the drive, dead slow because of the eggs, and the AV sat there like a lamb.",
#:   "Witness in the café says she'd had time to butter both halves. The lorry came from the direction opposed to the motorcycle's. It slewed gradually to its left, over the motorcycle's side of the street, so as to enter the brewery yard there, and its wheels, she says, were turning \"like the hands of a clock\".",
#:   "I thought I'd lost my brakes, but it was only that he'd taken all of time itself. This chap on a cargo bike, four crates, coming towards my cab. He looks, he sticks out his left arm, and then he waddles that bike through my lane to the pub's back gate at a rate where I could've got down and held it open.",
#:   "You've got an oncoming hatchback with the indicator going. Ask yourself, left to where? There's no road there. There's a drive, though, on our side. So we wait, since he's begun it already, and he's not going to be rushed, is he, he's tiptoeing over our lane like somebody coming in late from a party.",
#:   "At first it was two headlamps that met us, then it was one, and for a long, long time after it was a whole flank. The hearse, I mean, that came from the town and had to be taken left into the mourners' gateway on our side. It wouldn't have been decent to hoot. It went over our lane at the pace of those who'd follow on foot.",
#:   "Complaint no. 88. Customer's robotaxi was halted in a residential street for \"an eternity\". Review shows one pickup from the opposite direction on its way to a carport on the customer's side. It went over the customer's lane in a left-hand arc at three km/h, probably since there were planks on the roof. The taxi's conduct was correct.",
#:   "Oncoming camper, over our lane, garden gate, at grandmother's pace.",
#:   "post van facing me took a WEEK to get left across into number 9",
#:   "Bike from ahead: left over your lane, someone's yard, barely rolling.",
#:   "It was a good ten seconds between the moment the oncoming hearse's bonnet entered our lane and the moment its tail was out of it and in the vicarage drive.",
#:   "I'd time to read the whole list of services on the side of that van, which had been facing me and was now on its way, snail fashion, to a gate on its left.",
#:   "If the lady coming towards you is looking for her own gateway over here, on your side, she'll have it found by Christmas; you may as well put the handbrake on.",
#:   "Opposing target departs its lane to the left at the property entrance; transit of the subject vehicle's lane at 1.2 m/s, uniform, without standstill, ending on private ground.",
#:   "Make the oncoming lorry want the builder's yard on our side of the road, and make it want it so gently that an ant could get out of its way.",
#:   "What held up the shuttle was length divided by speed: eleven metres of coach from the opposite direction, bound for the hotel forecourt through our lane, over a walker's pace.",
#:   "The gate stands on my side of the street. The car was on the other, coming my way, with a wardrobe on its roof. You see the problem. He'd not trust that wardrobe to anything above two miles an hour, so once he'd put himself over my lane I watched the wardrobe go by, left to right, like a ship leaving harbour, and in at the gate.",
#:   "Nothing happened fast, and that was the mistake I made. The oncoming Peugeot's front wheels had turned towards a drive on its left, I'd all the distance in the world, I thought he'd be over by the time I came. He wasn't over. He was half over. The half of him that still lay in my lane was rolling towards its garage as a glacier does.",
#:   "Blocked-lane dwell 8.6 s, no junction within two hundred metres. Cause: the bicycle with trailer that we'd tracked as opposing traffic took a line through our lane to its left, to an allotment gate. Its velocity in this phase is such that the tracker twice declared it a static object. It was in motion at all times.",
#:   "My son has got a torch and he likes to inspect. He said, that man has a broken mudguard, a sticker, a rust hole and a tail light out. How can you know all this of a car that a moment before was in front of us, face to face? Because it went across us to its left so slowly, to the neighbour's court, that the torch had time for all four.",
#:   "The bollards in front of the surgery are staggered, so a bus that comes down the hill and wants the surgery car park must cut over the uphill lane. Which it may. What it may not, I wrote to the council, is to do so at the speed of honey. I was the uphill lane. I'd finished my sandwich before the last of its windows had gone in past the bollards.",
#:   "You know the sound gravel makes under a tyre when someone is trying not to wake the house? That's the speed. He'd come down the lane to meet us, seen the drive on his left, and was now laid straight across our path, with the gravel of it crackling under his front wheels, one pebble at a time, and his back wheels not yet in the road's middle.",
#:   "There's a difference, my lord, between a driver who takes a chance and one who takes his time. My client took no chance. He was opposite, he saw the plaintiff far off, and he set out to bring his tractor lorry through her lane into his own yard, on his left. He then took his time. He was still taking it when she arrived.",
#:   "From the AV's log, with my notes. 14:02:10, beer truck approaching on the opposite side. 14:02:14, beer truck's nose points at the pub's cellar yard, on our side. 14:02:15, we stop. 14:02:31, we're still stopped, and the last barrel goes by the camera. I've walked the distance the truck did in that time, and I wasn't walking fast.",
#:   "Me I come with scooter. From front there comes auto-rickshaw full of schoolgirls, he must go in the school gate, which is at my hand, for him it's left side. He comes over my way, okay. But every bump he's afraid they will fall, so he's rolling like one egg. All the girls waved to me. I had to wave back to every one.",
#:   "It wasn't rude, and it wasn't dangerous, it was just eternal. He'd come along on his tricycle with the milk churns, from the far end, and of course his dairy is on this side, so over he comes, in front of Dad's Jag, to his left. Dad drummed on the wheel. You could see the spokes. You could count them. And then each churn went in under the arch.",
#:   "Everything in that street happened as under water. The limousine that had been coming to meet us put its long face round, to its left, to the gate of the embassy. Yet it floated over our side of the road with such deliberation that the chauffeur opposite had lit, smoked and dropped his cigarette by the time the flag had passed in.",
#: ]
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "slow"]
#: position = "oncoming"
#: maneuver = "straight"
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
