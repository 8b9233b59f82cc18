#: description = "The car overtakes the ego and swerves at it while passing."
#: rephrasings = [
#:   "As he comes past he jerks the wheel at us.",
#:   "While passing, vehicle 2 veered toward vehicle 1 and then straightened.",
#:   "Overtakes with lateral lunge into our lane.",
#:   "During overtaking the target makes an abrupt lateral excursion into the VUT's lane.",
#:   "When he passes he comes to our side and goes away again.",
#:   "A lorry going by gets caught by the wind and lurches over us.",
#:   "The motorcyclist kicks out and weaves at our mirror on his way by.",
#:   "Drawing past, the driver reaches for something and wobbles into our space.",
#:   "As he came by me he gave the wheel a tug and had a go at my wing.",
#:   "While passing, Unit 2 swerved in the direction of Unit 1.",
#:   "Bike overtakes, jerks at us halfway past.",
#:   "During the overtaking phase the target vehicle makes a sudden lateral excursion towards the test vehicle.",
#:   "The car passes me from behind and when it is beside, it steers to me.",
#:   "Overtaker with lateral jab at us mid-pass, doesn't stay level first and doesn't brake.",
#:   "He drew up on her, and in the very act of going by he flung the machine at her door.",
#:   "One coming round you now, watch him, he's swinging in at you while he's still alongside.",
#:   "guy was passing me and mid pass he jerked at my car on purpose",
#:   "While going by, the motorcyclist made a lunge sideways at the car.",
#:   "In the very act of passing, the defendant directed his wheel toward my client.",
#:   "While overtaking that bike suddenly dashed towards my side, almost touched.",
#:   "Halfway past me he has a little lunge at my front wing, charming.",
#:   "Lateral incursion by overtaking vehicle during the passing phase",
#:   "SWINGS AT ME WHILE OVERTAKING",
#:   "The passing car feints at us midway.",
#:   "Coming by, the motorbike veers at my door, then rights itself.",
#:   "Passes us, and halfway through has a swipe at our side.",
#:   "Overtaking saloon: sudden lateral deviation towards VUT whilst alongside.",
#:   "On its way past, the hatchback flinches over towards Granny's car.",
#:   "WHY would you steer AT someone while you're passing them??",
#:   "Let a sports car go past the ego in the neighbouring lane and, before it is through, twitch over in the ego's direction.",
#:   "The rider came from behind, and as his back wheel drew even with my mirror the whole bike darted sideways at me and away again.",
#:   "In passing V1, V2 made a brief steering input towards it, encroaching upon its lane, and went on ahead after correcting.",
#:   "He overtakes me at the left side, and in the middle of it he makes a Schlenker to my side, I was shocked.",
#:   "He's going by you now, hold it steady, he's a road-rage merchant and he's jinking in your direction as he goes.",
#:   "An angry motorist, it is alleged, drove past a pensioner's car and wrenched his estate towards her in mid-pass before speeding on.",
#:   "There's a sort of bully you get on the M6. He comes up behind, goes out to pass you, all normal, and when his back door is level with your front one he gives the wheel a flick at you, just to see you jump, and then off he goes.",
#:   "As the faster vehicle went by the AV on the left, its driver was evidently handling a phone. It lurched to the right, towards the AV's flank, for about a second; he must have looked up then, because it straightened out and completed the pass.",
#:   "I never heard the motorcycle, my ears not being what they were. The first I knew was a black shape going by my window, and hardly was it there than it leapt at me, sideways, so that I cried out. It recovered and was gone up the road.",
#:   "The target vehicle approaches from behind in the adjacent lane at a higher speed. Once its front has gone past the front of the subject vehicle, it deviates abruptly towards the latter for a defined time, then resumes its straight course without slowing.",
#:   "Side wind, that's what he told the insurers, but there was hardly a leaf moving. I had the kids in the back. His van came round us and, while still overlapping my bonnet, hurled itself at us like it meant business, then went straight again and left.",
#:   "Goes by on my outside, flinging itself at me halfway.",
#:   "Passing biker throws his weight our way, then rides on.",
#:   "Overtaking SUV: lunge towards subject's flank mid-pass, then away.",
#:   "He pulled past me nice and easy, and when his rear wheel was about level with my lights he chucked the Beemer at my wing.",
#:   "Have the hatchback pass the ego in the lane beside it and, during the pass, make one brief vicious dart in the ego's direction.",
#:   "She was coming past me, my Granny says, and she dropped her lipstick, and then the whole red car came jumping at our side.",
#:   "Vehicle 2, which was going faster, drew ahead of Vehicle 1 in the adjacent lane and, as it did so, deviated abruptly towards Vehicle 1's fender.",
#:   "The taxi who doubled me had already his nose in front when he gave one coup of the wheel to my side, one moment, and continued.",
#:   "Van's just gone round us, control, and took a swing at us on the way by, no contact, he's carrying on up the road.",
#:   "I'd upset him at the lights, I think, by not going quickly enough. Up he came from behind in the outside lane, window down, and I saw his lips moving as he drew past. Then his hands moved too: the car kicked over at me, so that I felt my own door handle draw in, and it straightened, and that was his farewell.",
#:   "The overtaking itself was unremarkable, the court heard: a clear lane, good light, ten miles an hour of difference. What the prosecution relies on is the second in which, the front of his estate being already beyond hers, the accused turned the wheel in her direction. She put two tyres on the verge. He went on his way.",
#:   "Side clearance is logged for the duration of the pass. It begins at 1.9 m, when the motorcycle's front wheel comes by our rear bumper. It stays there until the machine is nearly through. It then collapses to 0.5 m, recovers to 1.9 m, and the motorcycle pulls away. The speed, on the other hand, never alters.",
#:   "Cycling home along the A-road I had a ringside seat. The silver saloon was steadily overhauling the little Fiat next to me. It had more or less done it when somebody inside must have opened a map, since it sheered over at the Fiat's headlight, like a shark, and sheered back. The Fiat's driver gave it the horn.",
#:   "It was only afterwards, when there wasn't anything beside me any longer and my heart was still going, that I could put it in order. There'd been a rush of air from behind. There'd been a wheel at my window, then forward of my window. There'd been that wheel leaping at me. And then the tail of a pickup, straight as a die.",
#:   "In my operator's chair I've two jobs, watch the road and stay calm. A van was passing our robotaxi on the left, all very civil. With its sliding door just ahead of our sensor it twitched, no, more than twitched, it threw itself over at us for about a second. It then completed its pass. I was not calm.",
#:   "Our podcast guest races karts, and he recognised it at once. \"It's the dummy. You're going by the slower guy, you've got your nose clear, and you feint into him to make him lift.\" All well on a track, but this was a Seat on the ring road, feinting at a mother of three before driving off.",
#:   "Listen to what I say about being overtaken: you hold your speed, hold your line, and keep your eyes moving. That bike's past us now, nearly. And there's why! He's swatting at a fly, and the whole machine has jerked in at our front wheel, and out it goes again. Had you been dreaming, we'd have touched.",
#:   "As in the standard overtaking case the target approaches from the rear in the neighbouring lane and passes. The present case adds a disturbance. When the target leads by the given distance, its steering is offset towards the subject vehicle for a short time, after which the target regains its own lane's centre and goes on.",
#:   "I'm in lorries so they all go past me, I don't even see them any more. This one I saw. A Porsche, up the outside, and just as his boot's coming off my front corner the nutter yanks it over at me. I don't know, a dare? Missed my bumper, got himself straight, and he was gone.",
#:   "A hot wind from the side, I believed, but the trees were quite, quite still. This Hyundai was overtaking from behind and I was politely slowing. When it is nearly finished with the overtaking, suddenly its body comes to me, as if it wants to kiss my mirror. I cried. Then it became straight and went away only.",
#:   "Bike draws past, kicks out at my wing, straightens, gone.",
#:   "Going by me, the estate had a stab at my side.",
#:   "Mid-overtake, SUV lurches our way, then resumes.",
#:   "The gap between his doors and mine, as he went by, was a yard, then a hand, then a yard again.",
#:   "Have a faster motorcycle come through in the next lane and, once its front's beyond the ego's, dart sideways at it for an instant.",
#:   "My husband ducked, indoors as it were, in his own car, because the pickup that was passing us had hurled itself at his elbow.",
#:   "From astern, along our flank, a jink in our direction as its boot cleared our door, and on up the road it went.",
#:   "What's the point of going by me in a perfectly good lane of your own if you're going to throw the car at my mirror halfway?",
#:   "V2 was engaged in passing V1 at a higher speed when it veered momentarily toward V1; without contact, V2 returned to its line and continued.",
#:   "He'd have been out of my life in two more seconds. He'd come up from nowhere in the outside lane, he'd got his back wheel about level with my front one, job done. And there he jerks it at me, you can see the whole van tilt, I'm in the gravel, and off he toddles in his lane.",
#:   "When I'm cycling home there's a draught as each car goes by, and it's always the same draught. This one sucked. That means close. I turned my head to find a door handle by my ear that hadn't been there when the bonnet passed; then it receded, and the saloon it belonged to drew ahead in its own lane.",
#:   "Our lateral radar keeps a minimum for each vehicle that overtakes. For normal people it reads 1.4, 1.5 metres all the way along. For this Kawasaki it reads 1.5 from our rear bumper to our front door, 0.3 by the front wheel, and 1.5 again from there on, until the rider's out of range ahead.",
#:   "Why I know it was on purpose? Because he looked at me. He has overtaken me on the left, already he is with his back at my front, he turns the face to me and then the steering wheel to me, hopp, one time, so that my children cry. Then he drives straight and further, as if nothing was.",
#:   "You felt that wobble in your own hands, didn't you? You flinched, and flinching's natural. Chap's rushing up on your right, he's all but past, and then his front twitches over at you. You don't swing away from it; there's a kerb there. Ease off, let him go, look, he's back in his line already and leaving.",
#:   "It was to be a peaceful ride in the robotaxi. A black coupé had been gaining on us in the lane beside, I remember admiring its wheels as they came level, then slid forward. One of the wheels turned in. For a blink that coupé was coming through our wing; next it was admiring itself in the shop windows, well ahead.",
#:   "Coming past at last, grandad, I told him, so give her a bit of room. He'd no room to give. That hatchback had got most of the way by when it hopped, there's no other word for it, at our front wheel, and hopped off again, and went bouncing away up the lane it had come in.",
#:   "Both lanes are shown in the engineer's sketch. V1's line is straight. V2's begins behind V1, runs beside it, gets ahead of it by half a car's length, and exhibits at that place, and at that place alone, a bulge of about a metre towards V1. Thereafter V2's line is as straight as V1's, and longer.",
#:   "The seat belt bruised me, so hard did our driver brake, and all on account of a motorbike which never touched us. It had come up on the left, faster than we, it was practically by. Then for no earthly reason it flung itself over at our headlamp, hung there an eye-blink, flung itself back and roared on.",
#:   "insulted by my speed i suppose, forty in a forty. theres a beep, a blur to my right, and as the blurs tail gets to my headlight it comes in AT me, real close, like a boxers feint. didnt stay didnt cut in just scared me witless and buzzed off along its own lane",
#:   "The reaction demanded of the automated vehicle is modest: it shall neither leave its own lane nor brake to a stop. A passing vehicle, approaching from the rear in the adjacent lane, gives as it draws clear one short steering impulse toward the automated vehicle, after which it restores its lateral position and departs forward.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "swerve"]
#: maneuver = "straight"
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.0
#: high = 13.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -2.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.6
#: high = 2.5
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_TIME"
#: low = 1.0
#: high = 1.6
#: unit = "s"
#: meaning = "for how long it swerves"

param OPT_ADV_SPEED = Range(11, 13)
param OPT_ADV_AHEAD = Range(-2, 3)
param OPT_SWERVE = Range(1.6, 2.5)
param OPT_SWERVE_TIME = Range(1, 1.6)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do SwerveOnPath(advLane, globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_SWERVE if offsetFrom(ownLane(egoRoute), self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
