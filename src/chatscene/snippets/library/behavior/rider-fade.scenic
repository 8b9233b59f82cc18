#: description = "The cyclist ahead sprints off, tires and slows to a crawl."
#: rephrasings = [
#:   "The bike in front stands on the pedals, runs out of puff and crawls.",
#:   "The bicyclist accelerated and subsequently slowed to a very low speed ahead of Vehicle 1.",
#:   "cyclist ahead sprints, then fades to crawl",
#:   "The bicyclist target accelerates and then drops to low speed ahead of the VUT.",
#:   "The cyclist before us goes first fast and then has no power any more.",
#:   "A schoolboy pedals like mad until his legs give out.",
#:   "The weekend racer we follow blows up and dawdles.",
#:   "Her chain slips after a spurt and the bike ahead barely moves.",
#:   "the cyclist in front went off like Bradley Wiggins and then ran out of puff and was barely turning the pedals",
#:   "The bicyclist ahead of V1 sprinted, became fatigued, and slowed to a very low speed.",
#:   "Cyclist ahead: sprint, out of breath, then snail's pace.",
#:   "The bicyclist ahead of the VUT accelerates strongly and then falls progressively to minimum speed.",
#:   "The cycle man in front goes very fast, then he has no more power and goes very slow.",
#:   "Bike lead with exhaustion profile: peak speed first, gradual decay down to just-upright pace, never zero.",
#:   "He had stood on the pedals and flown ahead of them, but his legs gave out and soon he was barely turning them.",
#:   "He's giving it some welly on that bike... and he's blown up, legs have gone, he's just about staying upright ahead of you.",
#:   "cyclist in front went turbo mode then ran out of battery lol now its so slow",
#:   "A pensioner on a bicycle put on a burst before flagging to little more than walking pace",
#:   "You set off vigorously, then tired, so that those behind you were barely moving?",
#:   "Front cyclist first go so fast like race, after that no stamina, slow until like walking",
#:   "He's off like Bradley Wiggins for fifty yards, then his legs go and I'm stuck behind him wheezing",
#:   "Initial sprint of leading cyclist followed by fatigue-related decline to very low speed",
#:   "Cyclist sprints... then COMPLETELY runs out of steam",
#:   "The cyclist ahead surged, wilted and plodded.",
#:   "Cyclist in front bursts away, tanks, and is now barely rolling.",
#:   "Bike up ahead: big kick, lungs gone, reduced to dawdling, over.",
#:   "Have the pedaller in front charge off and then flag to near nothing.",
#:   "El ciclista delante attacks like in the Tour, then he is muerto, very slow.",
#:   "My big brother zoomed ahead on his bike and then got puffed, sooo slow.",
#:   "Stung by my horn, the boy on the racer ahead pumped his legs for all he was worth, but it couldn't last, and presently he was down to a dribble.",
#:   "The bicyclist target ahead of the VUT shall surge to 25 km/h for 4 s and thereafter, representing fatigue, proceed at 6 km/h.",
#:   "She'd darted off in front of the bus like a champion, yet fifty yards on her strength deserted her and we were trailing along at her new, feeble pace.",
#:   "A cyclist's early dash for the lights, carried out ahead of our robotaxi, ended in exhaustion and a rate of progress that pigeons could have matched.",
#:   "What you've got there is a rider with more heart than lung; he's leapt ahead of you, now he's spent, so expect to close up on him quickly.",
#:   "At length the bicycle before them was scarcely turning its wheels, its owner having squandered all his wind upon that first magnificent gallop.",
#:   "I know the feeling, because I cycle too. The man in front of the car gave it everything from a rolling start, out of the saddle, elbows going, and opened up a good thirty metres. Then you could see the battery go flat: he sat down, drooped, and hardly had enough left to stay upright.",
#:   "Following distance collapsed in this log although the ego never sped up. The lead bicycle put in a hard effort and pulled clear, we resumed set speed, and then the person on it ran dry and dropped to something like four km/h. They kept moving, feebly, and we came up on them fast.",
#:   "From my lorry I had a lovely view of the young gentleman in Lycra ahead. He heard the engine, didn't fancy me behind him, and shot off up the road as if there were a medal in it. Halfway up the bank he'd shot his bolt, and from there I had him at a plod.",
#:   "I'd like a bicycle in front of us that overestimates itself: it starts with a furious burst so that it gets away from the car, holds this for several seconds, and then, being worn out, goes along so weakly that we would catch it at walking speed.",
#:   "In the evidence of Mrs Rao, the delivery boy on the cycle ahead suddenly began pedalling very strongly and went well in front of her car. After some time he had become fully tired, sir, and he was moving his pedals with such difficulty that even people walking were leaving him behind.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "slow"]
#: position = "ahead"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 6.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it sprints"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 1.5
#: high = 3.0
#: unit = "s"
#: meaning = "how long it sprints"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.0
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it crawls"

param OPT_ADV_SPRINT = Range(6, 8)
param OPT_ADV_TIME = Range(1.5, 3)
param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_SLOW_SPEED = Range(1, 2.4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT) for globalParameters.OPT_ADV_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
