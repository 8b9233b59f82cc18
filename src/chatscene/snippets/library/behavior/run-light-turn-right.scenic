#: description = "The vehicle runs the red light and makes an abrupt right turn."
#: rephrasings = [
#:   "A car ignores the signal and hooks sharply to the right inside the junction.",
#:   "Jumping the lights, the adversary swings right in front of the ego.",
#:   "The other driver crosses on red and suddenly turns right.",
#:   "Against the red a vehicle enters and yanks the wheel rightward.",
#:   "The motorcyclist disregards the lights and cuts round to the right.",
#:   "he runs the red and chucks it to the right",
#:   "Vehicle 2 entered against the signal and turned sharply to the right.",
#:   "runs red, late hard right",
#:   "The van didn't bother with the red, he just whipped it round to the right in front of me.",
#:   "Unit 2 failed to stop for the red signal and made a sharp right turn.",
#:   "MC ignores red, snap R turn.",
#:   "The target vehicle passes the red signal and performs a right turn with high yaw rate.",
#:   "The bus has red but goes fast around to the right.",
#:   "Red runner with a sudden right turn into our exit, quick steering, no stop at the line.",
#:   "She had green; he had red, and still he threw the wheel over and barrelled round to the right.",
#:   "Truck's not stopping for that light, he's yanked it right, he's coming into your road.",
#:   "he didnt even stop for the red just whipped a right",
#:   "A car took a sudden right-hand turn against the red signal.",
#:   "The signal being against you, you nonetheless turned to the right, and sharply.",
#:   "Red signal was there but he cut the right turn just like that, full sudden.",
#:   "Red's only a suggestion for him, hard right and gone.",
#:   "Abrupt right turn of vehicle in violation of red signal",
#:   "NO STOP ON RED, snaps right in my face",
#:   "The truck flouts the red and lunges right.",
#:   "Crossing biker blows the red and dives off to the right.",
#:   "Side-street van on red, doesn't halt, violent right-hander, over.",
#:   "Let the cross-traffic bus ignore red and veer round right sharply.",
#:   "The red lamp he didn't see, and fast he turned right.",
#:   "saloon jumps its lights then a handbrake style right lol",
#:   "Its signal was at stop, yet the lorry from the intersecting street entered and, all in one jerk, made a turn to the right in front of us.",
#:   "The crossing target does not comply with its red signal; within the junction it initiates a right turn with a steep rise in steering angle.",
#:   "You've got the green, so you think he's waiting. Nope, he's through the red, and there he goes, wrenching that hatchback round to his right.",
#:   "Monsieur in the cross street burned the red fire, and when I thought he will go straight he has brutally taken the right.",
#:   "I saw the motorcycle pass its red light and thought it meant to go over; instead it was suddenly laid over into a right turn.",
#:   "How did the pickup end up on the road to its right? By passing a red light without pause and hauling the wheel round at the last second.",
#:   "I was in the middle of my driving lesson, would you believe. The cab on the other road had red, clear as day. He came out, and before my instructor could get a word in he'd thrown it to the right, tyres squealing, with the passenger's face squashed on the window.",
#:   "The operator of Vehicle 2 disregarded a steady red indication on the cross street and entered the intersection. He then changed direction abruptly to the right. There was no signal and no lowering of speed beforehand, and the marks on the asphalt show how tight and how late the turn was begun.",
#:   "Ticket: red-light runner, right variant. The NPC arrives on the crossing arm against red and goes on in. We predict it straight across; a few metres before the conflict point its heading swings by ninety degrees to its right in under two seconds. Please keep the straight and the left one separate.",
#:   "Nobody at the bus stop could believe it. The coach had a red, the people were already lifting their feet to cross, and it came through as if the lamp had been put up for decoration. Then its whole length heeled over and it was gone round the corner to the right, luggage doors rattling.",
#:   "In the fourth video the culprit is a milk tanker. It's on the road that crosses ours, its light has been red for an age, and it doesn't so much as lift. Having come in, it takes a savage right, and you can see the far wheels go light. The cammer just says \"wow\".",
#:   "Scooter on the cross road ignores red and darts right, just like that.",
#:   "Let the crossing coach enter on red and haul itself sharply right.",
#:   "didnt stop on the red just slung the van right in one go",
#:   "A hatchback whose lamp stood at red rolled into the junction and, where one expected it to carry on over, was wrenched round to the right.",
#:   "Notwithstanding its red aspect the crossing target enters, and at the set distance its heading changes rapidly by ninety degrees to its right.",
#:   "The truck of the side street has eaten the red light, and then he made so sharp the right turn that I saw the underneath of it.",
#:   "He's on a red, over there. Is he bothered? He is not: he's past the line and he's chucking that pickup into a right-hander as we speak.",
#:   "It isn't merely that you drove past the red, Mr Bell, but that inside the crossroads you then spun your wheel and turned off to the right.",
#:   "Signal was red for that bike, still he entered, and then suddenly he cut right side full lean, knee almost touching road, like in the cinema.",
#:   "A lady on the tram island dropped her parcels. She had been watching the green man, quite properly; the minibus on the other street had red. It came in at a good speed notwithstanding, rolled like a dinghy as it was thrown to the right, and left on two wheels down the road that lies on that side of it.",
#:   "V2, a motorcycle, was southbound and facing a circular red. It did not stop at the limit line. Inside the intersection the operator made an abrupt right turn, westbound, scraping the footpeg for a distance of eight feet. No signal was given. V1, on green, had to brake sharply.",
#:   "A red-light jumper usually goes one way: ahead. You set up for that, you lift, you leave him the space in the middle. The lorry on my cross street jumped its red and I'd left it the middle, very handsome; then it swung hard to its right, all eighteen tonnes, as if it'd seen a bargain.",
#:   "Library request: signal violator with turn, right-hand version. Actor on crossing arm, phase red, does not slow for the line. Close to the conflict area, full right lock, tight radius, completes the turn. I've seen the left-hand one and the go-straight one; those are other scenarios.",
#:   "We were doing the crossing game, where you shout out the colours. \"Green for us,\" I shouted. \"Red for the bus!\" shouted my brother. But the bus came anyhow, and it went round to its right so quick that it nearly fell over, and my brother shouted a word that isn't a colour.",
#:   "What first struck me was that I could hear tyres but the brake lights on the taxi weren't on. It had come through on the red, no pause, nothing. They were howling because the driver had, at the very last, flung it off to the right, and it was doing its best to get round without rolling.",
#:   "The old professor's saloon had no quarrel with the red lamp; it just did not acknowledge it. It advanced into the crossing. Everyone saw it on the other side already, when it recollected an appointment, and with a violence nobody'd have believed of it, swerved round the corner to the right and was no more seen.",
#:   "In the footage from the bike lane the pickup's traffic light is in shot, and it's red at every frame. It goes in regardless. At frame 212 its front wheels are straight; at frame 218 they're hard over, toward its right; by 260 it has turned the corner and its load of gravel is on the zebra.",
#:   "I've done the night bus for nine years and the light at Cable Street's always the same. Some boy racer on the other road, red as you like, doesn't even look at it. And they never go straight. He flicked it right, handbrake I shouldn't wonder, and I was left stopped on my green with the bell ringing.",
#:   "To whom it may concern. On the said date the cab on the intersecting road had red, which can be proved. It nevertheless drove in. I supposed that it wished to go over. It suddenly broke off and made a right turn of extreme sharpness, for which no lamp was lit, and my shopping is all over the footwell.",
#:   "Copy that, the vehicle that failed to stop for the red at Ninth is a white box truck. It did not continue across. Repeat, it did not go across; it made a hard, last-second right, took out a newspaper box on that corner, and was last seen going away from there on the street to its right.",
#:   "Taxi on the cross street snubs its red, snaps right.",
#:   "Red for him. In he comes, hard right, no warning.",
#:   "lorry thru a red then WHIPPED it to the right omg",
#:   "His light being red I'd have bet on him standing, and as he wasn't standing, on his going over, and not on a scooter flat on its right-hand side round a bend.",
#:   "At red it ought to have stayed put; the SUV entered from the intersecting street and cut to its right at such a rate that its left wheels went light.",
#:   "Let the coach on the crossing road take no notice of its stop light, enter as though bound straight on, and be wrenched round to its right at the last moment.",
#:   "The conflicting target passes its stop line during red and, at the swerve distance, executes a ninety-degree turn to its right at undiminished speed.",
#:   "Now what's he up to, coming in on his red like that? Don't guess, because there he goes, all the lock he has got, to the right-hand road.",
#:   "You had a red signal, you ignored it; you had a straight road before you, and ignored that also, by hauling your lorry to the right within its own length.",
#:   "I heard crockery. It wasn't mine. The catering van had come out from the side, under a lamp as red as a pillar box, and I'd stopped where I thought it would go through. Instead of going through, it went round, rightward, in the space where you'd turn a wheelbarrow. The plates all went to the left; you could tell.",
#:   "The arc begins inside the stop line, at a point that V2 had no business to be, the head over it having shown red for five seconds. It's the arc of two tires only, the left ones, the others having hardly weighed anything. It leads through ninety degrees to V2's right. It's not preceded by any braking mark.",
#:   "We expected three things at that light, in order: that the bike would wait as it had red, that it would shoot straight over as it did not wait, that it'd take a nice wide bend as it didn't shoot over. We got none. It fell on to its right side, or so you'd think, and was round in the blink of an eye.",
#:   "Pavement view, with ice cream. Big silver people carrier comes up to the red and it's as if no one had told it. It is in the junction. A lady in a test car has green and brakes. At that, or anyhow then, he winds the wheel clockwise like a sailor, the whole box leans outward, and off to the right with it. Dropped my cone.",
#:   "Our prediction module knows that those who run reds go fast and straight. Case 77 is there to teach it otherwise. Actor on the intersecting approach, signal state red, no deceleration at the line; and a heading that changes by minus ninety degrees in under a second, from the straight, when it's well inside. Same speed throughout.",
#:   "\"He's dreaming,\" I said to my pupil, as the bus from the other street hadn't slackened for its light, \"so we wait.\" He wasn't dreaming. A dreamer would've gone over. He'd remembered all of a sudden that the 36 turns off to the right there, and he'd have it turn off, standing passengers or no standing passengers.",
#:   "It was the mirror that flew at me. Not the pickup, the mirror from the pickup, since he'd come so sharply round to his right hand that he left it on the traffic island. And that with a red light! I had mine green, I was going gently, I'd seen him break his red and had thought he'd pass in front.",
#:   "Sir, first mistake, red signal he's not seeing. Second mistake, he is inside the crossing and he isn't going straight also. In one jerk he has cut the handle of auto to right side, without horn, without hand, full ninety degrees, three wheels became two. Whatever I was planning for him became useless.",
#:   "The gust from it took the hat of the man at the crossing. There'd been the red on that side, he knew it well since he had been walking with his green man, and it hadn't kept a black saloon from darting out of its queue, into the square. He jumped. And at that it spun on its heel to the right, past his toes, and away.",
#:   "Title: \"red light? right turn? both? BOTH\". Crossing lorry, top corner, see its signal, it's red, it's been red since the clip started. In he comes. Everyone in the comments thought he'd be off the other edge of the picture. At 0:09 his cab lurches round to the right like it's been kicked, and his trailer cuts the kerb.",
#:   "As a cyclist I trust the engine note. His never fell for the red lamp, hence I stayed at the line, though my own lamp was green. And his never rose, either. There was a shudder and a scrabble of rubber, and the sound, which ought to have passed across in front, bent away round the corner on its right.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-right"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(18, 42)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(0, 8)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    # Where no way goes straight on, it leaves its way before that bends.
    start = self.pose[2]
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE or abs(self.pose[2] - start) > 0.15
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.5708)
