#: description = "The pedestrian stands in the middle of the lane and bolts only when the ego is close."
#: rephrasings = [
#:   "He stops halfway across, stares at us, then legs it at the very last second.",
#:   "Pedestrian 1 stood in the roadway until Vehicle 1 was near, then ran toward the far curb.",
#:   "ped halts mid-lane, bolts late",
#:   "The target rests on the VUT's trajectory and accelerates to running speed shortly before contact.",
#:   "The child remains standing on the road and runs away first when the car is there.",
#:   "A jogger pauses right in our lane and then sprints off once we are nearly upon her.",
#:   "Frozen with fright at first, the walker comes to life late and races out of the way.",
#:   "Someone waits on the carriageway as if daring us and takes flight in the nick of time.",
#:   "He stood there bang in the middle like a lemon until I was nearly on top of him, then legged it.",
#:   "Pedestrian was standing in the travel lane and ran clear only as Unit 1 was about to strike him.",
#:   "Ped stands mid-lane, no move, runs off last sec.",
#:   "The pedestrian target is stationary at lane centre and leaves it at a run when the time-to-collision falls below a threshold.",
#:   "A man stands in my lane and only when I am very near he runs away.",
#:   "Static walker in ego lane, sprint out triggered at short distance.",
#:   "She stood rooted like a rabbit in the headlights, and only when they could see her eyes did she spring away.",
#:   "There's someone just standing in the road, he's not shifting, not shifting, and now he's scarpered.",
#:   "dude just stood in my lane staring and only ran when i was basically on him",
#:   "A man who had been standing in the roadway took flight only as the car was almost upon him.",
#:   "He remained where he stood until my client was within feet of him, and then he fled.",
#:   "He is standing in centre of road like pillar, when I came very near then only he ran.",
#:   "Stands there like he's waiting for a bus, and shifts only when he can read my licence plate.",
#:   "Stationary pedestrian in own lane with escape at critically small distance",
#:   "WAITS TILL THE LAST METRE THEN RUNS",
#:   "The man in the lane stands fast and scrams when we are near.",
#:   "Bloke's planted in our lane; only at the last gasp does he dash on over.",
#:   "Ped motionless on the lane, flees onward just before the ego arrives.",
#:   "Put a walker mid-lane who breaks into a sprint once we're close.",
#:   "A boy made a statue in the road and zoomed to the other side very late.",
#:   "She stands, stands, stands, and when the car is there she runs.",
#:   "Someone was standing stock-still in our lane, and not before we were a few metres away did he tear off towards the far pavement.",
#:   "The pedestrian target halts at lane centre, remains stationary and, at a small remaining distance of the VUT, completes the crossing at running speed.",
#:   "hooted from miles off, man in the lane didnt stir, then once my bumper was basically at his knees he shot away over the road",
#:   "The pedestrian remained standing in the path of V1 as it approached and took off running at the last instant, narrowly clearing the front end.",
#:   "He is standing in the middle of lane like traffic police, and when the bumper is at two metres he becomes a hundred-metre runner.",
#:   "Is this a dare among the kids now, to wait in the lane until the car's nearly there and then fly across out of its way?",
#:   "We came round the church and there was a figure in the lane with its arms hanging down. We slowed and it stayed; we crept nearer and it stayed; and when we could make out its face it was off across the road at a gallop.",
#:   "Never count on them going, and never count on them staying. That lady has been stuck in your lane all the time you were coming, hasn't twitched a muscle, and just now, with hardly a car's length left, she has bolted for the other pavement.",
#:   "For the prediction team: the agent enters the lane and then shows zero velocity long enough to be filed as a static obstacle. When we're practically upon it, it accelerates hard and clears the lane at sprinting speed in the direction in which it was going.",
#:   "My client did what any prudent driver would. He saw a man standing in the lane, he reduced his speed, he prepared to stop, and the man, who'd had all the time in the world, chose the very last moment to take to his heels.",
#:   "Deer do that, I told my husband, not people. It stood there in the lane gazing into our lamps, a great tall fellow in a parka, and nothing moved but his breath until we were nearly touching him, and then he leapt away.",
#:   "Stood like a post in our lane, hurtled onward just in time.",
#:   "Static ped, lane centre; at three metres shoots off to far side.",
#:   "bro waited in the lane till my headlights were ON him then sprinted across",
#:   "A girl had come as far as the middle of our lane and was stood there, quite calm; with the bonnet almost at her hip she flew across.",
#:   "The pedestrian target enters the lane, remains stationary at its centre, and resumes the crossing at sprint speed once the VUT's distance falls below 6 m.",
#:   "He is waiting in my lane as for the tram, I come, I come, I'm there; and like a hare he jumps off to the opposite pavement.",
#:   "Simulate a boy who parks himself on the ego's line and hangs on until the car is practically upon him before he scoots over to the other kerb.",
#:   "P1 occupied the center of V1's lane without moving and, with V1 only feet away, ran the rest of the way across the roadway.",
#:   "Motionless figure in your lane; caller says he leaves it very late and then pelts across, so take it gently.",
#:   "I had the window down and I was talking to him, though he couldn't hear: come on, son, shift yourself. He'd come out to the middle of my lane and turned into a lamp post. It was when I could see the whites of his eyes that he shifted, and my word, he fairly flew to the far kerb.",
#:   "We have a word for it at the depot, matador. The matador walks out into your lane, stands there with his chin up and lets you come; and it isn't before you're leaning on the brake with your whole weight, a coach length off, that he whisks himself away across to the other side.",
#:   "What I remember is the shoe. It was lying in the lane, in just the place where the woman had stood the whole time we were slowing down for her, and its owner was by then on the opposite pavement, for in the last few yards she'd taken off like a sprinter.",
#:   "The AV did as it should and planned to stop short of a stationary pedestrian. Then the pedestrian wasn't stationary. With four metres of gap remaining he accelerated from nothing to a dead run, continuing to the far side, so the AV's stop was no longer needed.",
#:   "You mustn't bully them with the horn. That old boy's in the middle of your lane and he's frozen; the nearer you get, the more frozen he'll be. And then, as you see, right under our number plate, he thaws all at once and gallops over to the other pavement.",
#:   "At first he took it for a scarecrow that somebody had put in the road for a joke. It stood in the lane through the whole length of the avenue, getting taller; and at the very moment when he was sure of the straw, it picked up its coat and raced for the far hedge.",
#:   "My friend Lily dared me. You walk into the lane where a car's coming, you stand still in the middle and count, and you're not allowed to run to the other side until you can feel the engine. I got to nine. The lady in the car cried, and I'm sorry.",
#:   "The braking marks stop two metres from a chalked cross. The cross is where the man was standing, and had been standing, in the lane; he was not there any more when the taxi reached it, since he'd waited for the squeal of its tyres to go tearing off over the road.",
#:   "I was cycling on the other side, which is where she ended up, nearly in my lap. She had been in the opposite lane, stock-still, a van bearing down on her; I yelled, and nothing; and only with the van's bumper a stride away did she explode out of there and across.",
#:   "Could it have known? For five seconds there was an adult in its lane who didn't move a toe, and the robotaxi came down to a crawl for him. He let it come within touching distance. Then he was off at full tilt for the side that he had originally been making for.",
#:   "In bus-stand this is normal game. One man came in middle of my lane and there he became statue of Gandhi-ji, I am blowing horn, he is not hearing. When my bumper was near his lungi, then he caught it up in his hand and ran like Usain Bolt to opposite side.",
#:   "Lamp post in our lane; grew legs at three metres and sprinted over.",
#:   "Motionless till he felt our breath, then away to the far kerb.",
#:   "She waits, waits, waits in the lane, then hares on across.",
#:   "We'd have bet that it was a bollard, up to the moment when, with our bumper at its knees, it tore off towards the opposite pavement.",
#:   "The whole avenue long he'd stood on our line; for the last stride of it he chose to be somewhere else, namely the other side, at a gallop.",
#:   "Create a walker who comes out to our line, rests there as though asleep, and is only startled into a sprint for the far side by our being nearly on top of him.",
#:   "The later they leave it the faster they go, and that girl in your lane has left it very late; there, she's streaked off to the bakery side.",
#:   "P1's speed was zero until V1 was within 5 meters, whereupon it rose to 4.8 m/s, taking P1 to the curb opposite that from which P1 had come.",
#:   "He is staying in my lane like a saint on his column, and when I'm before his feet he flies like a devil to the other trottoir.",
#:   "I'd written him off as one we'd have to stop for. You do, don't you, when a man has come to the middle of your lane and stands there with his hands in his pockets while you lose all your speed. With the speed nearly gone and the man nearly under the bumper, he went off like a cork to the other side.",
#:   "There's a draught where somebody's been, I felt it on my hand, which was out of the window. A moment earlier there was the somebody. She was in our lane, she'd been in it since I first saw the lane, and she'd grown from a match to a woman without moving a hair. Then the draught, and feet, and the hedge on the far side shaking.",
#:   "My stopping distance was right, let me say that, and it would have been about a yard in hand. It was never put to the test. That yard from my bumper the youth whom I had been watching for a hundred, planted there, not a twitch, discovered his legs and pelted away over the remaining half of the road.",
#:   "The trick in the data set is the label. Up to frame 340 the annotators have \"static obstacle, human shape\"; quite a few believed it to be a mannequin. At 341, with the ego four metres off, it's at a sprint, in continuation of the way it had come into the lane. At 365 it's on the other sidewalk.",
#:   "Grandpa used to hunt and he says that a hare does this. It sits in your furrow and thinks you can't see it. We came closer and closer in the car and the big boy sat, I mean he stood, right in our lane. When we were so near that Grandpa said now, he shot off the far way.",
#:   "What's the good of hooting? I hooted at the pond, I hooted at the school. The figure in my lane might have been cast in iron. I'd got down to second, my lorry was hissing like a snake, and it took the hiss to do it: with the grille at arm's length the iron melted and ran, over to the other kerb.",
#:   "The witness, a jogger, admits it was a wager. He'd gone out to the centre of the eastbound lane and was to remain there until he could make out the driver's eyebrows. They were, he says, bushy. From a standing start he then covered the rest of the road in a time that he's rather proud of.",
#:   "She thought of a sleepwalker, and so she let the car roll up to him as softly as she could. He never stirred. The lamps climbed up his trousers, his belt, his clasped hands. And when they touched his face he woke, if that's what it was, and fled before them, over the road, into the dark of the park on its farther side.",
#:   "I was riding the other way and saw him head on, face like a card player. The van closed on him: nothing. It braked: nothing. The nose of it dipped so near that his coat moved. And that was his cue, out of the van's lane and through mine to my pavement, head down, at a rate of knots.",
#:   "Dashcam title idea: \"STATUE DEVELOPS SENSE OF URGENCY\". Because for twelve seconds the bloke is literally street furniture, centre of our lane, and the robotaxi's slowing for street furniture. Then there's a car length between us and him, less, and it's like somebody fired a gun. Bang, far kerb. Bye.",
#:   "Behind the mill there's a peacock and there's a watchman, both same nature. In my lane they'll stand. You'll come near, standing. You will press horn, standing. Last week was the watchman's turn; when my number plate was reading his buttons, he lifted the dhoti and flew, same way he was coming, till the tea shop on the other side.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "block", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.6
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it walks out"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 28.0
#: high = 44.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.25
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"
#: [[parameters]]
#: name = "OPT_REACT_DISTANCE"
#: low = 2.5
#: high = 7.0
#: unit = "m"
#: meaning = "how near the ego is when it bolts"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 3.5
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it runs"

param OPT_ADV_SPEED = Range(2.6, 4)
param OPT_ADV_DISTANCE = Range(28, 44)
param OPT_STOP_DISTANCE = Range(0.2, 1.25)
param OPT_REACT_DISTANCE = Range(2.5, 7)
param OPT_ADV_SPRINT = Range(3.5, 6.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(6) until abs(offsetFrom(egoRoute, self)) < 3.8
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
