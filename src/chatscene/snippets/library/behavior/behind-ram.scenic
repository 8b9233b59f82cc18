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
#:   "No gap at my tail to start with, then he used it up.",
#:   "Coach breathing on our exhaust, pedal down, bodies meet.",
#:   "SUV welded to my rear plate chooses violence, boot it, crunch",
#:   "Two coats of paint were all there was between the fire engine's bumper and our boot, and then its driver opened her up and there weren't even those.",
#:   "The follower maintained a separation of roughly one metre and, at the trigger point, demanded full torque, so that the metre was consumed and the rear crash sensor fired.",
#:   "I could count the flies on his radiator grille. Somewhere near the bakery I also heard it coming at me under power, and the seat kicked.",
#:   "Put a taxi so near behind the AV that its headlamps disappear under the rear window, then have it surge and drive home the last foot.",
#:   "Dispatch, female driver says the motorbike that was stuck on her boot has just opened right up into the back of her. She's still rolling, she didn't brake.",
#:   "Yes, I was near, your honour, I concede a yard at most. And yes, it was my right foot that abolished that yard, her brake lights being dark the entire time.",
#:   "When the assessor asked why there were no skid marks, I had to explain that nobody had braked. My speed was forty throughout. The lorry in my mirror, of which I had for some minutes seen only the middle of the grille, was suddenly doing fifty, and there was no room for the difference.",
#:   "The rear ultrasonic sensors were in solid tone, one long beep, from the garden centre onwards. You get used to it. What I was not used to was the howl of a diesel coming up on top of the beep, then a bang, then no beep at all because the sensors were broken.",
#:   "My pupil asked whether she should go faster for him. No, I said, he chose to sit with his bonnet in our luggage, let him be cross. A moment later we were going faster regardless, pushed along by his bumper, and I could hear his engine doing the pushing.",
#:   "The imprint in our tailgate is that of a Suzuki front mudguard. It had been hovering a hand's breadth off that tailgate since the canal, and I confess I'd grown used to it. Then the note of the engine climbed a whole octave, and where would all that go, with us in front?",
#:   "V1's event data show steady cruise and no brake input. Dash video from a third vehicle shows V2, a transit bus, trailing V1 by under five feet for nine seconds. Exhaust smoke is then visible at the bus, its nose lifts, and the five feet are gone. V1's trunk lid was displaced nine inches.",
#:   "I was eating crisps in the back and I could read the lorry's number plate upside down on my phone, that's how near it was. Daddy said ignore him. Then the lorry went VROOOM, and my crisps went everywhere because it had bumped us.",
#:   "Normally they get fed up and drop back, or they go round you. The chap in the pickup did neither. I had been looking at nothing but his bull bar for the length of the bypass, I lifted a hand as if to say what, and he answered with the whole of his engine, straight through my parcel shelf.",
#:   "What the passengers on the back seat of our robotaxi describe is first an absence: of road, of space, of any strip of asphalt between them and the police car. Then comes a lurch forwards. Both agree that its engine had risen just before, and that the robotaxi itself hadn't changed its speed at all.",
#:   "Expected in step four is constant clearance of 0.8 m aft. Observed: clearance 0.8 m up to the marker, followed by a steep rise of follower speed and a rear contact at +11 km/h. The follower stays in our lane; nothing goes past us. Please confirm that the contact is intended.",
#:   "She'd have sworn the cab meant no harm, only that its driver was late and had crept up until his lamps lit the inside of her car. It was raining. She was thinking of her exam when the light in the car swelled, an engine bellowed, and her neck was thrown against the rest.",
#:   "I am driving in Germany since two years, and people come near, this I know. But this one with the van, he was so near that between us no cat could pass. I don't make slower, I don't make faster. He makes faster! So of course he arrives in my trunk, where else shall he arrive.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["tailgate", "accelerate"]
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
