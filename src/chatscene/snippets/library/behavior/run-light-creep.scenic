#: description = "The crossing car creeps over the line on red and crosses at walking pace."
#: rephrasings = [
#:   "the guy from the side just trickles out while his light is still red",
#:   "Vehicle 2 crept past its red signal and proceeded slowly across the travel lanes.",
#:   "red for cross traffic, veh inches across anyway",
#:   "The target moves off against a red signal and traverses the junction at no more than 12 km/h.",
#:   "A bus passes very slow the red light, like it has all the time of the world.",
#:   "A cyclist dawdles across on red in front of the ego.",
#:   "The lorry rolls gently over the stop line although it has red, and takes ages to clear.",
#:   "Although the lights are against it, the van crawls into the crossing and keeps crawling.",
#:   "He dribbled over the line on red and inched across the junction.",
#:   "Vehicle 2 rolled past the stop bar against a red signal and proceeded through the intersection at about three miles per hour.",
#:   "Red; bus edges over line, ~5 km/h across.",
#:   "The crossing target passes the stop line at red and traverses the junction at walking speed.",
#:   "The car goes very slow over red light, like a walking man.",
#:   "Slow-motion red-light runner: oozes over the stop line and takes forever to clear.",
#:   "The light was against him, yet he stole over the line and went across no faster than a man on foot.",
#:   "He's sneaking over on the red, look, barely moving, let him dribble across.",
#:   "he just kinda rolled out on red super slow like nobody would notice",
#:   "A coach sidled over the line against the signal and went over at strolling pace.",
#:   "The signal was against you, and you proceeded notwithstanding, at the pace of a man walking?",
#:   "Red light also he is coming out slowly slowly like it's nothing.",
#:   "Sneaks out on the red like a kid raiding the biscuit tin, slow as you like all the way over.",
#:   "Low-speed red-signal violation of crossing vehicle.",
#:   "SLOWEST RED LIGHT RUNNER EVER",
#:   "The crossing bus seeped past the red at a shuffle.",
#:   "Cross traffic's on red and a taxi is tiptoeing over regardless.",
#:   "Lorry from the side ignores red, takes an age to trundle across.",
#:   "Have a scooter ooze past its red and amble over the junction.",
#:   "Lights red stop van nosed out at funeral pace stop crossed entirely stop",
#:   "That bus is going on red, and so slow like an old turtle!",
#:   "From our left a hatchback slid forward past the stop line with the lamp still red against it and went over the junction hardly quicker than a pram.",
#:   "Facing a red indication, the crossing target nevertheless advances beyond the stop line and maintains roughly 4 km/h through the intersection.",
#:   "I couldn't believe the nerve of the cyclist, who had a perfectly good red lamp in front of him and pottered over in front of me all the same.",
#:   "V2 entered from the intersecting street against a steady red and moved through the intersection at a very low, constant speed.",
#:   "red for him, green for us, an still the coach from the side street comes sliding out and takes half a minute to get accross",
#:   "In our city they do it so: signal is red, the auto from side is slowly rolling, rolling, till he has passed whole junction.",
#:   "When they run a red they usually go for it, but not this gent. He let his Rover trickle over the line while the signal forbade it and went from one kerb to the other no faster than the ladies on the crossing.",
#:   "The violation is easily missed because nothing about it is fast. The agent on the cross street starts rolling during its red phase, clears the stop line at a snail's pace and goes on crossing at that pace right in front of the AV.",
#:   "I had the green, I'd have sworn it on the Bible, so the lorry on the side road must have had red. Yet out it came, inch by inch as if nobody would mind, and it plodded over until its tail was finally out of my way.",
#:   "You'll meet them, the ones who think a red doesn't count so long as you don't hurry. That motorbike on the right has just dribbled over its line, feet down, and it's walking itself across the whole junction in front of you.",
#:   "The lights had not changed in his favour; the footage leaves no doubt. Nevertheless the pickup's bonnet came over the line from the cross street, and it then proceeded, as one might follow a coffin, the full width of the crossroads.",
#:   "Against a red lamp, crossing lorry slides out and dawdles over.",
#:   "Bicycle from the side treats red as \"slow down\", potters across.",
#:   "you had a RED and you strolled your whole bus across anyway?",
#:   "From the street on our left a cab, for which it was plainly red, stole out and made its way to the other side like a hearse.",
#:   "The target, approaching on the intersecting road, passes its stop line during the red phase and maintains a speed of 5 km/h until clear of the junction.",
#:   "That motorcyclist over there has got a red, you've got the green, and he's still paddling out; he'll be a good while getting over.",
#:   "Let the side-street tipper ignore its red signal and move through the intersection so slowly that the ego meets it halfway.",
#:   "With red he rolled out, the gentleman with hat, and he passed over the whole crossing not faster than his wife would go with the dog.",
#:   "Traffic signal data confirm that V2 faced red when it inched beyond the limit line; it was subsequently driven across at about three miles an hour.",
#:   "You expect a red-light jumper to be in a rush. I was looking for speed, and what I got was a school bus emerging from the side road like a cow from a shed. Its light was red, it must have been, mine was as green as grass, and it took for ever to plod over to the other side.",
#:   "I thought at first that its brakes were slipping. The pickup on the cross street had a red above it and ought to have been standing; but its shadow slid over the white line, and on, and on, at about the pace of the lollipop lady, until it had got to the far kerb.",
#:   "Our green had been on for four seconds, according to the controller. It follows that the cross road had red. The van on that road entered regardless, and since it was doing no more than 1.2 m/s it was in our conflict zone for a very long time.",
#:   "I'd like to say he was brazen, but he was more like somebody sneaking out of church. There was the red, there was the bicycle behind it, and then the bicycle was a bit in front of it; and a bit farther; and in this shy manner he trundled all the way over.",
#:   "The defendant's case was that he had waited at the line, believed that nobody minded, and let the car roll. He allowed that the lamp was still red. He allowed as well that it had taken him some fifteen seconds to travel from one side of the crossroads to the other.",
#:   "You want to shout at them, but it does no good. He's had a red the entire time, that lorry, and he's sneaked his cab over and now he's dragging the rest of it through the junction at the rate of a glacier, and your lovely green's going to waste.",
#:   "Why is the tram bell ringing? Because a little old Fiat has come out of the side street on a red light. It doesn't jump or dart or anything of that kind; it just rolls, with grandma behind the wheel bolt upright, until after an age it's on the other side.",
#:   "They'd sent us over to test the camera on signal violations, and we'd hardly set it up. A moped, its own lamp glowing red, trickled past the stop line from the right. It had to be steered with both feet, so slow was it, and it stayed that slow till it was clear.",
#:   "Everything on the avenue was green for the robotaxi, and it was quite right to come on. What it found was a coach broadside to it, scarcely in motion. The coach had oozed out from the cross street on a red, and it was now shuffling over to the far side, wheel turn by wheel turn.",
#:   "The lady in the paper shop has seen the lot. On Monday, she says, it was a bread van. His signal was against him, but out he poked, no faster than you'd push a pram, and he carried on like that, straight over, while a car with the green sat and hooted.",
#:   "Night time is like that only in our town. For side road it is red, and that one tempo is coming, not fast, no no, just like bullock is pulling it, crosses the line, crosses my front, and goes to other side taking full two minutes.",
#:   "Red for them, yet that hatchback's seeping across like spilt milk.",
#:   "Our green, his red, his bonnet, his doors, his boot, one per second.",
#:   "Side-road scooter treats red as a stroll permit.",
#:   "It can't have been two miles an hour that the pickup was doing when it came out past its red from our left, and it never did more.",
#:   "The crossing bicycle's lamp hadn't changed; he had just got tired of it, and he trickled over the line and on to the far kerb like a man pushing a cart.",
#:   "Put a bus on the cross street, hold its signal at red, and have it seep into the junction all the same and on over it, as slow as a procession.",
#:   "I've got a green and you've got a green, but there's a lorry oozing across from the right who hasn't got one, and he's in no hurry to be gone.",
#:   "During the red phase of its approach V2 left the stop line, and 14 seconds elapsed before its rear bumper was clear of the opposite curb.",
#:   "At him it was red like a tomato and nevertheless he let his Mercedes glide before us over, so slow that I could count the screws of the wheels.",
#:   "There's an arrow of shade that the signal post throws on the road there, about ten in the morning. I was waiting for my green and I'd got it. Along the shade, out of the side street, came a front wheel that had no green at all, at the rate the shade itself moves; then the rest of a taxi, all the way over.",
#:   "If someone's going to burgle a junction, they generally run. Here we saw an elderly coach, all its passengers looking straight ahead as if they weren't in it, steal out below its red lamp. We'd been on our way. It took up our whole road for as long as you'd need to make toast, and stole out on the other side.",
#:   "Two clocks decide this case. The first belongs to the traffic signal, and by it the cross street had been at red for six seconds when the Rover came over the line. The second belongs to the camera; by that one the Rover was eleven more seconds about getting to the other side, without once having stood still.",
#:   "You keep waiting for it to either go or stop. There's the red, there's the motorbike that ought to be behind it, and the gap between them's getting wider by inches. He's out in front of us now. He's not turning, he isn't pausing, he's just being wheeled along by his own idle; well, we've nothing to do but brake.",
#:   "My son asked if the man was broken. He was on a cargo bike, his light was red as anything and ours was green, and he went over in front of our car as though the air were treacle. I said no, love. I said some people think that it isn't cheating if you do it very, very slowly.",
#:   "Actor definition, crossing leg. Signal state at entry must be red, else the run is void. Speed on passing the stop line 1.3 m/s, the same at the conflict point, the same at the far side. It's meant to be in the ego's lane for seven seconds or so; that's the whole nastiness of it.",
#:   "The tyres told me before the driver's eyes did. They were going round, but only just; you'd see the valve come up, and go down, and come up. It was a tipper off the quarry road and he'd a red over him that you could have warmed your hands at. He rumbled on across us, valve up, valve down, until he was over.",
#:   "What woke the constable was the silence. He was used to horns when anyone disobeyed that lamp. But the van that had slid out from Tanner's Row against the red made no more noise than a cat, and went no quicker than one that's stalking; and by the time the first horn sounded it had the far pavement under its wing.",
#:   "We lost our green to a milkman, I ask you. It'd come, we had moved up, and there he was in front of us with all his bottles, coming from a road where it was as red as red. Did he have the grace to hurry? He'd eggs on board as well, I imagine. We saw every crate he had.",
#:   "I hauled timber for thirty years and I've been slow over junctions myself, but on my own colour. This one had the wrong colour. From the right, on a red, he brought out a low-loader no faster than you'd unroll a carpet, past my bumper, past the island, and so on to the far road, looking neither left nor right.",
#:   "Signal at that side is red from morning, I think so. But fruit-cart-type tempo doesn't see it as red, he sees it as fruit. He came out over the line, slow like marriage band, crossed my way with full dignity, bananas shaking a little, and when he was finally on that side, my green became red.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "slow"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.0
#: high = 3.6
#: unit = "m/s"
#: meaning = "how fast it creeps across"

param OPT_ADV_DISTANCE = Range(0, 15)
param OPT_SLOW_SPEED = Range(2, 3.6)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
