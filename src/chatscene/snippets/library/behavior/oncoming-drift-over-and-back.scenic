#: description = "The oncoming car drifts over the centre line and comes back."
#: rephrasings = [
#:   "he's on his phone, wanders over the middle line and then notices",
#:   "Vehicle 2 gradually crossed the centreline and returned to its own lane.",
#:   "opposing veh drifts over the line, corrects",
#:   "The oncoming target slowly departs its lane toward the VUT and returns.",
#:   "The truck comes little by little on our side and later goes again to his side.",
#:   "A dozy lorry driver strays across the line before he pulls it straight.",
#:   "The biker coming the other way takes a wide arc over the dividing line.",
#:   "Sliding gently over onto our half, it eases away again.",
#:   "Someone coming the other way dozed off over the white line and then pulled himself back to his side.",
#:   "The opposing vehicle gradually went left of center and then returned to its lane.",
#:   "Opp. truck sags over CL, corrects back.",
#:   "The oncoming target departs its lane gradually across the centre line and subsequently recovers its lane.",
#:   "The bus against me comes slowly over the middle line and goes back to his side.",
#:   "Opposite actor: slow lateral drift over the centre line with recovery; encroachment is temporary.",
#:   "He must have nodded off, for he slid gently over onto her half, woke with a start, and slid back again.",
#:   "He's wandering over the middle, this one coming, probably on his phone; there, he's corrected himself.",
#:   "oncoming car was slowly floating into our side then went back, prob texting",
#:   "The driver of an approaching lorry nodded off, slipped over the middle of the road and recovered in time.",
#:   "By degrees you left your side, crossed the line dividing the traffic, and by degrees returned?",
#:   "The opposite bus came slowly into my side, must be sleeping, then he went back to his own side.",
#:   "Wanders over the middle at me, eyes on his phone no doubt, then wanders home again.",
#:   "Gradual centreline encroachment by opposing vehicle with self-recovery.",
#:   "ONCOMING DRIVER FALLS ASLEEP, WAKES UP JUST IN TIME",
#:   "The oncoming car leaked over the centre line and ebbed back.",
#:   "Oncoming van floats across the middle, then floats home.",
#:   "Lorry from the front leans gradually over the line, then recovers.",
#:   "Approaching biker eases wide over the dividing paint and returns.",
#:   "Have the oncoming coach stray slowly over centre, then resume its lane.",
#:   "He crept over the white line toward us and crept back.",
#:   "Bit by bit the saloon coming up the hill slid onto our half, and bit by bit it found its own again.",
#:   "A gradual excursion of the opposing vehicle beyond the centre marking is followed by an equally smooth return to its lane.",
#:   "You'll often meet this: the fellow opposite looks at his sat-nav, sags across the line, notices, and steers gently onto his own side.",
#:   "The bus came from the other direction, and slowly, like a boat without captain, it went over the line before it found back.",
#:   "By the time our robotaxi had braked, the pickup approaching it was on its proper side again after wandering half a metre over the centre.",
#:   "Did you notice that oncoming tipper sort of melt over the middle of the road and then put itself right?",
#:   "She was coming round the long bend in a little hatchback, fiddling with something on the seat. I watched the car bleed over the lines inch by inch, hugged the verge, and then watched it ease itself where it belonged.",
#:   "V2, approaching from the opposite direction, was seen to encroach upon V1's lane over a distance of roughly forty feet. The encroachment was progressive, no sharp steering was noted, and V2 regained its lane prior to the vehicles meeting.",
#:   "It was a night of long straight roads and the trucker opposite had surely been awake since Poland. His lights moved over, over, until they were half in front of me; then he stirred, and they slipped away to the right place.",
#:   "I'm asking for an oncoming motorcyclist with a lazy line. He runs a bit wide past the centre stripe, not jerking, just carried out there, spends a second or two on our side, then curves back into his lane.",
#:   "Every evening this coach comes the other direction and the driver is eating. So the coach also is coming little over the centre, little over, then he sees me and little little he takes it to his side.",
#:   "Gently over the dividing line toward us, gently home again.",
#:   "Approaching coach strays onto our half, then mends its ways.",
#:   "Opposing biker's line sagged over centre and slowly recovered.",
#:   "The tanker coming the other way leaned little by little over the paint till I was on the rumble strip; then, at the same lazy rate, it withdrew.",
#:   "For four seconds part of my lane belonged to a saloon from the opposite direction, which had slid over without haste and without haste gave it back.",
#:   "Let an oncoming pickup ooze over the middle line, reach its farthest point as we meet the cones, and ooze back into its own lane.",
#:   "The bus from front is coming slowly slowly over the line, like he's sleeping, after that slowly slowly he is going home in his lane.",
#:   "Lateral position of the oncoming vehicle relative to its lane follows half a slow sine: out over the centre line, maximum 0.9 m, and in again.",
#:   "Did he look up from his phone, do you suppose, before or after that SUV of his, meeting us, had seeped over the middle and seeped back?",
#:   "The gap between its left headlamp and the white line was my measure. On the hill it was a yard; by the chapel it was nothing; then there was no line, the lamp was on my side of it. I had the hedge in my ear by that time. At the bridge, bless him, I could see paint again, and more, and more.",
#:   "No one swerved, I want to make that clear, not I and not he. The wagon simply leaked. It came along from the quarry as they all do, and by degrees its front corner was over on my half of the road; and by degrees, once he'd poured his tea, I suppose, it was gone from there.",
#:   "Our AV slowed to twelve when the motorcycle that was coming up from the valley began to wander. From its own lane it sank, not quickly, toward the centre, over the centre, a hand's breadth, an arm's length; there it seemed to wake, and took the same gentle curve in the other direction. We had stopped by then.",
#:   "She'd wanted to see the lambs, said the lady in the hatchback later, over tea. The lambs were on my side. So her car, which was coming toward mine, had followed her eyes, as cars do, over the centre of the lane and a good way into my half; and when the lambs were done with it had followed her back.",
#:   "Long bend, wet leaves, you on the inside. Here's a van meeting us and I don't care for his line. See? He's running wide, over the stripes, onto ours, nothing sudden about it. Ease off, tuck in. And now he's bringing it back, in his own sweet time. A drifter, we call those. Not a dangerous swerve, only a dream.",
#:   "On night runs you watch the other feller's marker lights. When they stay in a row, he's awake. These ones, coming down from Shap, slid sideways like a tray off a table, right out over the cat's-eyes on my half. I gave him a flash. Took him a moment, then the tray slid slowly back to where it should be.",
#:   "V2, approaching V1 from the opposite direction, was observed on video to encroach gradually upon V1's lane to a maximum of approximately three feet over a period of two seconds. It then returned at a similar rate to its proper lane. No contact occurred there; V1, having steered to the right, sideswiped a mailbox.",
#:   "Every summer the same with these caravans, no, motor homes. One was coming in face of us on the corniche, papa driving, mama showing him the sea. Softly it has slipped over the line, I was seeing already mama's sunglasses. Softly also it has returned, and they never knew we existed.",
#:   "My question for the forum: would your assist have reacted? Oncoming school bus, slow drift, its wheels maybe 70 cm across the double yellow for a couple of seconds, then it eases over to its side again just as slowly. Mine beeped once and did nothing, and I was the one hugging the guardrail.",
#:   "I thought at first that it was the road that moved. The milk truck was coming toward us in its half and then it was coming toward us in rather less of its half, and in some of ours; my sister stopped knitting. The road, if it was the road, moved back. \"Well,\" she said, and picked up the stitch.",
#:   "Scenario from the fatigue set: approaching minibus, steady speed, no braking. Its driver's eyes close. For about two seconds its path bulges into the ego's lane, smoothly, no jerk; the eyes open and the bulge closes, equally smoothly, so that at the point of passing it's back on its own side. Only one such bulge.",
#:   "Half asleep over the line, half awake home again.",
#:   "Approaching coach bulged onto our side and slowly subsided.",
#:   "Sagged over centre, that lorry, then healed itself.",
#:   "I'd a bus coming the other way that lent itself a metre of my lane, for about as long as you'd take to read a text, and gave it back unhurriedly.",
#:   "The line between us vanished by degrees beneath the van that was coming, then by degrees it came out again on the proper side.",
#:   "As the target nears the VUT its path is to swell smoothly beyond the road's middle and shrink as smoothly, being wholly its own before the passing point.",
#:   "What did the motorcyclist do, apart from giving my wife a fright, when he let himself be carried wide over the stripes and then tightened up again?",
#:   "Slowly like the moon he's coming over in my half, this camion from the other direction, and slowly like the moon he's going away from it.",
#:   "Nobody touched anybody, since the old fellow opposite, who'd been slipping across for a good two seconds, noticed the hedge was on the wrong side and slid back.",
#:   "Have you seen a curtain blow in and out at a window? That's how it moved, that white flank. It had been over there with the rest of the oncoming stuff; a breath took it, and it swelled across the paint until I was steering by the ditch. The breath went. It hung straight again by the time I'd to pass it.",
#:   "I was reading his face. You can, on a slow hill. The face was turned to the child in the back, and the car, as they do, was turning with it, inch by inch, till my half of the hill had a good third of a hatchback in it. Then the face came round to the front. It went white, and very carefully it took the car home.",
#:   "The tyres told me, on the rumble strip. First it was his, in the middle, a long purr getting louder as that tanker from opposite leaned out over it toward us. Next it was ours, at the edge, since where else could we go? Ours was still purring when his began anew and then ceased, for he'd come off it on the right side.",
#:   "What do we call it if there's no jerk at the start, no jerk at the end, and a metre of encroachment in the middle? We called it the yawn. The approaching minibus yawns once, over the centre line and back, at a constant fifty; our question is whether the AV, seeing the first half, will bet on there being a second.",
#:   "There was blossom on the bank and she will have looked at it. I don't blame anyone. Her little blue car, that was climbing towards ours, came away from its own edge as gently as a boat from a jetty, and drifted, and was with us; I laid my hand on Edwin's arm. It was gone from our side before I'd found words.",
#:   "Dear claims team, there is no second vehicle to name. It was a lorry, it came from the front, and I have the gatepost on my wing because for three seconds it wasn't where lorries from the front belong. It wasn't sudden. It leaned over the dashes at its leisure, and at its leisure it straightened itself out; we never met.",
#:   "My pupil was steering at it. They all do, you go where you look. \"Left hand down,\" I said, \"and look at the hedge.\" The motorbike that had us hypnotised was running out of bend: further out, further out, both wheels over the middle, ours by a yard. You could see him lean more. Bit by bit he'd hauled it in, and past he went on his own side.",
#:   "V1's front camera shows V2's headlamps to the left of the center line at a range of 110 meters. Over the subsequent 1.8 seconds they migrate across it to a maximum of 0.9 meters; over the following two seconds they migrate back. At no time is there evidence of abrupt steering. V1's right wheels went off the pavement.",
#:   "With us on the mountain the milk collector is a famous man, he has coffee at each farm. Yesterday he had it on the knees. He came down to me, I went up to him, and his truck got always broader on my side, quite comfortable. I stood nearly in the brook. Then he had drunk out, so it seemed, and his truck got narrower again.",
#:   "The point for the defence is that it cured itself. When my client first saw the coach come over the centre she had six seconds; for the first three it went on coming over, gradually; during the next two it was, just as gradually, taking itself off. In the sixth it passed her properly. But by then, m'lud, she was in the orchard.",
#:   "anyone else get these on the a9 at 6am. campervan coming the other way, just sort of floats over the middle, no rush, like its on a river. im hard up against the barrier goin pls no. and then it floats back. i could see him rubbing his eyes as he went past in his OWN lane thank god",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: opposite direction, no manoeuvre; own code"
#: [slots]
#: actions = ["oncoming", "turn-back"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 28.0
#: high = 60.0
#: unit = "m"
#: meaning = "distance to the ego at which it starts to drift"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.5
#: high = 3.0
#: unit = "m"
#: meaning = "how far it drifts"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 5.0
#: high = 8.0
#: unit = "s"
#: meaning = "twice as long as it is off its line"

param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_DISTANCE = Range(28, 60)
param OPT_ADV_AMPLITUDE = Range(1.5, 3)
param OPT_ADV_PERIOD = Range(5, 8)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for 0.5 * globalParameters.OPT_ADV_PERIOD seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
