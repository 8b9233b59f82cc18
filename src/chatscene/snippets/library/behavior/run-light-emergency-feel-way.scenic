#: description = "The emergency vehicle feels its way over the line on red, halts to look, then accelerates across."
#: rephrasings = [
#:   "the ambulance noses out on red with its siren going, waits a tick, then puts its foot down",
#:   "An ambulance on an emergency run entered on red at low speed, paused, and then accelerated through.",
#:   "ambulance, red, slow entry, short halt, then gas",
#:   "The emergency vehicle passes the red signal at walking pace, stands briefly and subsequently accelerates across the VUT's path.",
#:   "The fire truck passes the red light carefully, makes a little stop, then it gives full gas.",
#:   "A police car edges past the stop line on red, looks both ways, and shoots off.",
#:   "Blue lights flashing, the fire engine inches into the crossing, hesitates and then surges over.",
#:   "A rescue vehicle with priority tests the traffic against the signal before it speeds up.",
#:   "ambulance nosed over the line on red, stopped for a gander both ways, then went for it",
#:   "The ambulance edged past the stop line against the red signal, halted to clear the intersection, and then accelerated across.",
#:   "Fire eng. on red: creeps over line, stops, looks, then full over.",
#:   "The emergency vehicle passes the stop line at low speed on red, pauses to check and then accelerates through the junction.",
#:   "The police car has red, it comes slow over the line, stands and looks, then goes quick across.",
#:   "Blue-light crosser at red: inch out, v=0 for a look, then accelerate through. Cautious phase first, not a flat-out blast.",
#:   "The engine had crept out beneath the red lamp, waited till every head had turned, and only then put on speed and was over.",
#:   "Ambulance is poking his nose out on red, good lad, he's having a look left and right, and now he's giving it the beans.",
#:   "ambulance kinda tiptoed out on red, stopped to check, then zoomed",
#:   "A fire crew probed its way out against the signal, stood to see the coast was clear, then hurried over",
#:   "The police driver entered on red with caution, stopped, looked, and only then applied power?",
#:   "Ambulance on red slowly slowly putting nose out, stop see left right, then go fast",
#:   "Credit where it's due, the fire engine pokes out on red, has a good look, then he's gone",
#:   "Cautious red-signal entry of emergency vehicle with check halt and subsequent acceleration",
#:   "Ambulance sneaks out on red, PAUSES, then blasts across",
#:   "The patrol car tiptoed over the red, paused, then pounced.",
#:   "Ambulance from the side: inches over against red, stops, looks, powers across.",
#:   "Fire engine peeped out on red, sat tight a sec, then legged it over.",
#:   "Have a police car sneak past a red, wait, then surge across.",
#:   "Die Ambulanz, by red, tastes forward, stands, looks, and then Vollgas over.",
#:   "Nee-naw came out tiny bit on red, stopped, then went whoosh!",
#:   "With its lights against it, the fire engine coming from our left ventured its front axle past the line, held still while the traffic froze, then thundered over.",
#:   "The crossing emergency vehicle violates red at crawl speed, comes to zero velocity beyond the stop line for observation, and clears the junction under strong acceleration.",
#:   "I'll give the police driver his due: he only trickled out against the red, made a proper stop to see who'd spotted him, then floored it to the other side.",
#:   "Not until it had probed its way past the red, halted and satisfied itself that we were all standing did the ambulance put on speed and go over.",
#:   "You hear the siren? She's on red, so she's nosing out gently, now she's stopped to check on us, and now she's off across like the clappers.",
#:   "Did the appliance, having the red signal, not proceed cautiously past the line and stand there for a look before its driver sped over the crossing?",
#:   "I was at the crossroads on my bicycle, next to one of those driverless taxis. An ambulance rolled over the line from the side street although it had red, so gingerly that it seemed to be on tiptoe; it paused, I saw the crew turn their heads, and then it stormed to the far side.",
#:   "Control, from Engine Four, regarding the complaint. We had a red at Mill Street. I eased her over the line, brought her to a stand so that my mate could call \"clear left\", and once he had I gave it full throttle across. At no time did we just charge through that signal.",
#:   "Priority-vehicle case for the AV: it comes along the cross street with siren on and a red light facing it. First it slips past the stop line barely moving, then it freezes for a second or so to see whether people give way, and after that it picks up speed hard and crosses ahead of us.",
#:   "My wife grabbed my arm, for a patrol car was easing into the junction on its red, a foot at a time. There it stood, blue lamps turning, while the young constable peered up and down. Evidently he liked what he saw, as he then put his boot down and tore over to the other road.",
#:   "What good blue-light driving looks like, in today's video: signal's red for the fire truck, so the driver doesn't trust anybody. He feeds it in beyond the line at a snail's speed, brings it to a halt, scans both ways, and only when the silver car has clocked him does he let it roar across.",
#:   "Ambulance, red against it: sneaks past the line, freezes, looks, guns it over.",
#:   "Police car tested the red, stood, then flew across our front.",
#:   "Fire engine's light's red; it tiptoes, halts, checks, and off it roars over.",
#:   "Lit red for her, yet the ambulance from the right slid her nose over the line, came to rest until everyone had noticed, and stormed through.",
#:   "The patrol car's three moods at its red signal: shy, as it slipped over the line; watchful, as it stood; and furious, as it went for the other side.",
#:   "Der Rettungswagen has red, but he comes with feeling over the line, stands a moment for looking who is there, and afterwards he shoots across.",
#:   "Only after the fire appliance had inched beyond the stop line on red and halted for a good look each way did its driver power over before the coach.",
#:   "Make the crossing ambulance treat its red like thin ice: a cautious step past the line, a stand to listen, then a headlong rush to the other bank.",
#:   "Would you agree that the police vehicle passed its red at a crawl, was stationary while your light was observed, and accelerated only then through the crossing?",
#:   "Everything blue was going round on it, and the siren was enough to wake the dead, so I wondered at how shy it was. It put its wheels past the line under that red as if the road might be hot. It stopped there, too. I saw a hand go up to thank me, and the tail went down, and it was over like a shot.",
#:   "The signal timing diagram shows red for the side street from 10:14:02. At 10:14:09 the fire engine's front bumper is 1.5 metres past the line, at a speed of 4 km/h. At 10:14:11 that speed is zero. From 10:14:13 onwards it's rising as steeply as eighteen tonnes allow, and by 10:14:17 the appliance has cleared the crossing in front of us.",
#:   "I drive a cab, so I've seen some cowboys with blue lights. But this paramedic was a class act. He's got a red, right? So he doesn't come out, he leaks out. He gets his bonnet where we can all see it and he parks it. Has a look at me, has a look at the bus. And then, God, did that thing go.",
#:   "Across from us they had red, and I told my pupil to expect nothing from that side. There's an exception, of course, and it had a siren on. \"It's coming!\" No, it's peeping. \"It's stopped!\" Yes, it's asking us. \"It's gone!\" Yes, now it's gone, over to the hospital road at a fair old lick, since it's seen that we've answered.",
#:   "For the blue-light section the AV must hold back through all three stages and not be tempted by the middle one. Stage one, the crossing emergency vehicle drifts over its line while its signal shows red. Stage two, it's motionless, roughly for the time it takes to look left and right. In stage three it sprints to the opposite exit.",
#:   "It would be wrong to write that the constable jumped the light. To jump is to be quick. He passed it, red as it was, at the pace of someone entering a dark room; having entered, he waited for his eyes to get used to it; and when he knew where the furniture was he made for the opposite door as fast as he could run.",
#:   "When I came back to the flat I told them that I was nearly killed by people whose work is to save. This is unjust. The red vehicle of the pompiers, which had itself the red, put just the nose past the line. It rested so. It looked at us. And it is only when nobody moved any more that it traversed, with all its horses.",
#:   "Mummy held my ears because of the siren. The ambulance wasn't allowed, since its man was red. It came out a tiny bit anyway, like when I come out of bed, and it stood still to see if anybody's cross. Nobody was cross. So it went brrrm really hard and went past all our noses.",
#:   "Since there's CCTV on three corners we can be quite precise. At no stage did the engine \"charge the red\", as the letter claims. It was fed over the line at a trickle. There it was held, on the brake, while the officer in the left seat looked down Queen Street. The throttle went down when he dropped his arm, and it sped to the far side.",
#:   "I'm on the number nine, top deck, front seat. Everybody's got their eyes on the police van in the side street because of the racket, and we've the green. It doesn't wait for its own. It sort of seeps out past the line and there it stops dead, so that for a moment there's quiet. And then it rips over the crossroads, right below me.",
#:   "Lorry drivers can't see what's under their mirrors, and this ambulance driver knew it. He'd got red. He brought her out as far as my bumper, so gently I felt rather than saw it, and stood there until I'd lifted both hands off the wheel to show him. Soon as I had, he gave her the lot and was away across.",
#:   "Ambulance, its red: toe over line, stop, look, whoosh across.",
#:   "cop car snuck past its red, froze, checked, then BLASTED thru",
#:   "Engine on blues, other road: easing over on red, holding... now it's going, hard.",
#:   "The fire engine's light was against it, and you could see it knew: a yard over the line, and then another, a dead stop for a look at us, and only then the noise and the dash.",
#:   "Not the siren but the silence gave me pause, when the police car, having stolen past its red, stood there with its nose out just before it leapt over in front of me.",
#:   "Between my first sight of the ambulance's bumper beyond its stop line and my last sight of its rear doors in the far street lay four seconds of dawdle, one of nothing, one of fury.",
#:   "Blue-light target on the crossing arm, signal red: passage of the stop line at creep speed; full stop short of the conflict point; then maximum acceleration through the junction.",
#:   "You had the green, yes, but they've got a patient; see how he lets her trickle over on the red, plants her, checks you're not coming, and now he boots it?",
#:   "Have a fire truck on the side road treat its red like thin ice: gently onto it, stand and listen, and then go over the rest as fast as it can.",
#:   "My green had been green for ages. What I found in the junction all the same was the front third of an ambulance, at a standstill, from the street whose light was red as red. It had come out there by inches. A face in it turned my way, decided I was far enough off, and the remaining two thirds went through with a howl.",
#:   "Listen to the siren. While the police van was coming up to its red, and a bit past it, it only grumbled. For the time it took the driver to look left and right, with the van halted out there beyond the line, it held one low note. Then it went up to the top along with the engine, and they were over and away on the opposite side.",
#:   "I was on the beach bike, waiting on nothing, watching. Everyone else had green. The big red engine had the other colour, and it put its front wheels over the paint like a bather, right foot, left foot, brr, halt. Six helmets turned. No one coming but the one blue car, which had seen them. In went the bather, then, head first, and the whole junction shook.",
#:   "Ticket: planner clears \"yielded\" flag too soon. Crossing emergency vehicle passes its line against red at 1.5 m/s. It then has zero speed for about a second (crew is checking). At this point we concluded that it was giving way and we resumed. It was not giving way. It went from zero to the far exit with its pedal on the floor.",
#:   "They will tell you, Mesdames, that the gendarmes have no fear. Mine had. His lamp was red, he knew it; he slid his blue Renault over the white band as one slides a foot under a cold sheet. He stopped. He looked me well, to see if I had understood. I had. And pffft, he was already on the other side of the boulevard with all his horses.",
#:   "The court has heard that the ambulance \"flew through a red light\". It did, at the end. Let's begin at the beginning. At 11:02:05 it is behind its line. At 11:02:09 it's two metres beyond, having walked there. At 11:02:10 it's in the same spot, its driver's head turning. What flew was the vehicle that had taken such pains, at 11:02:11, and it flew across.",
#:   "Our class went to see the robots' cars. The man made a pretend fire engine come out of the other street. It had a red light and it wasn't allowed, but it's a fire engine. It came over the line on tiptoe. Then it stood very, very still and I thought it was broken. Then it went NEEOW to the other side and the robot's car had waited, because it's clever.",
#:   "We'd the radio up, so it was all dumb show. Lamps going round on the police car's roof, up the side street; red light over it; bonnet over the line by so much, by so much more. Stop. Copper leans forward to see past the bus shelter, sees us, sees we're braking, nods. Nose goes up. He's a streak from one side of the windscreen to the other.",
#:   "At a red signal the engine commander has three duties, and on the cross street from ours she did all three. She brought fourteen tons over the stop line so gently that the water in the tank didn't slop. She brought them to rest where both ways could be seen. When she'd seen all there was to see, that is to say us, braking, she gave it full power and was through.",
#:   "Insurance isn't going to like \"I was rear-ended because an ambulance hesitated\", but stick with me. Light's red for him. He noses out regardless, fine, I brake. He stops! So I think he's waving me on, and I let off. He wasn't waving, he was checking. He's across in front of me like a shell from a gun. I brake again, and this time the guy behind doesn't.",
#:   "The street lamps were out, so that one had nothing but colours. Red hung over the mouth of the cross street. Under it there grew, little by little, a blue that turned; it came out past the red until it had painted the first tram rail, and there it stayed for a breath. Then blue filled all the windows of the square, one after the other, at a terrible pace.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "hesitate", "accelerate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it feels its way over the line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -8.0
#: high = -4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it halts to look"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 1.0
#: unit = "s"
#: meaning = "how long it looks"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(0, 20)
param OPT_SLOW_SPEED = Range(2, 3.5)
param OPT_STOP_DISTANCE = Range(-8, -4.5)
param OPT_STOP_TIME = Range(0.3, 1)
param OPT_THROTTLE = Range(0.6, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advTrajectory.entry) < -1 and distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
