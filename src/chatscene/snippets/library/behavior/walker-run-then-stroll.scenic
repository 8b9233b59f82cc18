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
#:   "He burst out running and turned tourist in our lane.",
#:   "Haste up to our lane, then a promenade through it.",
#:   "Let the girl race in, then mooch past our bumper.",
#:   "All that speed she'd come off the pavement with was gone by the time she was before us, and it was at window-shopping pace that our lane got free.",
#:   "Given how he flew into the road I had half a second to wait, I thought, and it became nine, as in front of me he only ambled.",
#:   "Nobody tripped and nobody stopped, the jogger merely went from a run to a dawdle, and did it exactly where the robotaxi wanted to be.",
#:   "Entry speed of the pedestrian target is 3.5 m/s; on the VUT's lane it falls to 0.8 m/s, which is kept, without rest, to the far edge.",
#:   "You've braked for a sprinter, haven't you, and now he's in your lane he's a flâneur, hands behind his back, so you'll just have to sit there.",
#:   "He is coming like P. T. Usha from the footpath, and in my lane only he becomes like one who has eaten a big lunch.",
#:   "The thing about a running man is that you look at where he'll be. I looked there, at the far kerb, and he wasn't. I looked back along the line, and there he was in the middle of my lane, on his two feet and quite well, putting one before the other as if he'd come to admire my radiator.",
#:   "The scarf was horizontal when he came off the kerb. I noticed because it's silk, and I sell silk. It stood straight out behind him. Then, when he was right in front of the bus, it sank, and hung; yet he hadn't stopped, he was walking with it, ever so gently, as one walks in a gallery, till he was past our off-side lamp.",
#:   "Pedestrian's footfalls were recovered from fresh concrete dust. From the site gate to the edge of V1's lane they are 1.9 metres apart, toes only. Inside V1's lane the distance comes down to half a metre, heel and toe, and stays there as far as the opposite curb. There is no double print, i.e. no stop, and no handprint.",
#:   "I'd be obliged if the tabloids didn't call it a \"dash.\" She dashed to begin with, yes, out from behind the coach. But what made three cars run into one another was what followed, since in the lane of the first, which had counted on the dash, she was having a stroll, lipstick in hand, and strolled on to the end.",
#:   "It's what my lot call the peacock. You're coming down the estate in the wagon, kids on the wall, and one of them's off like a hare, straight out. And just as you have everything on, hissing and rocking, he's in front of you and he isn't a hare any more. He's got all day. He walks it, slow, with his tail up.",
#:   "Requested: one actor, two speeds, no tricks besides. The high one's for the stretch from the kerb to where the ego's lane begins. The low one, a lazy walk, is for the ego's lane and whatever there is behind it. I would ask that he not come to rest anywhere, and not lie down either; we have all that in other cases.",
#:   "It appeared to her that the young man was made of two. The one had sprung from the steps and had crossed the tram rails at a bound, so that she cried to the driver. It was the other who arrived before the carriage. He was looking about him at the chestnut blossom, and did not so much pass as drift, out of their lamps.",
#:   "\"Run!\" I told him. \"There's a car!\" So my brother ran. He ran really well till he was where the car was coming, and then he saw that it was the one with no driver, and he's mad about those. I shouted run again. He did keep on going, but like when we're sent to bed, while he looked in at all its windows.",
#:   "The time-to-clear estimate started at 0.9 s, so that the AV only lifted. The next estimates were 1.4, 2.2, 3.5 and 4.1, the AV going from lift to brake to hard brake. What had occurred is that the pedestrian, who had come into the road at a run, was strolling by the time his feet were in our lane, and he strolled out of it.",
#:   "Cross-examination, continued. And was there anything wrong with your leg? No. You'd seen the car? Sure. You'd been running up to there, like the clappers, as your friend says? Sure. But with the car's lane under your feet you weren't running any longer? I was across by then, more or less. You were two metres in, Mr Hobbs, and taking the air.",
#:   "Primero corre, corre, as if the police is behind, he came so out of the bar to the street. I hang myself on the brake. And when I have all the bar tables looking at me, what does he make? He goes slow, slow, in my lane, lighting a cigarette, he never stays still, but I tell you a procession is quicker.",
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
