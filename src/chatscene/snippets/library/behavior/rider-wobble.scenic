#: description = "The rider ahead rides slowly and wobbles from side to side."
#: rephrasings = [
#:   "The old boy on the bike in front is wobbling all over the shop at walking pace.",
#:   "The bicyclist traveled slowly ahead of Vehicle 1 on an unsteady path.",
#:   "slow bike ahead, wobbling",
#:   "The bicyclist target moves at low speed ahead of the VUT with lateral oscillations.",
#:   "The cyclist before us is slow and goes left and right.",
#:   "A child learning to ride teeters along in our lane.",
#:   "A rider with shopping on the handlebars cannot keep a straight line.",
#:   "The scooter in front dawdles in wavy lines as if looking for an address.",
#:   "The cyclist in front was tottering along all over the place, hardly moving.",
#:   "The bicyclist ahead was riding unsteadily at low speed, drifting left and right.",
#:   "Bike ahead slow + unsteady, L-R-L. Keeps going.",
#:   "The leading cyclist target proceeds at low speed with continuous lateral oscillation.",
#:   "The bicycle in front is slow and shakes left and right.",
#:   "Slow leader VRU with lateral wander; no stop or turn, just unstable.",
#:   "She was new to the thing, and went along before him at a crawl, her front wheel hunting this way and that.",
#:   "Give him a wide berth, he's a shaky rider, slow as you like and swaying about in front of you.",
#:   "this old guy on a bike in front is so slow and so wobbly im scared for him",
#:   "An elderly cyclist teetered along at a modest pace, holding no line, witnesses said.",
#:   "The rider ahead was slow, and he could not keep a straight course; he swayed, did he not?",
#:   "Front cycle uncle going very slow and shaking this side that side, cannot pass.",
#:   "Pedalling through treacle in front of me and swaying like a washing line.",
#:   "Slow leading two-wheeler with pronounced lateral instability.",
#:   "WOBBLIEST CYCLIST IN TOWN",
#:   "The rider ahead joggled slowly left and right.",
#:   "Cyclist in front, doing about nothing, tacking like a boat.",
#:   "Have a feeble scooter ahead of us that totters left, right, left.",
#:   "Bike ahead: jelly-legged, tortoise speed, all over its bit of lane.",
#:   "Davanti a me one bicycle, piano piano, dancing left and right.",
#:   "Boy on bike's so slow he keeps tipping one way then the other",
#:   "My neighbour, ninety next week, was ahead of the taxi on her bicycle, proceeding at a dawdle and swerving a little this way and a little that.",
#:   "Leading powered two-wheeler to be ridden at 7 km/h with a periodic weave of ±0.5 m for the whole run, upright and under way throughout.",
#:   "A man balancing a ladder on his bicycle crept along the lane in front, and the ladder swung to and fro with each unsteady stroke of his pedals.",
#:   "You can't sensibly pass a moped that's waggling about like that, so we'll sit back here at its five miles an hour and be patient, shall we?",
#:   "At so low a speed no bicycle will run true, and the one ahead of the robotaxi rolled its front wheel continually leftward and rightward to keep from falling.",
#:   "The reason I held up the traffic, officer, was a biker before me, hardly moving, whose machine lurched now to the kerb side and now to the other.",
#:   "I got stuck going up Gallows Hill. There was a chap on a tourer in front of me with four panniers and no gears left, and he was grinding upwards slower than I could walk, with the bike squirming from one side to the other every time he pushed down on a pedal.",
#:   "The planner's lateral-gap check flip-flops here. A cyclist ahead in our lane is riding at eight km/h, and because of the low speed their track oscillates, half a metre left, half a metre right, for the whole length of the log. They never come off, never turn away, never stop.",
#:   "When you teach your daughter to ride on the road, pick a quieter one. Dad jogs alongside, and there she is, directly ahead of our car, at the speed of a toddler's tricycle, the handlebars twitching one way and then the other as she fights to keep the thing pointing forwards.",
#:   "Newspaper letters page: Sir, must learner motorcyclists practise at rush hour? For a mile on Tuesday I was behind one who travelled at little more than a trot and whose machine swung across the lane in a kind of slow pendulum, to left and to right, with the rest of us strung out at the back.",
#:   "Madam, the old uncle ahead was having two big milk cans hanging on his cycle. So he was going very slowly, and with the weight the cycle was rocking on both sides, once to the left, once to the right, like an elephant only, and I was going behind him fully careful.",
#:   "Unsteady moped ahead, walking pace, drifting off left, drifting off right.",
#:   "Kid on a bike in front: dead slow, handlebars all a-jitter.",
#:   "the guy ahead on the bicycle is so drunk hes doing 3mph in zigzags",
#:   "She had a cello on her back, and both she and the bicycle ahead of us tilted ponderously to the one side and the other, making hardly any headway.",
#:   "At this rate of travel the scooter before us has no gyroscopic help to speak of, and so it totters left, rights itself, totters right, and so on.",
#:   "The cyclist we were behind had a dog on a lead, no great haste and no fixed line, being tugged to the kerb and tugging back.",
#:   "Lead bicyclist: mean speed 2.1 m/s, lateral standard deviation 0.35 m, alternating sign; no standstill and no departure from lane over the ninety seconds evaluated.",
#:   "What was I to do, with a motorcyclist in front of me who went no faster than a perambulator and swung about as a drunkard carries one?",
#:   "Give the ego somebody to be patient with: a bicycle straight ahead, going at a dribble, its front wheel never pointing the same way for two seconds.",
#:   "If you've carried a Christmas tree home on a bike, you'll know. If you haven't, picture me behind someone who was. All I could see was tree. The tree nodded to the hedge, thought about it, and nodded to the middle of the road, and with all that nodding it was making about four miles an hour.",
#:   "It's on account of my knees that I ride the moped, and on account of my balance that I ride it slowly. I know I had a car on my tail. The lady says I was \"sweeping\". Well, at that speed the front end goes where it likes, a bit to this side and a bit to that, and I follow it.",
#:   "The log calls for a stopwatch and a ruler. With the stopwatch, measure how long the cyclist in front takes from one lamp post to the next: eighteen seconds. With the ruler, measure the widths of the loops left by her tyre in the slush, first on one side of the straight line, then on the other, like a child's drawing of waves.",
#:   "That isn't a novice you can hurry. He's ahead of us, he's holding on to those bars like grim death, and he's hardly making any way, which is just what makes him roll about so. If you come up close he'll look round, and when they look round they roll about twice as much. So stay here.",
#:   "My bus was full of commuters, all of whom had advice. Overtake, they said. I'd have liked to know on which side. The gentleman on the bicycle before us was at an age when one doesn't push, and as he inched along his rear lamp went from left to right and from right to left like someone saying no.",
#:   "The plaintiff had been following the motor scooter for some two hundred yards. It was, he says, barely in motion. Nor was it straight: its rider, who was texting with his thumb, allowed it to fall away to one side until alarmed, then recovered it and allowed it to fall away to the other. This was continuous.",
#:   "Every pedal stroke was a decision. The monk ahead of the jeep, in his long robe, would press the left one and the whole bicycle leaned out and came a hand's breadth over; he would press the right one and it leaned back and came a hand's breadth the other way. In such a fashion he rose, scarcely faster than the smoke, towards the monastery.",
#:   "What I need from simulation is a slow leader without a stable heading. A bike will do. Keep it upright, keep it in the ego's lane, about the speed of someone pushing a pram, and superimpose an oscillation of half a metre to each side. It mustn't stop, fall, or peel off, as those are separate cases.",
#:   "In Kerala we are seeing this daily. The fish man was in front of our van, with the wet box behind him on the motorcycle, so heavy. He will go slow only. Also he cannot go straight, the box is swinging him to left, he is bringing it to right, again it is swinging. We took twenty minutes for one kilometre.",
#:   "The headline number is three: that's how many miles per hour we were down to. And the reason's that backside you can see on the screen. It belongs to a man on a hire bike. He's obviously not ridden since school, because look, his front wheel's flapping one way, flapping the other, all the way up the Mall ahead of our robotaxi.",
#:   "Fourteen of us on the club run got stuck behind her, and then a car got stuck behind us. She wasn't doing any harm. She'd just bought the thing. She'd got her tongue between her teeth, and she was going forward at the rate moss grows, and sort of sideways as well, to the left a while, then to the right a while.",
#:   "Bike in front: no pace, no balance, both ditches by turns.",
#:   "scooter ahead going like 5 mph n swinging about like a drunk duck",
#:   "Old lad leading on a pushbike, barely moving, tacking side to side.",
#:   "The bicycle before us needed the whole width of the lane and most of the afternoon, what with its front wheel falling now to this side, now to that.",
#:   "You could draw his track by shaking your hand with a pencil in it, and you'd have to draw it slowly too, the rider in front not being in a hurry.",
#:   "If I aimed to pass on the left, that's where the moped ahead was tottering to, and if on the right, likewise, all at about a jogger's pace.",
#:   "Leading two-wheeler: forward speed 2 m/s; superimposed lateral oscillation of some 40 cm each way, uneven; no fall, no halt, no departure from the lane.",
#:   "Her shopping hung on one handlebar and then, as she swayed, on the other, and so she led us up the street at the rate of a church procession.",
#:   "Have someone on a bike in front of us who's only just fast enough to stay up, and who for that very reason is forever steering himself back under his own saddle.",
#:   "Let me describe what I overtook. For half a mile it had been in front of the van, three bags of cement on the carrier and a man of about the same weight on top. The front wheel hardly touched the road. It went over to the kerb with him, it went over to the white line with him, and I went along behind at the speed of cement.",
#:   "We have stopped calling it noise, because it's the signal. The track of the lead bicycle crosses its own mean line nine times in twenty seconds, while its mean speed is so low that our creep mode can't hold the distance. Any passing plan made on one side expires within a second and a half as it drifts over there.",
#:   "My daughter shouted \"Left! Right! Left!\" like the cox of a boat. She meant the back light of the motorbike that we were stuck behind, a learner's, with a learner's feet trailing out on both sides to be on the safe side. I never got out of first. He never got himself in a straight line. But he never toppled, and we clapped when he'd got to his house.",
#:   "It was two degrees, and the puddles had skins. In that skin, in front of our wheels, ran the line of her tyre, and I had a long look at it. It was the line one makes with a finger on a steamed pane: over here, over there, nearly a loop. At the end of the line was the district nurse, upright, and pedalling about once in a hymn.",
#:   "The passenger in the robotaxi pressed the help button. \"There's a man on a bike,\" she said, \"he's in front, he's going nowhere.\" Was he stopped? \"No, he's rolling. Only he's also going sideways. And sideways the other way.\" Was there room to go by? \"There is,\" she said, \"and then there isn't, and then there is.\" They stayed behind him as far as the hospital.",
#:   "On my lorry I've got the big mirror that looks down at the bumper, so I could see all of him. Little lad, father's bike, legs too short, so that he had to slide off the saddle to one side for the left pedal and to the other side for the right one. And where he slid the bike slid. I had the clutch in all the way.",
#:   "Nothing he did was against the law, if you'll permit me. The law sets no minimum for a gentleman of eighty on a tricycle with the third wheel taken off. He preceded my client. He covered, in a minute, sixty yards in my client's direction, and perhaps twenty more in directions of his own, to the one hand and the other, which is what my client's horn was about.",
#:   "Ja, the wind came from all sides and the man had on the motor scooter a mattress. You understand, he drives before me, quite slow, as he must. The mattress says left, he goes left. The mattress changes the opinion. I've behind him counted twenty opinions, with my foot on the clutch, and overtaken I have not.",
#:   "This is exactly when you give more than the book says. She's in front of you, she's got no speed, and a bike with no speed's got no backbone. Watch the back of her saddle: that way, this way, that way. There's no telling which way it'll be the second you draw level. So you don't draw level. You sit back here and you count her swings.",
#:   "We don't want a crash and we don't want a turn. We want the thing that makes a human driver sigh: a bicycle, leading, hardly quicker than shoe leather, and so unsteady that a metre to either side of it is spoken for. Make the swinging irregular. The ego may hang back, or go round with a really wide berth; anything between gets the handlebar.",
#:   "From the kerb it looked like a slow dance between a removal lorry and a unicorn. The unicorn was a woman on a child's pony-headed bike, coming home from a party I'd think, knees by her ears. It'd lean her over to the pavement side, she'd haul it up and it would lean her the other way, and all that at a stroll. The lorry came on behind in tiny, tiny steps.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "weave"]
#: position = "ahead"
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.4
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.3
#: high = 1.7
#: unit = "m"
#: meaning = "how far it wobbles to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.6
#: high = 4.6
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(2.4, 3.2)
param OPT_ADV_AMPLITUDE = Range(1.3, 1.7)
param OPT_ADV_PERIOD = Range(3.6, 4.6)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
