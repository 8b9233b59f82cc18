#: description = "The oncoming car swerves over the centre line and jerks back at once."
#: rephrasings = [
#:   "he yanks it into our lane and straight back out again",
#:   "Vehicle 2 swerved into the opposing lane and immediately steered back.",
#:   "opposing veh, sudden swerve over line, snaps back",
#:   "The oncoming target performs an abrupt double lane change into the lane of the VUT and back.",
#:   "The car jumps suddenly on our side and in one second it's back.",
#:   "A biker dodges a pothole by darting over the line and in again.",
#:   "To miss a dog it flicks across the middle and recovers.",
#:   "A van coming the other way lurches at us, then whips away.",
#:   "the car coming at me flicked over the white line and whipped straight back again, texting I bet",
#:   "The oncoming vehicle veered across the center line and immediately snapped back into its own lane.",
#:   "MC opp.: jerks over line, instantly back.",
#:   "The oncoming target makes a short abrupt excursion over the centre line with immediate return.",
#:   "The car from the front jumps a moment over the middle line and at once he is back.",
#:   "Opposite NPC needs a quick steering twitch into our side and straight out again (< 1 s), not a slow drift.",
#:   "In a heartbeat it had darted over to their half and been snatched away to its own again.",
#:   "He's nodded off there, look, he's twitched over the middle, caught himself and yanked it back sharpish.",
#:   "car coming at us jerked onto our side for like half a sec then back, nearly died",
#:   "An approaching motorcyclist darted over the centre marking and snatched himself back the same instant",
#:   "You were over the line and back again in a heartbeat, would that be fair?",
#:   "Opposite car suddenly twist into our side then twist back, maybe fall asleep",
#:   "He's over the line, he's back, blink and you'd miss it, checking his phone I bet",
#:   "Momentary centre-line departure of opposing vehicle with immediate correction",
#:   "Oncoming driver twitches INTO MY LANE and back out",
#:   "The biker coming our way flinched over the line and back.",
#:   "Oncoming Clio stabs across the centre line, corrects in the same breath.",
#:   "Motorbike opposite: one violent flick to our side, straight home again.",
#:   "Wheel wrenched left, wheel wrenched right: that car facing us.",
#:   "Let the approaching saloon lurch over the middle and recoil instantly.",
#:   "Over the paint and off it within a second, coming at VUT.",
#:   "Something must have run out in front of him, because the oncoming driver tore his car across the white line and hauled it back the very next instant.",
#:   "Vehicle 2 was southbound when it made an abrupt leftward departure over the double yellow and, almost simultaneously, an equally abrupt return to the southbound lane.",
#:   "For less than one second the opposing target shall intrude 1.5 m beyond the centre marking, both the entry and the return being carried out at high steering rate.",
#:   "I need an SUV from the opposite direction that twitches violently over the divider into our half and is back where it belongs before anybody could sound a horn.",
#:   "Der Gegenverkehr, the red car, made a big jump with the steering on my half and immediately a second jump back on the own half, both very hard.",
#:   "My bike-riding brother-in-law reckons it was a wasp in the helmet, whatever it was, he came towards us, darted across the dashes and darted back like lightning.",
#:   "Nothing about the van had looked wrong until it was about forty yards off. Then its nose flicked over the centre line and I could see its whole side, and just as quickly it flicked away again, rocking on its springs, and went by on its own side.",
#:   "If we looked only at the lane position before and after, the opposing car did nothing. In between there are eight frames in which it is thrown a good metre over the line and yanked back at once; that spike is what the AV has to live with.",
#:   "I was in the bus, sitting right at the front, and I saw it! The car that was coming jumped onto our side like a frog, our driver said a bad word, and the car jumped back again straight away, and it was all over before I could scream.",
#:   "Insured states that the oncoming motorcyclist, apparently startled by a pigeon, wrenched his machine over the broken line into the insured's lane. He snatched it away again without delay, but by then the insured had already braked and been struck from behind.",
#:   "You saw how sudden that was? No drifting about, no sleepy wander. He was coming along nicely, there was this sharp jerk over the middle at us, and the same sharp jerk the other way, and now he's passing with both hands on the wheel and a red face.",
#:   "Oncoming moped: a twitch over our line, undone in a blink.",
#:   "Flung across the middle and flung home again, that approaching Seat.",
#:   "Have the facing biker dart over the dashes, instantly correcting.",
#:   "For a split second both right-hand wheels of the approaching taxi were on our side of the paint, and a split second later they had been wrenched off it.",
#:   "An abrupt lateral excursion of the opposing target into the VUT's lane shall be followed, without any dwell, by an equally abrupt return to its own.",
#:   "Did you see that, he tore the wheel over at us, tore it the other way, and now he's passing as if nothing had been!",
#:   "Opposite Swift, God knows, maybe one dog came, he pulled steering to my side and same second only pulled it back to his.",
#:   "Coming the other way, V2 lurched left of the centerline and recovered so promptly that the whole thing fits within twenty-two video frames.",
#:   "A wasp, so the motorcyclist explained, was the reason for his sudden hop into the path of oncoming traffic and the equally sudden hop out of it.",
#:   "Headlights at night tell you everything. His pair had been nicely on the right of mine, they leapt to the left so that they shone me full in the face, and before I could curse they had leapt to the right again. I think he'd dozed off and woken himself with the jerk.",
#:   "I drive the gritter, so I sit high. There was a pothole on his half the size of a bathtub, and he saw it late, the lad in the Corsa that was coming down to meet me. Over my line in one snatch, over his in the next, with the tyres complaining both times, and away.",
#:   "Our AV braked for something that was over before the brakes had built up pressure. The opposing motorbike, which had been going straight, showed a lateral velocity of 3 m/s towards us for 0.4 s and of 3 m/s away from us for the next 0.4 s. After that it was precisely where it had been before.",
#:   "There's a bend by the chapel where the sun gets you. The lady who came towards us had, I suppose, been got. Her little car gave a start, as one does when one is touched on the shoulder, and we had its bumper in our lane; then it started the other way, and we hadn't, and she went by on her own half, pale as milk.",
#:   "Cross-examined, the constable allowed that there had been no drifting. The respondent's vehicle, approaching, had been in its lane; it was then, in consequence of one violent movement of the wheel, partly in the lane of the deceased; and in consequence of a second such movement it was in its lane again, all within one second.",
#:   "If you have to sneeze, slow down first. That's my advice after this morning. A van was coming up the hill, chap sneezed, you could see his head go, and the van went with it, whoosh over the middle and whoosh out of it. He was back on his side before I'd finished saying \"oi.\"",
#:   "For the evasive steering paper the provoking event had to be short. The opposing car keeps to its lane up to a gap of thirty metres. It is then thrown across the centre marking by about a metre and a half and recalled at once, so that an ego which swerves for it does so in vain.",
#:   "Nothing touched, and yet three cars were scrap. The first had shied because of an estate coming from the opposite direction, whose driver, reaching for a bottle on the floor, had plucked the wheel to the left and in the same instant plucked it straight. By the time the brakes squealed the estate was back where it belonged.",
#:   "Il vient en face, tranquille. Suddenly the moto makes a big écart, it is on my part of the route, I see the colour of its eyes if I may say so. And pouf, it is no more there, a second écart has thrown it back on its own part, and we cross each other normally.",
#:   "Sierra three, possible drunk, silver saloon coming from your direction. He's just jinked clean over the centre line at me and jinked straight out of it, in and out quick as a flash, and he's now carried on past me in his own lane. I'm turning round.",
#:   "It was less a swerve than a flinch, with a ton of metal flinching along. From the front seat of the robotaxi she saw the approaching car's flank flash in the sun as it shied across the line, and the flash was put out in the same moment, for the car had recoiled to its half of the road.",
#:   "Facing Mini hops the line, hops home, all in one blink.",
#:   "Our lane, his lane, half a second: that biker flinched.",
#:   "Let the approaching cab twitch across the paint and snap straight.",
#:   "By the time my thumb found the horn there was nothing to hoot at, the oncoming estate had lunged over the middle and was already home again.",
#:   "Two opposite tugs at the wheel, hardly a breath apart, took the approaching hatchback's front across the dashes and out of our half.",
#:   "The opposing target shall cross the centre marking by 1.2 m at a high steering rate and, with no dwell, regain its lane at the same rate.",
#:   "Mosquito, pothole or phone, God knows, but the motorcycle from the front has jumped into my side and in the same jump he was out.",
#:   "You braked for a flash of bonnet, and quite right, but that taxi coming at us has plucked itself back to its own side as fast as it came over.",
#:   "I'd describe it as a hiccup, officer: he was coming along on his half, he was an arm's length into mine, he was on his.",
#:   "The parrot on my passenger seat said a word that I'd rather not repeat. It had seen what I had, namely a radiator where there ought to be open road, and it finished the word after there was open road again. Since the car facing us had whipped back over the line before the bird drew breath, no one believes either of us.",
#:   "Vehicle 1's camera takes thirty pictures a second. In pictures 212 to 219 the opposing motorcycle is in its lane. In 220 to 226 it leans so hard one way that its foot peg sparks, and is on our side of the line. In 227 to 233 it leans as hard the other way. In 234 it's in its lane.",
#:   "There are two black commas on the road by the chapel. The first one curls out over the white line, from his half to mine. The second, which starts where the first ends, curls back. Neither is as long as I am tall. A van coming to meet me wrote them, so quickly that I'd no use of either pedal.",
#:   "Somebody dropped a cigarette in his lap, I would guess. What I could see from the bus was his wing mirrors, as he came. They were level, then the one dipped, and his bumper was this side of the paint; then the other dipped and it wasn't. We went by each other with him patting at his trousers.",
#:   "Watch the gap between his wheels and the line, not his face. It's a foot, a foot, a foot, fine, and now it's minus a yard. See how he's snatched it back? It's a foot again. He had a fright, we had a fright, and nobody needs to do anything further about it, so let your breath go.",
#:   "The judge asked for how long the respondent had been on the claimant's side. \"As long as a sneeze, sir.\" And had he drifted there? He had not; he'd been coming in the opposite direction, perfectly true, when the wheel went hard one way in his hands, and, which the judge might note, as hard the other.",
#:   "A heart doctor would have paid to see my trace. We'd a saloon coming towards us on the long bend, all in order. The safety driver's notes say \"bang, in our lane,\" and on the same line, for there wasn't time for another, \"bang, out.\" The belts had tightened on us for something that by then was going by at a proper distance.",
#:   "From the novel I shall never write: The other car came on, keeping to its part of the road as the moon keeps to hers. It shuddered. For the space of one beat its lamps were in their laps, and the beat after they'd been torn out again and lay on the hedge, where they belonged; it passed them shuddering still.",
#:   "Please find below my request for a \"startle\" actor. It approaches in its own lane. At thirty metres somebody in the back screams, figuratively. The steering goes sharply towards the ego, so that the front wheels come over the divider, and at once as sharply from it. I do not want an arc, I want two corners.",
#:   "What made me put the bike in the ditch was a car that wasn't there. It had been, mind you. It'd been coming the other way, and I'd half of it before my front wheel as if it was thrown there. It had been thrown back by the time I'd picked my ditch. Drivers behind me saw nothing out of the ordinary.",
#:   "El otro me viene de frente, correct on his side. It passes a cat, I suppose. Zas, I have his two wheels in my side. Zas, I don't have them any more. In total it lasts less than the name of the cat. He goes on his way in his lane and I have to stop for drinking water.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "swerve", "turn-back"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 42.0
#: unit = "m"
#: meaning = "distance to the ego at which it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 2.0
#: high = 3.6
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.9
#: high = 1.5
#: unit = "s"
#: meaning = "after how long it swerves back"

param OPT_ADV_SPEED = Range(6, 11)
param OPT_ADV_DISTANCE = Range(18, 42)
param OPT_SWERVE = Range(2, 3.6)
param OPT_STOP_TIME = Range(0.9, 1.5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
