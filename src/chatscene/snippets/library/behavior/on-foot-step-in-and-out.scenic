#: description = "The oncoming pedestrian strays into the ego's lane and withdraws to the edge again."
#: rephrasings = [
#:   "A walker heading our way veers in front of us for a second, then jumps clear.",
#:   "A pedestrian walking against traffic entered the travel lane momentarily and returned to the shoulder.",
#:   "oncoming ped into lane, then out again",
#:   "The target approaches, enters the VUT's lane and leaves it on the same side.",
#:   "The person comes to us, goes into the lane and goes out again to her side.",
#:   "Somebody skirts an obstacle on the pavement by a short detour through our lane.",
#:   "The jogger we meet pops round a puddle and back onto the verge.",
#:   "A rambler lurches out to overtake a friend and tucks himself away again.",
#:   "some bloke walking towards us wandered off the edge into my lane and then took himself back to the side",
#:   "A pedestrian walking against traffic stepped into V1's lane momentarily and returned to the shoulder.",
#:   "Ped facing us on verge: in our lane briefly, then out again.",
#:   "The oncoming pedestrian deviates laterally into the VUT's lane and subsequently returns to the lane edge.",
#:   "A man comes against me on the side, he goes a little in my lane, after he goes back to the side.",
#:   "Walker heading towards SUT: lateral excursion into the lane and back to the shoulder, no crossing.",
#:   "She had been coming along the roadside towards them; her feet carried her out into their path a while, then she drew in again.",
#:   "Lady walking towards you there, she's come out a bit into your side... it's fine, she's tucked herself back in.",
#:   "some guy walking towards us wandered into the road then hopped back to the side",
#:   "A rambler facing traffic drifted off the verge before thinking better of it and regaining the edge",
#:   "You were walking towards the car, you entered its lane, and you then took yourself off it again?",
#:   "Uncle walking opposite side to us came inside the lane, then went back to the side again",
#:   "Geezer walking at me wanders off the verge, sees my face and hops back on it",
#:   "Transient lane incursion by opposing pedestrian with return to the edge",
#:   "Man walks AT my car, steps in the lane, steps out again",
#:   "The walker coming our way dipped a toe in the lane and retreated.",
#:   "Walker facing us slips into our lane, soon regains the road's edge.",
#:   "Oncoming woman with pram: into lane a moment, then verge again.",
#:   "He walks toward me, invades a little my lane, returns to the border.",
#:   "Elderly man, walking our way, steps in, thinks twice, withdraws.",
#:   "Send a pedestrian at us who strays in and retires sideways.",
#:   "A jogger running towards the AV on the hard edge let himself drift into its lane to dodge a hedge, and then got back to the edge.",
#:   "The lady approaching along the roadside wandered before our car as she looked at her phone; she noticed and sidled off to where she'd been.",
#:   "An opposing pedestrian makes a temporary departure from the lane boundary into the path of the vehicle under test and goes back to that boundary.",
#:   "See the lad walking up to meet us? There, he's in your lane to get round the puddle, and now he's out of it again, same side.",
#:   "On a road without pavements an elderly rambler who was coming towards the robotaxi ventured into its way and, a few paces later, left it again.",
#:   "Not across, note, only in and out: a person afoot, headed toward Vehicle 1, entered its lane from the side and quit it by that side.",
#:   "Without a footpath there she had to come along the edge towards me, poor thing, with her bags. Something made her step out into the bit of road I needed. I'd begun to slow down when she saw me and went back in close to the hedge.",
#:   "My client's dash camera shows the man on foot coming to meet the car along the edge of the carriageway. He diverges from it so that for about two seconds he is within the lane, and then makes his way back to the edge he came from.",
#:   "The pedestrian dummy moves parallel to the lane in the direction opposed to the VUT. At the set distance it is guided obliquely inwards until it overlaps the VUT's path, whereupon it is guided outwards to its initial line and resumes its walk along the edge.",
#:   "In Spain we say of such a one that he walks in the moon. He was walking against me by the side of the road, he enters my lane without to look, I blow the horn, and he goes himself out again to his side and greets me.",
#:   "Night shift, no lights, and there's a fella walking up the roadside towards my lorry. Next thing he's meandered out into my lane, right in the beam. He must have felt the air horn in his boots because he was back at the edge sharpish.",
#:   "Walker coming at us drifts into the lane, then drifts out.",
#:   "Facing pedestrian: short stray into our way, back to the margin.",
#:   "Jogger headed our way dips into the lane, retires to the verge.",
#:   "The man walking to meet us let himself be carried into the lane by his dog, and then dog and man were at the edge once more.",
#:   "lady with a stroller coming towards me along the side wandered into my lane for a sec then wandered back to the side",
#:   "The opposing pedestrian enters the VUT's lane at a shallow angle and, before the lane centre is passed, returns to the road edge on its own side.",
#:   "There's an old man coming at you on the left there, he's strayed out, ease off, that's it, he's taken himself in to the grass again.",
#:   "One aunty was walking opposite to us on road edge, little bit inside our lane she came, and then again outside she went, same side.",
#:   "Could we have somebody strolling towards the AV along the edge who blunders into its lane for a few paces and takes refuge at the edge again?",
#:   "It's the brambles, nobody cuts them. She was coming along the side towards my van with her rucksack, and where they hang out furthest she had to leave the side and be in my road for a bit. Past the brambles she was in against the bank again, and she raised her stick to me as we met.",
#:   "Was the pedestrian crossing? No, sir, I want to be exact about it. He was on the edge and coming in our direction; he slanted into the lane, I'd say to the depth of an arm; and he slanted out again to the edge that he had come from.",
#:   "In the recording there are two crossings of one and the same line. It's the edge line on our right, along which a pedestrian approaches us. He crosses it inwards at a range of twenty-five metres and outwards at a range of fourteen, and he has never been near the other side of the road.",
#:   "I was looking at a seagull, I'll admit that. When I looked back there was this hiker who had been well in on the verge, walking up to meet us, and he wasn't well in any more, he was in front of my left headlamp. Dad shouted. The fellow shifted himself out to the verge he belonged on and we rolled by.",
#:   "Non-motorist N1 was walking south, facing northbound V1, on the unpaved shoulder. N1 moved left of the fog line into the lane of V1 for reasons not determined. N1 then regained the shoulder before V1, braking, had reached the location, and there was no contact.",
#:   "The puddle there is as big as a pond after rain. So everyone who walks down towards the traffic does as that girl in the school blazer did, takes a curved way about it. The curve lies in our lane for three or four steps and lands her on the edge again, dry-shod, and I keep my foot off the gas till she has.",
#:   "Ageing is a funny thing, I found myself in the road. I'd been keeping to the side as I always do, with the traffic coming at me so I can see it, and my thoughts were elsewhere. A car slowed right down before me, and I saw that I was in its way, so I got myself over to the side that I'd left.",
#:   "Like the swing of a slow gate, out and home. The oncoming figure, a boy kicking a can, followed the can off the edge of the road and into the lane where our bus was due; the can came back, by luck, to the edge, and he came back after it. Our driver let out his breath.",
#:   "I come with my camion from the front and a man with a bottle walks in my direction, I mean he looks at me, at the border. He makes three steps in my lane, I take the foot away. He makes three steps back to his border, he salutes like a soldier, and I can pass.",
#:   "Expected behaviour for ticket 640: no full stop. The opposing walker will be inside the lane boundary for less than three seconds, because after the excursion it heads outward to the edge it was following. Slowing down is enough; the walker never intends to get over to the far side.",
#:   "Anyone else get these on country lanes? You're riding along, there's somebody on foot coming the other way, on the edge, good as gold. Then they float out in your lane as if you were made of air, and you're just about to shout when they float back to the hedge.",
#:   "Walker facing us: edge, lane, same edge again.",
#:   "Coming our way, he bulges into the lane and unbulges.",
#:   "The hiker meeting us tries our lane, prefers the verge.",
#:   "The dog walker coming up the road to meet us was in front of us for the length of a bramble bush, and on the verge again for the rest.",
#:   "Opposing pedestrian along the lane edge: lateral excursion of one metre into the ego's lane, then return to the original line, walking direction unchanged.",
#:   "why do people do this. walks towards me fine on the edge, floats out in front of my car, sees me, floats back to the same edge, waves",
#:   "Facing the traffic he was walking, very correct, then three steps in my lane for saving his new shoes from mud, then again on the mud side he went.",
#:   "You eased off for a jogger coming towards you who'd strayed into your lane; build up again, as she's gone in to the hedge she came out from.",
#:   "The walker's tracks in the snow came to meet our lorry along the roadside; in one place they bent into our lane, and a stride later bent out.",
#:   "The pram was the first thing in my lane, then the hands on it, then the woman, all of them facing me and getting nearer. I'd the brake half down. And then it went like a film run the other way, the woman was over the edge line, the hands, the pram, and they came on along the gravel as they'd done since the bend, and we passed.",
#:   "What I told the insurance is that nobody crossed anything. A youth was on foot at the side and heading for my bumper, so to speak, with his eyes on a screen. The white line at the edge was first on his right-hand side and then on his left; I used my horn; and then it was on his right again, and my mirror missed his elbow.",
#:   "For a while the minimum lateral clearance to the walker ahead is a comfortable 1.4 m. It falls to minus 0.3, so he'd be hit if nothing changed, and we're closing at the sum of our speeds as he's coming our way. Before the AV has braked to half, it is 1.4 again, on the same side. A short slow-down, not a stop, would be the proper response.",
#:   "There'd been a fall of rocks from the bank, not much, a barrowful. We were driving up and a couple were walking down along the bank. She stopped to let us by, like a sensible creature; he didn't, he walked around the rocks, and \"around\" was where we were. He looked up, gave a skip, and was at the bank once more a pace below them.",
#:   "Any road user may be where he likes to be, so long as he likes it briefly. The gentleman advancing on us along the nearside edge liked to be in the middle of our lane for some three seconds, by the bus driver's watch. The bus driver let it run slower; the gentleman remembered himself, retired to his edge and raised his hat as our windows went by.",
#:   "Court asked me to show it with my fingers, so: this finger's the car and this one's the lady on foot, and they're coming at each other. Hers is along the side of the table. Here it leaves the side, here it's in the way of mine. And here it's at the side of the table again, hers, and mine goes by it, so you see, they never touched.",
#:   "Our village hasn't pavements, it has opinions. My neighbour's is that one walks on the side where one can see what's coming, and so he saw me. He was nonetheless steered by his terrier until he was well within the part of the road that I was about to use. I braked, the terrier changed its mind, and both went back to his opinion, at the side.",
#:   "Night of the match, me on the last bus. I've got one walking at me down the gutter with a scarf on, arms wide, singing. He's out in my beam, both headlights on his belly, so I come right down. But no harm in him, he finishes his verse out there and wanders in to the gutter he'd been in, and he slaps the side as we go by.",
#:   "There stood a tree too near to the street, that's all. The old woman comes on the border with wood on her back, her face to our car. At the tree she has no place, so she comes out in our lane, my wife cries \"Achtung\". Behind the tree she has place and she's again on the border; she's come to us the whole time, never to the other side.",
#:   "An apple had rolled from the bag, and it's odd what one will do for an apple. She'd been coming towards their headlights along the grass. The light had been beside her, and now it was all about her, for she'd followed it out on to the tarmac. Somebody sounded a horn; she went in to the grass, with it or without it, and the light passed by.",
#:   "N1 and V1 were approaching one another. At the first reference point N1 was located on the paved shoulder; at the second, on the travel side of the edge line, in V1's lane; at the third, upon the shoulder anew. V1's operator reduced speed between the second and the third, and N1's direction of walking remained toward V1 at all three.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-back"]
#: position = "oncoming"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 32.0
#: unit = "m"
#: meaning = "distance to the ego at which it enters the lane"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.4
#: high = 1.6
#: unit = "m"
#: meaning = "how far from the ego's line it withdraws"

param OPT_ADV_SPEED = Range(2, 4)
param OPT_ADV_DISTANCE = Range(16, 32)
param OPT_ADV_REACH = Range(0.4, 1.6)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 2 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -2) until abs(offsetFrom(egoRoute, self)) > 3
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1)
