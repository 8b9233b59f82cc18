#: description = "The parked car starts to pull out, stops, hesitates and then pulls out after all."
#: rephrasings = [
#:   "The parked car starts out, stops, dithers, then goes for it right before us.",
#:   "Vehicle 2 began to leave the curb, paused and then entered the travel lane.",
#:   "Parked veh moves, halts, moves again into lane.",
#:   "The target starts from the parking strip, dwells at standstill and then merges ahead of the VUT.",
#:   "It goes a bit, stands a bit, and when we think it waits, it comes out.",
#:   "The bus twitches away from its stop, checks its mirror, and lumbers out anyway.",
#:   "A nervous learner creeps from his space, freezes, and commits too late.",
#:   "The motorcyclist paddles off the roadside, pauses, then pops out.",
#:   "the parked Fiesta edged out, thought twice, sat there dithering, and then came out anyway",
#:   "V2 began to leave the curb, stopped, remained for a moment, and subsequently entered V1's lane.",
#:   "Bus: starts off from stop, halts, dithers, then out after all.",
#:   "The parked target initiates a move-off, interrupts it for several seconds, and then completes its entry into the lane.",
#:   "The parked car comes out a little, stops, does not know, and then it comes out really.",
#:   "Two-phase move-off from the parking bay: creep, pause, then full entry into the ego lane. Timing of the pause tunable.",
#:   "The motorbike had inched off the kerb and baulked, and just when they believed it would stay, it came out.",
#:   "He's not sure whether to leave that space or not: bit out, stop, umm, ahh, and now he's coming after all.",
#:   "parked car was like should i go should i not, then went right in front of us",
#:   "The nervous driver edged from her space, had second thoughts, and finally came out in the face of traffic",
#:   "First he moved, then he waited, and only then did he enter the lane, as you recall it?",
#:   "The bus move out a bit, stop, think think think, then come out after all, confuse people only",
#:   "In or out, love? Nose out, stops, has a ponder, and just when I reckon she's waiting, out she comes",
#:   "Indecisive departure of parked vehicle: partial start, dwell, delayed entry into lane",
#:   "Parked scooter can't decide... then pulls out ANYWAY",
#:   "The parked car twitched, wavered, then slid out.",
#:   "Bus leaves its stop in two bites: a twitch, a wait, then out.",
#:   "Parked scooter: rolls a foot, stops, ponders, joins our lane.",
#:   "Out she came in the end, after one false start from the kerb.",
#:   "First the parked car bottles it, then it sets off into our lane.",
#:   "Let the parked moped dither once before it really joins the road.",
#:   "The estate at the kerb rolled forward a touch and checked itself, and when our car was nearly there the driver decided to come out into the lane regardless.",
#:   "Target vehicle aborts its departure from the parking lane after 0.6 s, is stationary for a set time, and then carries out the departure in front of the VUT.",
#:   "Claimant says the parked Peugeot moved, then stood, so he assumed he'd been seen, whereupon it moved off again and drove into his lane.",
#:   "Could you do a parked car that begins leaving, has doubts, stands for a couple of seconds and in the end pulls into the ego's lane and drives along it?",
#:   "Le bus, he commence to leave the stop, he brakes, he reflects two seconds, and finally he goes into my lane before me.",
#:   "If they nudge out and stop like that, don't think they're waiting for you, cause look, now she's coming out of the space for real.",
#:   "The wheels of the parked Golf had turned and it crept off by a hand's breadth, so I lifted off. It stopped dead. I thought good, she's letting me go, and I'd just put my foot back on when the thing moved out into the lane in front of me after all.",
#:   "V2 was legally parked along the east curb. Its driver initiated a pull-out, applied the brakes, and remained motionless for about two seconds while looking in the mirror; V2 then left the curb completely and proceeded in the lane of V1.",
#:   "Episode twelve, the ditherer. A motorcyclist sits at the roadside with his engine going, paddles forward with his boots, loses heart and stops. Any planner that takes that for a yield gets punished, because two seconds later he lets the clutch out and rides off in your lane.",
#:   "I drive the 38 and I know how it looks from behind. I'd let the brake off at the stop, then saw a car in my mirror and put it on again, sat there, wasn't sure, and then I thought I'd been let out and took the bus into the lane.",
#:   "Mum said the man couldn't decide. His car was parked and it went a tiny bit and then it stood still, and we waited to see, and then it really did go, out of its place and onto the road where we were driving.",
#:   "False start from the kerb, a breather, then properly out before us.",
#:   "Parked coach: lurch, freeze, second thoughts, and into our lane.",
#:   "Edges off, baulks, waits, comes: that's the parked Vespa.",
#:   "A parked people carrier gave a small jump forward, stood again for some seconds, and only then steered out and took its place in the lane ahead of us.",
#:   "Have the standing motorcycle roll a foot from the roadside, put its foot down, think it over, then ride out ahead of the AV and continue.",
#:   "Departure is to be carried out in two steps: a move-off broken off at once, standstill for the dwell time, then complete entry into the lane of the VUT.",
#:   "Bus has given indicator, moved small, then stopped, I thought he is giving me side, and just then he came out fully into my lane.",
#:   "Twice it left the kerb, that blue Honda, the first time for a foot or so before it thought better of it, the second time for good.",
#:   "Having begun to leave its space and then stood still long enough for V1 to come quite near, V2 went ahead with it and entered the lane.",
#:   "There's a word for people like that and I won't use it in front of the microphone. The wheels start rolling, so I slow. The wheels stop rolling, so I carry on. I've got maybe three lengths left when out the car comes from its parking place regardless, into the lane, and off it drives ahead of me.",
#:   "The indicator had been blinking for so long that I had stopped believing in it. There had been one little hop away from the kerb, and after it nothing, just the driver's eyes in his wing mirror. And then, when the bonnet of the shuttle was almost level, the parked Skoda did swing out in front of it.",
#:   "Statement of passenger, seat 4A. Our bus was at the stop. It jerked off and jerked to a halt, and I fell against the rail; then we stood for a bit, and the driver said something like \"go on then.\" After that he did take us out into the lane, and I heard the tyres of the car behind.",
#:   "Be wary of the second move, not the first. On the first, the parked scooter rolled half a metre and you were all alert. It stopped, the rider sat there doubtful, and you relaxed, I felt you relax. And that's the moment he chose to come into your lane and ride away up the road.",
#:   "In the file the parked vehicle's speed shows a small tooth, then zero for 2.4 s, then a ramp. The tooth is a started pull-out that got cancelled. The ramp is the real one; on it the vehicle leaves the kerb, enters our lane and proceeds as the new lead. Our yielding logic had been reset on the zero.",
#:   "My wife always says \"he's coming\" and I always say \"he isn't.\" With this parked Beetle she was right, then I was right, then she was right again. It had stirred, it had thought about it with its nose barely out of line, and it had finally pulled into the lane under our bumper.",
#:   "The old woman at the wheel had been sitting at the roadside all morning to collect her courage. Some of it sufficed to carry the car a hand's breadth; there it ran out, and she stopped and clutched the wheel. What remained she gathered in two long breaths, and then she steered out into the lane and drove.",
#:   "Dash cam shows it nicely. 08:14:03, parked taxi twitches. 08:14:04, it's standing again and he's looking over his shoulder straight at me, I swear we made eye contact. 08:14:07, he comes out anyway, right in front, gives me a little wave and toddles off down the lane.",
#:   "From the point of view of my tram-driver's seat it was comedy. The motor bicycle leaves the kerb, no, it doesn't. It remains, it thinks. Nobody breathes. Yes, it leaves after all, and the green car which had trusted in the \"no\" must make a brake like in the driving school, and then follow it down the lane.",
#:   "He insisted that he had been waiting for her to pass. It was pointed out to him that his parked car had first advanced and checked, which anybody would read as an offer to wait, and that it had nevertheless driven out into her lane when she was a bare ten metres from it. He had no answer to that.",
#:   "For the hesitation family we also want the kerb version with a bus. It sits at its stop; on trigger it creeps for about half a second, brakes to nothing and remains so for the pause we set. At the end of the pause it isn't cancelled: the bus moves over into the ego's lane and drives on there.",
#:   "One lurch from the kerb, a long think, then into our lane.",
#:   "It budged, it froze, it came: the parked scooter.",
#:   "Parked bus: twitch, dwell, and off into my lane after all.",
#:   "The gap between its tyre and the kerb opened by a foot and stayed at a foot, and just as I trusted that, the car slid out ahead of me and drove on.",
#:   "Having rolled a little and stood a little, with his blinker going all along, the man in the parked Lada ended by joining the lane under our nose.",
#:   "Step one, the kerbside target creeps for half a second; step two, it rests; step three, which the VUT must survive, it enters the lane and proceeds.",
#:   "He'd already lost heart once, that biker at the roadside, feet down and all, so who would think he would find it again with us ten metres off?",
#:   "Don't flash her out, I said, she's stopped again, but she found her nerve by herself and off into our lane she went.",
#:   "Twice my coffee went over, once when the parked taxi hopped out a foot and again when, having sat there, it did come out and drive away in front.",
#:   "Only by the second did I have my horn ready. On the first occasion its front wheel rolled out of the leaves and stopped at the edge of them, and the brake lights burned for a good three seconds. I took that as manners. Then they went out, and the whole Peugeot was in my lane and driving off ahead of me.",
#:   "The cyclist's statement agrees with the bus camera. Indicator on; wheels turn through about a quarter; wheels stop. Cyclist sits up and freewheels past one lamp post, thinking he's been seen. Wheels turn again and don't stop, bus occupies the lane, cyclist follows it as far as the station.",
#:   "From the AV's logs: \"parked vehicle active,\" brake. \"Parked vehicle inactive,\" release. \"Parked vehicle active,\" brake. The middle entry is what we call the doubt. For two seconds the motorcycle had in fact been at rest, half a length from where it had set out; after the third entry it was in our lane, on its way, our new leader.",
#:   "Her hand kept going up to her mouth. I could see that from behind, through her rear window, she was in a Micra at the side of the road. The Micra gave a little start when the hand came down, and stood when it went up. I crept. I was nearly beside her when the hand came down for good and she drove out before me.",
#:   "\"Will he, won't he\" is a game my wife and I play along the market street. That morning I won the first round, since the parked Passat moved and then didn't. There was a pause, for applause as it were. In the second round she won, as it pulled out before us with all its passengers and led us to the bridge.",
#:   "I'm the driver of the parked car and it's true what he says. I'd begun to go. Then I saw him in the glass and stood on the brake, and I remained there thinking he's far, he's near, he's far. In the end I decided he was far. I was out in the lane and on my way when I heard his tyres.",
#:   "Two thuds were heard from the gutter, madam tells us. The first is when the wheel of the standing coach dropped off the kerb edge, and then was nothing, so she carried on. The other is when the rear wheel dropped off it too, some seconds on. By this time the coach was in her lane, and pulling away up the hill.",
#:   "Your eyes have to stay on a car like that even after it's gone quiet. It had a go, didn't it, half a yard. It's thought better of it, brake lights, and you've put your foot back on the gas. Off with it! There, that's the real thing now, he's out, he's in our lane and he's away.",
#:   "Trainee bus driver, day two, and the whole top deck was with her. She let the brake off at the stop, we swayed. She put it on again, we swayed back. You could've heard a pin drop while she looked in that mirror. And then she went, right out in the lane in front of a van, bless her, and kept going.",
#:   "In the heat no one had any resolve. The moped that leaned at the roadside was walked forward a pace by its rider and let stand. He considered the street, with the blue car coming down it. He considered his sandals. When there was next to nothing left to consider he rode out into the lane, and on, and the blue car's tyres wept.",
#:   "Abhi he will come, I said, and slowed. He moved small small from the side and stopped, looking here and there. Okay he will not come, I said, and went. Exactly then he came, that parked Wagon R, complete into my lane, and without even saying sorry by hand he continued to Andheri, me behind.",
#: ]
#: adversaries = ["car", "bus", "motorcycle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "pull-out"]
#: side = "right"
#: position = "kerb"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 24.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 0.9
#: unit = "s"
#: meaning = "how long it hesitates"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(24, 42)
param OPT_STOP_TIME = Range(0.3, 0.9)
param OPT_ADV_SPEED = Range(4, 6.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 2, 0) for 0.6 seconds
    do BrakeOnPath(advKerb, 1) until self.pose[3] < 0.05
    do Park() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
