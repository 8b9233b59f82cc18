#: description = "The crossing car runs the red light, pauses halfway, and then goes on."
#: rephrasings = [
#:   "she goes over the red, gets cold feet, stops for a second and then carries on anyway",
#:   "Vehicle 2 entered on a red indication, halted briefly, and then continued across.",
#:   "red-light runner stops for a moment, then continues",
#:   "The target passes the stop line on red, comes to a temporary standstill and resumes its course.",
#:   "The car crosses by red, then it makes a little pause because the driver is not sure, and then continues.",
#:   "A bus pulls over the line on red, dithers and moves off again.",
#:   "The biker sneaks through on red but wavers in the middle before setting off once more.",
#:   "Against the signal a lorry comes out, waits an instant in doubt, and drives on.",
#:   "He jumped the red, stopped to think about it slap in the middle, then carried on.",
#:   "Cross vehicle entered on red, paused midway, and continued through the intersection.",
#:   "Truck thru red, half way stop, then on.",
#:   "The crossing vehicle passes the red signal, halts briefly in mid-junction and proceeds.",
#:   "The car goes over red, waits in the middle little bit, and goes more.",
#:   "Red-light runner with a short dwell at mid-box, then clears.",
#:   "It had run the light, and in the middle its nerve went; a breath later it plucked up courage and finished.",
#:   "Bus has gone through his red, he's stopped halfway, unsure, okay he's going again, let him out.",
#:   "he ran the red stopped halfway like oh no and then just finished it lol",
#:   "A driver passed the red signal, faltered midway over the junction and then resumed.",
#:   "Against the red you went; in the midst you paused; and then, reflection notwithstanding, you continued.",
#:   "Jumped the signal, in middle he stopped for one second, again he started.",
#:   "Through on red, gets cold feet bang in the middle, and then carries on regardless.",
#:   "Red-signal violation with momentary halt in mid-intersection and continued crossing",
#:   "RED LIGHT RUNNER BUFFERS HALFWAY, then goes",
#:   "The crossing van violates the red, balks midway and resumes.",
#:   "On red the cab enters, baulks in the middle, then completes its crossing.",
#:   "Crossing bus disobeys red, wavers mid-junction, drives on across.",
#:   "It passes by red, in the half it stays a moment, it continues.",
#:   "Moto from side: through red; brief halt centre; off and over.",
#:   "Red was no obstacle; doubt was, for a second; then on he drove.",
#:   "A crossing SUV took the red, seemed to notice us when it was in the middle, stood for a breath and then drove on out of the junction.",
#:   "Make the truck from the side disobey its light, stand a moment half over the junction, as if unsure, and then finish going over.",
#:   "The scooter had ridden out against the red; midway she put both feet down, looked at us, looked at the lamp, and rode over after all.",
#:   "The lorry's passage on red was interrupted once: it was at rest in the centre of the crossing for about a second before it was driven on.",
#:   "Entering on a red aspect, the crossing target shall halt temporarily at the midpoint of the intersection and then resume its original course at its original speed.",
#:   "Did he go through? Well, by instalments: over the line on red, a pause slap bang halfway while he plucked up courage, and then the rest.",
#:   "I was about to move off on my green when a hatchback came from the left in spite of its red. It got as far as the middle. There the driver must have thought better of it, since he stopped, but he thought worse again and carried on across.",
#:   "V2 failed to obey the red signal and entered the intersection. At about the centre V2 was observed to stop. After an interval of one to two seconds V2 proceeded in its original direction and cleared the intersection. V1 had entered on green and was braking throughout.",
#:   "With a bus it looks like a whale losing heart. It had passed the red lamp with a great sigh, come to the heart of the crossroads, and there it hung, rocking a little on its springs; then the sigh came again and it bore its passengers over to the far side.",
#:   "You should have seen my wife's face. This motorbike jumps the lights on the other road, no shame at all, then he loses his bottle and he's sat there halfway over, wobbling, and I'm waiting, he's waiting, and then, right, on he goes, off over the other side.",
#:   "Twelve seconds in you get the van in from the right, light's red for him, check the reflection in the bank window. Then he stops in the middle. I reckon he's going to sit there and block us, but no, he gets going again and clears it.",
#:   "Red ignored, crossing van stands mid-junction briefly, then continues over.",
#:   "Biker from the side jumps red, falters halfway, goes on.",
#:   "Past the red, full pause in the centre, off again.",
#:   "The taxi came out of the cross street against its light, came to a short standstill when it was half over, and then proceeded to the far side.",
#:   "dude in a pickup blows the red, realises it mid intersection, stops like a deer for two secs and then just keeps going",
#:   "Having violated its red signal, the crossing target dwells at rest near the middle of the conflict zone and afterwards completes its trajectory straight ahead.",
#:   "He's gone through his red, that coach, and he's stopped, half in and half out, wait for it, and there he's off again, over he goes.",
#:   "Red was there for the lorry, still he entered; in the centre he is thinking thinking for some time, then he has crossed fully.",
#:   "Let the crossing scooter run its red, lose heart halfway and hold still for a second or two, and then finish going across.",
#:   "I suppose he hoped for the best. His light must have been red, as mine was green, and I was under way when the bonnet of that Jaguar came out from the right. It came to the middle and no further, I could have counted to three; and when I waved my fist it got going again and slunk off to the left-hand side of my world.",
#:   "The defendant's evidence is that he didn't stop. The video shows that he didn't stop where he ought to have, at the line, with the signal at red. He did so in the centre of the intersecting carriageways, for one and a half seconds, before driving on across, thus obstructing my client not once but for as long as possible.",
#:   "When I cycled up, three things had already gone wrong for that bus. It had come through on a red, it had noticed as much, and it had chosen the very middle of the crossroads in which to think about it. The fourth thing was better: the driver made up his mind and took it out of there, straight on, and we could all breathe.",
#:   "A hiccup, that's what it looked like on the radar. Object from the cross street, passing its red at nine metres per second, then zero, right in the box, for about as long as a yawn, then nine again and out by the opposite arm. Our vehicle had stopped at the first sight of it and rightly stayed stopped.",
#:   "V2, a tractor-trailer, disregarded a red indication on the cross street. Having reached the center of the intersection, V2 halted, apparently because its driver had become aware of V1. V1 likewise halted; V2 then resumed motion on its original heading and exited the intersection.",
#:   "They all laughed at me for waiting on green. Well, there was a moped stopped in the crossing with a girl on it, sitting there, biting her lip, because she'd sailed by her red lamp and seen us all coming. I gave her a nod and she opened up and buzzed away over the rest of it, and nobody laughed then.",
#:   "Our side gets green and nothing moves, because there's a gravel truck broadside on in the middle of the junction. It isn't broken down. It came out on red, and something, conscience maybe, stopped it halfway; the horns start, and conscience having been heard, off it lumbers to the other side.",
#:   "In the crossing comes from the left a white car, for him is red since much time. I brake; he sees me and he brakes also, in the exact middle, and we look us in the eyes. I make no sign, he makes no sign, and then he gives gas and passes to the other side.",
#:   "I was in labour, I'd like that on record, and my husband was going over on green. A motorcycle came at us from the side through a light as red as anything, and stopped; not at the light, in our way, halfway over. He looked at me through his visor, I yelled, and he put his feet up and cleared off across.",
#:   "Dash cam bingo, all three in ten seconds. One, SUV from the cross street enters on red. Two, it bottles it and stands there in the dead centre like it's waiting for a bus. Three, it un-bottles it and toddles on over to the far side.",
#:   "Nothing is so dangerous as a scruple that arrives late. It came to him between the kerbs, when the red lamp was already behind his back and the other street's cars were in motion towards his door. He stopped for it, in the heart of the crossing, for the length of a breath; then he put it aside and drove on over.",
#:   "Over on red; a stop, mid-junction; then over after all.",
#:   "Biker defies his red, stands doubting halfway, rides on across.",
#:   "Red jumped, box half crossed, freeze, thaw, away over.",
#:   "We'd to wait out two decisions of that taxi's, one to ignore the red and one, made while standing in the middle of the crossroads, to go on.",
#:   "Crossing truck to start on its red, brake to rest at the conflict point, remain there for the set pause and then continue over at its former speed.",
#:   "lad comes thru a red on a ped, sees me, stops bang in the middle w his mouth open, i stop, then just carries on to the other side",
#:   "Red is there, in he came; in the middle some shame also came and he stood for it; then shame went and full crossing he has done, straight.",
#:   "The minibus which was obstructing the junction had got so far on a red, and it went the rest of the way after its driver had stood there and pondered.",
#:   "Having passed your red, sir, and got to the centre, what did you gain by halting for two seconds, only to drive on over to the other side?",
#:   "Its lamp was red, so before the line would've been the place for that coach to stop. It found another: slap between the two halves of our street, with us coming on our green. It rocked there long enough for me to say a whole sentence, and then it put its shoulder down and went on over to where it had been going.",
#:   "It's like the man on the diving board. He shouldn't have gone up there, the light on his road was red; but up he went, my friend in the little Suzuki, into the crossroads. At the end of the board, so to say, dead centre, he froze and looked down at us all. Nobody could talk to him, and he jumped, I mean he drove off across.",
#:   "In the speed trace there's a notch of 1.7 s. Left of the notch the crossing van does nine metres per second, at a point of the map where its signal was showing red. In the notch it does nothing, in the centre of the intersection. Right of it, nine again, same heading, outbound on the far arm; the ego wisely waited for that.",
#:   "I had green and couldn't get through for a motorbike. It was plumb in the middle, broadside, with a big fellow on it. He'd ridden by his red and, as I see it, his conscience had caught him up there. I leaned out to give him some advice, and he shook himself and rode off over to the other side before I'd got beyond \"oi\".",
#:   "The tram driver said that his bell had done both. The lorry had come out of the side street against a red lamp; he rang, and it stopped, so that was once. But it had stopped on his rails, in the heart of the junction, across the bows of the blue car on green. He rang again, and it gathered itself and moved off over to the opposite street.",
#:   "One second later and he'd have been fined less, the officer told me. Entering on red is so much. But he had stood in there, hadn't he, right on the crosshatching, with my car pulled up at his door and my mother praying; standing in the box is so much more. That he'd then driven on across, straight, in his own good time, was free of charge.",
#:   "Dear Sir, as a pedestrian I've a view of your crossroads which your planners lack. At ten today a saloon left the side street on a full red. It got half of the way, whereupon it stood, to the distress of a robotaxi that had green and of itself. I'd counted \"one elephant, two elephants\" when it resumed, and it finished its crossing to general relief.",
#:   "Two brake applications by V1 are on record. The first was made when V2, on the cross street, failed to stop at a steady red. V2 was then stationary at mid-intersection, and V1's operator, assuming that V2 would stay there, released the brake so as to pass behind. The second was unnecessary, for V2 had by that time resumed its course and left by the far side.",
#:   "Mine is the bakery van, and this morning I made an enemy and a friend, the same one. From the cross street comes a camion, he has the red, he comes all the same, so, enemy. In the middle he sees me, and he stops, he puts the hand on the heart. I make the sign, go, go, it's warm bread; he goes, to the other side, and we're friends.",
#:   "It's no good shouting at a bus. It had heard nothing up to there, not the red, and it was over that and as far as the middle before whoever was driving it woke up and stamped. We had its whole flank in front of us, not stirring. I shouted \"go on, then\"; I dare say it was a coincidence, but on it went, over and out.",
#:   "He had the look of someone in the wrong room. The room was full of cars in motion, and he'd ridden in past the red that hung at its door. He stopped, therefore, in the middle. It was as far to the one door as to the other; and after a moment in which nobody breathed he went on to the other.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "hesitate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -5.0
#: high = 0.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.5
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(-5, 0)
param OPT_STOP_TIME = Range(0.4, 1.5)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
