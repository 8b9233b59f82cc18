#: description = "The car overtakes the ego at high speed and keeps going in its lane."
#: rephrasings = [
#:   "Something screams past us in the next lane and is gone.",
#:   "Vehicle 2 passed vehicle 1 at a speed far above that of traffic and continued.",
#:   "Fast pass, no lane change.",
#:   "The target overtakes the VUT with high relative velocity in the adjacent lane.",
#:   "He passes near us as a rocket and doesn't care.",
#:   "A lorry thunders by in the other lane, way over the limit.",
#:   "The sports bike streaks past our mirror.",
#:   "A speeder shoots up from the rear, draws level and vanishes up the road.",
#:   "A hot hatch tore past me in the next lane like I was parked and that was the last I saw of it.",
#:   "Unit 2 passed Unit 1 at a high rate of speed and continued straight ahead in its own lane.",
#:   "Moto blasts by in adj lane, stays in it, gone.",
#:   "The target passes the VUT at high relative velocity, with no lane change before or after the pass.",
#:   "The car goes by me very fast in the next lane and just goes on.",
#:   "Fast pass only, no cut-in: actor blows by one lane over and disappears ahead.",
#:   "There was a howl at her window and he was by, dwindling up the road in the same lane he'd come in.",
#:   "He's just flying by on the outside, he isn't coming in on you, let him go.",
#:   "some dude flew past in the next lane and just kept going, never seen him again",
#:   "A motorcycle streaked by the column of cars and was out of sight within moments.",
#:   "It went by my client in its own lane at great speed and simply continued; it never came before her?",
#:   "One bike went past me like jet, straight in his lane, gone already.",
#:   "Whoosh, past my window, in his own lane to be fair, and over the hill before I'd blinked.",
#:   "High-speed passing in adjacent lane without lane change.",
#:   "CAR PASSES ME AT WARP SPEED",
#:   "A sports car vapourised past in its own lane.",
#:   "Vroom, past our window, and already just a dot up the road",
#:   "Superbike blasts by on the outside, holds its lane, vanishes.",
#:   "Put a speeding saloon past the ego, staying in its lane throughout.",
#:   "Something low and yellow whistled past, its own lane, and never lifted.",
#:   "Unit passed by sports car, excessive speed, continued on in lane two.",
#:   "motorbike came from behind like an arrow, level with me for a blink, then only its tail light getting tiny in the other lane lol",
#:   "The faster target moves by the VUT in the adjoining lane with a large speed surplus and carries straight on without changing lanes.",
#:   "He must have been doing double my speed when he went by on my flank, and he kept that up in the same lane until the bend swallowed him.",
#:   "V2 overtook V1 in the adjacent lane at high velocity, made no movement toward V1's lane either during or after the pass, and left the area.",
#:   "That one belongs to the let-him-go category: he's rocketing past you in the other lane, he's not interested in your bit of road, wave him goodbye.",
#:   "Yesterday one car has overtaken me like a bullet in the side lane and he just went straight, straight, straight till I could not see him.",
#:   "We felt it before we saw it, a thump of air against the doors. Then a grey coupé was beside the robotaxi, then it was in front but still one lane over, and then it wasn't anywhere at all, it had simply outrun the camera.",
#:   "I would like to see whether our planner stays calm. From the rear, in the neighbouring lane, a motorbike approaches with a huge surplus of speed, sweeps past the AV and carries straight on in that lane, with no cut-in and no braking.",
#:   "Nothing actually happened, as I explained to the nice young policeman. I was pootling along when a car tore by me at some ungodly speed in the lane next to mine, and it kept to that lane and kept up that speed until it was over the brow.",
#:   "From up in the lorry you get a good view of lunacy. The hot hatch came howling up from behind, went by the little blue car as if that was nailed to the ground, and stayed flat out in its own lane all the way to the horizon.",
#:   "The engine note rose, hung for an instant beside her ear and fell away. By the time she had turned her head the rider had passed, bent low over the tank, dead straight down his lane, growing small with absurd rapidity.",
#:   "Sports bike rips past on the outside lane, dwindles, disappears.",
#:   "Gone by at silly speed; never crossed into our lane, never slowed.",
#:   "whoever was late in that Golf, you FLEW past, stayed in lane tho",
#:   "The hatchback went by on my right as though fired from a gun and held its own lane as far as I could follow it.",
#:   "The target, arriving from the rear in the neighbouring lane, passes the VUT with a speed differential of 60 km/h and continues in that lane undiminished.",
#:   "I looked to the left because of the noise, and he was there; I looked to the front and he was already small, always on his own strip.",
#:   "Let a motorbike swoop by the AV in the next lane at twice its speed and carry on into the distance without ever coming over.",
#:   "Be advised, silver coupe has just passed unit 9 as if it were parked, remains in the outside lane and is still going away.",
#:   "V2 was observed to pass V1 in the adjacent lane at an excessive velocity and to proceed ahead in the same lane until it was out of view.",
#:   "First the mirror was empty, then it had a dot, then the dot was a car and the car was at my elbow. I'd barely turned my head when it was a dot again, out in front this time; and it had stuck to the lane beside mine from start to finish.",
#:   "We'd set the cruise at sixty and were listening to the cricket. Something went by one lane over with a noise like tearing cloth, the little car shook on its springs, and when I looked up the road there was a red speck in that same lane, still pulling away.",
#:   "The officer wanted to know whether it had interfered with me. I said no, it hadn't had time. It was in the lane next to mine, it left me standing, it was over the hill at the same mad rate, and my side of the line it never touched.",
#:   "Keep doing exactly what you're doing. The roar you can hear is that motorbike, and in a second he'll be beside us, there, and in another he'll be a long way in front in his own lane, and we shan't have had to do one thing about it.",
#:   "Relative speed at the moment the bumpers were level was 23 m/s. The overtaking saloon didn't alter its lane before, during or after, nor did it lift; the radar in front picked it up at five metres and lost it at a hundred and eighty.",
#:   "Whoosh, said my brother, and that was it. We were at the window of the robotaxi playing the number plate game, but nobody got that plate, since the yellow car was behind us, next to us and far in front of us in the one whoosh, one lane over.",
#:   "A lorry's mirrors are big, and still I nearly missed him. The lad on the superbike passed the car ahead of me as though it were a milestone. He never so much as leaned towards it; he stayed in lane three, chin on the tank, and shrank to nothing.",
#:   "The wash of air was what woke her, and the sound that it dragged behind it. By then the long black car had already left theirs far to the rear. It was speeding down the other lane with its lamps drawn out to a thread, and it did not falter.",
#:   "I'd rather they did that than what some do. He used the lane that's there for it, he went through at heaven knows what, a hundred and thirty perhaps, and instead of nipping in before me he kept to that lane and that speed till I couldn't see him.",
#:   "Yaar, my vehicle is not slow, I was at eighty. But this one Audi in next lane came from back and passed me as if I am doing parking, and straight only he went, same lane, same speed, one minute after he must be in Lonavla.",
#:   "Podcast, minute thirty. So there's this concept of a harmless nuisance, right, and our example is a car that comes up on the robotaxi's flank way over the limit, overhauls it, and stays put in its lane all the way to the vanishing point. Nothing to avoid, but planners twitch.",
#:   "A roar at the elbow, then a speck, lane two throughout.",
#:   "Door mirror, door, horizon: the yellow one took three blinks for that.",
#:   "Never came near us, that biker; came past us, though, like a jet.",
#:   "I'd call it a gust with a number plate, except I didn't get the number; it stayed on its own side of the dashes and was gone.",
#:   "The needle said seventy, and I seemed to be standing still beside whatever it was that ripped up the outside lane and on out of sight.",
#:   "Have a motorbike with far more speed than ours emerge from behind in the lane beside us, leave us standing, and go on exactly so in that lane.",
#:   "You flinched because of the noise, but he'd no designs on your lane; look, he's already a toy car, and he's still in the one he came in.",
#:   "V2 had drawn clear of V1 within one second and, without lateral deviation or reduction in velocity, continued up the adjacent lane beyond the range of the sensors.",
#:   "Like the ICE through a little station he went next to me through, and always on his own rail, till I saw only a point.",
#:   "The first thing was that the baby stopped crying. It had heard it before us, a whine from the rear, and by the time that I'd heard it too there was a low black shape next door; and then nothing next door, and a low black shape, the size of a beetle, in the same lane at the top of the rise.",
#:   "It left us with our doors humming. You want to know what he did wrong? He had no more to do with us than a plane has. The lane was his, he stuck to the lane, before us and beside us and after us. But there can't have been less than fifty between his speed and ours.",
#:   "We've a box for what a passing vehicle does afterwards: returns to lane, slows, stays alongside, other. For this one I ticked other and wrote \"leaves\". It had emerged from the rear in the neighbouring lane at some 45 m/s, and it kept to that lane and that figure for as long as we had it on the radar.",
#:   "The dust cart's crew wave at everybody, and they'd their arms up for the coupé that was coming behind us. They were still lifting them when it had been by us, and by them, out there in its own lane. I saw three orange men with their arms up, looking the wrong way, up the road.",
#:   "It's not my place to hold his speed against him, for I was a lad myself. I was doing the limit in my lane with the wireless on. There was a bellow and a shiver in the steering, my cap peak blew up, and a red motorcycle was laid out along the next lane in front of me as if drawn with a ruler, and then rubbed out.",
#:   "A planner that's afraid of this one is afraid of the wind. All that ever happens is that an object in the left-hand lane gets nearer from behind at forty metres a second, isn't behind any longer, and gets farther away in front at the same forty. It crosses no line. It doesn't lift. The ego need do nothing.",
#:   "How fast? Let me put it like this, officer. I looked in my mirror and the outside lane was empty. I looked at my speedometer, which takes no time at all. I looked up, and in the outside lane there was the arse end of an Audi, already going over the hill. It hadn't bothered me; it hadn't had the leisure.",
#:   "Lorries don't get passed, they get left. This kid left me and the grey saloon in front of me both at once. One long rip of sound down the next lane, no dab at the brakes, no dodging in to make his exit. I like them to know which lane they live in. I just hoped he'd live.",
#:   "Somebody had torn the evening from end to end, so it seemed to her. The tear began far at the back of them, ran along beyond her window, level, straight, never wandering out of its own half of the highway, and went on ahead towards the hills; and long after she'd lost the little red light she could hear it being torn.",
#:   "Comment by user: at 1:12 you can see the cone on the left shoulder spin. That's from the air. The thing itself is in frames 1:12 to 1:14, coming up behind, and then from the mirror into the windscreen one lane over, and then it's pixels. No cut-in, no brake. He'd do that to a cone every mile.",
#:   "On expressway my speedo was showing hundred, I was feeling like king. Then in side lane a sound came, like cloth is cut in shop, and one yellow car from behind became one yellow car in front became one yellow mosquito. Same lane, same speed. My son asked, Papa, why did we stop?",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "fast"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 20.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 13.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"

param OPT_ADV_DISTANCE = Range(20, 42)
param OPT_ADV_SPEED = Range(13, 17)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, 1, 0, globalParameters.OPT_ADV_SPEED)
