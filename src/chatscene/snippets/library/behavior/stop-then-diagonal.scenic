#: description = "The pedestrian steps out, suddenly stops, and then walks on diagonally."
#: rephrasings = [
#:   "A person enters the carriageway, halts, and goes on at a slant.",
#:   "The pedestrian freezes short of the lane and afterwards cuts across it obliquely.",
#:   "Someone pauses on the road, then sets off at an angle along it.",
#:   "The walker comes to a standstill and continues in a diagonal line.",
#:   "After a sudden stop the adversary drifts slantwise over the lane.",
#:   "He steps off, stops dead, and then wanders over at an angle.",
#:   "The pedestrian halted after entering the roadway and then proceeded obliquely across the lane.",
#:   "ped out, halt, then slanted path",
#:   "She stepped off the pavement, froze, and then wandered off across at a slant.",
#:   "Pedestrian entered the roadway, halted abruptly, then continued at an angle.",
#:   "Ped steps out, sudden halt, then oblique course.",
#:   "The pedestrian target enters the lane, stops abruptly and resumes on a trajectory oblique to the lane.",
#:   "Man comes on street, stops suddenly and then goes on not straight, in the oblique.",
#:   "Crosser: step-out, hard stop, restart with heading skewed along the road.",
#:   "He came out, pulled himself up short, and when he set off again it was on a long slanting line down the road.",
#:   "Lady's stepped out, she's stopped, now she's off again but cutting the corner, going at an angle.",
#:   "she stepped out, stopped all of a sudden, then kept going but like at an angle",
#:   "A woman stepped into the road, pulled up short and then resumed on a slanting course.",
#:   "He entered, he halted abruptly, and when he resumed it was not straight over but aslant.",
#:   "Came on the road, stood suddenly, then went cross-wise in slanting direction.",
#:   "Steps off, stops as if she's left the gas on, then drifts over on the skew.",
#:   "Pedestrian entry with sudden halt and continuation on oblique trajectory",
#:   "STEPS OUT, HALTS, THEN CUTS THE ANGLE",
#:   "The man emerges, halts and then slants away over the road.",
#:   "Walks out, stops dead, carries on at a slant.",
#:   "Man enters the road, freezes, then wanders obliquely over the lane.",
#:   "Let a jogger step out, abruptly halt, then proceed cornerwise.",
#:   "Off the kerb, sudden standstill, away again on a skewed line.",
#:   "She set foot in the road, checked herself, and then slanted across.",
#:   "The old lady left the pavement, came to an abrupt stop as though somebody had called her, and resumed in a diagonal direction.",
#:   "The person goes on the street, suddenly he is standing like frozen, and after that he walks further, but in a slope line.",
#:   "A pedestrian shall enter, make one unexpected halt, dwell, and continue with the heading rotated so that the remaining path runs obliquely.",
#:   "Watch him: he's out, he's stopped short, and now he's moving off again, only on the skew instead of straight over.",
#:   "Why did the boy come out, pull up all of a sudden, and then keep going kind of sideways up the road?",
#:   "The last leg was slantwise: it came after he'd stepped into the carriageway and stood stock-still there for a second.",
#:   "A woman with a pram pushed off the kerb ahead of us. She stopped in an instant, I suppose because of a dropped dummy, and then set out once more, this time bearing away at an angle rather than going square across.",
#:   "The pedestrian stepped from between two parked cars into the roadway and came to a sudden stop. When he began walking again his direction of travel had changed, being approximately forty degrees from the perpendicular, toward the bus stop.",
#:   "Two things fool the tracker here. First the walker quits moving without warning just after stepping out, and we assume a yield. Then she's off again on a heading that isn't the one she arrived with, but cuts the lane diagonally.",
#:   "He got off the pavement with his nose in his telephone. Something on it made him stop as if he'd hit glass; when his legs began again they bore him slantwise, along and over the street together, still reading.",
#:   "My grandson, he is four, let go of my hand and was out on the road. There he stopped, quite suddenly, to look at the car, and then trotted on crookedly, slanting off in the direction of the swings.",
#:   "Out she came, froze, then went on slantwise.",
#:   "One step, two, halt! And off again, skewed up the road.",
#:   "Pedestrian enters, pulls up sharp, resumes along a slant.",
#:   "I'd have the walker leave the kerb, be rooted to the spot all at once, and then cover the rest on an oblique line.",
#:   "He's come off the pavement, he has stood like he forgot the oven, and then he has gone further, but in the diagonal.",
#:   "A lad came out between the parked vans, stopped as if he had met a pane of glass, and bore away at an angle over our lane.",
#:   "Pedestrian dummy: entry into the carriageway, unannounced standstill, dwell, then continuation with heading turned by some forty degrees from the perpendicular.",
#:   "Who stops short after two paces into the road, has a think, and then sets off cornerwise instead of going over like anybody else?",
#:   "The nun took the road in two parts: straight out from the kerb to a sudden stand, and from there aslant, toward the bakery.",
#:   "If he'd only done one thing! I saw him come off the kerb, so I braked. I saw him pull up, all of a sudden, with a hand to his pocket, so I let it roll. And he'd found whatever it was, for he was walking again, though not straight any more; he was cutting along my bonnet toward the lottery kiosk.",
#:   "My granny does it with her trolley. Off the pavement, trundle trundle. Then the trolley stops, then Granny, and nobody in the road knows what's up, the robot taxi least of all. She's only seen that the greengrocer's open. So off they go the two of them, on a slant, up to the greengrocer's.",
#:   "Between the first chalk cross and the second there's a metre and a half, at a right angle to the kerb. On the second, witnesses agree, the deceased's cousin stood for a moment, having halted abruptly. The third cross is on the opposite side, but eleven metres farther up; she had continued, at a walk, in a straight slanting line.",
#:   "You've stopped because he's stopped. Is he looking at us? He's looking at his phone. He marched out, the phone buzzed, and he turned to salt. Wait, he's coming alive. Now mind, he isn't going square over as he was, he's drifting away up the road with every step, look, corner to corner. So still we wait.",
#:   "Ticket, low priority but odd. Person leaves the sidewalk, moving perpendicular to us. Person's speed drops from 1.6 to zero in one frame. We then release the brake since \"person yields\". Person restarts on a heading about fifty degrees off the old one and remains in our corridor twice as long as the map of crossings allows.",
#:   "As I was brought up, one crossed a street by crossing it. This young woman set out from the church door smartly enough. With her foot hardly in my lane she was brought to a stand, I suppose by a thought. When the thought was over she moved off in another direction altogether, along and over at once, like a bishop at chess.",
#:   "Lots of them are like deer, that is my experience with the truck. It comes from the edge, it stays suddenly, it looks in the lamps. Good, I think, now he lets me. The man with the fishing rod however goes again, and he goes not to the other side, he goes to the other side and forward together, crooked.",
#:   "A flute case, a red scarf, new shoes; she'd have been somebody's date. She swept off the kerb before our taxi, and there she stuck, abruptly, one toe pointing. It was the puddle. She took its measure, and resumed her way along the edge of it, which carried her diagonally over the street, far from where she'd been going.",
#:   "V1's driver observed the pedestrian step from behind a mail truck and come to an abrupt halt. He interpreted this as an invitation to proceed. The pedestrian thereupon walked on, \"kind of catty-corner\", in the driver's words, toward a parked vehicle on the far side and some forty feet along, and was contacted at mid-lane.",
#:   "I don't know if you have cats. A cat goes into a room, stops as though it's been switched off, and then leaves it by a corner. That's your pedestrian. He's come out into the road in front of the shuttle, there's the stop, dead sudden, no reason. And then on he walks, cutting over toward the corner.",
#:   "so this bloke steps out. then hes like frozen, proper mannequin challenge. im stood on the brake waving him over. n then he starts walkin but wonky, all the way slantways to the bus stop down the road instead of just across, took AGES",
#:   "Off the kerb, a freeze, then away on the skew.",
#:   "Jogger entered, stood, then cut our lane slantwise.",
#:   "Two steps, sudden halt, and a long oblique exit.",
#:   "She'd stepped down in front of us, turned to stone, and when the stone began to walk it was not over the road so much as along and over it.",
#:   "The dummy enters at a right angle, is halted all at once, dwells, and leaves by a line inclined along the carriageway; make sure that the dwell is visible.",
#:   "He stood there in the road so sharply arrested that I let off the brake, and then he was strolling cornerwise over my bonnet to the cashpoint up the street.",
#:   "From the gutter he comes, he's stopping like somebody called his name, and after he's going further, but in the oblique, to the church door.",
#:   "Whoever chalked the walker's route on the tarmac drew it with a dot in it: a stub out from the kerb, the dot, then a long slant.",
#:   "Had the boy kept to his first direction after pulling up dead in the road he'd have been out of my way, but he set off again toward the corner shop, aslant.",
#:   "Something had rung. It was in her bag, and it caught her with one foot in the gutter and the other well out into the lane; she went rigid, as you do. I was rigid too, with my foot on the pedal. \"Hello?\" she said, and moved, only that by now she'd forgotten the opposite pavement and sauntered off across us toward the far corner.",
#:   "You could make three films from this. In one a man leaves the kerb. It's short. In the next one nothing moves, and since it begins with a jerk you wonder if the player's stuck. In the third he's walking again, and the lamp posts behind him, which stood still in the first film, are sliding by, as he goes over with a lot of along in it.",
#:   "What we see in the bench results is a double failure. After the abrupt standstill just inside the carriageway, the predictor says, he gives way. When the walker resumes it says, he'll leave at right angles, 1.8 seconds. He leaves at forty degrees to the kerb and takes four. The two errors add up to one dented dummy.",
#:   "The old trick with pigeons is to stand still. Dad does it in the middle of roads. Off the pavement he popped, in front of a taxi with nobody in it, and whoa, there's a pigeon, so there he's stuck all of a sudden, on one leg nearly. The pigeon went off slantwise toward the station. So did Dad, after it, at a walk.",
#:   "I counted on politeness. He had come out from behind the skip, seen my lorry, and checked so suddenly that his hat moved; I gave him a flash, as who'd say, you first or me? I'll never know how he read it. He resumed, I grant, but on a fresh heading, slanting down the street away from me, and I'd him in front of my grille for ages.",
#:   "That she had stopped is not in dispute. Both drivers saw it: one pace from the kerb, abruptly, her hands in the air. What they differ about is which way she faced when she set off again. I say her footprints settle it, there was snow. They start out square to the pavement, there's a trampled patch, and they end up going toward the chemist's at half a right angle.",
#:   "In Shanghai the old aunties do like this. First she's coming down to the street, you brake. Then she's standing, very suddenly, because she remembers the soy sauce. You think she'll go back. No. She goes again, but the shop for soy sauce is not opposite, it's over there, so she draws one long slope before all the cars.",
#:   "V1 slowed for a pedestrian who had entered from the right. The pedestrian came to an instantaneous stop approximately four feet into the lane. V1 slowed further, to 5 mph. The pedestrian's gaze was directed to a bus on the far side, well ahead. She then proceeded in a straight line toward that bus, passing obliquely over the lane for about seven seconds.",
#:   "A cyclist has to guess from shoulders. Those of the woman who came off the pavement pointed straight over. They stopped, click, and I guessed she'd seen me. They turned a bit, to the left, up the hill; so when her feet began again it was that way that they went, over and up, and the car beside me, which hadn't been guessing, had to stop.",
#:   "He had once been a dancer. He came down from the kerb before the headlamps of the coach, and it was a step; he held it, without a tremor, for as long as the held breath of fifty tourists lasted; and then he released it, and was borne on a slant, upstage, from one gutter to the other, to where a door stood open.",
#:   "ok pedestrian ai is drunk again. spawns on the kerb, walks out, freezes solid for like a sec and a half. i go aw its letting me pass. then it carries on walking but at a diagonal, miles up the road, i have to brake AGAIN. 10/10 very realistic granny",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["hesitate", "stop", "diagonal"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 24.0
#: high = 56.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.45
#: high = 1.0
#: unit = "rad"
#: meaning = "how far its slanted way turns from straight across"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far from the ego's line it stops"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.5
#: unit = "s"
#: meaning = "how long it stands"

param OPT_ADV_SPEED = Range(1.2, 4)
param OPT_ADV_DISTANCE = Range(24, 56)
param OPT_ADV_ANGLE = Range(0.45, 1)
param OPT_STOP_DISTANCE = Range(1, 3)
param OPT_STOP_TIME = Range(0.5, 1.5)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    # Slanted along the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
