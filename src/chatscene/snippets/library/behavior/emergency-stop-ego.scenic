#: description = "The emergency vehicle overtakes the ego, cuts in and stops in front of it."
#: rephrasings = [
#:   "The cops pull past, swing in and stop us dead.",
#:   "The patrol car passed vehicle 1, entered its lane and stopped ahead of it.",
#:   "Police overtakes, cuts in, stops, blocks.",
#:   "The emergency vehicle overtakes the VUT, cuts in and brakes to standstill in its path.",
#:   "The police goes before us and makes us to stop.",
#:   "A fire engine surges by and pulls up at the blaze right under our nose.",
#:   "The ambulance gets round us only to halt at the casualty in our lane.",
#:   "Traffic patrol bars our way after sweeping past.",
#:   "the old bill went past me, pulled across my nose and made me stop, proper traffic stop",
#:   "Officer passed the suspect vehicle on the left, moved in ahead of it and halted his cruiser to force it to a standstill.",
#:   "Police: passes us, swings in ahead, halts, way barred.",
#:   "An emergency vehicle passes the VUT, changes lane ahead of it and brakes to standstill, obstructing the lane.",
#:   "The police goes by me, comes in front of my car and stands there, so I can not go on.",
#:   "Pull-over manoeuvre: squad car passes the AV from the rear, tucks in front and parks up as a barrier.",
#:   "The patrol car had drawn past him, slotted itself in before him and come to a halt, and there was nothing for it but to stop too.",
#:   "Get past him, get in front and box him in, 14; bring it to a stop right ahead of him.",
#:   "we're getting PULLED OVER the cops went round us and blocked us in front",
#:   "Officers drew past the suspect, took the lane before him and brought him to a stop by standing in his way",
#:   "The constable went by my client, placed his vehicle before hers and there stopped, compelling her to do likewise",
#:   "Mata car overtake us, come in front and stop, block until cannot move",
#:   "Old Bill whizzes by, plonks himself across my front and that's it, I'm nicked, can't go nowhere",
#:   "Enforced stop: emergency vehicle passes, moves in ahead and obstructs the lane at standstill",
#:   "COPS overtake and BOX ME IN at the front",
#:   "The patrol car rounded us and barricaded the lane.",
#:   "Blue lights come past, slot in ahead and stop us.",
#:   "Fire tender goes round us, pulls over our bows, parks there.",
#:   "PULLED OVER: police van passes, dives in, halts in front",
#:   "Let the squad car get by, move in and wall off our lane.",
#:   "Patrol unit overtook, took my lane, braked to nought; I was stuck.",
#:   "The police car came from behind and went past, then it got in front of our car and stopped, so Mummy had to stop as well.",
#:   "An ambulance with its lights going drew ahead of the robotaxi on the outside, came across into its lane and stood there so nothing could move.",
#:   "Emergency target: passes the VUT in the adjacent lane, enters the VUT's lane, brakes to rest and remains there as an obstruction.",
#:   "Control, we are past the grey Audi and in front of it now, we've brought our vehicle to a standstill in his lane, he's hemmed in.",
#:   "The policemen have overtaken me, then they have put themselves before my car and have braked until zero, so the road was closed for me.",
#:   "Our way was barred by the same patrol car that seconds before had gone flying by and cut across to our side of the marking.",
#:   "I saw the blue flashes in the mirror and thought they were after somebody else, so I kept going. They swept along my side, angled in front of my bonnet and braked until both of us were standing, with their back doors a yard from my bumper.",
#:   "Vehicle 2, a marked patrol car, accelerated along the lane to the left of Vehicle 1 until it was ahead. It then entered Vehicle 1's lane, applied its brakes and halted, leaving Vehicle 1 no option but to stop behind it, as was the officer's intention.",
#:   "We want to see whether the AV understands a traffic stop. Have the police vehicle approach from the rear in the next lane, go beyond the AV, merge close in front and decelerate down to a full stop, staying put as a roadblock.",
#:   "The fire engine went by me like thunder on the dual carriageway, and before I'd got my breath back it had swung over into my lane and pulled up short. It stayed there too, right across where I wanted to be, with the crew jumping out.",
#:   "He had half hoped that the wail behind him was meant for another. But the cruiser glided alongside, left him behind, leaned into his lane and sank to a halt on its front springs, and the road ahead was shut like a gate.",
#:   "Squad car swept by, planted itself before us, end of journey.",
#:   "Went past, came over, anchored up, walled us in: blue lights.",
#:   "Fire appliance outpaces us, takes our lane, parks there crosswise.",
#:   "The highway patrol had come up the next lane, got in front of me, and brought itself to rest so that I had nowhere to go.",
#:   "Vehicle under test is passed by a police unit, which then moves across ahead of it, decelerates to zero and holds the lane shut.",
#:   "Dispatch, he's not getting away: we've gone by him, we've cut over in front and we're sat dead still across his lane.",
#:   "Sir, the ambulance was crossing me from the right side, then entering my lane, putting brake fully and standing, so I was having no way.",
#:   "Why would a fire engine come tearing up beside us, swing in ahead and pull up, if not because the casualty lay right there in our lane?",
#:   "Have a patrol car come from the rear, get past, come across the ego's bonnet, pull up in its lane and leave it no way forward.",
#:   "I wasn't being followed, I was being stopped, only it took me a while to grasp that. The siren had gone along my right-hand side and got ahead of me. When I next looked there was a bumper with a chequered stripe straight in front, standing, and a policeman climbing out with his hand raised.",
#:   "It shall be verified that the AV recognises an enforced halt. The emergency vehicle travels in the neighbouring lane until it is ahead of the AV, transfers into the AV's lane, and brakes until stationary. It stays in that place as an obstacle and is not to be driven round.",
#:   "You'll have heard it before you saw it. Let it come by, good, and now it wants to be in here ahead of you, so lift off. See its nose go down? It isn't going on, it's putting itself to rest in front of you, and that's you told to stop as well.",
#:   "There we were, engine ticking, looking at the words FIRE AND RESCUE from about two yards. The thing had come howling up the outside a moment before, dived over to our side and stood on everything. Beyond it a Fiesta was burning. It made a very good roadblock, and nobody behind us could move either.",
#:   "The pursuit ended on Harbour Road at ten past three, officers said. A marked Volvo drew up alongside the stolen hatchback, pulled ahead, edged over into its path and came to a standstill. With the Volvo stationary in front of him the suspect had no choice but to give himself up.",
#:   "Our car is a good girl, she stops by herself. The police overtook her on the left, this was normal, then it went before her, much too near I would say. Its brake lights became red and it braked until it stood and it did not go away any more, so we both stood.",
#:   "At 14:06 the occupant noted sirens to the rear. At 14:07 there was a stationary ambulance across the lane ahead, rear doors already open, that had not been there a minute earlier. It had travelled by on the left, merged in front of V1 and made an emergency stop. V1 halted with 1.5 metres to spare.",
#:   "From my bike I saw the whole thing. The van had the lane to itself until the cops flew up next to it, kept going till they were clear of its front, and cut it off. They stopped hard, right there, on purpose. The van driver looked at the gap on both sides and there wasn't one.",
#:   "A traffic stop like in the films, bro. I'm doing seventy, they come up beside me, I think they're going on to some accident. Nope. They slide over in front, the anchors go on, it's sixty, thirty, nothing, and now I'm looking at the back of a parked cop car and can't go anyplace.",
#:   "The lady was adamant that she had done nothing. All the same the motorcycle policeman's colleague in the car went round her, put himself between her and the open road, and slowed until he stood quite still. She had to stay there behind him for a quarter of an hour.",
#:   "Emergency stop practice is one thing, but I never thought my examiner would see a real one. What she saw was blue flashing going from the mirror to the side window to the windscreen. Then the flashing was no longer moving; it was square across our lane, and so our test ended behind a police van.",
#:   "Siren behind, siren abreast, siren in front; nobody's moving now.",
#:   "Squad car slides round the ego, corks its lane, cuts its engine.",
#:   "ambulance flew by then parked itself smack across my bumper wtf",
#:   "It wasn't till the paramedics jumped down that I understood why they had raced by, come in before our bonnet and nailed themselves to the road there.",
#:   "Unit overtook subject, took up position in subject's lane, brought speed to zero; subject unable to continue, engine off, hands visible.",
#:   "We have now a wall with the word POLICE on it where was free street; it came by left, moved in and went not one metre further.",
#:   "Let the fire engine get by the AV in the lane alongside, slide across its bows, haul up short and remain as a barricade.",
#:   "Is it not the case that the constable's vehicle had gone from behind you to before you, and was standing, when your bumper touched its step?",
#:   "The driver of V1 could not proceed: the patrol vehicle, formerly at its rear quarter, stood foursquare ahead in its lane after drawing past and pulling sharply up.",
#:   "The blue flicker came to us in three places. It came first in the mirrors, on Dad's worried face. Then it was on the hedge to the right, running along with us, and then it was on the road in front, where it quit running. And after that there wasn't anything to do but stop and find the insurance.",
#:   "I'd only wanted to be helpful and stayed put in my lane so they could get by. Get by they did. But the ambulance wanted the old chap lying by the bollard, and the bollard was mine, so it came in tight ahead of me and pulled up dead. I stood there nose to its doors for twenty minutes, and was given tea.",
#:   "Request from the takeover team: an authority vehicle that ends the AV's journey. It starts in the AV's rear, gains on it by the other lane, cuts in when it has a few metres in hand and decelerates to nil. It doesn't drive off again. The AV has to come to rest behind, with its lane plugged.",
#:   "\"You'll sit here till he says different,\" I told my pupil, because there was nothing else to be done. We were looking at a chequered tailgate from four feet. It had come up the outside with all its bells on, swept in where we were about to be, and planted its brakes; and the sergeant was already putting on his hat.",
#:   "Three marks on the tarmac, says the sketch. The first is a faint curve from the right-hand lane into the left one, ahead of where the stolen Audi was. The second, from the same tyres, is straight, thick and black. At the end of that the squad car's wheels are drawn, and two metres behind them the Audi's bonnet. It had nowhere to go.",
#:   "From up in the cab I could see right over him, so I knew why: pallet in the road, glass everywhere. The motorist behind couldn't. All he knew was that a fire tender had gone hooting by his door, cut in, and then let its whole length come to a stand before him with a hiss. He leaned on his horn, the fool.",
#:   "The kerb stones crawled, then stayed where they were, and Lena saw that they had been stopped. No one had told them to. The long white car with its turning lamp had merely drawn level, drawn ahead, leaned over on to their side of the line and ceased to move. Its red lights shone upon their radiator like a closed door.",
#:   "Wheel-arch to wheel-arch with the copper, I'm looking at him, he's looking at me, he's pointing down with one finger. I don't get it. Next thing he's forged on a length, tucked in, all his tail lamps ablaze, and he's going nowhere. I got it then. Stopped with my plate kissing his. Finger meant here.",
#:   "The planner was waiting for the ambulance to clear off up the road, as every ambulance in the training data does. This one had reached the patient. Passing on the right it merged four metres before us, braked at 0.8 and set the handbrake. Our car halted, waited for it to leave, and is waiting yet.",
#:   "I did nothing wrong, madam insurance, so I did not think that it was for me. The gendarmes doubled me at the left, very fast. My lane was mine one second more, and then it was theirs, and they stood in it, two blue men walking to my window. My passengers had the nose on the seat in front.",
#:   "BREAKING from the bypass: chase over. Helicopter shot has the runaway camper in lane one, the interceptor creeping up on its right, half a length in front, a full length, then nudging across so the camper's got brake lights in its face. Both at walking pace. Both at nothing. The camper's door is open and, yes, they've got him.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "cut-in", "brake", "stop", "block"]
#: position = "behind-beside"
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.5
#: high = 6.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_AHEAD = Range(1.5, 6)
param OPT_BRAKE = Range(0.6, 1)

behavior AdvBehavior():
    do DrivePath(advLane, 14) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 9) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE)
