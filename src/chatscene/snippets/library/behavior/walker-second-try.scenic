#: description = "The pedestrian steps out, goes back to the edge, waits a moment and then darts across after all."
#: rephrasings = [
#:   "He starts over, thinks better of it, then changes his mind again and runs across right before us.",
#:   "The non-motorist entered the roadway, returned to the edge, and subsequently ran into the path of Vehicle 1.",
#:   "ped out, back, pause, then dash across",
#:   "The target aborts a first crossing attempt and begins a second one at running speed.",
#:   "First she goes, then back, then again she runs over the street.",
#:   "A dithering walker retreats once and on the second attempt bolts over the road.",
#:   "False start by the kid, back to the kerb, and off he goes for real.",
#:   "After one abandoned attempt somebody makes a rush for the other pavement.",
#:   "She stepped out, bottled it and went back, then a moment later made a run for it.",
#:   "Pedestrian stepped from the curb, retreated, waited briefly, and then ran across the roadway.",
#:   "Ped out, back, short wait, then sprints over.",
#:   "The pedestrian target enters the lane, withdraws, waits at the edge and then crosses at running speed.",
#:   "The boy goes on road, goes back, waits, and then runs over anyhow.",
#:   "Walker: one aborted attempt, dwell at edge, second attempt at run speed completes the crossing.",
#:   "His first go came to nothing and he returned to the side; but hardly had she relaxed when he made a break for it.",
#:   "He's gone back, good, but don't trust him yet, see, he's gone for it after all, and at a run.",
#:   "she stepped out, chickened out, waited a sec, then just ran for it",
#:   "After a false start that took him back to the pavement, the pedestrian raced over.",
#:   "His first attempt he abandoned; he bided at the roadside; his second he made at a run.",
#:   "First time she went back, stood at the side, next time she ran and crossed.",
#:   "Has a go, loses his bottle, back to the side, counts to three and sprints it.",
#:   "Aborted pedestrian entry followed by wait at the edge and renewed rapid crossing",
#:   "FALSE START! Attempt number two is a SPRINT",
#:   "The girl ventures, retreats, lingers and then scoots across.",
#:   "Steps off, scurries home to the kerb, ponders, then bolts over.",
#:   "Ped enters, withdraws, short wait at edge, then crosses at a run.",
#:   "Give me a jogger who aborts, lingers at the side, then sprints across.",
#:   "First she came, then back, she waited, then quick quick over.",
#:   "the kid went out went back counted to three n pelted across",
#:   "An old man put himself into the road, backed out of it, stood awhile at the edge, and then made a dash for the other side.",
#:   "The pedestrian target's first entry is cancelled by a return to the kerb; following a dwell time, it traverses the lane at sprint speed.",
#:   "Fine, he's seen you, he's stepped back on the pavement and he's waiting. Don't speed up just yet... what did I say? There he goes, flat out.",
#:   "The woman with the pram has come on the street, returned herself to the border, reflected one moment and after all she has run to the other side.",
#:   "Who'd have thought that someone who had already retreated from the lane and stood there quietly would, moments later, fling himself across it at full speed?",
#:   "On her second attempt she flew over the road in front of us, the first having ended in a retreat and a spell of waiting.",
#:   "I was approaching at a moderate speed when a youth walked out from between the shops. He saw my car and went back to the side, where he remained, so I took my foot off the brake. At that very moment he changed his mind and came tearing over the road.",
#:   "A witness on a bicycle told us that the pedestrian had been \"like somebody testing the water\". She entered the carriageway, drew back to its edge and hung about there for a second or two. Then, with Vehicle 1 now far closer, she shot out and ran the entire way across.",
#:   "Parameter sheet, two-attempt crossing. Attempt one: pedestrian walks into the lane and reverses to the roadside. Dwell there, zero speed, one to three seconds. Attempt two: straight over at a sprint. Our intent estimator drops to \"not crossing\" during the dwell and the ego re-accelerates, which is exactly the wrong thing.",
#:   "Three times I've told this at the depot. Little lad with a football comes off the kerb, sees my bus, hops back on it. Good lad, I think. He stands there, toes over the edge, looking at me, and I'm already rolling again when whoosh, over he goes like a rabbit, ball under his arm.",
#:   "He ventured forth, and the headlights drove him home again; he stayed at the brink of the pavement with his hat in his hand, so that Marie took it for settled that she was to go first. It was then that he ran, coat-tails out, right across before her bonnet to the other shore.",
#:   "Kid steps out, scuttles back, stands a sec, then sprints the lot.",
#:   "Let her venture out, retreat to the kerb, wait, and race across.",
#:   "old boy: out, back, hmm, and then LEGS IT over the road",
#:   "The jogger put one foot in our lane, took it home to the kerb, stood there long enough to be believed, and flew over in front of us.",
#:   "The target's initial entry is aborted by a turn-back to the roadside; following a brief standstill there, it crosses the full lane at maximum running speed.",
#:   "The grandmother goes in, goes again out, at the border she is standing and looking, and when I give gas she is running to the other side.",
#:   "He's had one go and lost his nerve, he's back on the edge and thinking about it, and whatever he does next he'll do at a gallop... there, see?",
#:   "One uncle came inside road, seeing us went back, stood at the side like he will not go, then suddenly he ran full speed across.",
#:   "Did my client's trust not rest on what she had seen, namely a man retreat from the road and wait, before he shot over it at a sprint?",
#:   "I was eating a banana at the bus stop and counting buses. A girl went off the kerb, saw a car, and was on the kerb again before I had swallowed. She stood with her toes over, and I said to myself that she's sensible. She wasn't. She put her head down and ran like mad to the other side with the car right there.",
#:   "The pedestrian left the west curb at a walk and entered V1's lane by about a yard. He then reversed direction and regained the curb, where he stood for approximately two seconds. V1, having slowed, resumed its speed. The pedestrian then ran eastward across the entire roadway, clearing V1's bumper by three feet.",
#:   "We had an argument about it in the canteen. The first time the old woman set out, we all braked, and the second time we nearly didn't. What came between was convincing: she had gone back where she started from, she stood, she arranged her scarf. Then you never saw an old woman shift so. Whoosh, over.",
#:   "Two-phase walker for the prediction team. He walks in; he turns about and leaves the lane by the side he came from. At the edge he's idle for between one and three seconds, during which the ego is going to be tempted. He thereafter sprints over from one side to the other. Score is the gap at that moment.",
#:   "Nobody tells you that the dangerous ones are those who've already been good. The boy with the skateboard under his arm had been very good. He'd come out, seen my lorry, gone back to the kerb, and waited there; I could have kissed him. I changed up. Then he ran, flat out, over the road, the little blighter.",
#:   "The first time, she carried the parcel two paces into the street and carried it back. The headlights came on, and she stood at the brink, with the parcel held against her. Whatever it was she whispered to it then, it decided her. She ran, bareheaded, all the way to the opposite pavement, and the brakes sang behind her.",
#:   "There's a hat lying in the middle of the road and I can account for it, constable. Its owner wasn't hurt. He'd started over and thought better of it, came back and stood beside my newspaper stall for a couple of seconds, tutting. He was then off across the road like a greyhound, too fast for the hat.",
#:   "My daughter's theory is that he'd forgotten his keys and then remembered he hadn't. It would explain it. A chap stepped off, did an about-turn onto the pavement, patted his coat, standing quite still. The taxi that I was following took that as its cue, and so did he: he charged to the other side, arms going like pistons.",
#:   "I'm a cyclist, I wait behind cars, I see feet. Under the door mirror of the robotaxi I saw sandals in the road. Sandals going back. Sandals side by side on the kerbstone for a moment or two. The robotaxi rolled, and the next I saw of the sandals was both soles, running, on their way to the chip shop opposite.",
#:   "Third video, the so-called encore. Woman with the yoga mat walks on stage, gets one look at the audience, exits the way she came. You can see her wait in the wings, maybe two seconds at the kerb. The cammer lifts his foot off the brake and back on she comes, sprinting from one side clean through to the other.",
#:   "With a pram you'd think one would be careful. The mother pushed it down the kerb, pulled it up the kerb again, and remained there rocking it, as if she'd given the whole thing up. When my pupil let the clutch in, she ran. I mean ran, pram and all, from our side right over to the park.",
#:   "Out she steps, back she goes, dithers, then bolts over regardless.",
#:   "First go aborted, short think at the edge, second go flat out.",
#:   "kid in, kid out, kid waiting... KID SPRINTING ACROSS",
#:   "Three times I had my foot on the brake for the same old man: as he came out, in vain as he went back and stood, and, in earnest, when he tore over.",
#:   "A student ventures on to the lane, retires to the kerb, stands there looking at his watch, and then makes a mad dash for the other pavement.",
#:   "That he'd gone back to where he came from and stayed put made me take him for somebody who would wait; he was over before I'd finished thinking it.",
#:   "The dummy shall be moved to the reach point, returned to the edge, held for the dwell time, and launched at sprint speed through to the opposite side.",
#:   "Watch that mum, she's out, no, she's back, she's having a think, don't you trust it, look at her weight on the front foot, there, she's off.",
#:   "Having once been frightened home from the tarmac by our headlamps and having stood a while to get over it, the hen-party girl hared across in her socks.",
#:   "The braking log of the ego has two peaks with a lull in between. The small one belongs to a pair of shoes that came off the pavement and then returned to it. The lull belongs to the same shoes side by side on the kerb. The large peak is for when they left it for good, at a run, and were over on the far side a second later.",
#:   "It's not the boy's first try that I blame him for. He took a look, he took two paces, he saw my truck and did the right thing, he went back and stood by his sister. I gave them a nod and I gave it some throttle again. It was by the sister's scream that I knew he wasn't standing by her any longer, but streaking over my road.",
#:   "You could have sold tickets. There was this gent in slippers after his newspaper, which the wind had got over to the other side. Out he shuffled. A hoot; in he shuffled. He stood so long at the edge that we'd all made up our minds he'd let it go. But slippers or none, the next thing you saw was heels.",
#:   "My sister was driving and I was the one who said \"it's all right, she's gone back,\" for so she had, with her shopping, from about the gutter to where she'd started. She'd put the shopping down, even. I'd have sworn that a person who puts her bags down is staying. She was lightening herself. She flew across without them.",
#:   "Sir, lady has come on the road, I've slowed. She's seen me and gone back to footpath, good, I've raised my hand for thanks. Some two seconds she's standing like a statue. I press the race, and this statue has become P. T. Usha, full speed from this side to that side, before my bonnet. What's the meaning of going back?",
#:   "There was a fox once who did just this, said the postmistress, but it was a man that time. He had set a foot on the lane and another, he'd weighed the robotaxi up and withdrawn both. On the kerb he seemed to say a prayer, it took about as long. With that done, he ran for his life, and gained the far pavement with a shoe less.",
#:   "We labelled it as two pedestrians at first, the one who gave up, and the one who sprinted. The clothing's the same. What separates them is a second and a half on the kerb, without motion, by which time the intention estimate was down at \"not crossing\". So the one who sprinted met an ego that had put its speed back on.",
#:   "You're owed an explanation for the dent in the lamp-post, which I hit, rather than him. He'd already been out there and had scuttled back, and I'd begun to go past. He was standing as good as gold. People who have changed their minds once, Mr Chairman, should not be let near a road: he pelted over, in front of me.",
#:   "In my village the goose makes this. She goes on the road, she finds the car not good, she goes to the grass again and there she is thinking. The driver says, now the goose has understood. And then she crosses, with the neck long, as quick as she can. Today it was no goose. It was the son of the mayor, with his phone.",
#:   "He'd hold his breath each time he told it. There was the pram's front wheel over the kerb, and off, and then back up on the kerb, thank God. There was the girl, quite still behind it, for as long as it takes to look both ways. There was the sound of small wheels at speed; and there, on the other pavement, was the pram.",
#:   "Comment from the clip's owner. For those who ask why I got back on the gas at 0:14: because at 0:11 he's walked out, at 0:12 he's walked in again, and at 0:13 he's parked on the edge with his arms folded. I can't know that he's only taking a run-up. 0:15, he goes past the wipers like a greyhound to the other side.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-back", "hesitate", "cross", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.4
#: unit = "m/s"
#: meaning = "how fast it goes at first"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 38.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far from the ego's line it first turns back"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.0
#: unit = "s"
#: meaning = "how long it waits"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 3.8
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it runs across"

param OPT_ADV_SPEED = Range(2.2, 3.4)
param OPT_ADV_DISTANCE = Range(14, 38)
param OPT_ADV_REACH = Range(1.2, 2.2)
param OPT_STOP_TIME = Range(0.4, 1)
param OPT_ADV_SPRINT = Range(3.8, 6.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > globalParameters.OPT_ADV_REACH + 0.9
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159)
