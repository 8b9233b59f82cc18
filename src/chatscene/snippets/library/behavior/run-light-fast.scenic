#: description = "The crossing car shoots through the red light at high speed."
#: rephrasings = [
#:   "some maniac blasts through the red at seventy right in front of us",
#:   "Vehicle 2 entered the intersection against the red signal at a high rate of speed.",
#:   "cross veh, red, no attempt to slow, very fast",
#:   "The target passes the stop line on red well above the speed limit, on a path that intersects that of the VUT.",
#:   "A motorbike is coming very quick and doesn't care that the traffic light is red for him.",
#:   "A racer ignores the lights and flies over the crossing.",
#:   "The biker barrels across on red flat out.",
#:   "Speeding, the other driver jumps the signal without touching the brake.",
#:   "Some boy racer shot the lights from the side at about seventy.",
#:   "The suspect vehicle ran the red light at a high rate of speed from the cross street.",
#:   "X-car blows red, v. high spd, no lift.",
#:   "The crossing target disregards the red signal and traverses the junction at high constant speed.",
#:   "A motorbike comes from the side with red light, extremely fast.",
#:   "Red-light runner at high speed, already quick before the line; no accel phase, no decel.",
#:   "The lights meant nothing to him; he went through on red like a bullet, right across her bows.",
#:   "All units, he's blown the red, he's doing seventy across the junction!",
#:   "someone just FLEW thru the red from the side like 100 mph",
#:   "A speeding car thundered through a stop signal from the side road, narrowly missing traffic.",
#:   "At what speed would you say the motorcycle was travelling when it went past the red signal; very great?",
#:   "Red light he never bother, full speed he went across from the side.",
#:   "Red as a beetroot, that light, and he comes out the side street like a shell out of a gun.",
#:   "High-speed red-signal violation of crossing vehicle.",
#:   "MANIAC BLASTS THROUGH RED LIGHT AT INSANE SPEED",
#:   "The crossing car lanced through the red.",
#:   "Sports bike whistles over the crossroads on red at a lunatic speed.",
#:   "Red for him, ninety on the clock, and across our front.",
#:   "Make a saloon from the cross street blow its red flat-out.",
#:   "Like an arrow past the red lamp: a pickup from the right.",
#:   "Stop signal showing, target crosses at 80 km/h nonetheless.",
#:   "We'd had green for ages when a black hatchback from the cross street, already doing motorway speed, went sailing past its red light and over the junction ahead of us.",
#:   "The crossing vehicle, whose signal head displays red, enters and leaves the junction at a velocity considerably above the limit, no deceleration being commanded at the stop line.",
#:   "Camera footage shows V2 crossing the stop bar 3.2 seconds into red at an estimated 68 mph and clearing the intersection immediately ahead of the subject vehicle.",
#:   "I want a motorbike coming from the side with its signal at red, going like the clappers, and blasting straight over the crossing in front of the AV.",
#:   "Der Ampel was red for him since long, and this BMW comes with hundred things per hour from the side street and flies over.",
#:   "His light's against him and he's not shifting off that speed, he's not going to stop, hold it, hold it, wow, did you see how quick that was?",
#:   "I have stood at that bus stop for forty years and never saw the like. The lamp for the side road was as red as my coat, and a little white van came down at such a rate that you felt the wind, straight over the crossroads in front of everybody.",
#:   "There was never any question of his not having seen it. Members of the jury, the signal facing the motorcycle had been red for four seconds; he approached it at over eighty miles per hour, he passed it at over eighty, and so he went across my client's bows.",
#:   "Worst one this month. Robot car gets its green, is about to roll, and out of the cross street there's this blur. We froze the frame: it's a Mustang, the light on its side is bright red, and going by the markings it's travelling more than twice the limit.",
#:   "To stress the emergency brake, we let the crossing traffic violate its signal in the nastiest way. The car is fast long before the line, it is fast at the line and it's fast in the middle of the junction, while its lamp stays on red throughout.",
#:   "Dad says you must always wait when it's red. But the man on the motorbike didn't wait at all. He came from the other street, quick as a firework, and his light was red, I saw it, and he whizzed in front of our car and away.",
#:   "His signal red, his speed insane: straight over ahead of us.",
#:   "Crossing bike, ninety plus, blows right through its red.",
#:   "Let a hatchback rocket across the junction, ignoring its stop lamp.",
#:   "A sports saloon on the intersecting street came at its red light like a train and went like a train over the crossing, never easing up.",
#:   "With the signal group of the crossing arm at red, the target vehicle passes stop line and conflict area at 80 km/h without reduction.",
#:   "Red is red in my country, but this biker from the side was making maybe hundred and twenty and the lamp has not interested him.",
#:   "You'd stopped breathing too if a Porsche had come out of the side road at three times the limit, with its light against it, and hissed by your bumper.",
#:   "Traffic unit to base, a black BMW has just gone through a solid red on the cross street, must be doing eighty, straight over the junction.",
#:   "The operator of V2, eastbound at a speed far in excess of that posted, disregarded a steady red indication and traversed the intersection in front of V1.",
#:   "There was wind where there should have been no wind. I was first at the line, my light had gone green, and I had my clutch half up when my whole car rocked. What rocked it was already over the junction and away down the cross street, whose lamp, I checked, had been red for three seconds.",
#:   "The film comes from the bakery's camera. Notice the pedestrian signal, which is green, so the cross street is on red. Notice the bus, which waits. And now, between frame 51 and frame 58, notice a motorcycle going from edge to edge of the picture; seven frames for thirty metres, you can do the sum.",
#:   "He told the officers that his accelerator had stuck, and perhaps it had. What the passengers of the robotaxi saw was a grey van on the road that crosses theirs, going at motorway speed towards a light which was red, and still at motorway speed when it flew over the junction just ahead of their windscreen.",
#:   "I clean the windows on that corner, and from the ladder I could see both. A small white car on the main road, on green, quite in order. And another one in the side road, hell for leather, its lamp red, and the fellow not so much as touching his brake. It missed the white one's nose by a hat.",
#:   "Before you pull away on green, look right, look left. You think I say it for fun? Look at this one on the left, his light's red as blood and he's coming like a bat out of hell. He isn't going to stop, there's no dip in the nose. Whoosh. And now you may pull away.",
#:   "Red-light violation, severe. Crosser's speed at 40 m before the stop line is 22 m/s, at the stop line it's 22 m/s, in the conflict area it's 22 m/s. Its signal was red for the entire time. No evasive path was available; ego relied on AEB and stopped with its front at the crosswalk.",
#:   "Bloody mopeds are bad enough, but what came out of Station Road was a superbike. I was in the wagon with a green in my face. All I got was a scream from the right, a smear of yellow over my bonnet and a scream to the left, and behind it the red light it'd gone through, still red.",
#:   "So the scene I want goes like this. It's night, few cars about, the ego has green. On the cross street somebody is treating the road as a racetrack, and the red there means nothing to him; he takes the crossroads at full speed, dead straight, just before we get to it.",
#:   "We children had to count how many cars stop at the red light for our school project. Twenty-six stopped. One didn't, it was a silver one, and it was so fast that Mia's paper flew away. It zoomed across the other street while its light was red the whole time and a lady's car had to go eek.",
#:   "Die Kreuzung was for us free. My wife was explaining me the way, so I only noticed a black line, and one moment later the noise of it. It was an Opel from the cross direction, it had red, the people outside were all showing on the red lamp, and it must have had hundred and thirty.",
#:   "At the fourth stroke of the church clock the lamps changed, and the side street had to wait. He didn't know how to wait. The long bonnet came out of the dusk, past the crimson light and over the crossing with such a rush that the leaves got up and ran after it.",
#:   "Red against him, foot to the floor, straight over our bows.",
#:   "A streak from the side street, and his lamp stone red.",
#:   "Let the crossing bike flash through its red, flat out.",
#:   "We never saw what it was, we saw leaves flying over the junction in its wake and the cross street's light, which had been red for ages.",
#:   "The crossing target arrives at its line already doing eighty, its signal red since four seconds, and neither there nor inside the junction is any speed taken off.",
#:   "If he'd hit the brake at all for that red, my lord, the noise would have dropped, but it was one unbroken howl from the one side of the crossroads to the other.",
#:   "It was my green, I was rolling, and a motorbike came out from between the waiting cross traffic like a bullet from a barrel and was gone over the way.",
#:   "Count with me from red: one, two, three, and here's somebody on that side street who hasn't heard of it, seventy if he's doing a mile.",
#:   "Only a blue smudge is on the picture, sharp behind it the red light it ignored, and sharp before it the white faces of my grandchildren.",
#:   "The hubcap landed in the florist's. It came off the grey thing that took the dip in the middle of the crossroads at, well, you tell me at what. We in the bus were on green. For the street it had come out of the lamp was red, and there were three cars obeying it in the other lane, rocking on their springs.",
#:   "Two sensors, forty metres apart, lie beneath the minor road. On either side of its stop line, that is. The vehicle passed over the first at 13:02:07.1 and over the second at 13:02:08.7. I'll save you the sum, it's twenty-five metres a second. The signal controller has that approach on red from 13:02:03 to 13:02:31.",
#:   "You've heard of the Doppler effect? Eeeeee-ooooow, that's a motorcycle when it goes by. I had a lesson in it at the lights by the museum. They'd turned green for me and red for the street he was on. The \"eeeee\" was on my right; the \"ooow\" was on my left; and where they met was where my bonnet would have been.",
#:   "All the others on that road had done as they ought to. You'd a taxi, a cyclist and a police van in a row behind the line, with the red on their roofs. Past the lot of them, on the empty lane, came a pickup. I'd say it was the fastest object I've seen outside an airport. It shot over the junction, and our robotaxi sat down on its nose.",
#:   "When I'm asked why I wait a second on green I tell them about the Saab. I didn't wait that day. I was a yard over the line. He'd been on red so long that people were walking over his road with prams, other end of it, thank God. I felt him more than I saw him, right to left. Motorway speed, and more.",
#:   "From the rejected-scenarios list, now wanted after all. Cross traffic whose light's been red for some time. Unlike in the polite version there's no braking, and unlike in the sneaky one there's no late surge; he comes at the junction much too fast and goes through the junction much too fast, dead straight, ahead of us.",
#:   "I should like to thank the dog. He sat down in the middle of the zebra, on the green man, and wouldn't go on. I tugged. And then that monster of a car came down the side road, where it was red, red as jam, and it was over the crossing and out of sight before the lady in the little white one had finished her scream.",
#:   "Base, was that one of ours? Something just went over the Cornmarket lights from west to east, and I was stationary at them, I mean I was about to go. West was on red, I'm looking at it now. Black estate I think. I'd put it at three figures. No blues, no siren. Correction, I've got his plate, it's lying here.",
#:   "\"A red light at night is only a suggestion,\" he used to say, and the whole of the Friday crowd laughed. It was suggested to him at Elm and Fourth. The needle stood at a hundred and ten. Between the suggestion and the far kerb there came, from the left, two headlamps on a green, and these stood on end.",
#:   "At that moment, I must say, I was looking in the other direction, to my colleague. He became white. Behind my neck something made \"fft.\" I have turned and there was a Suzuki, very small already, in the continuation of the cross street. And over the place where it came from was burning the red. It is burning still, he said.",
#:   "The planner is not to blame. Occlusion by the waiting lorry ended at 1.1 s before conflict; at 24 m/s there's no stopping for him nor any yielding for us. What it did have, and this is the point of the ticket, was the state of the cross signal, solid red, and hence the belief that nobody would come out from there.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "NHTSA pre-crash typology: running red light; own code"
#: [slots]
#: actions = ["run-light", "fast"]
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
#: low = 12.5
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it shoots across"

param OPT_ADV_DISTANCE = Range(25, 60)
param OPT_ADV_SPEED = Range(12.5, 17)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
