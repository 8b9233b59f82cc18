#: description = "The pedestrian shuffles into the lane, takes fright and rushes back at a run."
#: rephrasings = [
#:   "Granny creeps out, sees us and shoots back onto the pavement faster than you'd think.",
#:   "The pedestrian entered the roadway at a slow walk and then hastily retreated to the shoulder.",
#:   "ped creeps out, then rushes back",
#:   "The target enters the lane at 1 m/s and withdraws at running speed.",
#:   "The person goes very slow into the street and then quickly runs back.",
#:   "A hesitant walker tiptoes into our lane and then turns tail in a hurry.",
#:   "Someone dawdles off the kerb, gets a shock and dashes back to safety.",
#:   "The kid edges out bit by bit, then whirls round and scoots home.",
#:   "An old dear came shuffling out, got the wind up and scurried back to the pavement.",
#:   "The elderly pedestrian entered the lane at a slow walk, became frightened and ran back to the curb.",
#:   "Ped slow in, startles, runs back.",
#:   "The pedestrian target enters the lane at low speed, reverses direction and returns at running speed.",
#:   "The grandma goes slow in my lane, is afraid and runs back.",
#:   "Asymmetric return: slow walk in, panic, fast retreat to the near kerb.",
#:   "He shambled out before her, caught sight of the bonnet, and bolted for the kerb he'd come from.",
#:   "She's tottering out, ah, you've spooked her, she's legging it back where she came from.",
#:   "lady shuffled out, saw us, freaked and RAN back lol",
#:   "A pensioner edged into the road, caught sight of the car and fled to the pavement again.",
#:   "She entered at a slow walk, took alarm, and ran to the side she had left; is that your evidence?",
#:   "Ah ma came out slow slow, saw my car, got scared and ran back to the side.",
#:   "Creeps out in her slippers, sees me, lets out a yelp and she's back on the kerb like a whippet.",
#:   "Slow pedestrian lane entry with panicked running retreat.",
#:   "PEDESTRIAN PANICS AND RUNS BACK TO CURB",
#:   "A man dawdled out, spooked and skedaddled home.",
#:   "Pensioner inches into our lane, panics, sprints for the pavement again.",
#:   "Slow step in, shock, full-speed flight to the near kerb.",
#:   "She enters slow like a duck, becomes fear, goes back running.",
#:   "Let a pedestrian plod in, get scared, and race back out.",
#:   "Out at a crawl, home at a gallop: one startled lady.",
#:   "A man with a stick hobbled off the kerb into my lane, looked up, and found his legs again: he was back there in three bounds.",
#:   "Ever so gradually the woman with the pram came out before the robotaxi, until it seemed to dawn on her, and she fled to the side with it.",
#:   "The pedestrian's speed was 0.8 m/s on the way into the lane and, after a visible start, 3.5 m/s on the reverse course to the footway.",
#:   "Our witness had ventured out at a dawdle; your horn, or your headlamps, gave her such a turn that she tore back to the pavement she had come from.",
#:   "See, he's wandering in front of you with his paper, in no rush, and now that he's noticed us he's pelting back the way he came.",
#:   "At a leisurely walk the young man entered the lane of V1, was alarmed at its nearness, turned about and fled from it as fast as he could run.",
#:   "I am eighty-three and I do not run, as a rule. I had set out over the road in my own time, one foot and then the other, and I'd got to the lane when I saw that car. I can tell you I ran, all the way back to my gate.",
#:   "Target profile, two phases of opposite direction. Phase one, entry into the VUT's lane at a shuffling speed. Phase two begins abruptly within the lane: the target turns by 180 degrees and returns to the edge it set out from at sprinting speed, where it stays.",
#:   "Like a snail that's been touched. The little girl was coming out in front of our bus by tiny steps, pulling a toy dog, and the driver flashed his lights, and you never saw anything so quick: round she went and back into her mother's coat, dog flying.",
#:   "I cycle past the care home daily. There's this gent who comes over the kerb as if the road were made of treacle, and I ring, and the car behind me hoots, and he gets such a jolt that he's off back to the kerb like a sprinter.",
#:   "I'd like to test whether the AV waits for someone who's already gone. So: a person drifts slowly into its lane, appears to be frightened by it, whips round and goes running back to safety on the side where the thing had begun.",
#:   "Ambles into our lane, panics at us, hares off home.",
#:   "grandpa inches out, sees the bus, and suddenly runs back",
#:   "Slow entry by jogger in slippers, a start, then sprinting retreat.",
#:   "The woman came out over the kerb a few inches at a time, had the fright of her life, and was back there in a flash.",
#:   "dude strolls into the lane staring at his phone all slow, looks up, goes oh no, and sprints back the way he came",
#:   "The dummy, entering the lane at 0.9 m/s, shall on the horn signal reverse its heading and leave the lane on the entry side at maximum running speed.",
#:   "She's pottering out before you with her trolley, in her own sweet time, now she's noticed, and look at her go, haring off to her own side.",
#:   "One old babuji was coming in my lane step by step; my horn made him so much afraid that he turned and ran like schoolboy to his gate.",
#:   "I want a pedestrian who trudges into the ego's lane, is scared by the oncoming car and pelts to the side where he'd been standing.",
#:   "It was our reversing alarm that did it, it's faulty and goes off on its own. Until then he had been making his way out in front of us so gently that I'd taken out my sandwich. He gave a skip like a lamb, faced about, and was on his own pavement quicker than I could swallow.",
#:   "The claimant's husband, 84, had stepped from the footway and was proceeding into the lane at a very slow walk. The approach of the defendant's taxi alarmed him. He turned and ran to the footway he had just left, where, having had no occasion to run for many years, he strained his calf.",
#:   "Walking speed estimate on the way in: under one metre per second, with short steps. Then the head turns towards us. On the way out it's 3.8, over the same ground and in the contrary direction, so any model with a single pace parameter per pedestrian is going to be wrong in one half of this clip or the other.",
#:   "How she'd managed to dawdle as far as the lane with the traffic there is on our street, I don't know. It was all dawdle, believe me, I saw her examine a glove. But one peep at what was coming, a fire engine it was, and she'd hitched up her skirt and was tearing back to the bank door she had come out of.",
#:   "There's a crossing by the school that I go over on my bike. A teenager was sort of sliding into the lane, barely lifting his trainers, in front of this black car. Something clicked, he leapt round, and those trainers that couldn't be lifted carried him off to his mates on the kerb like a sprinter's.",
#:   "Q. He walked across the lane, did he? A. No, my lord, he'd been creeping into it, I'd call it, and then he got scared, you could see it go through him, and he ran, he actually ran, to the hedge he'd started from.",
#:   "Control, cancel the ambulance at the market. Elderly female had wandered into the bus lane at a snail's pace, the driver's given her a flash. It's put the wind up her and she's shot back to the stalls she came from at a speed, he says, he'd not have thought possible.",
#:   "Non-motorist N1 entered the lane of V1 from the south curb at a pace described as \"a shuffle\". Upon perceiving V1, N1 exhibited a startle response, reversed direction and ran to the south curb. V1's driver had begun to brake, and N1 was clear of the lane before the arrival of V1.",
#:   "When a tortoise is afraid it goes in its house, but it goes in fast. This man was going out of his house, in my lane, slow as the tortoise, one foot, rest, one foot. I came with the truck, he opened his mouth, and quick, quick, he ran in his door again.",
#:   "Half of it was a funeral and half of it was a bank robbery. He'd come off the grass into the lane before them with his head down, one grave step after the other. He raised it, beheld the coach, and fled; they could hear the soles of his shoes slapping all the way to the grass.",
#:   "You won't see a better one this year, folks. Bottom left, woman with pram, leaving the pavement as if she'd all afternoon, she's in our lane by second six. Second seven her face changes, and from eight to nine it's woman and pram hurtling to bottom left again with the blanket flying.",
#:   "In by inches, one look at us, out at full pelt.",
#:   "Pensioner dribbles into our lane, yelps, flies home.",
#:   "He sidles in front, spooks, tears back to his bench.",
#:   "A funeral step brought the lady off the kerb ahead of us and, once our horn had scared her, an Olympic one took her home to it.",
#:   "Dummy to shuffle into the ego's lane at low speed; on reaching it, turn about at once and run to the starting edge at sprint speed; hold there.",
#:   "this kid is scuffing into the road in giant sandals like 1 km/h, hears my brakes, screams, and LEAVES, back to grandma, sandals still in my lane",
#:   "With small small steps that aunty was coming before my cab, then my face she saw, what she saw in it I don't know, back she ran like young girl.",
#:   "Watching that man inch out before the bus you'd have sworn he couldn't run; one hoot, and he did it, back the way he'd come.",
#:   "Pace in, about that of a bride; pace out, to the same kerb, about that of a bridegroom who has changed his mind, with us as the reason.",
#:   "His sandwich is still there. He'd been eating it, that's what had made him so slow, a step and a bite, off the grass and into my lane with his back half to me. I touched the horn. I've never seen a sandwich let go of like that, nor a man of his build hit the hedge he'd just come out of at such a lick.",
#:   "Two of us in the taxi saw her coming out and the third saw her going back, and you'd think we'd seen two women. Ours was ninety and took a step a week; she was hardly in our lane when it dawned on her that we were as well. His had her skirt in both hands and went over the kerb, the one ours had come off, like a steeplechaser.",
#:   "The step frequency is the interesting variable. From the kerb to the lane it's 0.9 Hz with a stride of thirty centimetres. There's then a flinch of the upper body, some two hundred milliseconds after our headlamps have swept it. From the lane to the kerb, the very one, it's 3.6 Hz, and the stride is over a metre; the ego had planned for a slow crosser who'd keep on.",
#:   "What frightened him was the fire engine in front of me, bowling down on him. He'd been drifting out, if I may so put it, from the bookshop, nose in a book, a page or so per yard. He clapped it shut, I heard that through the glass, he spun on his heel and fairly flew back among the postcards.",
#:   "He isn't there any longer. Where the man with the two sticks has gone is where he'd come from. You saw him come, bit by bit by bit, you'd time to choose a gear. You didn't see him go, nor did I, to speak of; he heard your tyres, he tucked the sticks under his arm and he bolted for it.",
#:   "The statement of the lollipop man is brief. \"She dithered out there a toe at a time, never looked, she'd got as far as where the cars go. The Audi gave its lights a flash. She let out a noise like a kettle and came back at me that fast I had to catch her.\" She has since reverted to the toe at a time.",
#:   "Grass-green coat, handbag, small dog. All three came out from between the bins, in slow procession, and the coat had just come in line with my near-side headlamp. I wasn't going fast myself but I've sixteen wheels. Well, she noticed them. You never saw a procession break up so, the dog was pulled clean off its feet, and they were all three between the bins before I'd stopped laughing.",
#:   "In Vienna we say: a pensioner has no hurry but he's got reserve. He goes in the street very comfortable, I see it from far, the shoe is almost not lifting. Now he's before my motorcycle, he hears it, he throws up the arms. And then the reserve! Around, and with long jumps to the coffee house, from where he has come.",
#:   "Ego's contingency plan was based on an occupant of the lane who'd need another eight seconds to leave it. The occupant needed one. Having entered at a dawdle from the south kerb, she reacted to the AV's approach by a jump, an about-turn and a run to the south kerb. We recommend that slow pedestrians should not be assumed to be incapable of fast ones.",
#:   "We know him by the jacket. It was taking a stroll into the carriageway before our bus, with its hands in its pockets, looking up at an aeroplane. The driver said, not very loud, \"Oh, sir.\" It looked down. It had its hands out, its knees up to its chest, and it went like the clappers to the kerb behind it, and our whole top deck cheered.",
#:   "She'd put out a foot upon the roadway as one tries the sea; then the other. In this fashion, by little and little, with her eyes on her shoes, she had waded to where the cars went, when the light changed about her. She lifted her face into two lamps, and shrank; and she reached the shore from which she'd come at a run, with her hair down.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "turn-back", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.7
#: high = 1.2
#: unit = "m/s"
#: meaning = "how fast it goes out"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.2
#: high = 1.1
#: unit = "m"
#: meaning = "how far from the ego's line it turns back"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 3.6
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it runs back"

param OPT_ADV_SPEED = Range(0.7, 1.2)
param OPT_ADV_DISTANCE = Range(12, 30)
param OPT_ADV_REACH = Range(0.2, 1.1)
param OPT_ADV_SPRINT = Range(3.6, 5.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 3.14159) until abs(offsetFrom(egoRoute, self)) > 4.5
    do Halt()
