#: description = "The pedestrian stands in the lane until the ego is close, then runs back to the side it came from."
#: rephrasings = [
#:   "She freezes in front of us and at the last moment flees back to where she started.",
#:   "The pedestrian stopped in the lane of travel and then ran back toward the curb it had left.",
#:   "ped stops in lane, panics, runs back to own side",
#:   "The target stays stationary on the path of the VUT, then returns to its starting side at running speed.",
#:   "The old man stays in the lane, he is afraid and is running back when we come near.",
#:   "A teenager plays chicken with us in the road before scampering back to the pavement.",
#:   "Having stood there like a deer, the walker loses their nerve and bolts homeward.",
#:   "Someone loiters in our path, gets scared as we draw near, and hares back the way they came.",
#:   "some joker stood his ground in my lane till I was nearly on him and then legged it back where he came from",
#:   "The pedestrian remained standing in the lane until V1 was close, and then ran back to the side from which he had entered.",
#:   "Ped blocks lane; we near -> runs back same side.",
#:   "The pedestrian target is stationary in the lane; at low TTC it returns at running speed to its side of origin.",
#:   "The boy stands in my lane, and when I am near he runs back to his side.",
#:   "Chicken game: walker holds in the lane, distance trigger, then retreats at a run to the starting kerb, not over to the far one.",
#:   "She had stood there facing them down; only when they were all but upon her did she turn and flee to the pavement she had left.",
#:   "He's stood there playing chicken with you... and he's bottled it, back to where he started, sharpish.",
#:   "guy just stood in the road till we were super close then legged it back where he came from",
#:   "A man who had halted in the road scurried back to his own pavement when a car was almost upon him",
#:   "You remained in the lane until the car was nearly on you, and then fled to the side from which you had set out?",
#:   "He standing in the road never move, we come near then he run back same side",
#:   "Stands there like a bollard till I'm on top of him, then scuttles back the way he came",
#:   "Pedestrian standing in lane with late running withdrawal to the side of origin",
#:   "Man stands in the road, then RUNS BACK at the last second",
#:   "The walker loitered in our lane, then skedaddled homeward.",
#:   "Stands daring us, waits, then sprints home to his kerb.",
#:   "Walker blocks lane; proximity trigger; runs off to entry side.",
#:   "Boy in the road, doesn't budge, then zooms back where he was.",
#:   "Stood in my lane till spitting distance, then tore back to her side.",
#:   "Would you stand there until it's nearly on you, then run back?",
#:   "Let a woman step into the ego's lane and wait there motionless, and when the ego has come near, flee at speed to the side she came from.",
#:   "He'd been rooted in our lane all the while we approached, and it was only with us upon him that he raced for his pavement.",
#:   "The pedestrian, having entered V1's lane, remained there immobile; when V1 was a short distance away, she ran in the direction of the curb she had left.",
#:   "The girl has gone into my lane and stays, stays, stays, and when I am almost there she runs there where she has come from.",
#:   "They do this for a dare on our estate, pupil mine: in he walks, he stands and waits for you, and now he's haring back again.",
#:   "It ended with him scampering to his own side of the road, but until I was a car's length off he'd been holding his ground.",
#:   "Like a heron in a stream he stood there, one hand on his hat, and I kept thinking he will surely move. Closer I came and closer. All at once the heron took wing; he fled, not forward to the baker's, but back to the churchyard gate he had come through.",
#:   "The pedestrian target walks from the nearside into the lane and comes to rest. It holds that position until the vehicle under test is within the reaction distance, whereupon it turns about and leaves at running speed by the nearside, never touching the offside.",
#:   "Bloody kids. One of 'em walks out in front of my wagon and just stands there, arms wide, his mates filming from the verge. I'm on the brakes, I'm on the horn, and at the last possible moment he scarpers, back to his mates, killing himself laughing.",
#:   "Log review: VRU comes from the right and stops in our lane. AV decelerates, VRU doesn't react. With the distance down to about eight metres it breaks into a run, and the run goes to the right, i.e. back, while we'd already started nudging right to go behind him.",
#:   "She must have frozen. There was I, coming along Harbour Street, and there was this lady with her terrier, stock-still in my way for ages. Only when she could practicaly feel the heat of the radiator did she wake up, and she flew back to the bus shelter she'd left.",
#:   "Motionless in our lane till we're close, then off home, running.",
#:   "Lad holds our lane, loses his nerve late, dashes back.",
#:   "Pedestrian blocks, waits until near, flees to side of entry.",
#:   "She'd stepped in from the bus stop and stood there like marble, and only when I was almost touching her did she run back to the bus stop.",
#:   "Place a man in the ego's lane, have him stay put until it is very near, and then let him race to the pavement he left.",
#:   "From the left she came in, in the middle she waited for me like for a bus, and to the left she has fled when I was there.",
#:   "Pedestrian in lane two not moving, not moving, we're right on him, there he goes, he's run back to the nearside where he came from.",
#:   "Old Tom will wander out in front and stand and stare, but once you're right up close he takes fright and scampers back to his gate.",
#:   "Dashcam: woman freezes in the lane for ages, then legs it at the last second, and NOT to the side you would bet on",
#:   "We have a game of that kind at the level crossing, the stationmaster explained. A youngster goes to the middle of the motorists' lane and stays there. He's not to stir until he can see the driver's eyes; he's then to run, and if he runs over to the far side he has lost. This one won. You could see my eyes all right.",
#:   "The interval during which the pedestrian was stationary was measured from the film at six seconds, and V1's distance at the end of it at nine meters. In the second following, she covered four meters, at a run, and this took her to the north curb. It was from the north curb that she'd walked in to begin with.",
#:   "There's a moment on a bike when you think, he's seen me, he'll go. He was in my lane, a fisherman with a bucket, he'd come up from the canal and just stuck there. I was in the van that day, not on the bike, but I thought it again. He did go, when I could've leaned out and tapped him, and he went helter-skelter for the canal.",
#:   "Note for anyone who tunes the yielding behaviour. This walker enters, stops, and lets you come. As long as you're far off nothing you do will have any effect. At the reaction distance she leaves in a hurry, and where she goes to is where she came from, so creeping past on that side, as our car did, is the worst of all choices.",
#:   "He was the last of the boys. The others had scattered when they saw the lorry turn in by the church; he alone remained in the road, his fists at his sides, looking at it, while it grew and grew. At the very last he broke. He did not cross. He ran back, sobbing, to the wall they'd all been sitting on.",
#:   "\"Stay in the road till I say so,\" her brother had told her, and so she stayed, six years old, in a tutu, before an approaching coach. The coach driver stood on his brakes. With not a great deal of road left between them her brother said so, and the tutu flew, not forward, but back to the hedge she'd come through.",
#:   "The Ego saw a static obstacle in its lane, on two legs, and began to slow. Static it remained for quite a time. I'm the safety driver and I was on the point of taking over, the gap being what it was, as the obstacle came to life, about-faced and sprinted to the pavement which it'd quitted ten seconds before.",
#:   "Pigeons do it and so do people. You drive up, they sit there. You drive closer, still they sit. Your bumper's over them, and whoosh. My pigeon today wore a mackintosh. He'd come out from the right-hand side with a newspaper and settled in my lane to finish a paragraph, and when it was nearly too late he took wing, for the right-hand side.",
#:   "Claim description: I was driving with moderate speed. One boy went from the shop side to my lane and was standing there, looking in my face. I expected he will move; he didn't move. When the distance was left very less, then he ran with full force back to the shop side, and the car behind struck mine because I had braked.",
#:   "They'll tell you he crossed, those who only heard the tyres. I was on the balcony, and he didn't cross. He'd come off our pavement to bait the blue car and there he was in its lane, hands on hips, as it got nearer and nearer. When it was almost on his toes he sprinted back under my balcony.",
#:   "lol my uncle vs the robotaxi. he walks out in front of it from the bbq, plants himself, beer in hand, \"watch this, it'll stop\". we watch. it's braking but it's not stopping stopping. he holds, he holds, its like two metres away, and my man absolutely BOLTS back to the bbq. beer everywhere. legend",
#:   "In our lane like a bollard; then, bumper-close, gone whence he came.",
#:   "Held her ground, held it, cracked, fled to her own kerb.",
#:   "stood there in our lane till he could feel the radiator then ran home",
#:   "Only when our bumper was a yard away did the statue in our lane come to life, and it tore off to the kerb it'd stepped from.",
#:   "A man should be stationary in the lane, ignoring the ego until they almost touch, and next thing be racing off to his own side.",
#:   "We'd all but stopped before the lady in the road gave up waiting, whirled round and pelted for the gate she had come by.",
#:   "V1 had closed to within five metres of the motionless pedestrian when the pedestrian fled, not onward but towards the side of his first appearance.",
#:   "Was he testing you, standing there in your lane until you could count his buttons, and then haring off where he'd started from?",
#:   "He has come from the left, he stands, I come, he stands, I'm there, and now at last he runs, and he runs to the left.",
#:   "There's a rope swing over the river there, on the right, and the kids dare one another. One walks up into the lane and stands. You come along in the coach. He stands. You blow, you brake, you're a pole's length from him and he stands; then his nerve goes, pop, and he's through the nettles and back at the rope.",
#:   "We don't show the manual driver what'll happen, so it's interesting to see when they brake. The figure came on from the left, it's stationary in the lane, everybody sees it at a hundred metres. They ease off: it'll move. It doesn't. At twelve metres they stamp, and at eight, too late to be a help, it wheels and sprints off left.",
#:   "I can do you his expression. Bored, at sixty yards. Bored at thirty. He'd wandered up onto the road from the allotments, he was in no hurry for a Transit. At ten yards he had seen that the Transit was in a hurry for him, his mouth went like that, and it was the back of his head legging it to the allotments.",
#:   "Why, if he'd wanted to be safe, counsel enquired, hadn't the deceased's friend got out of the lane earlier? The lane had been his for a full nine seconds. He'd spent them upright, immobile, and looking at the approaching car. What he did in the tenth, when it was all but touching him, was to rush to the pavement that he'd come off.",
#:   "Mothers have a special way of doing it. She'd come two steps into my lane to look down the road for the school bus, so there she was, rooted, shading her eyes. I'm the school bus. The nearer I got the less she moved. And then, with the wiper practically on her nose, one shriek, and a flying leap back to the kids.",
#:   "The brake squealed, and that's what did it. Till that squeal the gap had been melting away with nothing changing at the other end: a cap, a coat, two wellingtons, planted. On the squeal, by when he was as good as on my bonnet, the wellingtons faced about and went like pistons, up the bank he'd earlier come down.",
#:   "Oh we used to do that with trams, dear. You went out from your own side and stood in front. You let it come. The one who ran last had won, and you had to run to where you'd come from, not over, else it didn't count. I saw a lad do it yesterday with one of those cars without a driver. He won.",
#:   "Radio, it's all right, he's off. He was just stood in lane one with me bearing down on him, wouldn't look, wouldn't shift, blues on and all. I was down to a walk with my bull bar at his belt before he woke up, and then he was off like a greyhound, same nearside hedge that he stepped out of.",
#:   "Behaviour tree: enter, walk as far as the lane, idle. Idle has one exit condition, range to ego below the reaction distance, which you should set small. The exit leads to \"retreat\": turn by 180°, sprint, until the point of entry has been regained. People have asked for an exit to the other side; that is another tree.",
#:   "In our street one buffalo-man, the milk seller, has an argument with motorcars. He comes to the middle from his shop, he stands in your lane, you come near, he's standing, you come near-near, he's standing like a king. When you are touching his dhoti, then the king picks it up and is running to his shop with white legs.",
#:   "She'd have wagered on him crossing. People who stand in one's lane have, after all, somewhere to get to. So when she was upon him, so near that she could read the crest on his blazer, and he, after all that standing, exploded into motion, it was the other pavement that she looked to; and it was on the one behind him that he arrived.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "block", "turn-back", "accelerate"]
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
#: low = 0.0
#: high = 1.2
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"
#: [[parameters]]
#: name = "OPT_REACT_DISTANCE"
#: low = 2.5
#: high = 7.0
#: unit = "m"
#: meaning = "how near the ego is when it flees"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 3.5
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it runs back"

param OPT_ADV_SPEED = Range(2.6, 4)
param OPT_ADV_DISTANCE = Range(28, 44)
param OPT_STOP_DISTANCE = Range(0, 1.2)
param OPT_REACT_DISTANCE = Range(2.5, 7)
param OPT_ADV_SPRINT = Range(3.5, 6.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(6) until abs(offsetFrom(egoRoute, self)) < 3.8
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_REACT_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159) until abs(offsetFrom(egoRoute, self)) > 5
    do Halt()
