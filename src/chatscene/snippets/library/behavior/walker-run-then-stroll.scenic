#: description = "The pedestrian runs out into the road and then slows to a stroll in the ego's lane."
#: rephrasings = [
#:   "She legs it as far as our lane, then dawdles the rest as though the danger were over.",
#:   "The pedestrian ran into the roadway and then slowed to a leisurely walk in the lane of travel.",
#:   "ped runs out, then slow walk in lane",
#:   "The target's speed drops from running to 1 m/s within the VUT's lane.",
#:   "First he runs, then in our lane he goes very slow.",
#:   "A youth sprints off the kerb and swaggers through the lane provocatively.",
#:   "The jogger runs out of puff mid-road and drags himself over.",
#:   "After a brisk start somebody takes it easy exactly in our way.",
#:   "this teenager pelted out into the road and then slowed right down and sauntered over in front of me, cocky so-and-so",
#:   "The pedestrian ran into the street and then reduced his pace to a leisurely walk in V1's lane.",
#:   "Ped dashes out, then dawdles in our lane.",
#:   "The pedestrian target enters at running speed and decreases to slow walking speed within the VUT's lane.",
#:   "The woman runs in the street, but in front of me she walks very relaxed.",
#:   "Crosser with negative speed step: fast entry, then slow amble inside our lane; keeps moving, doesn't halt.",
#:   "He had burst out running, and then, right before them, let himself fall into an idle walk as though in a park.",
#:   "He's bolted out, you'd think he'd keep at it, but no, now he's in your lane he's having a leisurely wander.",
#:   "he sprinted into the road then just started walking all slow in front of us like bruh",
#:   "A youth raced off the pavement and then sauntered through the lane as cars waited",
#:   "You ran into the road, and having got in front of the car you chose to amble?",
#:   "He came running on road and then in front of our car walking like in a park, full hero",
#:   "Bolts out like he's late for a bus, then takes his time in front of me like he's missed it",
#:   "Running road entry of pedestrian with pace collapse to slow walk in lane",
#:   "Guy sprints out then STROLLS in front of my car",
#:   "The lad dashed out and then moseyed through our lane.",
#:   "Sprinted into the road, then ambled past our bumper like royalty.",
#:   "Ped: run to ego lane, drop to slow walk, keep going.",
#:   "In our lane the boy who'd raced out was merely sauntering.",
#:   "Make a jogger charge off the kerb, then dawdle before the AV.",
#:   "Ran into the road, then pure leisure in our lane, cheeky schoolgirl.",
#:   "A bloke in a tracksuit came haring off the pavement, and once he was in front of my car he fell into the laziest of walks without ever standing still.",
#:   "On reaching the VUT's lane, the pedestrian target, which has entered the road at running speed, is slowed to 0.8 m/s and continues its crossing at that value.",
#:   "Policyholder braked for a woman who ran into the carriageway and who, having got into the policyholder's lane, eased down to a stroll and took her time getting out of it.",
#:   "Can you have a teenager run into the street and then, just when he's before our robotaxi, throttle back to a relaxed wander for the rest of the way?",
#:   "Zuerst the man is running in the street like for the Olympia, but before my car he makes it suddenly comfortable and goes slowly as on Sunday.",
#:   "Don't take her sprint for a promise: she flew out, you thought she'd be gone, but now she's in your lane and she's only mooching along.",
#:   "There were three of us in the cab of the tipper and we all expected him to keep running. He had come out of the yard at a real lick. But in our lane he sort of ran down, like a toy, to an idle walk, and wandered the rest with his hands in his pockets.",
#:   "The model had him at 4 m/s and so predicted a free lane in a second and a half. He was at 4 m/s when he entered the road, yes. In the lane itself he came down to a slow walking speed, still upright, still moving, and the prediction was wrong.",
#:   "You know what gets me, on the bike? People who bolt into the road, so you swerve your plan round them bolting, and then halfway, right in your lane, they decide there's no rush after all, and it's slow steps and a look at the phone until they're over.",
#:   "Police are asking for witnesses after a man dashed into Harbour Road on Friday. A driver said he'd come out running at top speed but slackened to an unhurried walk as soon as he was before her car, so that she had to brake to a standstill while he passed.",
#:   "She came out of the hotel at a run, skirts gathered. Then, as she gained the lane in which the car was approaching, she appeared to remember who she was; the run died away, and she proceeded before its headlights at the pace of a lady inspecting her garden.",
#:   "Charges off the kerb, then saunters before us like a duke.",
#:   "Ped: galloping entry, then a lazy amble through our lane.",
#:   "Make the kid race out and, in our lane, turn leisurely.",
#:   "The woman burst out between two parked vans, and as soon as she stood in front of our grille, or rather walked, she had all the time in the world.",
#:   "High entry speed of the pedestrian target is reduced on the VUT's lane to 0.9 m/s, at which it continues without coming to rest.",
#:   "Full speed he has come running into road, and exactly before my bus he became like bridegroom, walking slowly slowly, no tension.",
#:   "As he'd run out so fast, the claimant's driver relied on his being gone, whereas he had dropped to a relaxed walk in the claimant's lane.",
#:   "What's the use of a sprint like that if you're going to spend it on a leisurely promenade right under my windscreen, eh, young man?",
#:   "omg this dude legged it into traffic n then right infront of our car switched to museum speed, never fell never stopped just sloooow",
#:   "It was the trainers I noticed, they were luminous. They came over the kerb in a blur, thrup thrup thrup, and I was already letting my foot back off the brake since they'd soon be out of my way. But in my lane the blur came apart. It was one shoe, then, after a while, the other shoe, then the first one again.",
#:   "Two boys had a bet on, it came out later. One was to run in front of the driverless car and the other was to film. He ran, he got as far as its lane, and there, as agreed, he put on the walk of a man on holiday, and it had to stop and watch him go by.",
#:   "Pedestrian 2 entered the roadway at a run, according to the crossing guard. On gaining the lane of V1 she slackened her pace to \"a slow walk, like window shopping,\" at which she proceeded to the median. She didn't stop, stumble or turn back at any time. V1 was struck in the rear by V3.",
#:   "When you've learnt to drive you'll learn to wait, and this is how. Here he comes, hell for leather off the pavement, and you think well he'll be over in a jiffy. Nope. Now that he's in your lane he's slowing down, he's looking at his nails, he's strolling it. Smile and wait.",
#:   "There's a trap for trackers in this. The filter has settled on a running person, three and a half metres per second, and the ego's lane is forecast to be free again very soon. In the middle of that lane the runner becomes a stroller. He remains in motion, only at a quarter of his pace, and the forecast is wrong by four seconds.",
#:   "He had flown down the steps of the opera, coat-tails out, and into the street without a look. But there in the lane, in the white light of the approaching car, his haste fell from him. He walked, and walked slowly, buttoning his glove as he went, until he'd reached the dark on the other side.",
#:   "My gran can still run when she wants, so she ran, because of the car. Halfway she saw that it had no driver in it at all. So she stopped running and walked, very slowly and with her nose up, past the whole front of it, because she says she doesn't run for a machine.",
#:   "Coaches don't stop on a sixpence, love. You rushed out, I saw that, and I thought good, she's quick on her feet, I'll hardly need to brake. Then you got in front of me and it all went out of you. You were strolling, you were looking at the sky, with fifty-two passengers coming at you.",
#:   "Scenario 31, working title \"the swagger.\" One pedestrian begins at the kerb and enters the road running. His speed drops when he has arrived in the ego's lane, to something like one metre per second, and this is held for the rest of the crossing. There is no halt and no fall, only a change of mood.",
#:   "The gentleman was first in a big hurry, I must say, he came to the street as if the dog is behind him. I made strong braking. When he has seen that I braked he took the tempo out, and he walked along my whole car width like in the garden of his house. He even greeted.",
#:   "Fewer than ten yards, the expert says, lay between bumper and boy. He'd raced into Castle Street, witnesses agree on it. They also agree that in the lane of the oncoming robotaxi the race was over and he was ambling, hands in his hoodie, and that if he'd kept his speed the robotaxi need never have braked.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.2
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it runs at first"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.9
#: high = 1.9
#: unit = "m"
#: meaning = "how far from the ego's line it slows down"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 0.6
#: high = 1.2
#: unit = "m/s"
#: meaning = "how fast it strolls"

param OPT_ADV_SPEED = Range(3.2, 6)
param OPT_ADV_DISTANCE = Range(4, 24)
param OPT_ADV_REACH = Range(0.9, 1.9)
param OPT_SLOW_SPEED = Range(0.6, 1.2)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
