#: description = "The crossing car runs the red light and swerves to its left in the junction."
#: rephrasings = [
#:   "he blows the red and yanks the wheel left when he spots us",
#:   "Vehicle 2 ran the red signal and veered abruptly to its left.",
#:   "red-light runner, sudden swerve inside crossing",
#:   "The target crosses the stop line on red and performs an evasive steering manoeuvre to the left.",
#:   "An ambulance comes on the red light and makes a fast movement to the left side.",
#:   "The biker jumps the lights and lurches aside at the last instant.",
#:   "Going through on red, a van darts off its line.",
#:   "It disregards the signal, then jinks to the left.",
#:   "he jumped the red and then jinked to his left in the middle of the junction",
#:   "V2 entered against the red signal and veered sharply to its left within the intersection.",
#:   "Police thru red, jerks to own L mid-jct.",
#:   "The crossing target passes the red signal and makes an evasive steering movement to its left inside the junction.",
#:   "The motorbike goes by red and in the crossing he pulls suddenly to his left.",
#:   "Red runner plus lateral kick: after entering the box, step in steering to its left, keeps moving.",
#:   "He had paid no heed to the light, and halfway over, the car lurched to its left hand for no reason they could see.",
#:   "Ran the red, and now he's flung the wheel over to his left in the middle; no telling where he'll end up.",
#:   "he ran the red then freaked out and swerved to his left in the middle",
#:   "A car passed the red signal and then sheered off to its left inside the crossroads",
#:   "You disobeyed the signal, and within the junction you wrenched the wheel to your left?",
#:   "Jumped the red, then inside the junction he swing to his left side, macam stunt driver",
#:   "He's come through on red, seen me, and thrown it over to his left",
#:   "Signal violation by crossing traffic with abrupt leftward evasion inside the junction",
#:   "Ambulance blows red light and VEERS to its left",
#:   "The biker burst over on red and jinked to his left.",
#:   "Crossing saloon jumps its red, then flings itself leftward mid-box.",
#:   "Have a side-road biker shoot the red and dodge to his left inside.",
#:   "Patrol car through red, sharp jink to its left in junction, be careful.",
#:   "Red was for him, he came, and inside the crossing made left jerk.",
#:   "Who runs the lights and then yanks it to his left halfway over?",
#:   "Out of the side street came a van that wouldn't stop for its red, and amid the crossroads it lurched bodily over towards its left.",
#:   "The crossing target disregards the red signal and, once within the conflict area, performs a lane-change-like steering input towards its own left-hand side.",
#:   "i had green, the motorcyclist on the cross road had red and came anyway, then midway he threw the bike to his left like dodgeing a pothole",
#:   "V2 proceeded into the intersection on a red indication from the cross street and, near its center, deviated suddenly to the left of its course.",
#:   "The ambulance ignored the red and, when it was already in the crossing, the driver gave a strong pull to his left, then went on like this.",
#:   "Add a red-light offender on the crossing road which, midway over, kicks out to its left rather than holding a straight course through.",
#:   "The grey SUV never so much as lifted for the red. It came in from the side at full speed, and when it was out there between the four corners it twitched hard over to the driver's left, the body leaning and the tyres complaining.",
#:   "What confuses the tracker is the second event. First a crossing vehicle violates its red, which we handle; then, inside the junction, it shifts its line abruptly to its left without actually making a turn, and the predicted conflict point is wrong.",
#:   "I'm a courier, I've seen folk jump lights for years. This one in the Astra went clean through his red from the cross street, got into the junction, and then wrenched the car leftwards as if a wasp had gone up his trouser leg.",
#:   "Asked to describe it, the old lady drew a line on the tablecloth. The car had come across when its lamp was red, quite straight as far as here, she said, and then, in the middle of the crossroads, it had dodged to its left, like so.",
#:   "The engine was coming from the right with its horn going and its signal at red, and the crew no doubt trusted us to wait. What we hadn't foreseen was that in mid-junction it would sheer away to its own left.",
#:   "Through its red, then a sharp dart to its left mid-junction: bike.",
#:   "Crossing police car, light against it, sheers to own left inside.",
#:   "red for him, still came, then dodged left like there was a ghost",
#:   "Had the ambulance, having come out on red from the side road, only kept its line; but between the corners it was flung over to its own left.",
#:   "The crossing target disregards the signal; inside the intersection its path is displaced abruptly to its left, its direction of travel otherwise being kept.",
#:   "She'd ignored the red altogether, the lady in the Yaris, and in the middle of everything she hauled herself across to her left.",
#:   "Create a saloon on the cross road that doesn't stop for red and whose driver, once out in the junction, plucks the wheel towards his left hand.",
#:   "From the side street, by red, the motorcycle shot out, and in the middle it made a hook to its left, like before a dog.",
#:   "V2 failed to stop for a red indication and, approximately at the center of the intersection, made a sharp lateral movement to its own left.",
#:   "I keep seeing its roof lean. I had the green, it came out from the right where everyone should have been waiting, and I had just worked out that it would go by in front when it heeled over, all on its right-hand springs, because the driver had yanked it to his left in mid-crossing.",
#:   "A paramedic on a motorbike has every reason to go through a red, and we'd have let him. The trouble was that he saw us when he was well into the junction; he threw his bike to the left, his own left, I mean, and so spoiled all that we'd guessed about him.",
#:   "There were two mistakes by the man in the Kadett. The first was the red light on his own street, at which he didn't so much as hesitate. The second came in the middle of the junction, when he snatched the wheel and the car jumped sideways, to the left as he sat.",
#:   "The track of the crossing object isn't straight. It starts behind a stop line whose lamp is red, it runs out across the cross street's axis as you'd expect, and at the conflict area it has a kink, one and a half metres to the object's left within a second.",
#:   "You've checked your light, it's green, good. He hasn't checked his, for it's red and he is coming over from the side road; don't try to guess which way he will go round you, because there, look, he's thrown it to his left in the middle of the crossing.",
#:   "They asked the fire officer about it at the station. He'd gone over on red with everything flashing; that was within his rights. But inside the junction he believed the grey car wasn't going to give way, so he flicked the wheel over to his left, and that nobody had expected.",
#:   "From my stall on the corner I see all the ones who can't read colours. Today's was a white pickup. Its lights said red, it sailed in from the cross street, and then, out there in the open, it skipped to its left like a horse that has seen a snake, and all the cabbages in the back moved over to the right.",
#:   "The motorcyclist's knee was nearly on the ground. He'd burst over the line with his signal at red; we could see him framed in the junction, upright; and in the next frame he was heeled over, carving off to his left-hand side, so our prediction of his crossing point was wrong by metres.",
#:   "Is it a turn if he doesn't leave by that road? I'd say not. The taxi came from the side in defiance of its red, and well inside the crossroads it lurched to the left of its own course, for no reason I could see, and I sat on my horn.",
#:   "My sister swears that it came at us; what it did was worse to describe. The estate jumped the lights on the other road, it was halfway over in front of us, and then its front wheels twitched and the whole car hopped a lane's width to the driver's left.",
#:   "In this junction everybody knows the side has long red. That one Bolero did not care, he came, and in centre, seeing one cow or one policeman, he pulled full steering towards his own left side, tyres were crying, and my tea was on my trouser.",
#:   "Through on red, then, mid-box, a hop to its own left.",
#:   "Their light was red; their line, straight, until it kinked leftwards halfway.",
#:   "Crossing biker: no regard for red, sharp dodge to his left out there.",
#:   "The ambulance had come out on red as straight as a die, and it was only between the four corners that its wheels jerked over to the crew's left.",
#:   "It isn't its passing the red that did for our prediction; it's the metre and a half by which it jumped to its own left in the crossing.",
#:   "The other car shall have a red and ignore it, and shall, once it's well in, be flicked over towards its driver's left without making a turn of it.",
#:   "He's had the red, he's coming regardless, and, whoops, he's thrown it to his left in the middle there; sit tight till you can see what he's about.",
#:   "Within the intersection, which it had entered on red, V2 exhibited an abrupt lateral displacement to its left and then proceeded in its former direction.",
#:   "Rouge for him, he passes, I still can accept; but in the middle of the crossing he gives a stroke of the steering to his left, as if a hen was there.",
#:   "I'd already steered for where he wouldn't be. He was coming across from the right with his own light against him, I had judged his line and meant to go behind it. Then his bonnet twitched, his offside springs went down, and his line was a good yard further to his left. There was hardly any behind left.",
#:   "The gravel's on the outside of the bend, says the report, but there's no bend; it's a straight road over a straight road. The bend is in the tyre marks. They start from a stop line where the lamp was at red, keep on for nine metres, and there, in mid-junction, hook to the left of the way that V2 was going, and carry on.",
#:   "When the dog barked I looked up from my crossword, and a police motorbike was coming over the crossroads with the red behind him still swinging in the wind. Upright, he was. One second on he wasn't; he lay on his left side nearly, like a sail when it's gybed, and had shifted himself to that side by the width of a car.",
#:   "It takes two wrongs to make this test. In the first, a saloon on the intersecting road disregards its red and comes in at undiminished speed. In the second, at the conflict area, its steering goes hard to the left and back, so that the saloon stands a lane farther to its own left than anyone computed, still crossing.",
#:   "Everybody on the island saw the red. None of us had been watching for what followed, and our shopping went flying. She'd driven clean past it in her little yellow car; out in the centre she must have seen the taxi, for she wrenched herself away to her left, and on she went like a skater who's caught an edge.",
#:   "They want him to answer for the light, but I'd sooner he answered for the wheel. A red I can cope with: he comes, I brake, he's gone. He was in the midst of going when he plucked it over to his left hand, Lord knows why, and the tail of that pickup waved at me like a flag.",
#:   "On screen we had his path as a dashed line, nice and straight, from the stop line (lamp red, noted) to the far kerb. The dot that was he followed the dashes as far as our lane. There it left them. It jumped sideways, to the left of its travel, and ran on parallel with the dashes it ought to have been on.",
#:   "I drive for a dairy and milk tells you everything. If I'd swerved like that the crates would be in the road. He'd come out of the side street under a red light, the fool, in one of those sports things, and amidst the crossing he shied to his left, so quick that his hubcap didn't.",
#:   "You never know what they'll do once they have done one bad thing. The scooter had burst through its red on the other street; all right, we're stopped, let her. But out there she sees us and gets a fright, and look at that, her whole machine's flung over to her left-hand side. We were better off here.",
#:   "The captain was asked by the committee why the engine hadn't kept its line. There was a car, he said, and he wasn't sure of it. They had gone out on the red with horns; they were as far as the middle; and he'd shouted, and the driver had heaved her to port. To port as one sits in her, yes.",
#:   "Near my shop there is signal but red is only decoration. One Pulsar came from the small road, red was showing full, like eye of tiger. He came till the centre, straight, singing. In centre he saw the van of us, and to left, his left, he threw the bike, like somebody has slapped him, and song was finished.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "swerve"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.4
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swerves to its left"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 2.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it swerves"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(7, 11)
param OPT_SWERVE = Range(1.4, 3)
param OPT_SWERVE_DISTANCE = Range(2, 9)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
