#: description = "The crossing car turns left in front of the ego at walking pace."
#: rephrasings = [
#:   "he takes forever to get himself round to the left, right across our nose",
#:   "Vehicle 2 executed a slow left turn across the path of Vehicle 1.",
#:   "left turn, crawling, cuts our lane",
#:   "The target turns left from the cross street at no more than 14 km/h, crossing the lane of the VUT.",
#:   "The bike turns to the left but so slow that the ego must wait.",
#:   "A scooter potters round to its left without any hurry.",
#:   "An elderly driver eases the car leftward through the junction at a snail's pace.",
#:   "The cyclist bends left across the ego's way, barely moving.",
#:   "car from the side came round to the left in front of me about as quick as a milk float",
#:   "V2 made a left turn in front of V1 at approximately walking speed.",
#:   "Bicycle from side: L turn before us, v. slow.",
#:   "The crossing target turns left ahead of the VUT at 5 km/h without stopping.",
#:   "The motorbike from the side goes left before me, but so slow like a man who walks.",
#:   "Side-road left-turner with crawl speed; occupies the conflict zone far too long but never halts.",
#:   "It came out of the side street and bent its way round to the left before them as if it had the whole afternoon.",
#:   "He's doing his left turn in front of you, and isn't he taking his time, I could get out and push him round.",
#:   "guy turning left in front of us at like grandma speed pls hurry up",
#:   "An elderly motorist eased through a left turn so slowly that approaching traffic had to wait",
#:   "You took the left turn before my client at no more than a walk, and you never stopped?",
#:   "That scooter taking left in front of us so slow, like bride walking to stage",
#:   "Left he's going, in front of me, some time this week with any luck",
#:   "Low-speed left turn of crossing traffic in front of own vehicle",
#:   "SLOWEST left turn ever right in front of me",
#:   "The cyclist oozed round to the left before us.",
#:   "Side-street moped bending left before us, hardly quicker than a pram.",
#:   "Let a car from the cross street dawdle left through our path.",
#:   "Bike on the cross road: going left ahead, pace of a walk, over.",
#:   "Gira a la izquierda before us one car, so slow, I could walk.",
#:   "The learner from the side road took her left in front of me at a trickle",
#:   "Coming from the cross street, a vintage tourer wended its way leftward ahead of our car with no more haste than a swan changing direction on a pond.",
#:   "Crossing target: left-turn trajectory through the ego's lane at a constant 5 km/h, without standstill, with conflict-zone occupancy exceeding six seconds.",
#:   "We had to hold back for a motorcyclist out of the side street, who paddled his machine round to the left before our bumper with both feet.",
#:   "Nobody was hurt, since the hatchback which made the left turn from the intersecting road in front of V1 was going at barely two or three miles an hour.",
#:   "How long can a cyclist take over one left turn, I wondered, as the man from the side street ambled round it ahead of us.",
#:   "Wait for this lady, she's coming out of the road at the side and taking a left ahead of you, and she's doing it at tea-trolley speed.",
#:   "I drive a bin lorry, so nobody can call me a speed merchant. But the gentleman in the Honda who came out of the side road this morning made me look like one. He turned to his left in front of me at something like the rate you'd push a wheelbarrow, and I simply stood there and watched.",
#:   "The AV was approaching the junction when a cyclist in the cross street set about a left turn through its path. Weighed down with two crates of beer, he went round in a large, placid curve, at what I'd call pallbearer's pace, and without once putting a foot to the ground.",
#:   "Scene idea for the patience tests: cross traffic, one car, turning left directly ahead of the ego. The only odd thing about it is how slow it goes. It ought to take the bend at the speed of somebody out with a dog, steadily, and so occupy our path for what feels like an age.",
#:   "Dear Sirs, with regard to the broken eggs. I had to brake because a lady on a motor scooter, emerging from the lane at the side, turned left across my front. She did so at such a gentle rate that I could see her counting the house numbers. There was nothing wrong with her signal.",
#:   "It was at the four-way by the feed store. This old boy in the station wagon comes off the side road, making his left in front of the cammer, and he's feeding that wheel hand over hand like he's docking a ferry, and you could honestly stroll alongside and clean his windows while he did it.",
#:   "Caddy from the side street, left past our nose, hearse tempo.",
#:   "Cyclist out of the cross road bending left ahead. Glacial.",
#:   "that scooter going left in front of us, is he even moving",
#:   "It took the hatchback which emerged from the side road a whole verse of the hymn on our radio to get itself bent round to the left before us.",
#:   "The sidecar outfit from the intersecting street had a left to make ahead of V1, and its rider made it as one moves a piano.",
#:   "Should a vehicle from the cross street, turning left through the subject's path, keep to five km/h from entry to exit, the subject will have to wait.",
#:   "A nun on a bicycle came from the street at the side and wheeled left in front of the tanker, so placidly that its driver removed his cap.",
#:   "Be patient with him, he's towing; he's got to get out of that side road and round to his left ahead of us, and walking's about what he'll manage.",
#:   "Traffic from the side: one beige saloon, turning to the left over our lane, with the driver holding it in check so hard that it barely rolls.",
#:   "What I object to isn't that she went, because she'd room to go. She came off Orchard Street on the bike with the baby seat and she'd a left to do in front of my cab. What I object to is the baby waving to me at the start of that left, and in the middle of it, and at the end of it.",
#:   "At a normal pace the thing takes three seconds. I've timed it: vehicle comes from the side, swings left before you, away it goes. Yesterday's vehicle was a classic Beetle with a wedding ribbon on it, and it was swung left before me so tenderly, for the sake of the hat in the back, that it took fourteen. It never stopped, it just didn't hurry.",
#:   "The dispute is over the word \"blocked\". The witness's car was not stationary at any point. It had left the side road and was turning to its left ahead of the claimant; the wheels were going round. They were going round, it is true, at a rate which allowed a gentleman with two sticks to keep pace upon the footpath.",
#:   "In the side view of the AV there's first a headlamp, the motorbike's, waiting in the cross street. Then it's in the front view, and there it remains. It leans left, or rather it doesn't lean, since it's too slow for that; the rider paddles it along its arc with both feet, and seven seconds go by before our path is clear.",
#:   "My father bought a car at seventy and drives it like a water buffalo. Today he shall come from the temple street and take the left, and I am approaching on the main road, and I know this number plate. So I stop. He is passing before my eyes from one side, round, round, so gentle, and he has not noticed his own son.",
#:   "You could've set your watch by it, if your watch was slow. Out of Tanner's Row there came the undertaker's second-best limousine with nobody in it, and the habit was so strong in the man that he took his left, right in front of our coach, exactly as he would have with a departed alderman in the back.",
#:   "Param sweep, left-turner from cross street, ego path crossed. At 20 km/h no reaction is needed. At 12 the ego lifts. At 4, which is somebody out for a walk, it has to come nearly to a stop and then wait through the remaining half of the turn. Use the last one, it's what we see from beginners in the field.",
#:   "Tom says that tortoises are faster and I said they're not. We were in the car and a lady on a bike came out of the other street and went left, in front of us, with a cat in her basket. We counted. It was twenty-one elephants before we could go. Tom says a tortoise needs only nineteen.",
#:   "Why the long face? Because I had a run at the hill, lorry full of sand, and you don't get a second run. And a chap in a little electric car comes out of the lane beside the pub and goes left ahead of me. Goes? He seeps. I was down to bottom gear with nothing left by the time he'd seeped all the way round.",
#:   "The fog lay so thick on that corner that each of us drove by ear. A soft ticking came out of the side street, and passed before us, and bore away leftward; it was the better part of a minute in passing. Not till it was nearly gone did we make out the motorcycle, and its rider with his legs let down like oars.",
#:   "For the attention of the road safety committee. I live opposite the mouth of Bridge Lane. The new hump has so frightened people that they now come out and take their left in front of the main-road traffic at three miles an hour. On Monday it was a red Skoda. The lorry that had to brake for it was still hissing when I'd found my pencil.",
#:   "Cab from the side street: left before us, tortoise tempo.",
#:   "cross road biker taking his left in front of me in slow mo",
#:   "Estate, from your side, bearing left over your bows, dead slow.",
#:   "By the time the hatchback that came out of the intersecting road had got itself pointed down the one on its left, I'd eaten the greater part of a banana.",
#:   "The cargo bike from the side road had so many beer crates to consider on its left-hander before our bumper that it took it at a stroll.",
#:   "What kept us waiting in the crossing was no jam, just a lady in a Micra from the road at the side, feeding her steering wheel to the left inch by inch.",
#:   "Crossing target, left turn through the ego's path; speed throughout the intersection 1.4 m/s, free of stops; ego conflict zone occupied for at least five seconds.",
#:   "Let something come out of the cross street and go to its left in front of the robotaxi, so slowly that a toddler holding on to the door handle could keep up.",
#:   "You can't fault his line, that motorbike from the side, it's a lovely left-hander, but he's doing it at two miles an hour and he's doing it in front of you.",
#:   "I was taught to look for wheels. These seemed to stand at the mouth of Ivy Lane on my right, so I went on. When I looked again the valve on the front one was at six o'clock and not at three. A wheel that lazy couldn't get a car out before me. It had the car across my nose and half round to its left before the valve was up again.",
#:   "There were nine of us in the pram club, and we saw it from the corner. The car with nobody in it came along the main road. Out of the side road, for its left turn, came a learner. We went along the pavement, and Beth's pram still got to the bookshop before the learner had straightened up. The empty car just stood and waited.",
#:   "Heading of the crossing vehicle against time: zero degrees at entry, a quarter turn to its left at exit, and a straight line in between, with no flat piece. Were it a normal turn the axis would need three seconds. It needs fourteen. Our vehicle, for which it was in front from the second second to the eleventh, stood with its nose dipped and its blinker going.",
#:   "In my taxi I have a saint on the dashboard, and he fell on his face. Because of who? Because of a grandfather on bicycle with a ladder. He's coming from the transversal street, he wants to his left, and the ladder must come also. First passes the front of the ladder, then the grandfather, then the long rest of the ladder. A snail with ladder, before my bonnet.",
#:   "Nobody had told the bride's chauffeur that his was the side road. He came forth from it as he'd been told to do everything that day, as if on cushions. The white ribbons, the white bonnet, the white veil in the back drew past the grille of our coal lorry, and swung away down the road to his left; you could've walked beside them and said the Lord's Prayer twice.",
#:   "The complaint against the shuttle was that it braked too hard for something so harmless. Harmless, yes. A scooter carrying a birthday cake was emerging from the street on the left and going round to its own left at the speed of a careful waiter. But it was slow enough to be still in front when the shuttle got there, and that's what one brakes for.",
#:   "Why's everyone hooting, asked Grandma, when it was she they were hooting at. We'd come out of our lane, and she'd the wheel hard over to the left, as she should. There was a bus up against my window. I could see the driver's socks. \"It's a corner,\" said Grandma, \"one doesn't gallop round a corner,\" and I looked up at the socks for ages and ages till we were round.",
#:   "I clean the windows above the crossroads. You'd think it was a film they'd put on too slow. Everyone else is at the right speed, the blokes on the pavement, the dog. Then there's this red pickup from the side street, with a greenhouse on it, going left. It's all round glass, so the sun comes off it. The sun crept over the front of that waiting fire engine pane by pane.",
#:   "What you've to work out isn't whether he'll come. He's coming, he's out of his side road as far as the doors. It's where he'll be when you arrive, and the answer with this gentleman is: in your way. He's turning left, he's got a caravan, he's barely touching the gas. A fast one would've been gone. So you're on the brake now, aren't you, and you'll stay on it.",
#:   "Under cross-examination the driver of V2 gave his speed in the turn as \"none to speak of\". That's consistent with his milk, of which he spilt nothing. He had come up the minor road, which meets V1's from the side. He had put his milk float into a left-hand turn across the nose of V1. He conceded that a man with a milk churn would have overtaken him.",
#:   "There was a motorbike that evening, a big tourer with a tired woman on the back, which came from the side and inclined to the left in front of my headlamp like a cow going home. I had all its chrome by heart. My heart had been in my mouth when I hit the brake; it had time to go all the way down again.",
#: ]
#: adversaries = ["car", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "slow"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.8
#: high = 3.9
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(4, 18)
param OPT_SLOW_SPEED = Range(2.8, 3.9)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
