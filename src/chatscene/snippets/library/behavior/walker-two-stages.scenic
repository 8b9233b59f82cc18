#: description = "The pedestrian hurries as far as the edge of the ego's lane, waits there, and hurries over the rest in a second stage."
#: rephrasings = [
#:   "She does it in two goes: a trot out into the road, a stop, and another trot past our bumper.",
#:   "The pedestrian crossed in two stages, stopping beside the travel lane before running across it.",
#:   "ped crosses two-phase: run, wait, run",
#:   "The target performs a staged crossing with an intermediate stop alongside the VUT's lane.",
#:   "He runs until our lane, waits, then runs the second part.",
#:   "A nipper scampers out, checks, and scampers on.",
#:   "Somebody with shopping bags jogs part of the way, lets a moment go by and jogs the remainder.",
#:   "One spurt brings the walker to the lane line, another takes them over.",
#:   "She trotted as far as the edge of my lane, waited on the line, then nipped over the rest.",
#:   "Pedestrian ran to the lane line adjacent to Unit 1's lane, waited, and then hurried across the remainder.",
#:   "Ped quick to lane line, waits there, quick over 2nd half.",
#:   "The pedestrian target crosses rapidly to the boundary of the test vehicle's lane, dwells there, then completes the crossing rapidly.",
#:   "Woman runs to the line next to my lane, stands, and after runs the rest.",
#:   "Crosser in two legs: run, dwell just outside our lane, run through it.",
#:   "He did the far half at a jog, stood on the line while she came up, and then did her half at a jog too.",
#:   "He's got himself as far as the middle, he's waiting on the line, mind, he's going for the other half now.",
#:   "she ran to the edge of my lane, waited there, then ran the rest of the way",
#:   "The pedestrian crossed in a pair of dashes with a wait between them at the lane marking.",
#:   "She hastened to the limit of my client's lane, and no farther; there she waited; then she hastened over the remainder.",
#:   "First half she came fast and stood at my lane line, then second half also fast.",
#:   "Scuttles up to the edge of my lane, hangs about there, then scuttles over the other bit.",
#:   "Split crossing of pedestrian in two rapid legs with wait at own lane boundary",
#:   "CROSSES IN TWO INSTALMENTS: dash, wait, dash",
#:   "The woman scurries to our lane's edge, waits and scurries over the rest.",
#:   "Dashes up to our lane, holds at its border, dashes past us.",
#:   "Two hops: kerb to lane marking, pause, lane marking to kerb.",
#:   "Have the jogger rush to our lane line, wait, rush on.",
#:   "Mum with pram trots out, stands beside our lane, trots through it.",
#:   "Stage 1 quick to lane boundary, dwell, stage 2 quick over the remainder.",
#:   "The waiter scurried over the far lanes with his tray, held back at the line that borders ours, and then scurried through ours to the other kerb.",
#:   "The pedestrian target covers the first part at 2.5 m/s, is halted clear of the VUT's lane at its boundary, and after the dwell time covers the second part at 2.5 m/s.",
#:   "I noticed her because she came quickly as far as the white line next to me, stood on it as on a tightrope, and then went quickly over my bit as well.",
#:   "Set up a man with a suitcase who hastens to the side of the ego's lane but not into it, waits there a while and then hastens over what's left of the road.",
#:   "La señora goes rapid until the line of my lane, there she waits very correct, and after this she goes rapid the second part to the other sidewalk.",
#:   "He has run up to your lane and he's stopped short of it, good boy, but he'll want the other half, and now he's running that too.",
#:   "My dispatcher always tells me to watch for people standing on the paint. This one had trotted out from the left, far lane first, and was stood on the line right beside where I'd be driving. He let a second or so go, and then he trotted in front of me and over.",
#:   "Pedestrian 1 crossed in two movements. In the first she jogged from the east curb to the lane line on the left of V1's lane and remained there, outside the lane. In the second she jogged from that line through V1's lane to the west curb.",
#:   "When you're eight you do as Gran does. Gran took my hand and we ran, and just before the part where the car was coming we stopped on the line and she said wait, and I waited, and then she said now and we ran the other part.",
#:   "The crossing is divided like a play with an interval. Act one, the man hurries out, and breaks off at the very margin of the lane the AV is using; interval, he stands there with his toes at the marking; act two, he hurries over that lane and is off.",
#:   "Nasty for a planner, this, since the person who comes up fast and halts neatly at the brink of the ego's lane looks exactly like someone who is going to give way. After the wait, though, she takes off again at the same fast clip and finishes the crossing.",
#:   "Dash, wait on our lane's border, dash: her crossing in brief.",
#:   "Jogs up to our line, holds, jogs over our lane.",
#:   "Two sprints with a breather just outside our lane: that's the jogger.",
#:   "The nurse came over the far half at a trot, waited on the dashes beside our lane until she'd weighed us up, and trotted over our half too.",
#:   "First leg brisk, terminating short of the VUT's lane at its marking; stationary period there; second leg likewise brisk, through the lane to the far kerb.",
#:   "Have a boy scoot over the road as far as our lane, hang back at its very edge for a moment, then scoot through it.",
#:   "She runs, but only until the line where my lane begins, there she is waiting one moment like for a train, then she runs the remaining part.",
#:   "Fast as far as my line, then parked himself on it, then fast again over the last bit, and all without once setting foot in my lane too early.",
#:   "Having hastened to the boundary of V1's lane and stood there for some seconds, the pedestrian hastened through that lane to the north curb.",
#:   "There's a sort of tightrope in the middle of our street, four inches of white paint. The florist came rushing to it with an armful of lilies and balanced on it, just to the left of where my wheels would go. I thought she'd let me by. After two seconds she rushed on, and there were lilies all over my windscreen.",
#:   "Our house looks down on the road and my mother calls it the ferry. People leave this bank in a hurry, she says, and tie up at the line. There they stay a bit, just clear of the lane the cars are in. Then they cast off and hurry over that lane as well, as the man did in front of the shuttle.",
#:   "Pedestrian 1 was observed to go at a quick pace from the west curb to the line separating the two lanes and to wait at that line. V1, in the lane beyond it, maintained speed. Pedestrian 1 then went at the same quick pace through V1's lane, where his bag was caught by its mirror.",
#:   "What's she going to do, the one who's standing with her toes against your lane? Remember how she got there, she ran, and nobody runs halfway over a road in order to stand in it. So she's only taking a breath before part two. And there it is, she's running again, in front of us and over.",
#:   "The tracker shows two ramps and a plateau. On the first ramp the walker covers the outer lane at 2.6 m/s. The plateau lies exactly at the edge of the ego lane, lasting 1.9 s, with the feet never inside it. On the second ramp he covers the ego lane at the same 2.6 m/s and is gone.",
#:   "I play the trombone, so I was careful. I hurried over the first bit with the case in my arms, as nothing was coming on that side. At the white line I pulled up, because something was coming on the other. It looked slow and it hadn't a driver, so when I'd stood long enough I hurried over the second bit.",
#:   "The child in the yellow boots had been told: to the line, and wait, and then on. So to the line she flew, and on the near side of it she waited with both boots together while the car that was coming grew large. And then, because that's what one does next, she flew on, through the very lane it was in.",
#:   "We'd stopped the tram to let him off, and off he went. In quick steps he got over our rails to the edge of the car lane. Good man, I said, he's waiting. He was, but he'd only so much waiting in him; when it was used up he nipped over the car lane too, in front of a robotaxi.",
#:   "Please split the crossing in two. In the first part a pedestrian moves briskly from the kerb up to our lane but not into it. A pause follows, he stands right at the lane's edge. And in the second part, as brisk as the first, he gets across our lane, by which time we'll be rather close.",
#:   "Cyclist here, was behind the car so I'd a good view. The girl ran from the chip shop, she came to a stop on the lane line, right next to where the car was about to pass, and stayed put there with her chips. Then away she ran again, over the car's lane, and into the bus shelter. She dropped three chips in all.",
#:   "Actually madam has done it in two installments. Installment one, she came fast fast up to the line beside my lane and she stood, pallu in hand. I also thought, okay, she will stand. Installment two, same fast fast, from that line across my lane to the temple side. My brake has saved both of us.",
#:   "Quick to our paint, a wait on it, quick through our lane.",
#:   "Trot, toes at the line, trot: that's how Nan crossed.",
#:   "Let him scoot to our lane's brink, hold, and scoot on.",
#:   "She had reached the white line beside our lane at a run and stayed clear of us there, so I forgave her, until she ran again and had to be forgiven for that.",
#:   "The waiting he did was perfect, on the stripe and not an inch over it, only it came between two sprints and the second was through our lane.",
#:   "With her shopping clutched to her she flitted over the empty half, perched on the dividing line to look at us, and flitted over ours.",
#:   "The target covers the first leg at 3 m/s up to the VUT's lane boundary, dwells outside the lane, and covers the remaining leg at 3 m/s.",
#:   "That's him on the dashes, out of your way, and he got there at a jog, so what do you reckon he'll do when he's done looking? Jog, exactly.",
#:   "First he has run until my lane's border, there he was standing like a policeman, and then he has run from there to the temple.",
#:   "The white line had somebody on it. I'd seen him get there, he'd fairly bolted over the other side of the road. He wasn't in my way so long as he stood on it, and he did stand, I could've touched his sleeve in a moment. I had just decided to when he bolted over my side as well, and I went nose down.",
#:   "In the queue at the ferry you get to know people by how they cross. The nervous never leave the pavement. The brave go in one. And this lady in green went in two: she hurried as far as she could without getting into the lane where our shuttle was coming, had her wait there, and hurried through that lane once she'd had it.",
#:   "Note on the dwell position. It matters a good deal that the walker, who has come up at a brisk 2.4 m/s, rests with both feet outside the ego lane, albeit by a hand's breadth. The AV saw a free lane and, rightly, kept rolling. Two seconds on, the lane had a walker in it, brisk as before, bound for the kerb beyond.",
#:   "It takes two green men to get over Harbour Road, but there's no green man at all by the kiosk, so my aunt makes her own. She's quick, as far as the line where the eastbound lane begins. \"Red,\" she says to herself, and stands upon it with her bag. \"Green,\" she says, whatever's coming, and is quick over the remainder.",
#:   "I lost a wing mirror to a cello. Its owner had come hurrying out with it, from the concert hall side, over the lane that was empty. He drew up at the edge of mine. I saw him there, with the thing on his back, sideways, waiting as one should. One, two. And he hurried on, and I was by then rather close.",
#:   "From the depositions: \"He ran up to our lane, then he stayed next to it.\" \"How long?\" \"You could say a Hail Mary.\" \"And he had not been in your lane at all?\" \"Not with a toe.\" \"How then did your bumper come to be touching his suitcase?\" \"Well, he'd finished his Hail Mary, hadn't he. He ran the rest.\"",
#:   "There's a sort of fish that goes dart, hang, dart. We've got them round our pier. When I saw the girl with the ice box do the first dart, over the far lanes, and then hang just short of the one I was driving the coach in, I thought of them, and kept my foot over the brake. And didn't she dart.",
#:   "Sequence to be rehearsed by the stunt walker: off the kerb on the whistle, at a trot; on the mark, which is taped to the asphalt outside the camera car's lane, stop dead. Look at the car. Count two. From the mark, at the same trot, over the car's lane to the other kerb. Don't stop on the car's side of the tape.",
#:   "It was as though the street were a brook with a single stone in it. The messenger made for that stone, in a flurry of small steps, and stood on it, drawn up tall, while on the one hand the water he'd crossed lay quiet and on the other a motor-car was borne down towards him. Then came the second flurry, and the farther bank.",
#:   "On the left half nothing comes, so the man goes fast over the left half. On the right half I come. He sees it and he stands before my half, on the stroke, very disciplined, I make him even a sign for thanks. I think after two seconds his discipline was empty. He went, again fast, over my half, and I have burned my tyres.",
#:   "V1's dash camera depicts Pedestrian 1 in three positions. In the first she is a blur on the far side of the street. In the second, for fifty-one consecutive frames, she is sharp, her heels on the lane line to the left of V1's lane. In the third she is a blur once more, directly ahead of V1, and leaves at right.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "hesitate", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.8
#: high = 4.8
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 20.0
#: high = 46.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.5
#: high = 2.0
#: unit = "m"
#: meaning = "how far from the ego's line it waits"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.6
#: unit = "s"
#: meaning = "how long it waits"

param OPT_ADV_SPEED = Range(2.8, 4.8)
param OPT_ADV_DISTANCE = Range(20, 46)
param OPT_STOP_DISTANCE = Range(1.5, 2)
param OPT_STOP_TIME = Range(0.4, 1.6)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
