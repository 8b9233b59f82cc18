#: description = "The car in the target lane weaves between lanes."
#: rephrasings = [
#:   "A vehicle swings from side to side and cannot be predicted.",
#:   "The adversary slaloms along, now left, now right.",
#:   "The neighbouring car snakes to and fro across the lane markings.",
#:   "The driver wanders back and forth between two lanes.",
#:   "The lorry sways about its lane as if the driver were drunk.",
#:   "The drunk keeps wandering all over his lane.",
#:   "Vehicle 2 was observed weaving within and out of its lane.",
#:   "The target shows sinusoidal lateral motion.",
#:   "There was a car in the next lane slaloming from one lane to another and back again.",
#:   "Unit 2 was observed making repeated unsafe lane changes back and forth.",
#:   "Adj veh: lane hop L-R-L, over lines, same dir.",
#:   "The target in the adjacent lane repeatedly alternates between lanes.",
#:   "The motorbike in other lane goes always from one lane to the other and again back.",
#:   "Neighbour-lane actor can't keep a lane: serial lane changes back and forth across the dividing line.",
#:   "He darted from one lane to the next and back, stitching his way down the road beside her.",
#:   "He's flitting lane to lane, that one over there, so don't get caught level with him.",
#:   "this car couldnt pick a lane, kept going back n forth n back n forth",
#:   "A van flitted from lane to lane, never settling in either, callers told the station.",
#:   "He took one lane, then the other, then the first again, and so continued, did he?",
#:   "The next-lane car simply changing lane, changing back, changing again, what is this.",
#:   "This lane, that lane, this lane again, he's knitting a jumper out there.",
#:   "Repeated alternating lane changes of vehicle in neighbouring lane.",
#:   "CAN'T PICK A LANE: IDIOT KEEPS SWITCHING",
#:   "The motorcycle stitched its way between the lanes.",
#:   "Hatchback next lane over keeps zigzagging across the dashes.",
#:   "biker alongside swings betwen lanes like a metronome over and over",
#:   "Let the lorry in the target lane wander back and forth across lanes.",
#:   "Adjacent coach lane to lane to lane, cannot be predicted, over.",
#:   "That car there goes wiggle waggle in two lanes, Papa!",
#:   "The pickup where we wished to go would not stay in its own lane but drifted out of it and in again, out and in, all the time.",
#:   "In the lane neighbouring that of the VUT, the target follows an oscillating path whose amplitude takes it repeatedly across the lane marking and back.",
#:   "Don't go over yet, because the van in that lane can't make up its mind: a bit of this one, a bit of that one, forever swaying.",
#:   "The driver on the other lane was surely tired, his bus was going like a pendulum from his lane to the next and always again back.",
#:   "Is that motorcyclist warming his tyres? He's been swinging left and right over the lane line beside us for the last half mile without pause.",
#:   "I did not change lanes since the saloon in the lane I needed was tacking to and fro across the markings like a dinghy in light wind.",
#:   "It was about half past two in the morning and there was only this one van in the lane next to mine. It leaned over the white dashes, leaned back, leaned over, leaned back. I could see the driver's head nodding in time. I rang your people as I dared not go by.",
#:   "Ticket: weaving neighbour. Actor in our merge target lane runs a sine-like lateral pattern that carries it over the lane boundary and back every few seconds, at steady speed. Lane assignment in the tracker flips with each swing and the merge decision with it. Should simply not merge until the thing has calmed down.",
#:   "The police helicopter kept its camera on the silver coupé for nine minutes. During this time, the prosecution says, the car was seldom in one lane for longer than the blink of an eye; it curved from one into another and curved back again, to the alarm of the driver travelling next to it.",
#:   "Thirty years in artics and I know the signs. This other rig, in the lane I was hoping to move to, its trailer's over the line, then it's gone, then it's over again, a slow wag from side to side as if the whole outfit were humming a tune. He's asleep or texting, I said.",
#:   "Dash cam from a reader: the motorbike on the left of the frame, lane beside the cammer. Watch the dashes go under its wheels. There, there, there, there. Never commits to one side, merely swings across and returns, swings across and returns, while everyone around hangs back and prays. Comments: \"free snake charming\".",
#:   "Motorbike in the next lane keeps swaying over the dashes and back.",
#:   "Make the truck in the lane we want wander from lane to lane.",
#:   "bus next to us cant hold a lane, left right left right, scary",
#:   "A hatchback in the neighbouring lane was travelling in long lazy curves, each of which took it across the broken line and each of which brought it home.",
#:   "The target, driving in the lane adjacent to the VUT's, is given a periodic lateral motion large enough to alternate between that lane and the next.",
#:   "The lorry which was rolling in the other lane did a slalom without cones, one time on the line, one time beyond it, and always so further.",
#:   "If you're thinking of moving over, think again: that coach is all over the place, out of its lane, into it, out of it, into it.",
#:   "Was there any half minute in which the pickup occupying the lane next to yours kept to one lane and didn't swing into another?",
#:   "One tempo in side lane is doing like snake, coming this lane, going that lane, coming, going, and I'm not getting courage to change over there.",
#:   "I had my indicator on for two miles and didn't use the lane once. You'd have done the same. There was a Mondeo in it which the driver was steering with his knees, going by the look of it: over the white line, back over, over, back. He was rolling a cigarette, I think.",
#:   "V2 was in the number two lane, V1 in number three. Over a distance of one half mile V2's tires crossed the lane line no fewer than eight times, V2 returning to its own lane after each. Its speed was steady at 55 mph. V1's operator held back and dialled 911.",
#:   "I want to see how long the ego can resist. It needs the lane alongside it; in that lane is a motorcycle that's warming its tyres, swinging across the marking to one side and across to the other, on and on at even speed. A merge is safe only when it's well clear of the thing.",
#:   "The caravan should have told me. It was on the hook of an estate car in the lane beside us, and whatever the estate car did the caravan did afterwards, only more so. What the estate car did was to stray into the next lane and come back, stray and come back, like a man looking for his glasses.",
#:   "From the cab I look down on roofs, and on roofs you can read everything. This one had skis on it. I was about to move into its lane when the skis pointed to the left of me; then they pointed to the right; then to the left, and at each turn they were in a different lane. I put my indicator off again.",
#:   "It's the cat's eyes I heard, da-dum, da-dum, da-dum. Not mine: those of the minibus in the other lane, running over them on its way out of the lane, running over them again on its way in. It never let up. The children in it were asleep and by the looks of it the driver was, too.",
#:   "There's a line in Bauer's diary about the drive to Linz: \"The lane we needed had been let to a lunatic.\" He'd met with a small red van. It didn't so much follow its lane as flirt with it, leaning out into the one beyond, leaning back, with the regularity of a rocking chair, from Wels onwards.",
#:   "Control from Tango Four. White box truck, middle lane of three, I'm in the one beside it. He's drifting out of lane, correcting, drifting out, correcting, I've counted six. Not speeding, not braking. Possibly fatigue. I'll stay back here and keep the public off him until he can be stopped.",
#:   "First I suspected the wind, as the bridge is known for it, but my own car went straight. Only the taxi in the lane to my side was swinging about. Its wheels would be over the marks, then they'd be in again, then over, so I stayed where I was and missed the turning for the airport.",
#:   "My riding group has a name for it, the zip. A guy on a sports bike, one lane across from the robotaxi, stitches the lane line: front wheel to this side of it, front wheel to that, this, that. He's not going anyplace with it. The robotaxi wanted over and gave up on the idea, very wise.",
#:   "In the simulator they gave us a neighbour who is drunk. He stays beside, in the lane where we have to go, and he goes out of it and comes in of it, like a ribbon in gymnastics. I waited one period, two periods, ten periods; the ribbon doesn't end. So the task is: don't change.",
#:   "Next-lane SUV goes dash-hopping, over, back, over, back.",
#:   "bike in the lane we want is slaloming the line nonstop",
#:   "Our target lane's bus can't choose: it, its neighbour, it again.",
#:   "Each time I'd have moved across, the lorry that was in the lane over there had one axle out of it, then had it in, then out again.",
#:   "Give the lane the AV wants a tenant who can't sit still, a hatchback whose wheels are over the stripes and back inside them in an endless rhythm.",
#:   "How do you join a lane whose only occupant, a people carrier, is half the time in it and the other half astride its border, by turns?",
#:   "The target in the lane adjoining that of the VUT travels at constant speed on a sinusoidal path whose amplitude carries it over the lane boundary in every cycle.",
#:   "Like a needle through a hem went the motorcycle in the lane alongside, under the broken line and over it, under it and over it, all through the tunnel.",
#:   "Do not commit to that lane yet, the coach in it is swinging its hips, out past the paint, in, out past the paint, in, and it's not stopping.",
#:   "It rained, and so he wrote it all down for us. You could see in the film of water on the lane over there the two tracks of that taxi's tyres, drawn over the dotted line, drawn back, drawn over it once more, as far as where he now was, drawing. I turned off my indicator. There are folk whom you simply let go.",
#:   "Overlap of the neighbour's box with its own lane, in per cent: 100, 60, 100, 55, 100, 62, and so forth with a period of some three seconds. The lane-change module waits for a stable hundred. It never gets one, and the ego's exit goes by. Nothing else about the pickup is unusual, its speed is as level as a table.",
#:   "Two cups of coffee, and I was watching a ladder. It was on the roof of a van, in the lane to which we had to get, and it pointed now to the one verge, now to the other, now to the one. The van went where the ladder did, through its marking and in again, and my husband, who can be patient, was.",
#:   "As a passenger on the upper deck I felt it in my tea. Our driver had us in the one lane only in theory. The tea went to the left of the cup and he was over the white dashes, it went to the right and he wasn't. A small test car, in the lane beside, had its indicator on for us. It gave up at about the fourth tea.",
#:   "Not drunk, the officers say; he'd been trying to get a wasp out at the window. For about a mile, however, a saloon on the A12 was seen to leave its lane and come home to it, leave it and come home, so that the robotaxi which meant to move in there had to stay out, with a queue at its back.",
#:   "A thing that keeps to its lane can be joined, and a thing that changes its lane can be awaited. What I had over there did each in turn. It was a man on a big Harley; he'd a song in his helmet and he'd lay her over to one side of the line, and over to the other side, and over, in time to it. I'd no heart to hoot.",
#:   "The reflectors on the line went out and came on, one group after the other. It took me some time to see why. There was a dark lorry without lamps, in the lane beside, and when it bellied over the line, it put them out; and when it went in, there they were. Out, on, out, on. I'd wanted to go there! I stayed.",
#:   "In my country a lane is a suggestion and I'm used to it, but this autobus took it as two suggestions. I was looking for place in the track where he went. He gave the place, I prepared, he took it again; he was on his track, he was on two tracks, on his, on two. After the third time one doesn't prepare anymore.",
#:   "Call from a woman who daren't go past, she's got the slip road coming up and needs to be in his lane. It's a white pickup. He's in that lane, he's over the edge of it, he's in it, he's over, like washing on a line, she says. Nobody's been hit. Any unit near the Esso get behind him and find out what he's had.",
#:   "Were I to describe his style I'd say \"skating\". There's the push with the left and the push with the right, and the white line between the two. My coupé and I were in the lane next door, with every wish to come in, and he kept skating, in a minibus, mind, and never stayed with either foot for more than a moment.",
#:   "Logbook, instructor. Pupil asked for lane change, mirror, signal, fine. Held her back. Car over there was on its way out of its lane. Now, she says, as it was on its way in. Held her back. It was on its way out. She sees the system in it by the fifth swing and switches her signal off by herself. Very good pupil.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["weave"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.75
#: high = 1.05
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 5.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(4, 7.5)
param OPT_ADV_AMPLITUDE = Range(0.75, 1.05)
param OPT_ADV_PERIOD = Range(3, 5)

behavior AdvBehavior():
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
