#: description = "The car ahead brakes without signalling and turns right off the road into a driveway."
#: rephrasings = [
#:   "The car in front hits the brakes and dives into a driveway on the right, no blinker.",
#:   "Vehicle 2 slowed abruptly and turned right into a private access.",
#:   "Lead brakes, right turn into property, no indicator.",
#:   "The target decelerates strongly ahead of the VUT and leaves the carriageway to the right.",
#:   "It brakes before us and goes to right in an entrance of house.",
#:   "The delivery van we follow anchors and ducks into a yard on the right-hand side.",
#:   "A motorbike ahead checks hard and peels off into a petrol station.",
#:   "Late for his parking space, the driver ahead slows sharply and hooks right off the street.",
#:   "motor in front braked out of nowhere and ducked right into someone's drive, no indicator or nothing",
#:   "The vehicle ahead slowed abruptly and, without using a turn signal, turned right into a private driveway.",
#:   "Van ahead: brk, no blinker, R into entrance.",
#:   "The lead vehicle decelerates and leaves the carriageway to the right into a property access; direction indicator off.",
#:   "The bike in front brakes and goes right to a house, he doesn't give the lights for it.",
#:   "Lead slows, then exits right into a lot entrance; blinkers must stay off.",
#:   "The bus had shown no winker; it simply braked in front of them and vanished to the right through a gateway.",
#:   "And he's braking, why's he braking? Ah, he lives there: right, onto his own forecourt. An indicator would've been nice.",
#:   "car in front brakes outta nowhere n turns right into someones house, no indicator",
#:   "A motorist who braked and disappeared through a gateway on the right gave no warning to those following",
#:   "You gave no signal before slowing and quitting the road rightwards into the premises?",
#:   "The car in front no signal, brake and then cut right into condo, like that also can",
#:   "Drops the anchor ahead of me and vanishes up some bloke's drive on the right, indicator's an optional extra",
#:   "Unsignalled braking of lead vehicle with right-hand exit into private access",
#:   "NO BLINKER: van brakes hard and dives into a driveway on the right",
#:   "The motorbike ahead braked and burrowed into a gateway to its right.",
#:   "No winker, just brakes, and the cab ahead was off right up a driveway.",
#:   "Simulate the lead SUV slowing unannounced for a drive on the right.",
#:   "Fire engine before us checks sharply, swings right into its yard, unindicated.",
#:   "Without any signal: lead brakes, exits road rightward via dropped kerb.",
#:   "Gone to the right through a gate, indicators dead, after a hard brake.",
#:   "The lorry we were behind lost all its speed for no visible reason, and only when it bent off right into a builder's yard did we understand, because it hadn't signalled.",
#:   "Policyholder was following a camper when it retarded suddenly and entered a residential drive on the right-hand side; its turn signal had not been operated.",
#:   "The lead vehicle decelerates to near standstill with lamps for direction inactive, then departs from the road through a 90-degree right turn to a private entry.",
#:   "I need a bus in front of the ego which, not using its flashers, brakes hard and leaves the road by a depot entrance on its right.",
#:   "He is braking in front, I am thinking what happened, no indicator nothing, then simply he has gone inside one compound on right side.",
#:   "Oh he's home, is he, and would it have killed him to indicate before he slammed on and pulled in at his garage on the right?",
#:   "I was keeping a fair distance from the pickup, as my late husband taught me. Its brake lamps came on very bright, there was no little orange light at all, and it went off the road to the right, up between two hedges to somebody's house.",
#:   "V2 was in the lead. Approaching a residence its operator applied the brakes heavily, with no turn signal displayed according to three witnesses, and made a right turn across the sidewalk into the driveway, so that V1 was confronted with the nearly stopped rear of V2.",
#:   "Off the record, half the trade does it. You spot the delivery address late, you stamp on the brake, you don't bother with the stalk, and round you go to the right into the entrance while whoever sits on your tail finds out what his own brakes are worth.",
#:   "Police car two hundred yards ahead of us, then fifty. It wasn't flashing, it wasn't indicating; it had simply braked, and the next thing it did was leave the street on the right, nose first into the drive of number eleven.",
#:   "The robotaxi follows a motorcycle. At the trigger the motorcycle cuts its speed drastically, gives no hand sign or lamp signal, and turns ninety degrees to the right, over the kerb line and away onto a private plot.",
#:   "Lead van, unsignalled: heavy brake, ninety right, up a private ramp.",
#:   "Who brakes like that and dives right into a yard without winking?",
#:   "Motorbike ahead anchors, no indicator, ducks off right between two gateposts.",
#:   "Our leader shed nearly all his speed without any lamp to explain it but the red ones, then nosed off the road to the right into a farm entrance.",
#:   "Make the saloon ahead of the ego brake sharply, keep its indicators off, and leave the road over the right-hand pavement into someone's front yard.",
#:   "That bus braked so I braked, and next thing it was rolling through the depot gates on the right, and I never did see a flasher.",
#:   "A lead vehicle turning right into a private access, following strong deceleration and in absence of turn indication, is presented to the VUT at 40 km/h.",
#:   "Auto in front is pressing brake for no reason, no light no hand, then he has entered right side only into one apartment gate.",
#:   "It was because he lives there that the pickup ahead slowed so violently and disappeared rightwards behind a hedge, but he might have indicated.",
#:   "First came the red, both sides, very bright, and I waited for the yellow on one of them. It never came. The lorry was nearly standing by now and I nearly sat in its bed; then its tail swung round past my bonnet and the whole thing was off the street on the right, climbing somebody's drive.",
#:   "The claimant contends that a signal would have cost nothing. The hearing heard that the Volvo, driving ahead of her, was braked to walking pace with its indicators dark, and that it departed from the carriageway at right angles, on the right, over a dropped kerb which serves a dental practice.",
#:   "He waved at his kids. I could see them hopping on the garage forecourt, on the right-hand side, and I should have put two and two together, for the ambulance in front of me had no blinker going. It stamped itself down to nothing and bent off right to where the kids were.",
#:   "V2 was directly ahead of V1, both westbound. V2's brake lamps activated abruptly; no turn signal was observed by either following driver. V2 then turned north, to its right, into the driveway of a residence and had its rear wheels on the apron when V1, braking, slid past on the wet grass.",
#:   "Right, what did I say about \"expect the unexpected\"? There's an SUV in front, no lights flashing. Brakes, and hard ones, so we do the same. And off it goes to the right, look, through that gap in the wall and up to the house, and not a blink from it from beginning to end.",
#:   "The rain was coming sideways and there was just that one moped to follow. It had been a blessing, a tail light in the murk. Then the light flared, it got terribly near, it went off at a right angle to the right with no warning lamp, and the next time I saw it, it stood under a carport.",
#:   "Ticket 902: brake reaction OK, but prediction head gave 0.97 for \"lane follow\" until the end. Lead vehicle has indicators off, decelerates from 12 to below 1 m/s, then yaws right through eighty degrees, leaves the road edge and goes into a parcel of land with a carport. Please add to training.",
#:   "It was on account of the sign, \"Fresh eggs\", so small that one reads it only when one is past it or nearly. The fat Mercedes before us read it. Its rear rose, no indicator spoke, and it swung to the right off the highway and into the egg farmer's yard while we slid to where it had been.",
#:   "I was riding behind the school coach and I was looking at its blinkers because Papa says you should. They were black, both of them. But the coach went slower and slower very fast, so that I had to skid, and it turned itself to the right, away from the street, into the place where the hotel is.",
#:   "How we lost him, you ask. We were following discreetly, two lengths. On the straight by the nurseries he dropped anchor, not signalling, and we shot up to his number plate; and before we had sorted ourselves out his plate had gone off to the right, up a lane marked Private, with the gate closing.",
#:   "Monsieur the plumber had his head out of the window in order to find the number. When he found it he has blocked nearly his wheels in front of my car, he didn't think of the clignotant, and he plunged to his right side into the court of the house. I have stopped with one hand from his ladder.",
#:   "No wink: lead SUV anchors up, hooks right through somebody's gate.",
#:   "From lead vehicle to parked in his garage, right-hand side, no signal.",
#:   "Let our leader brake blind and peel right into a yard.",
#:   "All I had for a warning was his stop lamps, close and getting closer, and then his flank as he went in at a farm gate on the right.",
#:   "Its indicators stayed as dark as its windows while the coach ahead fell to a crawl, and it was by the hotel entrance on our right that we got our road back.",
#:   "Why had the police car before me all but halted? Ah, for the station yard, rightwards, over the pavement; it would've been kind to blink.",
#:   "The lead target reduces speed to near zero, direction lamps unlit, and clears the lane by way of a property access on its right.",
#:   "On my own moped I did brake in time, for the van I was trailing had dropped to nothing and ducked off right up a private path, without one flash.",
#:   "He does not show, he brakes only, so I think he has problem with motor; but no, he lives there, he enters at right in his garage.",
#:   "The hole in the hedge is to blame. You can't see it until you're on it, and the fellow in front couldn't either. First his tail came rushing at me, both reds lit and nothing orange. Then it wasn't a tail but a side. Then there was a clear lane, dust over the hedge on the right, and a dog barking.",
#:   "The bulbs were examined by the laboratory. Filaments of both stop lamps stretched, that is to say they were lit at impact; filaments of both direction indicators cold. This fits the marks, which show V2, the leader, braked almost to rest before its front wheels were put over to the right and mounted the apron of the residence.",
#:   "Her mother's house, she told the court, comes up very quickly. The bus driver behind told it that he'd have known nothing of mothers or houses, since what he saw was a car losing all of its speed in his lane, silently as it were, no flasher, and then tilting over the kerb on the right into a carport.",
#:   "The motorcycle ahead had a passenger, and the passenger had a hand free. It would have been enough to stick it out. But they just sat up, both of them, the bike dived on its forks, and I was looking for a place to hit when they leaned off to the right and bumped up the ramp of a repair shop.",
#:   "Where there's a surgery there are people who find it too late. You'll see. This one ahead of you hasn't touched his stalk, has he? So you thought he was going on. But his nose has dipped, brake with him, and he's away, right, through the gates, and he is going to be on time for his teeth.",
#:   "As prompts go, \"brake lights, then nobody\" isn't much, but it's what I'd like. An ambulance leads the ego. It gives no turn signal. It slows so sharply that the ego has to do the same, and then it is gone from the road at right angles, on the right-hand side, into a gateway, and the lane is free.",
#:   "Post from r/drivingrage. I was behind a lorry with one of those \"blind spot\" stickers. He does the full anchors bit, cardboard flying off my seat, and I'm staring at his lights for a clue, left one, right one, nope, nothing's ticking. Clue arrives when he folds round to the right and backs of his wheels vanish into the sawmill.",
#:   "The first that the parents heard was a hymn to speed by the tyres. It was the priest, arriving for lunch. He drove ahead of the new electric car, and saw their letter box; he stopped, nearly, as one stops for a miracle; and with no sign to those who followed he wheeled in over the pavement, on his right, beneath our chestnut.",
#:   "Sequence reconstructed from the ego's video. Frame 12: lead's stop lamps on. Frame 40: range has gone from 24 to 7 m. Frame 44: lead's heading begins to go clockwise. Frame 71: heading is eighty degrees from the lane, front axle over a dropped kerb, house number 16 visible above its roof. Turn lamps: off in all frames.",
#:   "I carry eggs, sixty trays. So I hang well back, and I watch for indicators like a hawk. Hawk saw nothing. It saw the taxi in front go down to walking speed as though it'd hit treacle, then swing off right between two white posts. There were nine trays left when I'd stopped sliding, and he was paying his fare on the drive.",
#:   "In our lane there are villas with gates from both sides. One big car was before me. At villa number four, right side, gate was opening by remote. I did not connect these things, because blinker he had not put. Only when he has braked so that I smelt it, and gone in at that gate, I have connected.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: lead vehicle turning; own code"
#: [slots]
#: actions = ["brake", "turn-right"]
#: place = "road"
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it turns off"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_BRAKE = Range(0.6, 1)
param OPT_ADV_SPEED = Range(1.5, 3)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.5
    do TurnOff(-1.4, globalParameters.OPT_ADV_SPEED)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 4 seconds
    do Halt()
