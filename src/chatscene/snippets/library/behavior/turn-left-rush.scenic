#: description = "The crossing car launches into a left turn in front of the ego, gaining speed."
#: rephrasings = [
#:   "he guns it out of the side road and swings left right across us",
#:   "Vehicle 2 accelerated from the stop line into a left turn across the path of Vehicle 1.",
#:   "from the line, full throttle, left, across our bows",
#:   "The target, waiting at the line, accelerates into a left turn that crosses the lane of the VUT.",
#:   "The motorcycle starts with much gas and turns left before the ego.",
#:   "A biker snatches a gap and storms round to the left.",
#:   "The police car sprints off to its left with squealing tyres.",
#:   "Foot to the floor, the taxi nips left ahead of us.",
#:   "He shot out of the side road, swinging left in front of me and picking up speed all the way.",
#:   "Unit 2 accelerated hard into a left turn from the cross street ahead of Unit 1.",
#:   "Side-road car floors it, L-turn ahead of ego.",
#:   "The crossing target begins a left turn in front of the VUT with increasing speed.",
#:   "The motorbike from the side street turns left before me with a lot of gas.",
#:   "Cross-traffic actor does a hard-throttle left turn out in front of us; not from the opposite direction, no stop.",
#:   "He came out of the side street like a cork from a bottle and swept round left ahead of her, faster and faster.",
#:   "That one waiting on the side's going for it, he's booting it round to the left in front of you.",
#:   "she shot outta the side street going left right in front of us n kept speeding up",
#:   "A car burst from the side road, wheeling left before traffic and gaining pace throughout.",
#:   "You emerged from the minor road, to the left, ahead of my client, with your foot hard on the accelerator?",
#:   "From the side road he came fast, taking left in my front, increasing speed some more.",
#:   "Bursts out of the side turning and slings it left under my nose, faster by the yard.",
#:   "Accelerated left turn of cross traffic ahead of ego.",
#:   "CAR LAUNCHES OUT OF SIDE STREET, LEFT TURN IN MY FACE",
#:   "The police car sprang left out of the side road, quickening.",
#:   "Minor-road Subaru catapults itself into a left turn ahead of the AV.",
#:   "Left out of the cross street, revs climbing, inches from us.",
#:   "Make the motorbike at the give-way go left before us under full power.",
#:   "Quicker and quicker, the cab rounded leftwards out of Vine Street past our nose.",
#:   "Crossing traffic, left turn, speed building from zero, ego in the way.",
#:   "A saloon that had been held at the mouth of the side road took its chance, piled on the power and went round to its left in front of our car.",
#:   "Starting at the line of the intersecting road, the target follows a left-turn path ahead of the VUT with a continuous positive acceleration of 3 m/s².",
#:   "Witness was on the bench outside the bank and saw the ambulance pull from the lane by the bank, bearing left across the traffic and putting on speed all the while.",
#:   "I'd like a car from the intersecting street which, just as the robotaxi arrives, steers left ahead of it and doesn't ease off but keeps pressing the gas.",
#:   "L'auto at the side street, he starts with all the force, he turns to his left before my nose and he becomes only faster in the curve.",
#:   "The lad in the Fiesta's looking your way from that side road, he's thinking about it, and he's off, left in front of you, gunning it the whole way round.",
#:   "I was going straight on past the end of Quarry Lane and there was a biker waiting in it, one boot down. He gave it a fistful, pulled out and heeled over to the left right in front of my wheels, gaining speed with every yard he travelled.",
#:   "V2 had halted on the minor leg, perpendicular to V1's travel. Its operator entered the intersection under heavy acceleration, steering left. Data from V2 shows eleven mph as it crossed the first lane and twenty-four mph on completion of the turn ahead of V1.",
#:   "Blue lights coming out of the station road on my right, no siren. The fire engine dug its back wheels in and made its left, swinging by my front bumper, and I could hear the thing winding itself up through the gears while it was still in the bend.",
#:   "Typical for taxi men at six in the evening. They don't wait in the side street for a hole in the traffic, they make one: foot down, wheel to the left, across your bonnet, and the closer you come the harder they push the accelerator.",
#:   "Sim note on timing: the actor stands at the end of the crossing arm, not the opposite one. When the ego is near it begins a left turn through the ego's path, and because its throttle is held down, it is much faster at the exit than at the entry.",
#:   "Side-street Mini rockets round to the left just ahead of us.",
#:   "Fire engine, cross street: left turn before the AV, ever quicker.",
#:   "Out of the alley, hard left, revs soaring: one scooter.",
#:   "From the arm at right angles to ours a Jeep sprang out, wheeled to its left ahead of our bumper and had doubled its speed by the time it straightened.",
#:   "A left turn from the intersecting road into the VUT's path is performed by the target under sustained positive acceleration.",
#:   "He is coming from the small road, he is seeing me also, still he has given full race and taken left turn from before my bonnet.",
#:   "Let the taxi waiting in the side road bolt, bending left in front of the ego, with the pedal pressed all the way round.",
#:   "The operator of V2, who had been waiting at the side road, pulled out under power and turned left ahead of V1, continually gaining speed.",
#:   "I would have given her the gap if she had asked, but she stormed out of Elm Road, left-handed, across my nose, with the gas wide open.",
#:   "What you notice first on the recording is the sound, a small engine being asked for all it has. Then the moped comes into view out of the lane on the right, leaning to its left. It passes the lens with a yard to spare, and it's plainly going quicker at the end of its curve than at the start.",
#:   "My ladder was on the roof, so when I braked it carried on. I braked for an estate car which had been waiting in the mouth of the side road with its indicator going for left. It did wait, until I was about three lengths off, and then it took off round that corner in front of me with its tail down, faster and faster.",
#:   "Police car, no lights on, standing in a farm road to our right. It had a call, presumably. We were nearly there when gravel came flying out backwards and the car came out forwards, swung to its left over our lane and was pulling away harder every moment, so that our own trip was interrupted by a full stop.",
#:   "Eleven months I've been telling pupils that the ones in the side roads wait. They mostly do. This hatchback doesn't: he's off the line with a chirp, he's turning left ahead of us, and he isn't turning sedately either, his foot's staying down, so we brake now and grumble afterwards.",
#:   "Of the two phases the second is the critical one. In the first, the crosser merely stands at the entry of the minor arm. In the second it turns left through the ego's lane, and, since its throttle is kept open during the turn, it reaches the conflict point much earlier than a turner at constant speed would.",
#:   "It was the gentlest of evenings, and the motorcycle stood at the end of Church Walk like something on a plinth. As her sister's new electric car drew level with the yew, the thing came to life. It lunged into the high street, leaned over to its left before their very lamps, and its voice rose and rose.",
#:   "I'm the one who was in the side street, so let me say it. I was turning left, I'd a lorry up behind me, and I saw the robot car on the main road. I thought if I really go for it I'll make it, so I really went for it, and I kept my boot in till I was round.",
#:   "Injury: whiplash, front passenger. Cause: emergency braking at the junction with Hafenstrasse. The other vehicle, an ambulance, emerged from Hafenstrasse, which meets our road at ninety degrees, and took its left ahead of us. It didn't do that smoothly, the rear sat down under power and its speed was increasing until it was gone.",
#:   "Le scooter était là, in the street of the side, very wise, with one foot on the ground. When I arrive he decides himself. He makes roar the motor, he comes, he bends to the left in front of my wheels, and he doesn't slow in the bend as a normal person, he becomes always more rapid.",
#:   "Why did the AV stop with a jolt at an empty junction? It wasn't empty a second earlier. A coupé had shot out of the cross street on our left side, in a left-hand sweep that took it over our lane, and it had been piling on speed all along the sweep, so the cameras had it for barely a second.",
#:   "Sim request from the safety team. The adversary stands on the crossing road as though it would yield. Trigger it when we're at the distance that makes it tight. It then does its left turn ahead of us with a heavy foot, and it must never coast or brake in the turn, speed only goes up.",
#:   "From the side road, leftwards past our nose, quicker every yard.",
#:   "Crossing Jeep squats, springs, bends left ahead of us, still winding up.",
#:   "Make the side-street scooter bolt into its left, foot never lifting.",
#:   "At the mouth of Quay Street he was standing and at the end of his bend, which was a left across my bonnet, he must have been doing thirty-five.",
#:   "Gravel spat backwards, nose up, that's how the ambulance set about its left out of the farm road in front of us, and it was gaining the whole way round.",
#:   "Had the crosser gone round to the left at an even pace the AV would've got by behind it, but its right foot kept going down.",
#:   "Departing from rest on the intersecting leg, the target takes the left-turn path through the VUT's lane with positive acceleration up to its last point.",
#:   "He looked left, he looked right, he looked at me, and then with full accelerator from the gully to his left side, cutting my nose, more and more fast.",
#:   "He won't wait in that side road, I can tell by his front wheel; there, left, in front of us, and hear him go up through the gears.",
#:   "The scream of the gearbox began on our right, in Vine Street, low. It rose as it came over in front of the bumper and it was at its highest when it had got round and was making off to the left-hand side of things. You could've sung the scale to it. I was in the front seat of the robotaxi with my eyes shut.",
#:   "The arc of rubber starts at the give-way line of the minor road. It bends left, goes clean over the lane in which V1 was approaching, and joins the opposite lane. Normally such marks fade as the tyre finds its grip; these are as black at the finish as at the start, V2 having been under full power from one to the other.",
#:   "What the hedge hid from me was the first half of it. So for me it began with half a car, already leaning. The back half came after, and by that time the front was going much quicker than when I'd met it. It went round to its left, I mean out of the lane by the pub, and all this was in front of my wheels.",
#:   "Who taught him that? You've a stop line on your side street, you've a car coming along the main road, you want to turn left through its path, and you think that the answer's more gas. He thinks so still, listen to it. He's straightened up now, and he was going twice as fast there as when he passed in front of us.",
#:   "My mother sells fish by the crossroads. She says the police bike had stopped in the side lane, and the policeman was wiping his goggles. He put them on. And then the fish, she says, were all of them covered in dust, because he'd opened it right up and swung left, in front of the little electric van, and he opened it up more.",
#:   "The tracker had him at 0 m/s on the cross road, 3 at the edge of our lane, 6 in the middle of it, 9 when his heading had come round through ninety degrees to the left. We brake for turners on the assumption that they ease off in the bend. This coupe had not read it, and we stopped with nothing to spare.",
#:   "Please bring me somebody in a temper. He's been kept at the end of the crossing street. Our car approaches, ahead of which there'd be no room to speak of, and that's precisely where he goes, into a left-hand sweep, with his pedal pressed harder as he comes through. He's not the oncoming one, we've got that already.",
#:   "\"I had it all under control,\" the motorcyclist insists. As to that, consider what the others had. He had been waiting on Mill Lane, to their right. A lorry's driver stood on his brake, a robotaxi stood on its own. Between the two of them the motorcycle lay over to its left and flew round, and its exhaust note did nothing but climb.",
#:   "She had meant to turn her head once more towards the sea. Had she done so she would not have seen the landau of our century, a long yellow sports car, crouch at the end of the avenue which came in at the side. It uncoiled. It swept to its left before her very lamps, and there seemed to be no end to the speed it found.",
#:   "It's not only boys. The lady in question is seventy-four and drives a hatchback. She'd been standing at the give-way in Back Lane for some while, and her view is that nobody would ever let her out. So she let herself out, to the left, over my side. She had it in first all round the bend, with the engine at the red mark, and getting faster.",
#:   "De la rue latérale, he was there quiet as an image. I come on the principal road with my camping-car. At ten metres he wakes, I see the back go down, he comes left before my big nose. I brake, all the casseroles fall. And he, he doesn't slow for the curve, he does the contrary, until one doesn't see him any more.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "accelerate"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.3
#: high = 0.6
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.3, 0.6)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
