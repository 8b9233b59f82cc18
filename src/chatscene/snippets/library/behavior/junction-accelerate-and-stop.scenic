#: description = "The car suddenly accelerates, enters the intersection first, and suddenly stops."
#: rephrasings = [
#:   "A vehicle rushes into the junction ahead of the ego and halts in the middle.",
#:   "The adversary pulls out fast and comes to a dead stop on the ego's way.",
#:   "The other driver jumps in first, then freezes, blocking the crossroads.",
#:   "The crossing car speeds in and slams to a standstill before the ego.",
#:   "Having forced its way in, the car stands still in the junction.",
#:   "he guns it out in front of us and then stands on the brakes in the middle",
#:   "Vehicle 2 accelerated into the intersection and came to rest across the travel lanes.",
#:   "The truck goes fast in the crossing before us and then it stops completely.",
#:   "he booted it to beat me into the crossroads and then just stopped dead in the middle, the plonker",
#:   "V2 sped up to enter the intersection ahead of V1 and then came to an abrupt halt inside it.",
#:   "Bus guns it to be 1st in jct., then dead stop there.",
#:   "The target accelerates to enter the junction before the VUT, then brakes to standstill within it.",
#:   "The truck makes quickly to be first in the crossing, and then suddenly he stands.",
#:   "Actor races SUT to the conflict zone, wins, then parks in it (v=0).",
#:   "The biker had spurted ahead to be first over, and having won his race he came to a standstill right in the middle of it.",
#:   "He's put his foot down to get there before you, and now what? Bang, stationary, plumb in the centre.",
#:   "he raced us to the crossroads, won, and then just stopped in the middle?? ok",
#:   "A lorry driver sprinted to be first over the junction only to plant his vehicle in the heart of it",
#:   "You hurried so as to enter before the claimant and thereupon came to a complete halt in the junction itself?",
#:   "He want to kiasu go first at the junction, speed up somemore, then inside suddenly stop",
#:   "Has to be first over, puts a spurt on, gets there, and then he drops it dead in my road, what was the rush",
#:   "Competitive junction entry with hard acceleration, then standstill in conflict area",
#:   "Bus BEATS me to the intersection then parks in it",
#:   "The bike dashed in first and then rooted itself to the spot.",
#:   "Bus sprints into the crossroads ahead of us, then plants itself.",
#:   "he floors it to beat me over then whoa frozen mid junction",
#:   "Let the cab surge in before the ego and freeze there.",
#:   "Motorbike: burst of speed, junction first, abrupt standstill inside it.",
#:   "The silly man rushed to be first and then he stopped inside!",
#:   "Although I would have been there sooner, the saloon put on a spurt, took the junction before me and came to an instant standstill in it.",
#:   "At the trigger the target goes from a modest approach to hard throttle, reaches the conflict area prior to the VUT, and brakes to zero inside.",
#:   "What on earth is the point of racing somebody to the box if you're only going to nail the brakes the second you're in it?",
#:   "The coach stood lifeless across the middle of the junction, which it had won a moment earlier by a violent burst of power at our expense.",
#:   "He has made quick quick to arrive in the Kreuzung before my car, and directly in it he has made a full stop, nobody knows for what.",
#:   "Your examiner's favourite: the hatchback that suddenly goes for it, gets into the junction ahead of you, then loses its nerve and stands stock-still.",
#:   "The motorcyclist wound on the power as we both neared the intersection, so that he was inside it while our AV was still short of the line. There he grabbed both brakes, and bike and rider remained on the spot, square across our path.",
#:   "I have delivered in this town for thirty years and seen all sorts. This SUV picked up speed like a scalded cat just to get onto the crossroads in front of my wagon, and no sooner was it there than it pulled up dead and stayed.",
#:   "Video title aside, look at the timing. At two seconds the pickup ambles; at three it lunges forward, because he wants to be in there before the cammer; at five he's in the junction with the wheels locked, and then he's simply a wall.",
#:   "It had been, thought Clara, a sort of duel for the empty intersection. The little van leapt, and won it by a length; and then, as though victory had frightened it, it stopped with a jolt in the very centre and would not stir.",
#:   "The crossing coach was first seen at moderate pace. On perceiving the robotaxi it accelerated strongly and gained the intersection ahead of it, whereupon the driver executed an emergency stop. The robotaxi therefore met a stationary body in its path with little notice.",
#:   "Scooter jumps on the gas, claims the box before us, freezes.",
#:   "Have the SUV hurtle into the crossing ahead of us and halt dead.",
#:   "BURST, BOX, BRICK WALL: coach beats me in and stops",
#:   "With a sudden spurt of power the courier bike got to the middle of the crossing before our car could, and there its rider locked everything and stood.",
#:   "The target is to apply sudden throttle, occupy the intersection prior to the arrival of the vehicle under test, and come to an abrupt standstill inside it.",
#:   "He was rolling like a sleepy buffalo, then all at once full race, he is first inside the junction, and inside only he put sudden brake and finished.",
#:   "Watch out, he's gone for it, he wants to be in there before you, he's in, and now he's nailed to the spot in the middle of the crossroads.",
#:   "You put on a violent burst of speed in order to be in the junction ahead of my client, and you rewarded yourself by stopping dead there?",
#:   "Nobody minds a man in a hurry, but the hatchback that lunged in ahead of the robotaxi at Dale Cross then pulled up short, bang on the centre.",
#:   "I had my foot over the pedal, since a bus was coming up to the same junction and one can never be sure. I heard it rev up hard, so I thought it would be over and done with before me. It did get in before me; over it never got. It shuddered to a stop across both lanes.",
#:   "The recorder of V2, a hatchback, shows 21 km/h, then full accelerator for 1.4 seconds, then full brake. By the first it arrived in the conflict area in advance of V1. By the second it remained there, speed zero, at the point toward which V1 was travelling.",
#:   "It was like musical chairs. Me and this motorbike coming up to the one crossing, he hears the music stop and whacks it wide open, so in he goes and I'm the one without a chair. And what does he do with it? Sits on it! Both brakes, dead still, slap in the middle.",
#:   "Ticket: race and freeze. Other actor starts with a strong throttle as we near the intersection and gets to the meeting point earlier than we do. Our planner says \"he'll be gone\". He isn't, since he brakes at the limit there and stays. Expected result: ego stops before the box.",
#:   "My neighbour's boy has a new motor and wants it known. He was dawdling up to the crossroads; he noticed me; the exhaust went off like a gun and he was in there first. I suppose he hadn't thought any further, for he then stopped so suddenly that his cap fell off, and left me looking at his doors.",
#:   "Forty tonnes doesn't do surprises. I had the measure of that cab, he was slower than me and further off. Up comes his bonnet, though, whoosh, he's got the junction before I have, and where the rear lights of a normal person would be vanishing there was a taxi, broadside, with smoke round its wheels.",
#:   "Two black marks were found at the junction. The first pair, at its mouth, was left by spinning tyres when the pickup set about getting in before our insured. The second pair, nine feet on, was left by locked ones. The pickup was still standing on the end of those when the police arrived.",
#:   "Madame, I understand the hurry of the young. But this one on the scooter, he gave all the gas for to enter in the carrefour before me, I let him, please, go. And he goes not! He has blocked his wheels in the middle and he stays like a statue.",
#:   "From the pavement, with my cello on my back, I saw the whole silly business. The minibus surged, and the little car had to let it have the crossing. And then the minibus stopped; I mean it stopped as a slammed door stops. All the children in it fell against the seats in front.",
#:   "It's a fault I see in nervous candidates. They see you approaching, they panic and stamp on the throttle, so they're into the junction before you; then they panic about that too, and stamp on the brake. Result: one learner's car, stock-still, right where you were going to drive.",
#:   "Something had stung the black saloon, for out of a lazy approach it sprang at the empty square and was there before them. Ada waited for it to be gone. It had bitten down on its brakes, though, as hard as it had sprung, and there it squatted, and the square was not empty any more.",
#:   "Hatchback surges, wins the crossing, drops dead in the middle.",
#:   "He raced me in and then became a bollard, classic",
#:   "Bus: sudden burst, first over, instant halt inside the box.",
#:   "Simulate a motorbike that leaps off the mark so as to be in the crossroads before the AV, and once it's there nails itself to the spot.",
#:   "With what urgency the taxi shot in ahead of us you'd have thought a birth was on; and then, in the very middle, it was all at once a monument.",
#:   "The coach's nose rose, the coach's nose fell. Between the two it had beaten us to the intersection, and after the second it blocked it.",
#:   "On activation the conflicting target applies high throttle, arrives at the common zone ahead of the SUT, and within that zone abruptly brings its velocity to nil.",
#:   "I'd have been first by a length. He wouldn't have it, gunned his SUV past the give-way, and when he'd won, he froze, right there where the roads meet.",
#:   "Fellow was going like he had all day, next thing he's on full boil into the crossing before my auto, and there only he planted both feet on brake.",
#:   "The tyre marks in the crossroads come in two pairs. One pair, at the entry, is from wheels spinning under power. The other, nine metres on, inside the junction, is from wheels that no longer turned at all. The saloon was standing at the end of the second pair when V1, which should've been through first, arrived.",
#:   "We had worked out a fine plan, my pupil and I: he's far off, he's dawdling, we go ahead of him. Then his engine screamed. The plan was dead, for he'd be in there before us. Very well, plan two, let him clear. Then his front dived, and plan two was dead as well, with him motionless on our line.",
#:   "My knitting was on the floor by then. It seems the bus had wanted the crossing more than us, for I heard it roar, and my son-in-law said \"all right, you have it.\" I was bending for my wool when he said something else, and I came up to see that bus plumb across our road, not moving an inch.",
#:   "Planner timeline. At t0 we have priority and a two-second margin. At t0+0.6 the crossing motorbike's acceleration jumps and the margin turns negative, so we plan to pass behind it. At t0+2.1 its speed drops to zero in the conflict area. There's no behind any more, and the emergency brake does the rest.",
#:   "It is the greed that annoys one, and then the cowardice. Having snatched the junction with a great snort of exhaust from under the wheels of our van, the little red car appeared to remember something. Its tail went up. It stuck fast where it was, in everybody's way, and we with our eggs came to rest a foot from it.",
#:   "They asked me in court what I'd expected. Well, that he'd carry on! No man hoofs it into a crossing in front of a lorry in order to stay there. His wheels spun, he was in before me, I was already thinking about the next lights. And then, of a moment, there he was at a dead stand, side on, in my windscreen.",
#:   "From the second floor of the insurance office we have the crossing below us like a board game. The white piece had been to move. The black piece, a minicab, jumped the turn: you heard it rev, and it was on the square before white. There it stayed, from full tilt to nothing in one car's length, and white had nowhere to go.",
#:   "Was a noise first, as of a moped being strangled, no? I look: he who was sleeping at the side street isn't sleeping anymore, he flies, he wants to be before me on the crossing and he is. But his flight has finished exactly there. Both brakes, the back wheel in the air, and standing as a statue in my way.",
#:   "You will need two ugly moments for this one. The ego reckons it'll get to the crossing first, so spoil that with a burst from the other car that puts it in there ahead. The ego now reckons the other will be gone again in a second, so spoil that too: from the burst it goes straight to a dead stop inside.",
#:   "I saw brake lamps where I'd never seen brake lamps before, sideways on, in the dead centre of Four Ways. A second earlier there had been only a squeal of rubber and a minibus overtaking its own intentions, in order to be through before me. It wasn't through. It was parked on the drain cover that marks the middle.",
#:   "Reporter's notebook: bus company says driver \"accelerated to clear the junction promptly.\" Witnesses, four, agree about the accelerating, one says it threw the standing passengers to the back, and that it got there before the test car. None agree about the clearing. The same passengers were then thrown to the front, and the thing remained in the crossing.",
#: ]
#: adversaries = ["car", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["accelerate", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.5, 1)
param OPT_STOP_DISTANCE = Range(0, 4.5)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
