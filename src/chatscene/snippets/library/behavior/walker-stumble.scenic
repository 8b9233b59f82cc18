#: description = "The pedestrian runs across, stumbles and falls in the ego's lane."
#: rephrasings = [
#:   "He's running over, trips on his own feet and goes down right in front of us.",
#:   "The pedestrian was running across the roadway, tripped, fell, and came to rest in lane 1.",
#:   "ped runs, trips, down in lane",
#:   "The target crosses at running speed, loses balance laterally and is stationary in the VUT's path.",
#:   "The girl runs over the street, she falls down and lies there.",
#:   "A jogger loses her footing mid-crossing, reels sideways and collapses on the tarmac.",
#:   "Someone hurrying over slips on the ice, staggers and stays down in the lane.",
#:   "The lad lurches to one side, tumbles and does not get up.",
#:   "A lad came pelting over, tripped and went arse over tit right in my lane.",
#:   "The pedestrian was running across the roadway, tripped and fell in Unit 1's lane, where he remained.",
#:   "Ped running over, trips, down in ego lane.",
#:   "The pedestrian target runs across and falls, coming to rest on the ground in the VUT's lane.",
#:   "The boy runs over the street, his foot catches and he falls and lies in my lane.",
#:   "Crossing runner falls in our lane and stays down; low-profile obstacle, no recovery.",
#:   "He was nearly past her when his foot caught, and down he went full length in front of her wheels.",
#:   "He's tripped, he's gone down in your lane and he's not getting up, stop!",
#:   "he was running over and totally wiped out in our lane n didnt get up",
#:   "A teenager hurrying over the road lost her footing and ended up sprawled before a car.",
#:   "Running across, he lost his footing and lay in my client's lane; he did not get up?",
#:   "One girl was running to cross, slipped and fell flat in my lane only.",
#:   "Legs going like pistons, trips on his own laces and he's kissing the tarmac in front of me.",
#:   "Trip and fall of running pedestrian, person lying in ego lane.",
#:   "RUNNER TRIPS AND LANDS IN FRONT OF MY CAR",
#:   "The crossing runner toppled in our lane.",
#:   "Jogger going over, loses footing, flat on the deck before us.",
#:   "Have somebody race out, catch a toe, and lie sprawling in our lane.",
#:   "Ped was sprinting over, took a tumble, is down, not rising, lane one.",
#:   "La fille court, her shoe breaks, she falls and stays on my road.",
#:   "he ran out then went SPLAT right in front of us stayed down",
#:   "Rushing for the tram on the other side, the clerk put his foot in a pothole and went headlong, and there he lay, in the ego's lane.",
#:   "Target sequence: crossing at running speed; loss of balance with a short lateral stagger; dummy dropped to prone position in the VUT's lane, remaining there.",
#:   "I found a lady lying across my lane when I'd stopped, and I'd watched her get there: running from the pavement, ankle over, and a dreadful crash to the ground.",
#:   "Will he make it, running like that in flip-flops? No, he's come a cropper, he's face down in your lane, and that's where he's staying.",
#:   "The man on the asphalt ahead of the robotaxi had been crossing at a run, and it was a loose paving slab that upended him and left him there.",
#:   "Because her long coat had got between her legs, the woman who was hurrying across in front of V1 pitched forward and ended on the road surface.",
#:   "I'd only just come off the roundabout on my bike. A student came running across with an armful of folders, and I thought he'd beat the car easily. Then he clipped the edge of a drain, did three or four drunken steps and hit the ground like a sack, papers everywhere, in front of the car. He stayed there.",
#:   "The plaintiff does not dispute that he was running. He ran from the eastern pavement into the road, and in the lane of the defendant his foot struck a raised manhole cover. He staggered, fell at full length, and was unable to get himself off the ground, being stunned, before the defendant's car arrived.",
#:   "Low-obstacle case for the perception group. A pedestrian comes across at a run, and we track them without difficulty as an upright figure. In our lane they trip, reel for half a second and go down, after which what's left is a person-sized shape on the tarmac that doesn't move any more. Most classifiers drop it.",
#:   "There was ice about, and I'd told my pupil to expect the unexpected. Over came a woman at a trot, late for work I suppose, and when she got to our lane both her feet went from under her. Down she crashed. She lay there, dazed, and we sat with our hazards on to shield her.",
#:   "She had escaped from the house and she was running, that was all anyone knew, barefoot, over the road. In the beam of our headlamps she seemed to trip upon nothing; she swayed, her arms went out, and she dropped. She didn't stir. Her hand was lying on the white line, palm upward, three yards from our wheel.",
#:   "Jogger crossing, trips, reels, is now lying in your lane.",
#:   "She ran, she tripped, she's flat out before our wheels.",
#:   "kid sprinting across totally ate it in our lane and just lay there",
#:   "The road was wet, his soles leather; of the run that should have taken him to the other side there remained, in our lane, a man on his back.",
#:   "Runner's upright posture is lost in the VUT's lane after a brief sideways lurch, and the target thereafter lies motionless on the road surface ahead.",
#:   "Halfway over, and still at the gallop, the best man trod on his own shoelace, did a couple of crazy sidesteps and measured his length before the wedding car.",
#:   "What the coach driver braked for was a bundle in his lane, which a second earlier had been a woman running for the ferry, till her heel snapped.",
#:   "Let somebody come racing over, lose their balance in our lane with a lurch to the side, and hit the deck there for the rest of the scene.",
#:   "V1 stopped short of a pedestrian who lay prone in its lane, having tripped over a hose while crossing at a run, and who was unable to rise.",
#:   "There's a rail across the road there, from the old quarry line. He'd run over that road a thousand times, his mother said. The thousand-and-first, the rail had him by the toe. I saw his arms go round and his whole body slew to one side, and then he was down, full length, with my front tyres shouting at him.",
#:   "We on the bus thought it was a coat. \"Somebody's dropped a coat,\" a woman said. But there was a man in it. He'd been pelting over from the bank side and something took his legs away right in front of us, and he'd gone down, staggering first, like they do in Westerns, and now he lay there and the coat lay on him.",
#:   "I had a perfect right to be where I was, and so had the ice. I'd got the van down to fifteen. Along comes the paperboy, running, from the left, and in my lane his boots go one way and his bag goes the other. He slithered, he sat, he toppled over. He was still there, poor kid, among his papers when I'd got out.",
#:   "For the jury's understanding, there were in this crossing three phases and no fourth. The deceased ran. The deceased lurched, a matter of half a second, as a result of the kerb drain. The deceased fell. That was in the lane of the accused, and it is in the lane of the accused, on the ground, that the headlamps of the lorry found him.",
#:   "In the simulator he's known as the banana skin. He legs it from the pavement like any other dart-out, and the car has worked out nicely that he'll be through in time. Then in its lane he goes sideways on rubber legs, and he's down. From being a fast tall thing he's become a flat still thing, on the one spot we need.",
#:   "Aiyo, I tell you, the auntie was running with two chickens. Running means really running, bus was leaving. In front of my lorry the slipper broke. Auntie made some steps like drunk person, to this side, then she went down with her full weight. The chickens completed the crossing. Auntie stayed on the road, holding the ankle, crying.",
#:   "You can hear it on the clip, the slap. Before it there's just footsteps, quick ones, from left to right. There's a scuff where the toe catches, three wild ones as he reels off up the lane, and the slap, that's him. After that there aren't any footsteps, since he's lying in front of us with his cheek on the road.",
#:   "The telegram boy was fleet, and the street was narrow; he would have been over it between two breaths, had not a cobble stood prouder than its fellows. It plucked him out of his stride. He swayed along beside our wheel for an instant, clutching at the air, and fell at full stretch, and did not offer to get up.",
#:   "You've covered the brake for a runner, that's good. Now, a runner's someone who might not be running a second from now. This one's caught his foot. He's gone all over the place, he's down! And he's staying down, right there in your lane, winded I should think. So we're stopped, hazards on, and nobody drives round him.",
#:   "She rang from the ambulance to say she was sorry about my bumper, which she'd not touched. I told her not to be silly. She'd been running over to catch the chemist before it shut and put her foot in that pothole. I saw her stagger and go. By the time I'd stopped she was on her side in my lane, unable to move for pain.",
#:   "Fallen runner, night, rain. Detection held until the fall and was dropped within two frames after it. What's lying in the lane has a height of thirty centimetres, and our net has it down as a puddle. It's the same human being who'd been running over the road, stumbled a little way off to the right, and collapsed. Please don't drop them.",
#:   "Pelting over, toe caught, down in our lane, staying down.",
#:   "legging it over then FACEPLANT right in front of us, didnt get up",
#:   "Runner from the left: running, reeling, flat in your lane. Over.",
#:   "There was a slipper standing in our lane and there was a man lying in it, a metre beyond, who until a second ago had been using both to run over the road.",
#:   "Nothing was left above our bonnet, where a running schoolgirl had been about to go by, but her cap in the air, because she'd gone headlong and lay in our lane beneath it.",
#:   "He would have been over with a yard in hand at that speed, had his own bootlace not brought him, arms whirling, full length on to our side of the white line.",
#:   "The VRU crosses at running speed, loses balance in the ego's lane, reels for half a second along it, and remains prone there until the trial is ended.",
#:   "I'd like the jogger's dash to go wrong: over the road at a run, a foot in the pothole in our lane, two wild steps, and down she goes for good.",
#:   "Mind, he's hurrying over with that crate and he can't see his feet... and there he is on his face in your lane with bottles all round him, not moving.",
#:   "My headlamps had him at chest height, going left to right, fast. They had him at knee height, at an angle, arms out like a tightrope walker's. They then had nothing, and it was the dog who told me, standing there on its lead in my lane, with the lead going down and a hand on the end of it. The hand didn't let go. I'd eight feet left.",
#:   "The skin off both palms, the tear in the left knee, the lipstick on the road: all are in the ego's lane and all within the same square yard, and that's where the paramedics met her. The heel that caused it's further back, in the tram groove. Between it and her there are two long scuffs. Up to the groove, the florist says, she'd been running to get over before us.",
#:   "When we test with students they always put their hands out and are up again. I don't want that. He comes at a sprint from the side. In the lane of the test car he treads on something, staggers along a step or so, and what follows is a heap: he's a low, dark, shapeless heap, on the road, for the rest of the run. The detector mustn't lose the heap.",
#:   "On wet leaves, my brother says, one ought to walk. The lady on the wet leaves had heard her tram. We in the van saw first her coat open like a sail from left to right; we saw her shoes, both, higher than her head; then there was a slap, and we saw the tram leave. She was lying where our wheels were going to be.",
#:   "Pedestrian was at a run and V1 was going to pass behind him, it being his evident purpose to reach the opposite curb. That purpose wasn't achieved. The witness in the diner heard \"a sort of bark\" and looked out: the man was skating along V1's lane on one foot, then wasn't on either. V1's skid ends at the sole of the other one. He lay where he was until lifted.",
#:   "Ay, señora, for the bag of oranges! He runs to cross before my taxi, good, he's quick, I do not even brake. The bag breaks. He steps on one orange in my lane, with running you can't choose. He makes a dance, one two, and he's on the floor, on his stomach, and he doesn't get up; the oranges pass by me left and right, I'm stopped like a wall.",
#:   "The examiner noted \"emergency stop, good\". I'd meant only to slow a bit for the lad haring across with his kit bag. Then the bag went on and the lad didn't: it slid over to the far kerb on its own, and he was spread out in front of me with his chin on the road where the strap had tripped him, and he wasn't for rising.",
#:   "So many of you wrote in about the bin bag. Rewind, it's not a bin bag. Eleven seconds in there's a fella galloping over from the chip shop side. Pause. See the stump of the old traffic island, in our lane? His shin does. He goes sort of sideways, and down, and from then on, yes, he does look just like a bin bag. Hence the brakes.",
#:   "I was in the basket of the delivery bike, being six, and had the best view. A policeman was chasing nobody; he was late for his tea. He came thundering over the road before us, buttons and all. Then he trod on his cape. He thundered a bit the wrong way, towards where we were going, and went over like a wardrobe. We waited, but he lay there and said a word.",
#:   "Did she slow? She didn't; she was running until she was falling. Did she get to the other side? No, her handbag did. What did your vehicle do? It stopped short of her, the steward said. And where was she? On the road before it, sir, face down and full length, until the doctor came.",
#:   "Ice had come with the dusk, and the messenger did not know. The street he was flying over was white to the crown; from the crown on, on our side, it was black. He slewed along before the horses' noses, so to speak, clutching at the air, and the street rose and took him. The letter blew on. He stayed.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.8
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.6
#: high = 2.3
#: unit = "m"
#: meaning = "how far from the ego's line it trips"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 1.1
#: high = 1.4
#: unit = "rad"
#: meaning = "how far it reels aside"

param OPT_ADV_SPEED = Range(2.8, 4)
param OPT_ADV_DISTANCE = Range(12, 30)
param OPT_ADV_REACH = Range(1.6, 2.3)
param OPT_ADV_ANGLE = Range(1.1, 1.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # It reels along the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE) for 0.5 seconds
    do Halt()
