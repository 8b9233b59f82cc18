#: description = "The car behind tailgates the ego and then accelerates into it."
#: rephrasings = [
#:   "The maniac behind hugs our bumper and then gives us a shove.",
#:   "Vehicle 2 followed closely, then accelerated and struck the rear of vehicle 1.",
#:   "Tailgater floors it, rear-end hit.",
#:   "The target closes up behind the VUT and then accelerates toward its rear.",
#:   "He sticks behind us and then gives gas and pushes.",
#:   "A pickup on our tail loses patience and rams.",
#:   "The bus sits on our boot lid until the driver hits the wrong pedal.",
#:   "A lorry looms in the mirror, crawls up and bulldozes on.",
#:   "The van had been glued to my backside for ages and then he just floored it and shunted me.",
#:   "Suspect vehicle followed at an unsafe distance and intentionally rammed Unit 1 from the rear.",
#:   "Truck on rear bumper, then full throttle, rear-end hit.",
#:   "The following vehicle maintains a short headway and subsequently increases speed until it strikes the rear of the test vehicle.",
#:   "Bus behind is too close, then gives gas and crashes in my back.",
#:   "Rear actor closes up and does not stop closing: it speeds up into our rear end, collision from behind expected.",
#:   "They sat on his tail for a mile, and when he would not move over they put their foot down and drove straight into his boot.",
#:   "Unit, the pickup in back of you is bumping you on purpose; he's hanging right there and now he's powering into you.",
#:   "dude behind was so far up my butt and then he literally just sent it into me wtf",
#:   "A motorist was shunted from the rear by a lorry which had been hounding her for some time before putting on speed.",
#:   "Is it not true that you crowded my client's car and thereupon pressed the pedal until your bumper met his?",
#:   "Wah this bus stick so close behind, then suddenly press pedal and bang my backside.",
#:   "Feller's breathing down my neck the whole way, then he gives it welly and caves my rear in.",
#:   "Deliberate rear impact by pursuing vehicle following a period of insufficient separation",
#:   "ROAD RAGE: pickup stalks cammer then PLOUGHS into the back",
#:   "The truck behind presses up and batters us forward.",
#:   "Glued to my tailgate, then he gunned it right into me.",
#:   "Simulate a bumper-riding coach that finally powers into the ego's rear.",
#:   "Mummy, the lorry came really really close and then zoomed into our bum!",
#:   "shunted by close folower who speeded up on me",
#:   "Ambulance practically in our boot, next thing it put its foot down. Crunch.",
#:   "I want a scene where a pickup drives an arm's length from the ego's rear, then opens the throttle and drives right through that remaining arm's length.",
#:   "My rear hatch was crushed because the motorist at my back, who had left no room to begin with, stepped on the gas instead of dropping off.",
#:   "For a kilometre there was hardly a hand's breadth between the cab and the robotaxi, after which the cab surged and buckled the robotaxi's rear panel.",
#:   "The German behind me has hung on my stossstange all the time and then he gave full gas, so he drove me in the back.",
#:   "Test 14: following target at minimal headway; on trigger, target applies throttle and contacts the rear face of the subject vehicle without changing lane.",
#:   "How did the towbar get bent? A fire engine was filling my mirror, nose to tail, and instead of easing away it put on power.",
#:   "What I noticed first was that I could no longer see his headlights, so close was he. Then the engine behind me roared, and before I had understood it the motorbike's front wheel had been driven into my number plate.",
#:   "V2, a box truck, had been trailing V1 with less than half a second of headway. Its recorder shows pedal application rising to one hundred per cent immediately before its front end met V1's back end. No evasive action was taken by either driver.",
#:   "You know that feeling when somebody's reading your bumper stickers with a magnifying glass? That was the SUV at my back. I held my speed, he got cross, hoofed it, and the next I knew my head hit the rest.",
#:   "When you reach my age you don't like being crowded, and this young man in his saloon simply would not leave me any space. I suppose he lost his temper, for he revved up and ran himself into the back of my little Fiesta.",
#:   "The riders of the tour bus told officers that it had been driving on top of the small hatchback for several minutes. Their driver then leaned on the pedal, and the bus gained on the last metre there was and bulldozed the hatchback's rear in.",
#:   "No daylight between us and the cab; then he speeds up and thumps us.",
#:   "Have a coach crowd the ego's rear, then drive hard into its back.",
#:   "REAR CAM: SUV rides my plate, nails the pedal, wallop",
#:   "For two streets the scooter had its front tyre all but under our bumper, and then its rider twisted the grip and butted us from the rear.",
#:   "Following at a headway of 0.3 s, the truck target raises its speed on command and makes contact with the rear structure of the vehicle under test.",
#:   "Sir, this bus fellow was sticking to my dicky only, one inch gap, and afterwards he raced the engine and dashed me from back.",
#:   "My lady, the defendant first denied my client any stopping distance whatsoever and then, pressing on harder, made use of the little there was to strike her from the rear.",
#:   "Caller says a pickup has been sat right on her back end since the lights and has now put his foot in it and clouted her, she's still moving.",
#:   "Didn't I say he was too close, that ambulance on your number plate? And now he's picking up speed instead of dropping back, brace yourself, he's into us.",
#:   "We were on our way home from my sister's, doing thirty in a thirty. All I could see in the mirror was a radiator grille, no road, no bonnet, simply grille. Then came the sound of somebody changing down and burying the pedal, and our seats hit us in the back.",
#:   "My claim concerns the tow hook and the rear crossmember. The blue van had kept so near that I could not see its lights for the last kilometre, and I did nothing to provoke it. Where I expected it to give me room at last, its engine howled and it drove up into my boot.",
#:   "V1 was travelling at a constant 50 km/h. Radar returns show V2, a bus, less than two metres aft of V1 for eleven seconds. V2's speed then rose by 9 km/h within one second, and the separation reached zero. V1 sustained damage to the hatch and bumper.",
#:   "What the pupil must understand is that somebody driving in your boot can't be trusted to stay calm. This SUV had been there since the roundabout, so near that I could read the tax disc. I said keep steady, and then he hit the gas and we were hit in turn, square in the back.",
#:   "I drive a forty-four tonner and even I wouldn't do what that Scania did. He was nose to tail with the little robotaxi, you couldn't have slid a newspaper in. Black smoke from the stack, a roar, and he'd punted it from behind like a football.",
#:   "Can somebody look at run 311? The rear actor is supposed to keep its tiny following distance all the time. Instead, at the trigger, it goes to high throttle, our rear bumper gets hit, and the log ends there. If that is the intended ramming case, please rename it.",
#:   "Granny's neck still aches. She'd told us the fire engine was much too near, you could see the driver's moustache in the back window. There wasn't any siren, it just suddenly wanted to go faster than we did, and bang went the cake tin on the shelf.",
#:   "There had been a bare hand's width of wet tarmac between the two cars, and Irene, who watched it in the glass as one watches a fuse, saw it narrow to nothing. The saloon behind had bounded forward. The blow, when it came, was almost a relief.",
#:   "I'm no expert but I ride this road daily. A hatchback in front of me was all over the tail of the test car, honestly a tow rope would have been longer. Next I hear revs climbing, and it doesn't pull out or anything, it goes straight up the test car's backside.",
#:   "In Germany we say he was sitting in my trunk, this one with the big motorbike. I have not braked, I have not done anything. He wanted me to go faster, and as I did not, he opened the gas completely and pushed with his wheel into my rear light.",
#:   "Police are seeking a pickup driver after what they call a deliberate shunt on the B4100. A commuter's car was driven into from behind by a vehicle that, she said, had clung to her bumper since Warwick. \"I heard him floor it,\" she added. \"He hadn't far to come.\"",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "accelerate"]
#: leader = false
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = 1.0
#: high = 4.0
#: unit = "m"
#: meaning = "how much room it leaves between its bumper and the ego's"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.3
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 0.6
#: high = 1.8
#: unit = "s"
#: meaning = "for how long it presses the pedal"

param OPT_ADV_DISTANCE = Range(-10, 15)
param OPT_ADV_GAP = Range(1, 4)
param OPT_THROTTLE = Range(0.3, 1)
param OPT_THROTTLE_TIME = Range(0.6, 1.8)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
