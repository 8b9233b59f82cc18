#: description = "The emergency vehicle accelerates hard through the red light with lights and siren on."
#: rephrasings = [
#:   "an ambulance comes screaming through the red with the blue lights on",
#:   "A fire apparatus responding to a call entered the intersection on red at increasing speed.",
#:   "emergency veh, siren, red light, accelerating hard",
#:   "An emergency vehicle on duty passes the red signal under strong acceleration across the path of the VUT.",
#:   "The police car with siren goes faster and faster and passes in red.",
#:   "A fire engine tears across against the signal, gathering speed.",
#:   "The ambulance bombs over the crossing on red, siren wailing.",
#:   "Racing to an accident, a police van speeds up through the lights.",
#:   "An ambulance came belting through the red with the blues and twos going.",
#:   "Emergency unit, with lights and siren activated, proceeded against the red signal while accelerating.",
#:   "Fire truck thru red, siren on, full gas.",
#:   "The priority vehicle with active warning devices passes the red signal under strong acceleration.",
#:   "The police drives through red very fast with blue light and tatütata.",
#:   "EV pre-empts junction: ignores signal, positive accel, siren audio on.",
#:   "It wailed up to the crossroads, paid the red no heed, and put on speed.",
#:   "Engine 4 is going through against the red, code three, and he is not slowing down, so stop.",
#:   "fire truck blasted thru the red w sirens and everything",
#:   "A fire engine sounding its siren surged through the red signal on its way to a call.",
#:   "The ambulance, its lamps and siren in operation, went against the red with gathering speed.",
#:   "Ambulance siren on, red light also he never stop, press more somemore.",
#:   "Woo-woo-woo and through the red he goes, pedal to the carpet, ours not to reason why.",
#:   "Red-signal passage of warning-active priority vehicle under strong acceleration",
#:   "SIREN! Fire engine STORMS the red",
#:   "The wailing police car surges over the red.",
#:   "Siren yelping, fire engine storms the red, still piling on speed.",
#:   "Ambulance, blues on, takes the red with its throttle wide open.",
#:   "Against red, siren active, priority vehicle crosses, speed rising.",
#:   "The police car went nee-naw through the red and got faster and faster!",
#:   "Who floors a fire truck through a stop light, siren or no siren?",
#:   "Let an ambulance with its lamps flashing and horn blaring put on speed, ignore the red that faces it, and burst through the junction.",
#:   "Our light was green; theirs was red, and all the same the patrol car, lit up like Christmas and wailing, powered on across.",
#:   "The ambulance was, on its crew's own evidence, sounding its siren, passing a red aspect, and under full acceleration as it entered the junction.",
#:   "With tatü and blue lamps comes the Feuerwehr, has red, does not care and gives still more gas over the crossing.",
#:   "Don't go on green if you can hear one: there, a police van, siren going, foot hard down, straight over his red.",
#:   "Rescue 7 will be coming across your front with everything lit, disregarding the signal, and he's picking up speed, not losing it.",
#:   "Usually they creep up to a red and peep. This ambulance driver did none of that. You heard the siren, you heard the diesel straining as he gave it everything he'd got, and there it was, flying over the crossroads in front of us with the red light shining down on it.",
#:   "The emergency vehicle, with optical and acoustic warning devices switched on, waits out of the ego's sight. On the trigger, while the signal for its approach shows red, it accelerates at the configured throttle up to a high speed and cuts the path of the subject vehicle.",
#:   "What I can swear to is the noise: two-tones, air horn, and underneath it an engine being thrashed. The fire engine came at the junction on red, nobody lifted, if anything she surged, and she'd gone over and away before our lights had even changed.",
#:   "They'd had the call for a child not breathing, so nobody at the inquest blamed the crew. Blue lights, siren, signal against them, and the foot of the driver pressed to the boards, so that the ambulance was still gathering pace when it passed in front of the tram.",
#:   "dashcam caught the feds coming out of nowhere, siren blaring, and you can literally hear the V8 winding up as they cross the line with there light red. they werent slowing at all they were launching, thing must of hit 60 in the middle of the intersection",
#:   "Siren up, red ignored, ambulance winding itself up across the junction.",
#:   "Fire engine on blues hammers through red, quickening all the way.",
#:   "Warning lamps, two-tones, red signal: squad car simply floors it.",
#:   "With horns going and her blues reflected in all the shop windows, the fire engine put on a great spurt and ran the red like a bull.",
#:   "I want a police van with siren and flashing bar that comes to a red and gives it the beans rather than the brakes.",
#:   "Ambulance from your left against the red, full lights and noise, and he isn't feeling his way, he's piling it on, so give him the road.",
#:   "The SAMU arrives with the siren, for him it is the red, and instead of slowing he crushes the gas and flies across.",
#:   "At the stop line of its approach the patrol car, its beacons and horn in use, had a red before it, sixty km/h on the clock and its throttle fully open.",
#:   "Mum, the fire engine had a red man, I mean a red light, and it went woo-woo and zoomed even more and got over first!",
#:   "There was no creeping out, no peeping round the corner. I had my window open on account of the heat and could hear a siren, somewhere to the left; I could also hear an engine, and it was being asked for everything. The light over there was red. That ambulance came by it with its nose lifted, still getting faster.",
#:   "We discussed it in the canteen afterwards. Service rules say that you go through a red at a walk, even with your blues and twos on. Ladder 3's driver had a kid trapped in a flat, so he put the pedal through the floor. From my wagon I saw four storeys of ladder get up speed and go over the crossroads.",
#:   "The signal controller's record shows the approach at red from 17:04:10 to 17:04:52. The ambulance passed its stop line at 17:04:31 with warning devices operating, which the recording confirms. Its own tachograph gives 38 km/h two seconds before the line, 55 at the line and 71 in the conflict area, where it missed Vehicle 1 by some metres.",
#:   "I've been blind in this ear since the war, deaf I should say, so I went on the green as one does, or I would have gone. My grandson grabbed the wheel... no, my arm. Then I too saw it: a white van with blue lamps, hooting and wailing, that had a red, and was tearing over faster with every yard.",
#:   "Emergency vehicle compliance, test 4. On the crossing arm, which has red, a fire engine with active beacon and horn is released at full drive. It must reach a high speed by the conflict point and must not slow at the line. The AV, with green, shall detect it by sound or light, and shall give way.",
#:   "Blue on the walls, blue on the wet road, blue on the face of the man selling chestnuts: that is how it announced itself. Then came the howl. She looked to the lights of that other street, saw that they forbade it, and saw in the same moment a police car squat on its haunches under power and leap past them.",
#:   "\"Surely it'll slow for the red,\" said my pupil. I told her to look at its bonnet, which was coming up, not going down. When the bonnet's up the foot's down. Sure enough, with its yelper on and all its lamps going the paramedic's estate blasted by its red signal, and it was still gaining when it'd left the junction.",
#:   "Having the green is no use to you in a coffin, my father used to say. I remembered that in the robotaxi. It had green, it hesitated, I could've kicked it. And then an ambulance screamed over in front, for which the light was red, driven as though the crossroads were an airstrip, quicker at the end of it than at the start.",
#:   "Requested change: the siren case with the cautious crew is covered already, please add the reckless one. That is to say the vehicle has its light bar and siren active, sees red, and does not probe its way in. Throttle goes to the configured value before the line and remains there until it's across our path.",
#:   "Traffic police jeep came with hooter from the side where it was full red. In my city they are at least showing some hand. This one showed nothing, only the engine was shouting more and more, and in front of us it was at maximum. My driver did hard brake and said one prayer also.",
#:   "anyone else hear the fire truck on elm this morning?? siren like the end of the world. we had green so obviously dad starts going and it just LAUNCHES past the red on the other street. like you could feel it speeding up, windows shaking. dad had to stand on the brakes and he never does",
#:   "Red for him, but siren howling, pedal flat, across he shot.",
#:   "Ambulance treats red as a launch pad, lights going.",
#:   "Yelper on, blues on, red light ahead: engine screaming, not easing.",
#:   "The two-tone rose in pitch with its engine, for the police van that came at the red on our left wasn't slowing but piling it on.",
#:   "Let the fire engine, beacons and horn going, be given full throttle from its side of the junction while the signal there is at red.",
#:   "Lit up like a fairground and wailing, the paramedic car had red and answered it with kickdown, right over the crossroads.",
#:   "What do I do about an ambulance from the side that's got red, siren and a driver who's still feeding in the power?",
#:   "According to the signal log V2's approach was red; according to its own recorder V2, with warning lamps and siren active, was at full throttle throughout.",
#:   "I hear tatütata and see the blue, and his lamp is red, and the tone of the motor says to me he becomes only quicker.",
#:   "My green was good, I've the photograph. What I'd not got was any notion how quickly eighteen tons can put on speed. It came out of Foundry Lane, every lamp on its roof turning, the bullhorn blaring, and where there's a red for Foundry Lane it dug its back wheels in. You felt the draught inside the bus.",
#:   "As long as the siren gets higher and louder at one and the same time, don't you move. Higher means closer, you'd say; but listen underneath, that's an engine being revved for all it's worth. There. Past the red on that side as if somebody had painted it there for fun, blues flashing, and he's still going up the gears.",
#:   "Only the reflections were to be seen from where I waited, blue, blue, blue in the jeweller's window, and only the siren to be heard. The side street's red was plainly visible, so I thought there'd be a pause. You can't pause with your nose in the air. The squad car came out of there nose in the air, like a speedboat.",
#:   "I have the honour to report that the ambulance did give notice of itself, by its bell and by its lamps. Of what it did not give notice was its intention to rush the red signal. We took its roar for the effort of pulling up; it was the effort of the contrary. It flew by us faster than it had approached.",
#:   "Test matrix, row 9. Cross signal: red. Priority vehicle: light bar and wail, both on. Speed at 30 m from the conflict point: 8 m/s. Speed at the conflict point: 17 m/s and rising. Pass criterion: the AV, which holds a green, doesn't enter. Do not substitute the variant that creeps over the line.",
#:   "great clip sound on folks. you get the wail from the left, everybody on green freezes. you get the pump coming up to its red, blue strobes, and some bloke says hell slow up. cue the turbo. he does NOT slow up. thats a whole fire engine doing nought to silly over a crossroads against the lights",
#:   "All nuns are taught patience, young man, and we'd stopped although we had a green light. The noise was like the end of the world and so was the flashing. But theirs was a red one! And they saw it, and what do they do, they tread on the other thing. It made the ambulance sit down on its hind legs.",
#:   "The report finds fault with the instruction, not with the crew. \"On blue lights and siren make progress,\" it reads. The crew made progress: the recorder has the accelerator at a hundred per cent from forty metres before a stop signal, which had been red for nine seconds, until fifteen metres beyond it. The coroner called it a cavalry charge.",
#:   "Comme ça il arrive: first the music, then the blue light on the houses, and after, he himself, the camion of firemen. In front of him it is red like his paint. I expected that he feels his way. Instead he threw out black smoke and bounded, one would say a bull at the sight of the cape.",
#:   "The robotaxi's microphones had it long before its cameras: siren, bearing left, rising. The cameras supplied a roof with blue lightning on it behind the hoardings. What settled the matter was the estimate of its acceleration, positive and large, at a point where its signal, being red, should've made it negative. We stayed behind our line. It crossed at ninety.",
#:   "\"Won't he get a ticket, Dad?\" For the light had been red, the boy could see the back of it glow on the wet pole. And the police car, blue flashing and its siren going nee-naw, hadn't only gone, it had gone harder, with a squat and a bark, the nearer it came to that light. \"Not tonight.\"",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "accelerate", "fast"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 60.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it becomes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(25, 60)
param OPT_ADV_SPEED = Range(12, 17)
param OPT_THROTTLE = Range(0.7, 1)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, globalParameters.OPT_ADV_SPEED)
