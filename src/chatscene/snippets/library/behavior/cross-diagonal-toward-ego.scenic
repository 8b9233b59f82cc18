#: description = "The pedestrian crosses diagonally toward the ego, facing it."
#: rephrasings = [
#:   "She comes over at a slant and heads right for us while doing it.",
#:   "The pedestrian was crossing at an angle against the direction of travel of Vehicle 1.",
#:   "ped diagonal, toward us",
#:   "The target's course makes an acute angle with the oncoming VUT.",
#:   "He crosses not straight but in our direction, with the face to us.",
#:   "A stroller traverses the carriageway obliquely, getting closer to us with every step.",
#:   "Somebody drifts over the lane, angling back toward the traffic that approaches.",
#:   "The man shortens our gap as he goes across slantwise, looking at us all along.",
#:   "a bloke came over the road at a slant, walking up towards us and looking me dead in the eye",
#:   "Pedestrian walked across the roadway at an angle, facing oncoming V1 and closing on it.",
#:   "Ped X-ing obliquely, heading our way, face to us.",
#:   "The pedestrian target crosses on an oblique path with a longitudinal component opposite to the VUT's heading.",
#:   "The woman does not cross straight, she goes slantwise and comes in my direction, she sees me.",
#:   "Walker path: skewed crossing, vector pointing back at the SUT, so the distance shrinks as they cross.",
#:   "He cut the corner of the street on a slant, marching to meet them rather than going square over.",
#:   "Watch the lady: she isn't going straight over, she's coming at you on an angle, face on, getting nearer with each step.",
#:   "this woman is crossing but like towards us?? on a diagonal staring at the car",
#:   "A man took a slanting line over the carriageway and advanced on approaching vehicles, looking straight at the driver",
#:   "She did not go directly over but bore towards the defendant's car, face turned to it, is that your evidence?",
#:   "That aunty is crossing cross-ways only, coming towards our car itself and looking at us",
#:   "Course he can't cross straight like a normal person, has to come slantways at my headlights eyeballing me",
#:   "Oblique pedestrian crossing with component opposed to vehicle travel; frontal approach",
#:   "Guy crosses at an angle STRAIGHT AT my car",
#:   "The walker slanted over the road to meet us.",
#:   "Bloke cutting over the road cornerwise, walking up to meet us.",
#:   "Jogger takes the long diagonal across, coming my way face first.",
#:   "Make the kid cross on a slant aimed back at the ego.",
#:   "Ped crossing aslant, facing V1, range decreasing by both axes.",
#:   "The lady walked across our street sideways-ish toward the car, grandad.",
#:   "Instead of the shortest way over, the old man chose an oblique one that brought him nearer to our bonnet with every pace, his eyes on us.",
#:   "Why would you go over the road skewed like that, into the traffic's face, getting closer to the car as you do it?",
#:   "The pedestrian dummy is moved from kerb to kerb on a line inclined some thirty degrees against the direction of the approaching test vehicle, chest toward it.",
#:   "She was already halfway across when I understood she was not going square: she walked cornerwise, looking at my windscreen, and so shortened the distance.",
#:   "He is making the crossing, but inclined, na, not straight, and the incline is to our side, so he is coming over and coming near, both.",
#:   "Pedestrian on the carriageway by the chemist's, traversing on a bias and advancing on oncoming cars, reports the caller, looking straight into the headlamps.",
#:   "The robotaxi's log has the woman with the pram entering from the footway and drawing a slanted line over both lanes. Because the slant pointed back up the road to us, she arrived at our lane much closer than the geometry of a straight crossing predicts.",
#:   "I was in no hurry, thank heavens. A gentleman with a newspaper left the pavement some way up and came over, but not directly; he bore down toward me while he crossed, so that we were looking each other in the face all the way.",
#:   "Your Honour, the deceased did not turn her back on the defendant's car. She went from one side of the road to the other on a skewed course whose direction was against the traffic, with her face to it, and the distance melted accordingly.",
#:   "On a bicycle you learn to read feet, and his were pointing wrong: half to the far side, half to us. So he traversed the road like a bishop on a chessboard, heading for the very car I was riding behind, seeing it perfectly well.",
#:   "In the third clip a teenager comes over from the opposite kerb. He does not take the perpendicular way but an inclined one, up the street toward the subject vehicle, and he looks at it throughout, so distance falls lengthwise and sideways together.",
#:   "A nun comes over slantwise, walking up the road to meet us.",
#:   "Let an old man cross on a bias, facing the oncoming AV.",
#:   "ped crossing, not square: angles back at my bumper, staring",
#:   "The jogger did not take the straight way across but one tilted toward us, so that she was both getting over and getting nearer with her face to us.",
#:   "A pedestrian leaves the kerb, makes for the other side, and bends the line against the vehicle under test, which sees the front of the body throughout.",
#:   "Instead of going directly over she took the skew line, beta, coming up towards our bonnet only while crossing, and looking at us the whole time.",
#:   "He had his eyes fixed on the approaching tram of headlights and went over at forty-five degrees, each stride carrying him farther up the street toward them.",
#:   "When they slant away from you, you gain room; this lady's slanting toward you, nose to nose as she goes over, so you lose it twice as fast.",
#:   "Male on the carriageway outside the bookmaker's, going from one side to the other aslant and against the flow, face on to the traffic, so he's walking up at them.",
#:   "I was on the tram stop and had nothing else to look at. The lad in the yellow coat set off for the far pavement, only his toes pointed half up the road, to where the car was coming from. By mid-lane you could have drawn the pair of them meeting, and he was grinning at its driver.",
#:   "According to the driver of V1, the pedestrian's face was visible to her from the first step to the last. He traversed the roadway from the east curb on an oblique line whose northward part was opposed to V1's southward travel. The closing distance consequently shrank faster than V1's own speed would account for.",
#:   "Our crossing cases all have people going straight over like chess rooks. Real people see their bus stop behind us and head for it cornerwise. So please: someone from the footway goes over the lane obliquely, against our direction, chest to the windscreen, and reaches our path a good deal nearer than where she started.",
#:   "You know what it's like with a tray of coffees in both hands. I'm looking at the cups, I look up, and there's a woman with a pram already halfway over, and she isn't square on. She's coming across at a cant, pram pointing at my radiator, smiling at me like I'm her lift.",
#:   "It gave him, as he explained afterwards, an odd feeling of being chosen. Other people cross a street; this gentleman crossed it and approached, both at once, along one slanting thread with Henry's headlamps at the end of it. He never once looked anywhere but through the windscreen.",
#:   "My husband says I should've braked before, but how was I to know? He'd a whole empty road to go straight over. No, he has to set out uphill, at a slant, towards me, so every step to the other side was a step closer to my Micra, and him gawping right in at me.",
#:   "Chalk marks were made of the footprints in the snow. They begin at the northern kerb and end near the centre of the southern lane, eight metres further east, that is to say further toward where the defendant came from. The toes point at his car, as would the face of whoever made them.",
#:   "In the lorry you sit high, so I saw the parting in her hair and then her spectacles. I'd no business seeing spectacles; folks who go across show you an ear. She was going over the road, all right, but on a long slope up toward me, and I ran out of road quicker than I reckoned.",
#:   "Post #14: look at the zebra in the video and then look at the bloke. Zebra goes straight over, he goes corner to corner, up toward the cam car, facing it. So he's leaving on one side and arriving on the other like normal, it's only that he's also walking at you meanwhile.",
#:   "For this request I have in mind schoolchildren, well, one is enough. The child has spotted mum in the ego. It comes over the carriageway not at a right angle but tilted toward the ego, looking at it and waving, and thereby closes on it during the whole of the crossing.",
#:   "Der Mann was going over the street, this is allowed. But he has not gone the shortest way; he went schräg, and always in the direction where I came from. We have looked into our eyes, he became bigger and bigger, and when he was in my lane there were only three metres left.",
#:   "Woman traverses the street slantwise, advancing on us, eyes to windscreen.",
#:   "Skewed crossing, ped getting nearer with each stride, frontal view.",
#:   "He's cutting across cornerways and coming up to meet you, lad.",
#:   "Of a person crossing I expect to see an ear; of this man I saw both eyes and his tie, for his way over led obliquely up the street to me.",
#:   "Her path over the carriageway was inclined against the driving direction of the test vehicle by some thirty degrees, so that range fell by her walking as well as by our rolling.",
#:   "The pram pointed not at the far pavement but half at it and half at my headlamps, and there it went, over the whole width, baby first.",
#:   "I'd like somebody who's spotted a friend in the AV: leaves the kerb, goes over to the other pavement, but bends the line so he's walking up towards the bumper.",
#:   "Whoever drew his route over the road must have had the ruler slip, because it began at the post box and ended at the lamp-post nearer to us, his face toward us throughout.",
#:   "Granny, a jogger went over the road like the bishop in chess, this way and forwards to us at the same time, and he looked straight in our window.",
#:   "Where he stepped off, there's a zebra of drain covers; where he'd have stepped on again, on the other side, stands a bench, and that bench is twelve metres nearer to where my lorry was. Connect the two and you have his walk. He had seen me perfectly well. He looked at my badge the entire way.",
#:   "The pedestrian detector was content, the trajectory predictor wasn't. A person square to the lane should keep a constant longitudinal position; this one's decreased by a metre per second while the lateral one swept from kerb to kerb. The face classifier, for what it's worth, fired in all frames. We came to a stop at three metres.",
#:   "I had her for a lip-reader's distance, would you believe. She was singing, going from the chemist's over to the cinema, and I could see which song, since with every bar she was not only farther across but also bigger. The cinema is straight opposite. She preferred to get there by way of my radiator.",
#:   "It was the lapels that gave it away. You see lapels only on folk who are coming to you. The gentleman was passing over from my side of the street to the other one, no doubt about that, and yet the lapels were square to me and the space between us was shrinking from his end too. I stood on it.",
#:   "For the Spanish people it is very typical: one goes to the other sidewalk, but one goes it toward the bar. The bar was behind my car. So this old man has traversed with the chest toward my headlights, putting himself each moment more at the other side and each moment more near of me.",
#:   "By the time I'd stopped there was a boy in a football shirt almost at my number plate, and the odd thing is he'd begun by the bus shelter, a good way off, and his goal was the gate across the road. He had gone over on the bias, nose in the traffic, and it had brought him to us.",
#:   "There's no law that says a body has to take the short way. I was on the milk float, the lamps of the town were just going out. Over the cobbles came a monk, from left or from right I forget. His sandals made for the opposite pavement and for me in about equal measure, and he looked me in the eye and nodded.",
#:   "Witness: if he had been walking away from the defendant on that slant I wouldn't have worried, he'd have been given more time. It was the reverse. He had his front to the car, he went from one kerb to the other, and all the while he was using up the distance she needed for her brakes.",
#:   "When people cross they usually shrink or stay put in the picture. This lady in the red coat does neither, she swells. You see her set foot on the tarmac at the edge of the frame, pass in front of the lens still far off, and leave at the other edge, so large that we can read the name on her bag. She stares at us throughout.",
#:   "Have a go at the following with your class. Mark the ego with a cone, mark two kerbs. Ask a pupil to get from kerb to kerb and yet end up closer to the cone than she started, without ever turning her back or her side full to it. What she'll do then is what our dummy must do.",
#:   "Honestly he could have gone straight, there were like zero cars behind me. instead this dude in headphones crosses on an angle, upstream I mean, into us, close enough at the end that he taps the hood and gives me a thumbs up through the glass before he's over.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "oncoming"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.6
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.8
#: high = 1.05
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(1.6, 4)
param OPT_ADV_DISTANCE = Range(4, 26)
param OPT_ADV_ANGLE = Range(0.8, 1.05)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 9 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 2.4
    # Against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_ADV_ANGLE)
