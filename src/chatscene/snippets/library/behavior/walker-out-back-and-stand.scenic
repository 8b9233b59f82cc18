#: description = "The pedestrian steps out, steps back, steps out again and then stays standing in the lane."
#: rephrasings = [
#:   "In, out, in again, and then he just stops right there in front of the bonnet.",
#:   "The pedestrian twice entered the roadway and on the second occasion remained in the lane of travel.",
#:   "ped: out, back, out, stands in lane",
#:   "After an aborted first entry the target re-enters and comes to rest on the VUT's centreline.",
#:   "The person comes, goes back, comes one more time and stays on the lane.",
#:   "A dithering walker retreats once, has another go and gets stuck in the middle.",
#:   "Somebody rocks to and fro at the kerb and finally halts in our way.",
#:   "The kid toes the road, hops back, ventures forth anew and freezes.",
#:   "some girl went to come out, hopped back, came out again and then just stood there in my lane like a lemon",
#:   "The pedestrian entered the roadway, retreated, reentered, and remained standing in V1's lane.",
#:   "Ped: out, back, out again, then rooted in lane.",
#:   "The pedestrian target enters the lane, retreats, re-enters and finally remains stationary in the lane.",
#:   "The man goes in the street, goes back, comes again, and then he stands and doesn't move.",
#:   "False start, retreat, second attempt, then v=0 in the ego lane until the end of the run.",
#:   "He had come out and shrunk back, ventured out once more, and then it seemed his courage failed him, for there he stayed.",
#:   "Is she, isn't she: out, back, out... and now she's frozen like a deer in front of you. She isn't shifting.",
#:   "she stepped out, went back, stepped out again and now shes just standing there??",
#:   "A confused visitor came off the kerb, regained it, came off once more and planted herself in the lane",
#:   "Twice you left the kerb, once you returned to it, and the second time you stood fast in the road?",
#:   "She come out, go back, come out again, then stand there like statue",
#:   "Hokey cokey, this one: in, out, in again, and now he's rooted in front of my bonnet",
#:   "Repeated pedestrian entry with one withdrawal and final standstill in lane",
#:   "Pedestrian in, out, in... and then JUST STANDS THERE",
#:   "The walker ventured, recoiled, ventured anew and stuck.",
#:   "Out on the tarmac, back on the kerb, out again: now standing there.",
#:   "Let the walker start, withdraw, start afresh and then remain in the lane.",
#:   "Granny came, granny went, granny came again, and then she didn't move any more!",
#:   "Ped advanced stop withdrew stop advanced anew stop stationary in lane since",
#:   "In lane, off again, in once more, and now rooted. Proceed with care.",
#:   "lad puts himself in the lane, nah, back on the pavement, then enters a second time and just stays there like a post",
#:   "The pedestrian target enters the lane, returns towards the kerb, enters for the second time and is thereafter stationary in front of the VUT.",
#:   "I braked when she appeared, eased off as she skipped back, and had to brake all over again when she reappeared and stayed put in my lane.",
#:   "The pedestrian came off the curb, reversed direction to get clear, came forward again and was standing in V1's lane at the time of impact.",
#:   "He makes two steps on the street, two steps back, again two steps on the street, and this time he remains like a tree in my lane.",
#:   "Did the old man want to cross or not, coming out, going back, coming out afresh and finally settling in the lane like a bollard?",
#:   "I thought she had seen me, because she drew back to the kerb the instant she had left it. So I let the car roll; and out she came for the second time, and now nothing would shift her, she stood in my lane clutching her bag.",
#:   "Two attempts, says the log. The first ends with the person retreating out of our lane; the second begins a moment later and ends with the person standing in it, speed zero, until we have stopped too and the run is over.",
#:   "People waver, and you must give them room to waver. He's out, right, he's gone back, you're tempted to go; and see, he's on the road again, and now he's lost his nerve altogether and is standing in your lane looking at his shoes.",
#:   "According to several onlookers the tourist first set foot in the lane, sprang back when somebody called, and then ventured in anew. On that second occasion he remained where he was, map in hand, while the robotaxi waited in front of him.",
#:   "It was like watching a bather at a cold sea. In she went, and out; in she went again, a shade further, and there she stuck, arms hugging herself, in the middle of his lane, deaf to every word he said.",
#:   "Steps in, nips out, steps in for good, takes root there.",
#:   "Second time lucky? No. Second time she froze in our lane.",
#:   "kid: road. kid: nope, kerb. kid: road again. kid: buffering forever",
#:   "A lady came forward into the lane, withdrew from it, came forward once more and has been standing in front of us from then on.",
#:   "The target carries out an aborted entry with return to the kerbside, followed by a second entry that terminates in standstill within the VUT's lane.",
#:   "He has put the foot on the street, he has pulled it back, he has gone anew on the street, and there he stayed as if nailed.",
#:   "Would you give me a walker who enters, backs out, enters afresh and, having done that, doesn't stir from the lane?",
#:   "Look, he's out; no, he's thought better of it; no, he's out again, and he's stuck fast in your lane, so that's us stopped.",
#:   "P1 moved into the lane, regained the curb, moved into the lane a second time and was standing there, not walking, when V1 arrived.",
#:   "I'd braked once for her already. She'd been in my lane, she'd nipped back to the kerb with an apologetic hand, and I'd changed up again; and then the same red coat was in my lane a second time, only now it had no legs, so to speak, for it didn't move on or back.",
#:   "The tape measure marks two places. One is the kerb, to which the gentleman returned after his first sally; the other is the middle of the claimant's lane, where his second sally had brought him and where he was still to be found, upright and quite motionless, when she stopped.",
#:   "My brother does this with the diving board. The man did it with the road: he went in a bit, he ran back, he went in again, and this time he didn't run anywhere. He stood in front of our car with his arms stiff, and we had to stop.",
#:   "In the trace the lateral offset reads four, two, three and a half, one, one, one, one. So it approaches, it recedes, it approaches further than before, and it sits there. Please check that the AV doesn't treat the recession as permission to resume its speed.",
#:   "The bus queue was shouting advice, half of it stay and half of it go. The poor woman did as each half told her, out into the lane, back among them, out into the lane; at which point she evidently stopped listening and stood there with a taxi hooting at her.",
#:   "My instructor said, wait for the second act. Sure enough, the fellow who'd retired to the pavement the moment he saw us came forth again, and there wasn't going to be a third act, since he was now fixed to a spot in our lane like a parking meter.",
#:   "What made it so nasty for the lorry behind me was that I'd let off the brake. I'd seen the lad jump back to safety, I'd every reason to think that it was settled; but out he popped anew, and he was planted there, mouth open, with the lane all to himself.",
#:   "Tourists, bless them, look the wrong way. This one found herself in the lane, saw her error, and was back on the kerb in a trice; then she looked the other wrong way, advanced again, and upon discovering the robotaxi turned to stone, in the lane, guidebook and all.",
#:   "The door of the shop opened and shut on somebody's nerves. He came into the roadway and left it; came into it anew; and it was on this return that the will went out of him, and she, pulling up, had to look for a long while at a man who neither came nor went.",
#:   "I want to be fair to the old chap. He'd a bad eye. So when he'd ventured into the road, retreated, and ventured in once again, he lost track of where I was, and he did what you'd do in the dark: he stopped where he stood, in my lane.",
#:   "First time he is coming down from divider, I am braking. He is going back, I am happy, I am taking speed. Second time he is coming down, I am again braking, and this man is not going, not returning, only standing in my lane and looking at sky.",
#:   "Road, kerb, road, and there the coin landed on its edge: rooted.",
#:   "Lane, pavement, lane, statue. That's her whole morning.",
#:   "I'd eased off twice for him; second time he took root.",
#:   "The first time, she was gone again before my foot had reached the pedal; the second, she stood there in my lane as though somebody had switched her off.",
#:   "Three footprints out, three back, four out, and no more after that, since the boots that made them were standing in our lane when we pulled up.",
#:   "I'd like a man who's in the lane, then isn't, then is again, and who from that moment on doesn't shift at all, ego or no ego.",
#:   "He'd pulled back to the kerb, so you thought that's settled; it's not, he's come out once more, and this time his legs have gone on strike before you.",
#:   "The pedestrian's first entry was abandoned in favor of the curb; the second ended in V1's lane, in which P1 neither advanced nor withdrew thereafter.",
#:   "One time she showed herself on the street and took herself back, I rolled; a second time she showed herself, and now stood she in my lane like a parked bicycle.",
#:   "The brake lights on the van ahead of my pushbike told it in morse. On: she was in the road. Off: she'd gone back to the pavement and waved him through. On again, and this time they stayed on, because so did she; slap in his lane, bag in both arms, looking at neither him nor me.",
#:   "I have a wife who shops like that. Takes it off the shelf, puts it back, takes it off again, and there she stands in the aisle. It was a road, though, and the lady was taking herself off the kerb. By the time she'd done it for the second time she had no more notion what to do next, and our bus stood too.",
#:   "Two crossings of the kerb line outward and one inward: that's how a person ends up in the lane. The count in the log agrees. What ought to have followed is a third, outward, on the far side, or a second inward; what did follow is eleven seconds of zero velocity in front of the AV.",
#:   "I'd given her my best smile and a nod, and she'd retreated; she was a well-bred person. So I let the clutch in. Perhaps it was the nod that she thought about, for she reappeared from behind the letter box, came as far as my nearside headlamp, a foot beyond it, and became an ornament.",
#:   "Your worship, he says he \"hesitated\". I hesitate over the cheese. He came out of the chemist's into my road, whipped back to the doorstep, had me moving again, came into my road afresh and then did nothing whatever, in the middle of the lane, for as long as it took me to leave my tyres on it.",
#:   "Like the little man in the weather house, I thought. He's out, so it's fine; he's in, so it's not. When he came out for the second time the mechanism stuck. No hooting, no flashing would send him in, and he didn't go on over; he was simply out, arms at his sides, in my bit of road.",
#:   "We got the dog back in the end. It had pulled Gran off the pavement into the road, she'd pulled it back on, and it had pulled her off again. Then it lay down. So there they both were in the lane, Gran holding the lead and not budging an inch, and a robotaxi waiting and ticking.",
#:   "I've forty tonnes and two rules: never trust an empty kerb and never trust a full one. This lad emptied his. He filled it again, sharpish, when he heard me. And once I'd my foot back on the gas he emptied it, got three feet into my lane and just died there, stood up, mouth open, like a waxwork.",
#:   "What was wanted of him he never learned. There were the lamps, growing; there was the stone edge of the pavement, which he had left, and regained, and, hearing someone call, had left anew. Here, upon the wet black middle of her lane, purpose deserted him. She stopped. He stood. Between them the rain came down.",
#:   "People are posting that the car was too cautious. It'd let her go back, it had begun to roll, and I agree that looked fine. Roll on to 0:19, folks. She's in the lane a second time and she isn't leaving it, not for the pavement, not for the other side. She's just, like, installed.",
#:   "On our marriage day my uncle was like this. From hotel gate he came on the road, saw the bus, ran back in the gate. I told driver, go. Driver went. Uncle again came on the road! And now the garland came over his eyes, so he did not run here or there, there in front of bus he only stood.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "hesitate", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.6
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 32.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.4
#: high = 2.2
#: unit = "m"
#: meaning = "how far from the ego's line it first turns back"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 0.9
#: unit = "s"
#: meaning = "how long it waits"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.4
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(2.2, 3.6)
param OPT_ADV_DISTANCE = Range(32, 48)
param OPT_ADV_REACH = Range(1.4, 2.2)
param OPT_STOP_TIME = Range(0.4, 0.9)
param OPT_STOP_DISTANCE = Range(0, 1.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > globalParameters.OPT_ADV_REACH + 0.9
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
