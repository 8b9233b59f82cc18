#: description = "The pedestrian starts across slowly and suddenly breaks into a run."
#: rephrasings = [
#:   "A person strolls into the road and then accelerates sharply in front of the ego.",
#:   "The walker begins at an easy pace and sprints the rest of the way.",
#:   "Midway over the carriageway the pedestrian speeds up without warning.",
#:   "Someone ambles off the kerb, then bolts.",
#:   "The cyclist rolls into the lane and suddenly pedals hard.",
#:   "He's strolling over and then all of a sudden legs it.",
#:   "The pedestrian entered the roadway at a walk and then began to run.",
#:   "ped walks out, then sprints",
#:   "she started over nice and slow, then halfway she suddenly legged it",
#:   "The pedestrian began crossing at a slow walk and abruptly broke into a run partway across.",
#:   "Ped X-ing slow; midway -> runs.",
#:   "The pedestrian target starts crossing at low walking speed and changes to running speed partway.",
#:   "The boy goes slow in the street, and in the middle he runs.",
#:   "Crosser with speed step: slow on the first half, run on the second half; breaks constant-velocity prediction.",
#:   "The cyclist had been dawdling over when something spurred him on, and he finished the crossing at full tilt.",
#:   "Old fella's ambling over, plenty of time... oh, he's noticed you, he's picked up his skirts and he's running for it.",
#:   "she was walking across all chill then suddenly started sprinting lol",
#:   "A pedestrian who set out unhurriedly took to his heels halfway over",
#:   "You began to cross at leisure and, part of the way over, you began to run?",
#:   "Aunty crossing slowly slowly, halfway then she start to run, give me shock",
#:   "He's ambling over, hands in pockets, then in the middle he's off like he's heard last orders",
#:   "Pace change of crossing pedestrian from walk to run in mid-crossing",
#:   "Pedestrian strolls out... then SPRINTS",
#:   "The cyclist drifted out, then galvanised across.",
#:   "Man dawdles into the road, then takes off at a gallop.",
#:   "Cyclist rolls out gently, stamps on the pedals partway.",
#:   "Crosser's first half: stroll. Second half: flat-out dash.",
#:   "Granny was crossing slowly and then she zoomed!",
#:   "Why saunter into the road only to tear across the rest?",
#:   "Let a woman start over the street in no hurry at all and, somewhere on the way, switch to a run without looking up.",
#:   "He'd begun so leisurely that I reckoned I could pass behind him; then the schoolboy suddenly shot forward and finished the crossing at speed.",
#:   "The non-motorist left the curb at a slow walk and, when part of the way over, increased to a full run toward the far side.",
#:   "The man goes to cross very tranquil, like on Sunday, and when he is at the half he starts to correr like crazy.",
#:   "Careful, she might be slow now, that lady with the shopping, but if she spots her bus, there you go, she's pelting for it.",
#:   "The bicycle crossed our bow in two gears, so to speak: a lazy wobble to begin with, and thereafter a furious burst to the other side.",
#:   "There was a jogger who'd stopped to cool down. She set out over the road with her hands on her hips, practically at funeral pace, and just as the AV had worked out that it needn't hurry, she was up on her toes and racing for the opposite kerb.",
#:   "Two constant-speed segments make up the trajectory of the pedestrian target: from the kerb to the changeover point it moves at slow walking speed, and from there to the opposite side at running speed. The change occurs within one second and isn't announced.",
#:   "I'm on two wheels myself, so I know the feeling. The fella freewheeled into the road half asleep, caught sight of the van bearing down on him, and suddenly he was out of the saddle, going like a sprinter for the line, till he'd got across.",
#:   "You could have boiled an egg in the time it took the old boy to get from the kerb to the first white line. I'd my window down to say something encouraging. And then, blow me, he tucked his stick under his arm and fairly flew over the rest.",
#:   "phone zombie, takes like 5 tiny steps out from the pavement, no rush, doesnt even know shes in traffic. looks up, sees us, and then its full olympic hundred metres to the other side. our car had already planned to go past her and had to brake hard",
#:   "Lady drifts off the kerb, then bolts the remaining distance.",
#:   "Cyclist dawdles into the lane, then suddenly races clear.",
#:   "Man's crossing: first a saunter, then without warning a gallop.",
#:   "I'd timed it to go by behind the student, given her snail's pace off the kerb, and then she went from a shuffle to a full sprint.",
#:   "Make a walker leave the pavement at a crawl and, when he's part of the way over the lane, shoot off towards the other side.",
#:   "The elderly gentleman had embarked on the crossing as one embarks on a novel, and, in the middle of the first page, took to his heels.",
#:   "Ped off the nearside kerb, dragging his feet, cancel that, he's started running, he's going flat out for the far side, he's clear.",
#:   "The bicycle goes on the street so calm that I think he sleeps, suddenly he stands in the pedals and shoots across like a Rakete.",
#:   "A mother with a pram, no rush in the world to begin with, then in mid-road such a sprint that the pram was on two wheels.",
#:   "It's a matter of expectation, Mr Hughes, and you will lose marks for yours. You saw a boy come off the kerb with a football under his arm, dragging his feet, and thought: slow, so I've time. Then his mate on the other pavement whistles. You saw how he took off for him, right through the middle of your plan.",
#:   "As lorry drivers we have to guess what people's legs will do. The lady in the sari had set out at a speed that told me she'd need fifteen seconds. I took my foot off and waited for the fifteen. In the fourth, goodness knows what bit her, she had gathered the cloth in both hands and was flying for the market side.",
#:   "V1's operator reported that the non-motorist \"was taking her time\" when first seen in the roadway. The video agrees: 0.7 meters per second over the first three meters. Over the remaining distance it shows 4.1. Between these values there is half a second, and nothing is visible that explains the change. She reached the opposite curb.",
#:   "We've seen crossers who dash from the start, and crossers who dither, but to my ear the worst is the one with two speeds. He trickles into your lane on his bicycle like he's on holiday. You plan for that. And when you've planned for that he gets a burst on, and he's just where you were planning to be, heading over.",
#:   "He was reading a letter as he walked, or had been. It must have held good news; I like to think so. From my cab I saw him wander off the pavement with his eyes on it, hardly lifting his feet. Halfway over he crushed it in his fist, and then he ran, ran like a boy, and vanished up the station steps.",
#:   "Two-speed pedestrian. The article is released from the nearside at the slower of the speeds, so that the subject vehicle would, if nothing changed, pass before it. On reaching the boundary of the subject vehicle's lane it is accelerated to running speed within the shortest time that the platform permits and continues to the offside.",
#:   "When the AV chose to keep its speed, it had before it a person who would not be in its lane for another four seconds. When it braked, she was in it. The prediction had been sound; it was the person who'd altered, from somebody strolling out with a coffee into somebody pelting for a tram, the coffee all over the asphalt.",
#:   "My bike's heavy, I'd two crates of beer on the back, so I can only wobble off. That's how I started across. Then I saw the car. I wasn't going to stand about in front of it, was I, so I got up on those pedals and gave it everything, crates and all, and I was over before he'd hooted.",
#:   "There is a zebra by our temple, aunties are crossing very slow there, so I am always ready. This aunty also was slow, slow, one step, one step. Suddenly she remembers her gas is on, I think so, and she is running like PT Usha! I could stop, but the man behind me was not ready.",
#:   "What's the collective noun for people who do that? You let the jogger get going, she's plainly tired, barely lifting her trainers as she starts over the road. You're lining up to roll on by. And off she goes like a hare from about the middle, all the way to the opposite pavement, leaving you with your foot on the brake.",
#:   "little kid, huge backpack, crossing in tiny tiny steps, so cute. our car is doing its polite slow roll. then i guess he sees the schoolbus over there cause its like someone hit fast forward. legs blurry. straight across the rest of the road, bag bouncing. our car did NOT see that coming and anchored up",
#:   "Shuffle, shuffle, shuffle over the road, then all knees and elbows.",
#:   "cyclist wobbles out then up on the pedals n flat out across",
#:   "Her first ten steps took a week, her last ten nothing.",
#:   "I thought I could slip by ahead of the old boy, the rate he was going, till he put on a burst like a winger.",
#:   "Let the jogger set out across at little more than a stroll and, with part of the lane behind him, sprint the remainder.",
#:   "He'd had his coat tails hanging limp as he stepped out, and a couple of paces on they were flying straight out behind him.",
#:   "V1's driver judged that the pedestrian, walking slowly from the right, wouldn't reach his lane; the pedestrian, who began running midway, then did.",
#:   "Why does one put a foot onto the road as if the tarmac was wet paint and finish the trip as if it was on fire?",
#:   "The bicycle crosses first so slowly that it nearly is falling, and then, of one blow, he stands up and pedals like for the Tour.",
#:   "The scarf is how you can tell. For the first few frames it's hanging down as she trails over towards our side, phone at her ear. In frame eleven it lifts. In frame fourteen it's level with the road, like a windsock in a gale, and her shoes are a blur, and she's bang in front of the cammer, and over.",
#:   "Planner note: we solved for passing in front. With a walker making 0.6 m/s towards our lane that's the proper solution. Six tenths became five in a single step, while she was out there, which turned a comfortable margin into a hard brake. The new variant must start with the trudge, else the planner won't fall for it.",
#:   "They'd been carrying the piano stool between them over the High Street, in no hurry, bickering, and I had let the bus roll. It would've been all right at that pace. One of them shouted something, rain I think, and off they went like a relay team, stool and all, straight under my windscreen to the awning on the other side.",
#:   "A hen doesn't hurry either until you've worked out how to get round her. This was a postwoman. Out she plodded with her bag, on a line over to the houses, and I did the sum and it came to plenty of room behind the bag. What I hadn't in the sum was her feet beginning to drum.",
#:   "Did she look at you? Not once. Did that worry you? No, the girl was creeping. She was pushing off on her bicycle from the kerb with one foot, I reckoned she'd be an age. And when did it worry you? When I saw both her feet on the pedals and going round like a sewing machine, in my lane.",
#:   "The baby in the pram made the first half of the crossing asleep. You may ask the grandmother, who walked it over as one does, softly. Our car was to blame for the second half, she'd finally noticed us. The pram went from nothing to full gallop in the middle of the street, and the baby went off like a siren.",
#:   "Slow feet, slow feet, slow feet: right, so you cover your brake and wait, you do not work out sums. Why not? Because of this. The bus he wants is closing its doors, look. See him look? And there's your slow feet turned into quick ones, plumb in your lane, belting for that bus, and your sums are worth nothing.",
#:   "I wear a heart monitor so I've the trace. Sixty-eight, as I come up Tower Road in the milk tanker. Seventy, there's a man stepping down and dawdling across, no danger. A hundred and thirty-one! That's where his dawdle stopped being one. He'd seen me, dropped his chips and torn over the rest of the road in front of me.",
#:   "Uncle walks in the road like he walks in his own garden, hands on the back. Here in Chengdu everybody drives around uncle, he's constant. This one wasn't constant. I'm steering to the place where he was, he becomes suddenly athlete, run in the same direction he walked, so he's also in the place where I'm steering.",
#:   "Speed of the dummy's belt: 3 km/h from release, so slow an approach that the vehicle under test has no reason to intervene. At the switchover mark, which lies within the carriageway, the drive is commanded to 14 km/h in the same direction. The dummy doesn't halt at the mark, nor does it go back. Impact point 50 %.",
#:   "Her umbrella up, her eyes down, Miss Lark had embarked upon the crossing in the manner of a barge. Mr Dunn, in the fly, looked to pass astern. What the church clock then said to her we can only guess. The barge became a torpedo boat, amidships in the road; and it was only by hauling on everything that he missed her.",
#: ]
#: adversaries = ["pedestrian", "bicycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.0
#: unit = "m/s"
#: meaning = "how fast it starts"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs in the end"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 24.0
#: high = 56.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far from the ego's line it breaks into a run"

param OPT_ADV_SPEED = Range(0.8, 2)
param OPT_ADV_SPRINT = Range(4.5, 7)
param OPT_ADV_DISTANCE = Range(24, 56)
param OPT_ADV_REACH = Range(1, 3)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPRINT)
