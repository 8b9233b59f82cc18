#: description = "The pedestrian shuffles across slowly, stops for breath in the lane and shuffles on."
#: rephrasings = [
#:   "The old dear creeps over, has a breather in the middle and creeps on.",
#:   "The elderly pedestrian paused in the lane while crossing slowly and then resumed walking.",
#:   "slow ped, rests mid-lane, goes on",
#:   "The target crosses at 1 m/s with one interruption within the VUT's lane.",
#:   "The grandfather goes slow, must make a pause, goes slow again.",
#:   "A lady with a rollator inches over, catches her breath and inches further.",
#:   "He hobbles off the pavement, leans on his stick a while and hobbles the rest.",
#:   "Plodding across, the frail walker takes a little break just where we want to be.",
#:   "This poor old thing was shuffling over with her stick and had to stop for a breather in my lane.",
#:   "Elderly pedestrian crossing slowly, paused to rest in the travel lane, then resumed at a slow pace.",
#:   "Old ped, slow, rests mid-lane, then slow again.",
#:   "The elderly pedestrian target crosses at reduced speed with one rest period within the lane.",
#:   "Grandfather goes slow over the street, in the middle he is tired and makes pause, then goes slow on.",
#:   "Slow crosser, one long dwell in our lane to recover, then same low speed.",
#:   "Halfway over he leaned on his stick and puffed, and they waited till he had wind enough for the rest.",
#:   "Give the gentleman a moment, he's only small steps, he's stopped to get his breath, there, he's off again.",
#:   "this old man had to take a break halfway across, i felt bad",
#:   "A frail pensioner halted in mid-road to recover her strength and then resumed her slow progress.",
#:   "The old gentleman, walking feebly, was obliged to rest in the lane before he could go further.",
#:   "Ah gong walk halfway tired already, stand there take breath, then slowly walk again.",
#:   "Poor old girl runs out of puff in front of my cab, has her minute and then hobbles on.",
#:   "Slow crossing of infirm pedestrian with recovery stop in own lane",
#:   "GRANDPA TAKES A BREATHER IN MY LANE",
#:   "The pensioner hobbles out, pants awhile in the lane and hobbles on.",
#:   "Elderly lady, small steps, stops to puff in lane, small steps onward.",
#:   "Let some frail person toddle over, rest before us, and toddle on.",
#:   "Grandma went slow, then had a little rest, then went slow again.",
#:   "La señora walks despacito, in my lane she takes air, then despacito continues.",
#:   "Slow walker, winded, standing in lane... and moving again, same dawdle.",
#:   "A man with an oxygen bottle came dragging his feet into our lane, stood there until his chest stopped heaving, and dragged them on to the far side.",
#:   "She's taking it gently, bless her. She's had to pull up in your lane to get her wind back. Right, there she goes, gently as before.",
#:   "Pedestrian target: traverse at 0.8 m/s, one dwell of 4 s inside the VUT's lane representing exhaustion, traverse continued at 0.8 m/s.",
#:   "It wasn't confusion that made the old boy stand still before the robotaxi, merely lack of puff, and once he'd recovered he tottered along as slowly as ever.",
#:   "Did the deceased's neighbour, crossing at a feeble pace, not have to remain in the lane to recover her breath before she could plod on to the other kerb?",
#:   "Heavily pregnant and laden with bags, the woman waddled into the lane, needed a moment there with one hand on her back, and waddled on.",
#:   "I am that old woman, so let me explain. My hip won't go faster than it goes, and halfway across your lane it was my lungs that gave up, so I had to stand for a bit and pant. You were kind enough to wait. Then I got along, one little step after another, and thank you.",
#:   "The pedestrian, who used a walking frame, advanced into the roadway at a very low speed. In the lane of Vehicle 1 he became short of breath and ceased walking for some five seconds, supporting himself on the frame. After this interval he moved on, as slowly as at first, until he was across.",
#:   "I'd like our car to be tested for manners. Somebody old and out of condition makes their way over, hardly lifting their feet, gives out just when they're in front of us, and needs several seconds to collect themselves. When they've got their strength back they make their way to the other side, no faster.",
#:   "He walked as very old sailors walk, each step a negotiation. In the middle of our lane the negotiations broke down; he stood, one hand on his chest, drinking the air in great gulps, and no one in the line of cars dared to hoot. By and by he took up his journey, an inch at a time.",
#:   "We delivery riders are always rushing, so I felt a bit ashamed. This granddad with two sticks was in the lane already, going at maybe half a step a second. Then he stopped to catch his breath, looked at us both, me and the car, shrugged, and in his own good time pottered off to the far kerb.",
#:   "Old man crossing: feeble steps, a blow mid-lane, feeble steps again.",
#:   "nan shuffled out, ran out of breath in our lane, shuffled off",
#:   "Lady with trolley: slow, winded, standing in lane, recovered, slow again.",
#:   "It was her lungs that divided the crossing into two parts, each as slow as the other, with a good long gasp in our lane between them.",
#:   "Frail VRU, low gait velocity; dwell inside the VUT's lane to regain breath; gait resumed at the same low velocity until the far kerb.",
#:   "A stout priest, creeping over the road in the heat, gave out before our bumper, fanned himself until his colour returned, and crept on to the shade.",
#:   "Would the witness confirm that the deceased walked haltingly into the lane, halted there to draw breath, and only then completed the way at the same weary gait?",
#:   "Have a woman on crutches set off over the street with tiny steps, stand puffing in the ego's lane for a while, and then finish with steps just as tiny.",
#:   "He's not messing you about, driver, he's got a bad chest; give him his minute there in front of you and he'll toddle the rest, same as he started.",
#:   "Emphysema, he told us later through the window. I'd only seen a very slow man. He slid one slipper out into our lane, and then the other, and then nothing slid any more and his shoulders were going up and down. We turned the radio off for him. After a bit the first slipper set out again, and the other followed, to the far side.",
#:   "Pushing ninety and pushing a pram, that was Mrs Doyle, with the coal in it. She came off the kerb no quicker than the coal would let her. In our lane she leaned on the handle and I could hear her whistle, she was that short of wind. When she'd whistled enough she gave the pram a shove and crawled away with it to number 12.",
#:   "The shuttle's waiting time at the pedestrian was nineteen seconds and passengers have asked why. Breakdown as follows. Five seconds, person advances into lane at half a metre per second. Eight seconds, person stationary in lane, bent over, hands on knees, breathing hard. Six seconds, person advances out of lane at half a metre per second.",
#:   "My uncle has one lung only, and he crosses with one lung only. So you must not make horn. He will come into your lane like the moon comes, very slow. There his air will finish. He'll hold his knee, he'll take air, take air, take air. Then again like the moon he'll go, and he will thank you from the other side.",
#:   "Two buses, a fire engine and a hearse were held up in Castle Street by Miss Ivy Platt, 97, on her way to collect her telegram. Miss Platt \"doesn't do fast\". She does do breathers, and took one in the westbound lane, leaning upon her umbrella, before carrying on to the post office, reporters said, at \"the same stately dawdle\".",
#:   "That isn't dithering, and I'd like you to see the difference. When folk dither they look at you. This lady's looking at the ground, because each inch is hard work. She's had to stop, right in front of us, and you can see the poor soul's ribs heaving. She's all right. There go the feet again, inch, inch, inch, to the bollard.",
#:   "Lorry driver's diary. Had to stop at the foot of Gold Hill for an old boy with a sack. He dragged across as far as my near headlight. There he let go of the sack and held on to my bull bar, if you please, and blew like a whale for a while. Patted the bar. Picked up the sack. Dragged on over.",
#:   "It's a test of the timeout. The robotaxi yields to someone very slow, which it does well. The someone comes to a stand in its lane, simply because they're exhausted. After four seconds the robotaxi believes that they've given it the road. And that's the moment when they've got their puff back and start to shuffle again for the opposite side.",
#:   "I am not so young, I had my operation in spring, and this street is broad as the Rhine. I make small steps. In the middle of the car's lane my heart was knocking in my ears, so what should I do, I stood and I waited until it knocked less. Then I have made the other small steps. He didn't hoot, the gentleman.",
#:   "The cyclist's helmet camera gives the sound as well. There's the tap of a stick, with long gaps. Tap. Tap. When the figure is in front of the blue car the taps cease, and for some six seconds there's only wheezing. Someone calls, \"Take your time, my darling.\" And then it begins once more, tap, tap, no brisker, and fades to the left.",
#:   "Between the two kerbs there was for him a kind of island, though no mason had built it. It lay in our lane, and it was made of want of breath. He gained it at a creep. He rested there, grey in the face, among the headlamps, as castaways rest; then he let himself down from it and at a creep made for the mainland.",
#:   "Old boy: inches over, gets his wind mid-lane, inches on.",
#:   "nan shuffled out, had a lil rest in my lane, shuffled off",
#:   "Frail ped, slow; now halted, puffing, in your lane; slow again. Over.",
#:   "We saw the walking frame go down, and go down, and then for a good while not go down, right before us, while its owner wheezed; and then go down again.",
#:   "She'd all the time in the world getting to the middle of our lane, took some more of it there with a hand on her heart, and spent what remained on the other half.",
#:   "It wasn't on our account that the old priest had halted where he halted, in front of the bus; he was getting his puff back, and he then tottered on as before.",
#:   "The VRU target moves transversely at 0.4 m/s, is held inside the subject vehicle's lane for three seconds to represent breathlessness, and completes the transit at 0.4 m/s.",
#:   "Could we have an elderly gent who hobbles into our lane, leans on his brolly there until his chest has stopped heaving, and hobbles the remaining distance?",
#:   "Don't creep up on him, he's not done: he's as far as your lane on those poor legs, he's blowing, and when he's blown he'll drag himself over to the other pavement.",
#:   "Tap, scrape; tap, scrape. I'd my eyes shut in the back of the cab, so that's all I had of it, a stick and a bad foot, coming nearer. In front of us it left off. Someone was breathing out there, hard. The driver switched off the meter. It must've been a minute before it began again, tap, scrape, and went off on the other side.",
#:   "Three passages in the pressure mat: footfalls 1 to 9, one every second and a quarter, stride under thirty centimetres. No footfall for the next five seconds, with the whole weight on numbers 8 and 9, mid-lane. Footfalls 10 to 21, one every second and a quarter once more. The microphone has laboured breathing in the second passage. Ego at rest throughout, correctly.",
#:   "The climb's what does it, for the church is on the high side. She'd started at the low side, with a wreath. Ten little steps brought her and the wreath as far as my bumper. There she put it down and put both her hands in the small of her back, and took the air. Then up with the wreath, \"thank you, young man\", and ten little steps more.",
#:   "We in the queue couldn't understand the lorry. It had let the old fellow come on to the road, hardly lifting his slippers. It had let him come as far as its grille. But then there was nobody moving in front of it at all, and it stayed put! From his cab he could see him bent over, gasping, one hand on the badge. After that the slippers took him away.",
#:   "Mein Herr Doktor has said to me: Frau Kling, you go always only so far as the air goes. The air went to the second lane. So I remained standing there, in front of a car which had no driver, and I have fetched new air. It waited. I have thanked it. With the new air I went on, exactly so slowly as before, until the pharmacy.",
#:   "Of the delay of ninety seconds, thirty were the outward shuffle, kerb to lane; twenty were asthma, in the lane, inhaler in hand; forty were the rest of the road. I give these figures because my colleague maintains that the lady \"stood about\". There was nothing undecided in her. She'd never looked our way. She set off again as soon as, and no faster than, her lungs let her.",
#:   "My sister's got one of those oxygen bottles, on wheels. When we go over the road it's me, the bottle and her, and we go at the speed of the bottle. In the middle it beeps and then we've got to stand. The cars can hoot. One stopped, and we stood, and she breathed, and I waved at it. Then it stops beeping and we go on slow like before.",
#:   "What use is a gap of thirteen seconds? my pupil asks. I can go round. But he'd said that when the chap with two shopping bags was on the line; then the bags went down on the ground. There, in front of us. Chap's rubbing his fingers, chest like a bellows. You'd have been going round him when the bags came up. Off he trudges now, no quicker.",
#:   "At the foot of page two the deceased's widow is asked if he often rested. He did, she says, he'd a heart. He'd go along at a creep, then he'd be a tree for a bit, then he'd be along again at a creep. And so it was that night, by the bus driver's account: the creep, from the left; the tree, in the headlights; and the creep again, to the right.",
#:   "Cortège passing a cortège! We'd the hearse out, empty, and some very old person in a fur coat going over the road at about our own best pace. Right in front of the hearse this fur coat came to a standstill. You never saw two undertakers look so worried. She'd her hand up: one moment, I'm only getting my breath. She got it, too, and toiled away to the cake shop.",
#:   "If you've ever seen a beetle on a garden path you have it. He advanced by the width of a hand. In the course of time he was before us. Then some spring in him had run down; he stood in the glare of our lamps, and we heard the air whistling in and out of him. It was wound, by and by. He advanced by the width of a hand.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "slow", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.7
#: high = 1.2
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.5
#: unit = "m"
#: meaning = "how far from the ego's line it rests"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.8
#: high = 2.5
#: unit = "s"
#: meaning = "how long it rests"

param OPT_ADV_SPEED = Range(0.7, 1.2)
param OPT_ADV_DISTANCE = Range(10, 40)
param OPT_STOP_DISTANCE = Range(0.2, 1.5)
param OPT_STOP_TIME = Range(0.8, 2.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
