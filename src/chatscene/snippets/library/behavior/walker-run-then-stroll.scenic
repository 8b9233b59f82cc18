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
