#: description = "The emergency vehicle comes toward the ego at speed on the wrong side, in the ego's lane, and moves over only at the last moment."
#: rephrasings = [
#:   "An ambulance comes tearing at us on our side of the road.",
#:   "The fire apparatus was travelling against traffic in the lane of vehicle 1.",
#:   "EMS oncoming in our lane, high speed.",
#:   "The emergency vehicle approaches the VUT head-on on its path.",
#:   "The police drives against us on our lane with blue light.",
#:   "A fire engine passes a jam on the wrong side and fills our windscreen.",
#:   "Blue lights straight ahead, nose to nose, until they jink away.",
#:   "The paramedics take our side of the street and bear down on us.",
#:   "There was a police car hurtling straight at me on my side, and he left it till the last second to get out of the way.",
#:   "Responding ambulance was traveling the wrong direction in Unit 1's lane at high speed and returned to its side just before impact.",
#:   "Fire truck head-on in our lane, fast, ducks out last sec.",
#:   "A priority vehicle approaches in the opposing direction within the lane of the test vehicle and vacates it only at minimal time-to-collision.",
#:   "The ambulance drives fast against me on my side and goes away only at the end.",
#:   "Oncoming EV occupies ego lane, high v, returns to own lane at very low TTC.",
#:   "It came at them with its lights blazing, on their half of the road, and peeled away when they had already shut their eyes.",
#:   "There's a fire engine coming the wrong way at you at a lick, get over, he won't shift until the very end.",
#:   "omg ambulance coming AT me in my own lane n it only swerved like at the very end",
#:   "A police car speeding on the wrong half of the road missed an oncoming motorist by a whisker after yielding at the eleventh hour.",
#:   "The fire engine was on my client's side, bearing down on him, and gave up that side only when a collision seemed inevitable.",
#:   "Wah, ambulance drive opposite in my lane so fast, last moment then siam.",
#:   "Blue lights head-on in my lane, going like stink, and he waits till I've said my prayers before he shifts over.",
#:   "Head-on approach of responding emergency vehicle in own lane with belated evasion",
#:   "COP CAR PLAYS CHICKEN WITH ME in my lane",
#:   "The fire truck barrels at us against the flow and flinches aside at the death.",
#:   "Ambulance, our lane, opposite direction, flat out; ducks away with nothing to spare.",
#:   "Priority vehicle, contraflow in ego lane, high speed, vacates at TTC minimum.",
#:   "Nee-naw coming right at us on our side, then whoosh, it moved!",
#:   "Would you have trusted that fire engine, charging you head-on, to shift eventually?",
#:   "Police car occupies our side, charges, clears off only at the brink.",
#:   "Let an ambulance with blues on race head-on along the ego's own lane and slip across to its proper half just before the two would touch.",
#:   "The fire appliance had filled the wrong half of the carriageway and was storming my way; it relinquished it when I could read the number plate.",
#:   "I see Polizei with big tempo on my track coming to me, and in the latest possible moment it goes over to its own side.",
#:   "Unit 2, an ambulance running Code 3, was northbound in the southbound lane at high velocity and cleared it only an instant before contact with Unit 1.",
#:   "Fire truck responding, opposing our traffic in our lane and not lifting; it will get out of the way, but later than you'd like.",
#:   "Never trust them to be on their side; see, that ambulance is belting up yours towards us and will only tuck in when he's on your bonnet.",
#:   "My wife screamed. There was a fire engine, a big red one, coming at us down our side of the road like a train because the other side was jammed solid, and it only veered off into a space when I could see the driver's moustache.",
#:   "Test case EV-12. Emergency vehicle approaches in the direction opposite to that of the vehicle under test and, against the rule, in the latter's lane. Speed is kept high throughout. The lane is released by a lateral movement at the smallest distance the protocol allows.",
#:   "You tell yourself they're professionals. Even so, when a patrol car is doing seventy on your half of the bypass with its grille aimed at yours, and it stays there, and stays there, and leaves you only when there's barely a car's length left, your hands shake for an hour.",
#:   "Dash-cam from Leeds this week: what you'll see is an ambulance on a shout that has taken the oncoming lane, which is the cammer's lane, and is absolutely shifting. Keep your eyes on the gap, because it doesn't return to the correct side until there's practically none.",
#:   "He'd gone round the queue, sir, that's how he came to be on our side with his siren howling. He was going hell for leather directly at the AV and I was sure he'd never budge, and then, right at the end, he nipped across to where he belonged.",
#:   "Fire engine storming at us, our side, concedes it with inches left.",
#:   "Squad car head-on in my lane, bombing along, dodges dead late.",
#:   "Oncoming ambulance, wrong half of road, racing, gives way at last gasp.",
#:   "Simulate a responding police van that faces the ego in the ego's own lane at great pace and yields that lane when there is next to no room.",
#:   "They are trained for it, no doubt, but that rescue truck was thundering towards me where I had every right to be, and it spared me by a hair.",
#:   "Heads up, Medic 4 is running opposite to the stream in lane one, he's got his foot in it, expect him to peel off very late.",
#:   "The ambulance, it arrives in face of me, on my voie, at a mad speed, and it deports itself only when I already see the whites of eyes.",
#:   "V2, a marked patrol vehicle on an emergency call, closed on V1 head-on within V1's lane and steered clear of it a fraction of a second before contact.",
#:   "The gap between our bonnet and that of the fire engine shrank to a cricket pitch before it quit our side, and it hadn't lifted for a moment.",
#:   "The other carriageway was solid with lorries back to the roundabout. I was alone on mine, thinking how lucky I was, when a pair of blue strobes rose over the crest right in front. It was an ambulance, it was in my half, and it was not hanging about. When it finally whipped back through a hole between two lorries, my mirror twitched.",
#:   "My niece asked what was the scariest thing in forty years of haulage. I told her about the fire engine at Shap. Mine is a wide load, I can't dodge. He's on my side of the road, coming up as I'm going down, foot to the floor, and he leaves it till I can read \"Cumbria\" upside down before he pops across to his.",
#:   "Evaluate the response of the automated vehicle to an approaching priority vehicle. The latter travels at elevated speed, opposite to the legal direction, in the lane assigned to the automated vehicle. Its return to the proper lane is triggered by range, and the range has been chosen so small that a driver would perceive it as too late.",
#:   "I teach the theory as well. \"What do you do when an emergency vehicle comes at you on your side?\" They all say it can't happen. So I play them the clip: siren, a big square front end in the middle of your lane, swelling by the second, and it only steps aside, if you'll pause it here, when it's practically touching the number plate.",
#:   "He knew that the crew had seen him, because the horn was going. He knew also that they did not mean to lose a second over him. On they came, up his side of the street, as quick as that heavy thing would go; and it was no sooner than the very instant in which he shut his eyes that the wind of their passing struck his door.",
#:   "Chat, I kid you not. We are in a robotaxi, no driver. Cop car appears in front, facing us, same lane, easily doing ninety. The robotaxi goes \"braking\". Cop car keeps coming. Robotaxi goes \"emergency braking\". Cop car keeps coming. One single metre before it's goodnight, the cop car jinks over to the side it should have been on.",
#:   "The tender had crossed the centre line to pass a mile of stationary cars. That I accept. What my client complains of is that, having done so, it bore down on him at a speed of fifty miles an hour without the least sign of going back, and relinquished his half of the road only when his vehicle was all but beneath its wheels.",
#:   "We are two old sisters in an old Polo and we don't go out at night. So you may imagine it, young man: a howling and a flashing, and there in our side of Mill Road is the front of an ambulance, coming to meet us like a rocket. It never budged till it was on us, and then it budged in a great hurry.",
#:   "In the log the object first appears at 180 m, heading 180 degrees off ours, lateral offset zero. Class is ambulance. Its speed only ever rises. Lateral offset stays zero at 100, at 60, at 30 m, and it jumps to 3.4 m between two frames, by which time our AEB had been fully on for a second and a half.",
#:   "Please be knowing that I was in correct lane. The police jeep was chasing somebody, I think so, and came from the opposite with full siren in my lane only, hundred speed at least. I was flashing, he was not caring. When there was place for only one goat between us, then only he went to his side.",
#:   "A red wall, a noise, and a gust: that is all the passenger recalls. The driver can add a little. The wall was the face of a fire engine that had come straight up our lane against us, never easing; the gust was it ducking past our wing onto its proper side, having put that off for as long as could be.",
#:   "Blues, our half of the road, head-on, gone at arm's length.",
#:   "Fire engine's grille in our lane, growing, growing, then not.",
#:   "Patrol car on the wrong side, foot down, dodges by a coat of paint.",
#:   "They'd a heart attack to get to and my half of the street to get there by, and not till I'd shut my eyes did that ambulance shift.",
#:   "Set a rescue truck racing towards the ego within the ego's lane, and have it leave that lane only when a crash looks certain.",
#:   "never been so near a fire engines bumper, me on the proper side and it on the same one doing seventy at me, shifted over at the death",
#:   "What use is being in your own lane when a squad car is storming down it nose to nose with you till the last half second?",
#:   "Opposing responder, lateral offset to VUT zero, speed high and rising; lateral offset becomes non-zero at a time to collision of under one second.",
#:   "Two strobes where only tail lamps ought to be, swelling at a terrific rate, and then a gust on the right as they flicked off my line.",
#:   "My mirror was taken off by my own hand, I jerked the wheel so. The ambulance never touched it. It had come down our side of the bypass with the siren going and its bonnet square on mine, a proper lick too, and I'd written us both off when it was suddenly where it should have been all along.",
#:   "The other side of the bridge was chock-a-block. So where do you reckon the police van coming from town went? On mine, that's where. I waited for it to lift off. It didn't, you could hear the motor straining. I waited for it to tuck in. It did that too, when I could see the coffee cup on its dash.",
#:   "Dear Editor, I have every respect for our firefighters. I'd only ask that, when they see an octogenarian in a Honda on the side that is hers, they should return to the side that is theirs somewhat earlier than at a distance of one bus ticket, particularly if they are hurtling along it against her.",
#:   "Operators are reminded that the simulated appliance does not start in the wrong lane. It faces the subject on its own side, at first unhurried; at the set distance it goes over to the subject's lane, puts on full power against it, and at the set, very small, distance it regains its side. Sound the siren throughout.",
#:   "First the headlights flash at me and I thought, which headlights, the road is one way for me and one way for them. Then I understood that they are on mine. A Rettungswagen, it did not brake, it became big like a house. I was praying in two languages. It turned out of my lane between the first Amen and the second.",
#:   "TTC plot, page 6. It falls in a straight line to 0.7 s, which means that the object coming at us neither slowed nor moved aside for the whole approach. At 0.7 s it jumps to infinity. The object was a fire department ladder, in our lane, facing us, and that jump is it clearing off to its own half.",
#:   "My son wants to be a policeman now. We were in the van, on our side, when a panda car with its lights going came bang at us down the very lane we were in. I said Jesus. He said wow. It kept on coming as if we were made of air and only slid over when he'd already got his feet on the dashboard.",
#:   "Nobody plays chicken with eighteen tons of water, is what I used to think. Then one evening the horizon in my lane turned blue. I slowed right down; the blue didn't. I pulled half into the hedge; the blue stayed where it was, dead centre of my lane, bellowing. With one car's length to spare its driver finally gave me my road back.",
#:   "She counted afterwards. There had been three seconds during which the ambulance, siren howling, filled the lane in front of her, its face to hers; two during which it had filled her windscreen; and less than a half, at the very end, during which it leant aside and let her go on living. At no point had its engine eased.",
#:   "Judge: You say the officer was driving on the correct side when he passed you. Witness: When he passed me, yes. It's what he was doing until he was almost passing me that I'm here about. He was bombing along my side, straight for my radiator, and I was in front of that radiator with nowhere to go.",
#:   "Cyclists always hug the kerb, so I had the best seat. In the lane I shared with a bread van there appeared, coming the wrong way up it, an ambulance at God knows what speed. The bread van stopped. I got off. It was still pointing at the bread van's badge when a flick of the wheel sent it past on the far side.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "fast"]
#: position = "oncoming"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 55.0
#: high = 80.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.5
#: high = 14.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far from the ego it moves back"

param OPT_ADV_DISTANCE = Range(55, 80)
param OPT_ADV_SPEED = Range(11.5, 14)
param OPT_SWERVE_DISTANCE = Range(5, 30)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(ownLane(egoRoute)), 1, 0, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) < globalParameters.OPT_SWERVE_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
