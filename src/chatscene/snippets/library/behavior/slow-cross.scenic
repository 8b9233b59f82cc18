#: description = "The pedestrian crosses very slowly."
#: rephrasings = [
#:   "An elderly person shuffles over the carriageway.",
#:   "The pedestrian creeps through the lane and takes a long time about it.",
#:   "Someone plods across at a crawl, staying in the way of the ego.",
#:   "The walker dawdles over the street.",
#:   "A person with a walking frame inches across the road.",
#:   "The old lady takes for ever to get over the road.",
#:   "The elderly pedestrian crossed the roadway at a slow pace.",
#:   "ped crosses, very slow",
#:   "An old dear was pottering over the road at a glacial pace.",
#:   "The elderly pedestrian was crossing at a very slow walk, without stopping.",
#:   "Ped x-ing, dead slow, steady.",
#:   "The pedestrian target crosses at constant very low speed (below 0.5 m/s).",
#:   "Grandmother goes over the street so slowly.",
#:   "Crosser at minimum walking speed, continuous, no dwell, occupies the lane for long.",
#:   "He took his time about it, one small step after another, as if the road belonged to him.",
#:   "There's an old fellow on a cane going over, he's taking forever, just let him get there.",
#:   "this grandma is crossing sooo slow im gonna be late",
#:   "An elderly man made his way over the road at a very gentle pace as cars waited.",
#:   "The pedestrian's progress across was continuous, I grant, but exceedingly slow.",
#:   "Ah ma cross the road very slow, one small step one small step.",
#:   "I've seen glaciers get over the road quicker than this old boy.",
#:   "Prolonged lane occupancy by pedestrian of very low but constant walking speed",
#:   "LONGEST CROSSING OF MY LIFE - pedestrian in slow-mo",
#:   "The old man toddles across.",
#:   "Nan with her shopping trolley, crossing at the speed of moss",
#:   "Let a walker traverse the road at a very leisurely rate.",
#:   "Man on crutches is getting over the street little by little, never stopping.",
#:   "Elderly female crossing ahead, extremely unhurried, allow plenty of time.",
#:   "He goes from one side to other side like a slow film.",
#:   "A woman with a pram was making her way over in front of us so gradually that the indicator clicked forty times before she was through.",
#:   "The VRU target shall traverse the carriageway perpendicular to it at a uniform 0.4 m/s, without pause or change of direction.",
#:   "Somebody in carpet slippers came over from the bus stop, and we could have boiled an egg in the time he needed to reach the other kerb.",
#:   "The pedestrian was crossing from the west curb to the east at a markedly reduced walking speed and was still within the lane as V1 arrived.",
#:   "My knees being what they are, I get over that road as best I can, one little step and then the next, and cars must wait.",
#:   "In India also we respect aged people, so when one uncle was crossing in front at ant's speed, straight over, I simply kept my foot on brake.",
#:   "There was no drama in it, just length. The lady set out from the pavement with her two sticks, kept steadily on, and made perhaps a foot with every breath, so that half the street had come to a standstill before she was over.",
#:   "Please give me a pedestrian whose only peculiarity is lack of speed. He walks straight over the road ahead of the AV without halting or turning, but he needs about three times as long as anybody else would for the same distance.",
#:   "Never hoot at them. That gentleman with the walking frame left the kerb when you were miles away, he's been going steadily ever since, and he has only got as far as your lane, because that really is as quick as he can walk.",
#:   "She crossed as other people knit, without looking up and with no thought of finishing. The driver watched the grey coat progress from the left edge of his windscreen to the right, and it seemed to him that the seasons were changing.",
#:   "The child told the constable that the old man wasn't drunk and he wasn't silly, he was just slow. He went over the road in front of the blue car like when you carry a very full glass, all the way to the other side.",
#:   "Lady with two sticks inches over; bring a book.",
#:   "Ped going across steadily at about the speed of honey.",
#:   "he wasn't on his phone or anything, he just walks over THAT slow",
#:   "The gentleman got from one kerb to the other without a break, but he took such tiny steps that three cars had to queue.",
#:   "The adult target traverses the roadway at right angles with a constant velocity of 0.3 m/s, the path being straight and uninterrupted.",
#:   "Let somebody with a walking frame go over the road ahead of the AV, as unhurriedly as a real walking frame allows.",
#:   "She was so slow in passing the street, this old Madame, that the bread in my basket was cold when she arrived to the other side.",
#:   "Great-grandpa crosses the road like when you play that you're on the moon, every step takes ever so long, but he keeps going.",
#:   "At the time V1 approached, a pedestrian was traversing the roadway from north to south at a speed estimated by onlookers as well below normal walking pace.",
#:   "He had carpet slippers on and a newspaper under his arm. I first saw him leave the opposite pavement as I passed the garage, and when I got to him he had done about a third of it; he never faltered, mind, he only went over by inches, and I turned my engine off in the end.",
#:   "I'm writing this while I wait, that's how long it's taking. There's a woman going over the road in front of our car with a tartan trolley, straight as a ruler, a step, and a step, and a step, and I reckon she'll reach the other side by the end of this post.",
#:   "The pedestrian detector was never in doubt; the scheduler was. At half a metre per second and without a pause it takes a person about seven seconds to clear one lane, and our timeout for a crossing walker was four, whereupon the robotaxi began to fret.",
#:   "There are folk whose hips are done for, and my mum's one, so I've got patience. You hold the brakes on, you smile, you let the lady make her small, regular steps from your left-hand mirror to your right-hand one, and you don't rev forty tonnes at her.",
#:   "A church clock was striking twelve when the old man came off the pavement, and it had finished some time before he was on the other one. In between, a stick and two feet took it in turns to move, evenly, and the driver who had stopped for him took off his hat.",
#:   "What is that woman doing in the road so long? She isn't lost and she isn't dithering; she set off to cross, and crossing is what she's been doing. It's only that with a plaster cast up to the knee each step of it gets her no more than a few inches farther.",
#:   "In the statement the driver says he had \"loads of time\". He meant the distance, I think, and would've been right with anyone else. This walker covered the width of the street at less than a third of the usual pace, straight on, and was still before the bonnet when the car got there.",
#:   "Give me a plain crossing with one dial turned right down. No stops, no turning back, no wobble; the person goes from this side to that in a direct line, and the number of seconds that takes is what we're going to annoy the ego with.",
#:   "The bus had pulled up, the bicycle had pulled up, and so in the end had we. It was for an elderly nun, who was getting over to the convent as she no doubt did everything, evenly, with her eyes lowered, and about as fast as a candle burns.",
#:   "My dashcam isn't broken, it's real time. The fellow in the brown coat really does need twenty-six seconds to get from kerb to kerb, and he's moving through all of them; I've measured it, and it comes out at the top speed of a garden tortoise.",
#:   "When dadi-ji crosses, whole bazaar is waiting. She came down from the step, she was walking, always walking, so slow that you could not see it, same as the short hand of the clock, and after long time only she was on that side and I could go.",
#:   "Kerb to kerb in forty seconds, never pausing, tiny steps.",
#:   "She's moving all right, dear, only the clock's moving faster.",
#:   "One walking frame, one straight line over, one very long wait.",
#:   "A nun was going over in front of us, and I had time to read the bus timetable opposite, both directions, before her hem had left our lane.",
#:   "It wasn't that he stopped or strayed; he just needed nineteen of those small even steps to get past the width of our bonnet.",
#:   "Make the walker set off straight for the other pavement and carry on without a break, but with so little pace that the ego's patience is what's tested.",
#:   "That man with the crutches is going to be in your lane for a good while yet, because each swing of them gains him about a shoe.",
#:   "For 11.6 seconds the pedestrian, who was moving steadily and perpendicular to the roadway, remained within the lane in which V1 was approaching.",
#:   "This grandmother, she passed the street like one unrolls a carpet, by and by, without any stop, and I have smoked in the meantime the half of my pipe.",
#:   "The shadow of the lamp post had been at his heels when he left the pavement. I swear it had caught him up by the time he got to our side. He didn't loiter and he didn't look about; he simply had one speed, and on that speed you could get over the High Street between breakfast and elevenses.",
#:   "You can tell when somebody's dawdling, they look at their phone. She looked at the far kerb. Everything in her was bent on reaching it: the stick came forward, then the bad foot, then the good one, no gaps between, and still our engine had cut out and started again before she was past the headlamp.",
#:   "Frame by frame there is motion in each picture, which is how we know that the pedestrian never paused. Between any two pictures, however, it amounts to one or two pixels. It begins at the left sidewalk, ends at the right one, and the path is a straight line drawn by someone with all day to draw it.",
#:   "My little boy got through a whole banana. The lady was carrying a cake, a big one with candles, and she was going over to the hall with it. She was so careful that her feet hardly came off the road. She didn't stop for us, but she didn't go any quicker either, and Dad turned off the indicator.",
#:   "Why was I stationary? Because I'd been able to see since the bend that he'd be there for some time. He was on his way from the pub to the post box, dead straight, and sober as a judge, with each foot put down a thumb's length before the other. My coffee was cold when he posted it.",
#:   "What tempts the young ones is the arithmetic. It's a narrow road, there's a person a third of the way over, they think she will be off it by the time they get there. Do it again with her pace. She's covered one white line while I was saying that. She'll keep coming, and you'll keep waiting.",
#:   "Forty tonnes and I'm beaten by a tortoise in a headscarf. She's got a right to her road. She came off the pavement by the chemist's as I was passing the bank, and I'd stopped, and put the kettle on as it were, and she was still between my wipers, plodding for the baker's like a clock's big hand.",
#:   "The robotaxi's passengers rang support, believing that it had broken down. It had not. In front of it was a gentleman of ninety-one, going over to his daughter's. His speed, which was constant, was twenty-eight centimetres per second; his direction, which was constant as well, was the daughter's front door.",
#:   "There's a hush when they're like that. The bus had shut off, the van had, and the one sound in the street was slippers: shup, shup, shup. They started on the left of me. For ever so long they were in front, never missing a beat. And when at length they were shupping on the right of me, it was over.",
#:   "No fault is alleged in the way the pedestrian went over, neither hesitation nor detour. She had merely eighty-eight years and a shopping bag. The defendant, who saw her leave the kerb, supposed that she'd be out of his lane at the usual time, whereas she'd hardly come to its middle.",
#:   "My nani crosses with rosary. For one bead, one step. She'll not break, she will not run, and she'll not go here and there. So whole road can count with her: from this footpath to that footpath is one hundred and eight beads, and if you have come in your taxi at bead number forty, you'll kindly wait sixty-eight.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 22.0
#: high = 52.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"

param OPT_ADV_SPEED = Range(0.8, 1.4)
param OPT_ADV_DISTANCE = Range(22, 52)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
