#: description = "The oncoming car comes the wrong way in the ego's lane, stops, and backs away."
#: rephrasings = [
#:   "he realises he's on the wrong side, stops and backs off",
#:   "Vehicle 2, travelling the wrong way, stopped and reversed away from Vehicle 1.",
#:   "wrong-way, halts, reverses out of it",
#:   "The target approaches in the lane of the VUT against its direction, stops and moves rearwards.",
#:   "The truck goes in contrary direction, then stands and goes back with reverse gear.",
#:   "A van driving up our lane pulls up and retreats.",
#:   "The bus on the wrong side notices us and rolls backwards again.",
#:   "Seeing the ego, the ghost driver slams it into reverse.",
#:   "twit was coming at me on my side, realised, pulled up and then went backwards out of it",
#:   "V2, traveling the wrong way in V1's lane, stopped and then reversed away from V1.",
#:   "Bus wrong way in our lane: halts, R gear, moves off backwards.",
#:   "The oncoming target in the VUT's lane halts and subsequently travels rearwards, increasing the distance to the VUT.",
#:   "The car comes false way in my lane, stops, and then he goes backward away from me.",
#:   "Ghost driver that retreats: head-on, v=0, then negative v so the gap opens up again.",
#:   "The lorry had met them face to face in their own lane; it stopped, considered, and withdrew the way it had come, tail first.",
#:   "He's come up the wrong side, he's noticed you, he's stopping, and here come the reversing lights: he's giving you the road back.",
#:   "car came the wrong way in our lane, stopped all embarrassed and reversed away",
#:   "A van found itself in the face of traffic, pulled up and withdrew the way it came, backwards",
#:   "Upon finding my client before you in her own lane, you stopped and took your vehicle rearwards away from her?",
#:   "He came opposite in our lane, realise wrong, stop, then gostan all the way",
#:   "Wrong way up my lane, sees the error of his ways, stops, finds reverse and slinks off",
#:   "Wrong-way opposing traffic in own lane with standstill and rearward withdrawal",
#:   "Wrong-way truck realizes mistake and REVERSES OUT",
#:   "The bus facing us in our lane stopped and backpedalled.",
#:   "Van on our side, head-on, pulls up, beats a retreat in reverse.",
#:   "Bus contraflow in ego's lane, halts short, retires rearward, lane clearing.",
#:   "Have a lorry meet us in our own lane, stop, and back away.",
#:   "He drives against us in our lane, stops, then goes away backwards.",
#:   "Cab came up my lane nose to nose, stood, then reversed off sheepishly!",
#:   "The pickup had taken the wrong half of the road and was coming straight at us; it drew up short and then rolled tail-first whence it came.",
#:   "The opposing target travels in the VUT's lane contrary to its direction, decelerates to rest and subsequently enlarges the gap again by moving in reverse gear.",
#:   "He's on your side of the road, that fellow, keep calm. He's stopped, he's looking over his shoulder, and there he goes backwards, problem solved.",
#:   "A truck was falsely in my lane with its front to me. It came to stand, and then with beep-beep it drove in reverse away from me.",
#:   "Would you not have done the same as the coach driver, who on meeting us in the lane that was ours came to a halt and backed off?",
#:   "I want an oncoming hatchback that has strayed wholly into the ego's lane, comes to a standstill facing it, and then withdraws in reverse, leaving the ego unharmed.",
#:   "The claimant was proceeding along Bath Street when she found a delivery van approaching in her lane, against the flow. Both vehicles were halted. The van's driver then engaged reverse and took his vehicle backwards, away from her, for about twenty yards; there was no contact and the claim concerns whiplash from braking.",
#:   "New road layout, I suppose. There was this enormous coach coming at me in MY lane, full of tourists, every one of them pointing. Thank God it stopped. We stared at each other for a tick. Then on came white lights, and it trundled off in reverse the way it had come.",
#:   "Simulator operator's remark on the ghost driver: Opposing car swaps onto our lane at some seventy metres and continues toward us. It brakes to zero at the trigger distance and pauses for a fraction of a second. Then its velocity turns negative, range opens. Ego should hold and must not try to swerve round it.",
#:   "At first I believed I was the one who'd gone wrong, at my age you do. But no, my side was my side, and that lorry was on it, coming up to me with its lamps lit. It stood still. Then, beeping, it grew smaller and smaller, going backward, until I had my road again.",
#:   "Two drunks in a white saloon, said the girl on the cargo bike. They were heading for the robotaxi along its own lane, singing; the song broke off, the saloon dipped and stood. After that she heard the whine you get from a small car in reverse, and saw it shrink away, tail leading.",
#:   "Coach nose-on in our lane, halts, then beeps away backwards.",
#:   "Let a truck meet the ego in its lane, stop, and reverse off.",
#:   "lost hatchback on MY side coming AT me, stops, reverses, bye",
#:   "In our own half of the road we found a tipper coming to meet us; it was braked to a stand, and a moment later it was retreating, tail leading.",
#:   "The target drives contrary to the lane direction in the VUT's lane, brakes to v = 0 ahead of it, and then travels rearward so that separation grows.",
#:   "The bus of tourists was rolling on my hand, the wrong one for him, against me; he has immobilised himself and next he has recoiled in rear gear.",
#:   "Don't move, there's a van coming up your lane the wrong way. Right, it's seen you, it's at a stop... good man, he's taking it off backwards.",
#:   "Sir, in my lane one pickup was coming from opposite, full wrong side; he stopped, put reverse, and went back back back to give me my road.",
#:   "Was it not your own realisation of being head-on in another's lane that made you first stop your SUV and then withdraw it in reverse?",
#:   "Pity the hire-car driver. He had come off the roundabout on the side he was used to at home, which was ours. So there we were with his bonnet pointed at us in our lane, shrinking the road. He got it stopped all right; one could see him slap his forehead; then the bonnet shrank instead, as he backed off.",
#:   "V1 was eastbound. V2, a delivery truck, had entered the eastbound lane westbound in order to reach a driveway, and was approaching V1. V2 was braked to a stop some fifty feet short. V2's operator selected reverse and backed eastward, away from V1, until the distance had roughly tripled. There was no contact.",
#:   "When the fog parted there was a face in it, a flat, wide bus's face, on our strip of road, and getting larger. I had the hand on the horn and left it there. It grew until it grew no more. For one breath it hung; and then, you'll not credit this, it got smaller, since he was reversing into the fog again.",
#:   "I have the right of way, I told my pupil, and you can have that carved on your stone. A cab was advancing at us along our lane, no doubt about it. We stopped, and so, thank goodness, did he. His white lights lit up and off he went rearwards, the way he'd come, craning his neck.",
#:   "Behaviour of the ghost vehicle, in order. One: oncoming, shifts to our lane, so it's now against us. Two: continues until the trigger gap. Three: service brake, standstill, not half a second's wait. Four: reverse, several seconds, range rate positive. The trap is that an ego which swerves at two will look very silly at four.",
#:   "Our Jimmy calls it the day the lorry was shy. It was walking right at us, he says, in our road, not in its road. It looked at us. It stopped. And then it went all backwards and backwards, and went beep, beep, beep, because it was shy.",
#:   "I was riding second behind a white test car on the one lane that goes our way. Towards us in that same lane comes a silver saloon. All three of us have a think about it. He has the first idea: he's stopped. He then has the second, and it's the right one, because he whines off in reverse with his arm along the seat.",
#:   "He had come, this enormous furniture van, a good way along the wrong half of Station Parade, and it was toward Miss Pym's half that he had come. She faced him down. His brakes sighed; he stood, abashed; and presently, stern foremost, gave back to her yard by yard all the road he had stolen.",
#:   "The roadworks signs had blown over, so I don't blame the poor soul. She was coming at my lorry in my lane in her little Yaris. We were both stationary with ten metres in it. I couldn't back up, not with a drawbar. She could, and did; her headlamps withdrew down the road until there was space for the whole circus.",
#:   "Caller on Mill Hill reports that the vehicle facing her in her own lane has gone. It's a red pickup. It'd been coming at her contraflow, it pulled up short of her, and she was about to get out and give him what for. It then made off in reverse down the hill, still facing her.",
#:   "The tape shows the gap better than I can tell it. Forty metres, thirty, twenty: that's the coach, up the wrong lane, ours, and coming. Twenty, twenty: that is the coach standing still. Twenty-five, thirty-five, fifty: that's it going backwards, with the guide waving a flag in the rear window. Throughout, you see its front.",
#:   "Nose to nose in our lane, bus halts, then backs right off.",
#:   "van wrong way at me in my lane, stops, slinks off backwards",
#:   "Contraflow cab in ego's lane: halt, white lamps, gap opens up.",
#:   "The headlights that had no right to be in our lane got larger, held their size for half a breath, and then got smaller again, never ceasing to face us.",
#:   "It took the lorry driver, who was on our side and coming, about as long to stand on his brakes as it took him to find reverse and undo it all.",
#:   "I'm asking for a pickup which heads for the AV in the AV's own lane, draws up short of it, and gives the ground back tail first.",
#:   "The opposing target enters the lane of the VUT against the direction of travel, is braked to zero ahead of it, and, after a brief standstill, is driven rearward.",
#:   "Which way did it go? The same way as it had come, up our lane, only that it came with its bonnet leading and, after it'd stood, left with its boot.",
#:   "He's seen the arrows at last, he's stopped, you can breathe, and those white lamps at his far end mean that he's taking his minibus back out of your lane.",
#:   "You'll find that the tachograph of the coach has a hill, a nought and a little hill. The first hill was done the wrong way up a one-way street, in the very lane which my client was coming down. The nought is where the two saw each other. The little hill was done in reverse, for which my client is obliged to him.",
#:   "The pigeons flew up twice. Once it was from in front of a dustcart, which came up our half of the avenue, face on, as if that were the custom. It was brought to a stand with a good deal of hissing, and they settled behind it. And then they flew up from behind, since it was going away from us with its rear end first.",
#:   "I had begun to unbuckle. You would, with a taxi in your lane whose bumper's coming at yours, and no hard shoulder. He braked, I'll give him that, and stopped with room for a cat. I'd one foot out of the door in order to say something, when his whole face, bumper, lamps and sorry little wave, began to withdraw from me up the road.",
#:   "Range to the oncoming actor, which had occupied our lane at seventy metres: falling at 22 m/s, falling at 12, falling at 6 with the ego braking, constant for four tenths with both of us at zero. And then rising. The ego hasn't moved, so it's the actor that has, and since its heading's the same, it's in reverse. Test passed if we don't evade.",
#:   "It's a funny thing to be beaten to an apology by a truck. I'd pulled up because it was on my side of the cones, coming my way, huge. It had pulled up too. I was hunting for reverse myself, as one of us would have to, when I heard the beep, beep, beep. It wasn't me that was beeping, and the road between us was growing longer.",
#:   "Miss Thwaite did not yield, on principle. The car that approached her did so in the very lane that was hers, against the arrow; it could therefore go back where it belonged. She stopped and looked at it. It stopped and was looked at. In due course its wheels began to turn, the wrong way round, and it bore its red-faced owner off up the hill.",
#:   "Somebody on holiday, by the roof box. I'm coming out of the village with the mixer, and there's an estate car in my lane, heading into the village. Brakes from me, brakes from her. We stood grille to grille. She mouthed \"sorry\", put her arm round the headrest, and I watched her roof box go off into the distance, still facing me.",
#:   "It was dark, so we've only got lamps to go by, my wife and I. Two white ones, in front, on our strip where there ought to have been two red ones. They came. They dipped and came no farther. For a bit there was a glow beyond them, on the hedge behind that car, that'd be its reversing light, and the two white ones drew back from us.",
#:   "V2, a van, was in the westbound lane facing east after passing a closed road. V1, westbound, braked. V2 came to rest 31 feet from V1, by measurement of its oil drip. A second drip, the product of a longer wait, lies 160 feet farther west, to the rear of the first. V2's operator confirms that he had backed to there, away from V1.",
#:   "The bus did like the tide does, Grandpa. It was all coming in, on our side, right up to where we were sitting, and Mummy said \"no no no no no.\" Then it didn't come in any more. And then it went out, and you could see its face the whole time it was going out, and it got little, and there was road again.",
#:   "If you're met head on in your own lane, my learners are told, you brake and don't steer, as you can't know where he will go. Yesterday's proof was a hire van. He came, he stood, and the one place nobody would've had on the list is where he went, which is backwards. Had we dodged to the other side we'd have met a tram for nothing.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "stop", "reverse"]
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
#: low = 12.0
#: high = 32.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 2.0
#: high = 5.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_DISTANCE = Range(12, 32)
param OPT_ADV_BACK = Range(1.5, 4)
param OPT_ADV_BACK_TIME = Range(2, 5)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute)) until self.pose[3] < 0.05
    do Halt() for 0.4 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
