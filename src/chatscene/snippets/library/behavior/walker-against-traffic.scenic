#: description = "The pedestrian steps into the lane and walks along it toward the ego, against the traffic."
#: rephrasings = [
#:   "There's a bloke coming down our lane on foot, straight at us.",
#:   "The pedestrian was walking in the roadway against traffic.",
#:   "ped in our lane, walking toward us",
#:   "The adult target walks longitudinally toward the VUT in its lane.",
#:   "The man goes in the middle of our lane in false direction, to us.",
#:   "A stranded motorist tramps back up the lane with a fuel can.",
#:   "Someone steps off the pavement and trudges to meet us head-on.",
#:   "An old woman shuffles up the carriageway the wrong way.",
#:   "Some fella stepped into my lane and just walked up it towards me, cool as you like.",
#:   "Pedestrian entered the travel lane and was walking in it toward Unit 1.",
#:   "Ped in lane, on foot towards us, steady walk.",
#:   "The pedestrian target enters the lane and walks longitudinally in opposition to the test vehicle.",
#:   "The man goes on my lane and walks to me, against the cars.",
#:   "Walker travels along our lane head-on at walking speed, doesn't cross it.",
#:   "She left the verge, turned to face him and came walking up the middle of his lane as if he were not there.",
#:   "Dispatch, I've got a guy on foot in the lane, strolling into oncoming traffic, coming my way.",
#:   "some dude is literally walking in the lane towards me??",
#:   "A man was seen strolling down the traffic lane into the face of approaching cars.",
#:   "He took to the lane itself and walked up it, with his face to the vehicles bearing down on him.",
#:   "One person is walking in middle of my lane coming opposite, as if it is park.",
#:   "Taking the air in the middle of my lane, he is, ambling up to meet me.",
#:   "Longitudinal walking of pedestrian in own lane in direction opposite to traffic",
#:   "MAN STROLLS DOWN MY LANE TOWARDS ME",
#:   "The man marches up the lane to meet us.",
#:   "Woman leaves the pavement and comes up our lane toward us.",
#:   "Hitchhiker steps out, strolls down our lane to face us.",
#:   "Ped enters ego lane, proceeds on foot contrary to traffic.",
#:   "Have a man step off the kerb and walk at us.",
#:   "FACE TO FACE: pedestrian wanders up MY lane at me",
#:   "An old lady with a shopping trolley stepped down into the lane and set about walking along it, straight in the direction of our bonnet.",
#:   "The adult dummy moves out into the VUT's lane, turns to face it and proceeds along that lane in opposition to traffic at walking speed.",
#:   "he wasnt crossing at all officer he got into my lane and then kept coming up it on foot with his eyes on my windscreen",
#:   "A person goes down from the sidewalk and afterwards is walking in my lane against the sense of the cars, so he comes to me.",
#:   "We met him head-on, if one may say so of a gentleman on foot, he having left the verge and begun to stroll up our lane.",
#:   "Put a walker in front of the AV who goes into its lane and marches up it toward the AV as though it were a footpath.",
#:   "It was getting dark and I nearly didn't see her. A woman with a pushchair came off the pavement into the lane I was in and, instead of going over to the other side, walked along it towards me, right into the traffic.",
#:   "The pedestrian stood at the edge of the road until V1 was near. He then entered V1's lane and turned through ninety degrees, so that he was walking against the traffic and toward V1's front. He did not run, and he did not leave the lane again.",
#:   "There's a big difference between somebody who wants to cross and this chap. He's in your lane, yes, but he has turned towards you and he's walking up it, so he isn't going to be gone in a moment; the gap's closing from both ends.",
#:   "Caller on the coast road says a male, dark coat, possibly confused, has stepped into the carriageway. He's on foot in the caller's own lane and heading toward him, against the traffic, at an ordinary walking pace, and takes no notice of the horn.",
#:   "The soldier slung his bag over his shoulder, got down off the bank and took to the lane. He did not cross it. He walked up it, the wrong way, to meet the headlights, with the even step of a man who has far to go.",
#:   "Chap off the pavement, now footing it up our lane at us.",
#:   "Jogger-gear lady enters lane, strolls contraflow, nearing our bumper.",
#:   "Into our lane on foot, then along it, facing us, unhurried.",
#:   "A rambler got down from the bank into my lane and tramped along it to meet me, as though it were a towpath.",
#:   "Pedestrian leaves the kerb, makes a quarter turn toward the ego on reaching its lane, and advances along that lane at walking speed.",
#:   "Would you step into a lane and then walk up it, with the cars driving at your face, rather than keep to the pavement?",
#:   "One old baba came down on the road and started walking in my lane only, from front to my side, opposite to all vehicles.",
#:   "Have a woman with a pram get into the robotaxi's lane from the side and push it along there, nose to nose with the robotaxi.",
#:   "instead of crossing she hung a turn in my lane and came plodding up it towards my car, shopping bags and all",
#:   "For a moment I took her for a hitchhiker, since she was at the roadside with a rucksack. She then did a thing I've never seen. She set foot in my lane, swung round until she was looking me in the headlights, and came up it at the pace of somebody going to the shops.",
#:   "At no time did the pedestrian make for the opposite side. He descended from the sidewalk into the lane in use by V1, altered his direction by ninety degrees, and walked in that lane toward V1, that is, against the flow. His pace was put at four to five kilometres an hour.",
#:   "Faces are the trouble. If I see a back I know he's going my way and I've time; what I saw in the middle of my own lane was a beard, a lit cigarette and two knees going up and down. He'd come off the verge, and he was walking to where I was coming from.",
#:   "All right, she's in the road, and you've slowed because you suppose she'll be over in a jiffy. Watch her feet, though. They're pointing at us, not at the other kerb. She's walking down our lane and we're going to meet her, so come right down to nothing and let her sort it out.",
#:   "The longitudinal gap is what gives this actor away. It moves in from the edge like any other pedestrian, so one predicts a crossing; thereafter its lateral offset stays constant while the gap to the ego shrinks faster than the ego's own speed can account for. It's walking toward us, up our lane, at 1.4 m/s.",
#:   "My grandson asked whether the gentleman was cross with us. The gentleman, you see, had left the footpath, taken possession of our lane and begun to walk in it in our direction, swinging his stick. We had stopped, naturally. He came on step by step against the whole line of motors.",
#:   "Bus driver's log, 23:40. Young male, no shoes, comes down off the traffic island into my lane. I think he's crossing. He isn't, he's turned this way and he's walking, calm as a bishop, straight up the lane with my headlights in his eyes. I hold the bus and call it in.",
#:   "On a motorway, imagine. There's a dead car on the shoulder, and the owner with the petrol can climbs over into our lane. To walk to the last service station he has to go back, that's toward us. So he goes back, in our lane, one foot, other foot, and the trucks all blowing the horn.",
#:   "The dog was first, on a long lead, and it was in our lane and its nose pointed at us. After the dog came a boy. He had got off the pavement with it, and he didn't want to go across, he wanted to go along. So they both walked to our car.",
#:   "The lane ahead of them went up the hill between its white lines, and down the hill, in it, walked a monk. He had stepped from the grass but a moment before. He never looked to the side at which he might have left it again; he had them in his gaze and kept on toward them, evenly.",
#:   "We both of us got closer, I by driving and he by walking, and I stopped my part of it. He went on with his. He'd stepped out from the lay-by, this delivery man, turned to face the traffic, and was ambling along inside my lane looking for a house number, till he could have touched my mirror.",
#:   "Old chap's in our lane, on foot, coming up to us.",
#:   "Person in lane, facing us, pacing nearer. Not crossing.",
#:   "guy got down into my lane and is now marching at my windscreen",
#:   "We could read his T-shirt first as a smudge, then as letters, as he'd come in from the verge and was strolling up our lane to meet us.",
#:   "She left the footpath, made a quarter turn, and from there each of her steps brought her nearer to our radiator, along our own lane.",
#:   "Lateral offset of pedestrian, once inside the ego lane, constant; longitudinal distance diminishing at walking pace with the ego at rest; face toward the ego.",
#:   "Every vehicle was going his opposite, still that baba got down into my lane and came walking along it towards me only, swinging his umbrella.",
#:   "Could we have a tourist who quits the kerb for the AV's lane and then saunters up it, face on, as if it were the promenade?",
#:   "Not over the road, constable, up it; the man came off the bank into my lane and walked it from the milestone to my front bumper.",
#:   "The soles of her shoes were what I couldn't see. With people who walk in front of you you see soles, at every step. Here I'd toes, coming at me, and knees, and a paper bag held to her chest, in the dead middle of my lane, into which she'd stepped from beside the bins. I stopped and the toes did not.",
#:   "There's only him and us. He has come in off the gravel, which you saw. He's turned to us, which you also saw. So is he going to carry on over to the left? He's had ten paces to do that in, and all ten were in our direction, down the lane. Make it a stop, please, well before he's here.",
#:   "It is said that one should walk at the left side, to see the traffic. This man has understood the rule too well! He saw the traffic excellently, he saw me from so near as you sit there, as he had gone down of the sidewalk into my lane, and made in it his promenade, I north, he south.",
#:   "Twelve strides to the van. He'd worked out that twelve strides, at his easy pace, would bring him from the gap in the hedge, where he'd entered upon the lane and swung about to confront the traffic, to the van's front plate. He hadn't allowed for the van, whose driver had already stopped. It came to fourteen.",
#:   "Our braking distance was eleven metres, he supplied the other six. What I mean is that when we'd come to a standstill the pedestrian was still seventeen metres up our lane, and that a few seconds on he had his hand on our bonnet. He'd come out of the bus shelter, faced us and walked the lane from there.",
#:   "The deceased's brother explained that Albert \"always walked to meet the bus\". That evening too he had got off the pavement by the war memorial; he'd placed himself in the lane the bus would use; and he was proceeding along it in the bus's direction of approach, at his usual gait, lantern in hand, when the driver saw him.",
#:   "Hazard of the month: walkers who do not cross. The radar signature begins like a crossing, with a lateral track from the roadside, but the track makes a ninety-degree bend in our lane. From the bend on it points at us, at a metre and a half per second. There's no gap to wait for; there's only the man.",
#:   "He had his hood up, he had white trainers, and it's the trainers I noticed, going left, right, left, right in my beams. I slowed since I figured they'd go by to the other kerb. They weren't going by anything. They were getting bigger. He'd hopped over the barrier, turned into the traffic, and was hoofing it up lane two at me.",
#:   "I beg you to send someone, she's eighty-nine. She's out of the garden gate and in the road, in the lane on our side, and she isn't trying to get over. She's walking up it, the way the cars come from, to see where they come from, she says. There's a man in a lorry stopped now and she's going right up to him.",
#:   "From the upper deck you'd a good view of it. The lane in front of the bus was clear down to the lights, and there was a drummer in it. He had left his band on the pavement. Drumming, in step, he came up the lane at us while the lights behind him went green, and red, and green.",
#:   "Somebody's dropped a glove, I thought, that's why she's looking down. She had stepped from the traffic island into our lane and begun to walk this way, eyes on the ground, from white line to white line never straying. Cars were braking behind us. At five metres she raised her head, saw what she'd been walking into, and smiled.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: pedestrian walking along road against traffic; own code"
#: [slots]
#: actions = ["slow", "wrong-way"]
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 1.4
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 32.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.8
#: high = 1.8
#: unit = "m"
#: meaning = "how far from the ego's line it turns into the lane"

param OPT_ADV_SPEED = Range(0.8, 1.4)
param OPT_ADV_DISTANCE = Range(32, 50)
param OPT_ADV_REACH = Range(0.8, 1.8)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(1.4) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.57 if offsetFrom(egoRoute, self) > 0 else 1.57)
