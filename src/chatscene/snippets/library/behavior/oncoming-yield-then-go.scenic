#: description = "The oncoming car brakes as if to let the ego turn, then accelerates."
#: rephrasings = [
#:   "he slows down like he's letting us go, then goes for it himself",
#:   "Vehicle 2 decelerated on approach, appearing to yield, then accelerated through.",
#:   "opposing veh brakes, seems to give way, then gas",
#:   "The oncoming target brakes before the junction and then accelerates on a straight course across the path of the VUT.",
#:   "The truck in front brakes and we think it waits, but then it accelerates.",
#:   "A lorry facing us almost stops, flashes, and then barges on after all.",
#:   "The van opposite lulls us into turning, only to put its foot down.",
#:   "First it holds back at the lights, then it surges straight ahead.",
#:   "He slowed down like he was letting me turn, then the sod put his foot down and came anyway.",
#:   "The oncoming driver reduced speed as though yielding to Unit 1's turn, then accelerated into the intersection.",
#:   "Opp. car fakes yield: brakes, then guns it.",
#:   "The oncoming target decelerates, suggesting a give-way intention to the turning VUT, then reaccelerates.",
#:   "The car against me brakes, I think he lets me turn, but then he gives gas.",
#:   "Deceptive yield: oncoming drops speed to invite our turn, then takes back priority with full throttle.",
#:   "He eased off, as if to say after you, and the moment she believed him he came on harder than before.",
#:   "He looks like he's giving way to you, but don't trust it, he's changed his mind and he's coming through.",
#:   "he slowed down to let us turn and then went PSYCH and gunned it",
#:   "The approaching driver appeared to make way for the turning car, only to surge forward again.",
#:   "By slowing you led her to think she might turn, and then you sped up; is that not what occurred?",
#:   "Opposite fellow slowed as if giving way, then when I want to turn he pressed accelerator.",
#:   "Slows right up, after you he says, then after me he says and boots it.",
#:   "Misleading deceleration by opposing vehicle followed by renewed acceleration.",
#:   "FAKES LETTING ME TURN THEN SPEEDS UP",
#:   "The oncoming car feigned courtesy, then charged.",
#:   "Coach opposite sheds speed as if waiving priority, then powers through.",
#:   "oncoming van brakes u think u may turn he guns it",
#:   "Let the facing lorry feign giving way, then surge at us.",
#:   "Opposing car: slows, implied yield, reaccelerates straight over junction.",
#:   "He made slow for us and suddenly very fast, so unfair!",
#:   "As we waited to turn, the SUV opposite bled off its speed in what looked like an invitation, then its driver stepped on it and came over.",
#:   "An oncoming bus brakes before the junction, which the turning VUT may interpret as ceding the way, and thereafter accelerates briskly along its straight path.",
#:   "Never trust a dipping bonnet. He's braking for you, so it seems; wait for it; there, he's had second thoughts and he's belting across.",
#:   "The colleague in the truck has braked when I wanted to turn, I thought thank you, but then he has given full gas and came.",
#:   "I put it to you that, by reducing your speed, you held out a courtesy to my client which you withdrew by stepping on the accelerator.",
#:   "Why slow down to let the robotaxi make its turn, only to put the hammer down and shoot through the moment it thinks it's been let in?",
#:   "My bumper was torn off by a saloon coming the other way. I was signalling to turn, and its driver braked quite noticeably, so anyone would think he was letting me go. He wasn't. No sooner had I begun to roll than the thing sped up again and came straight over.",
#:   "Safety driver's note: the oncoming NPC brakes to a modest speed short of the intersection, we read that as a yield and start our turn, and the NPC then opens the throttle and continues straight on. It never stands still. We want the planner to hold until the gap is really there.",
#:   "There was a kind of politeness about the oncoming lorry; it lowered its nose, it seemed to bow. Anton was already thinking of lifting his hand in thanks when the diesel bellowed. The bow had been a crouch. It sprang forward over the crossing with all the horses it had.",
#:   "Dash-cam night on the podcast, and this one's a beauty. Bloke's waiting to turn. There's an estate coming towards him, brakes go on, front dips, universal sign for \"you go, mate\". Then what does the estate do? Drops two gears and comes flying through. I'd have fallen for it as well.",
#:   "The driver of the bus explained that he had first slowed because he believed Vehicle 1 would turn ahead of him. Seeing that it did not move at once, he accelerated. From the seat of Vehicle 1 the slowing had looked like a yield, and the picking up of speed came as a surprise.",
#:   "Lorry opposite slows as though for us, then puts on steam.",
#:   "Simulate an oncoming SUV that brakes invitingly, then hits the gas.",
#:   "\"after you\" \"no after ME\": van dips, then storms through",
#:   "I'd begun thanking the bus facing us with a nod, since it was braking to let me turn, when it gathered speed again and took the way for itself.",
#:   "The opposing target's deceleration ahead of the junction is to suggest a yield to the turning VUT; before standstill it transitions to strong positive acceleration.",
#:   "The taxi in face makes the brake, one would say he offers me the turn, but no, he pushes on the gas and passes before my nose.",
#:   "Looks like he's letting you in, he's shed a lot of speed. Wait, is he, though? No! He's back on the throttle, stay where you are!",
#:   "Opposite tempo was slowing down so I understood he's giving side for my turn; then that fellow simply raised full speed and came, how is it my fault?",
#:   "A driver who had slackened off for a turning ambulance, or so its crew took it, thereupon opened up his pickup and drove on straight at them.",
#:   "We'd been waiting for somebody to take pity and let us turn. Then this nice estate over there comes off the gas and its bonnet goes down, so my wife waves and I let the clutch in. I wish I hadn't. Up came the bonnet, there was a growl, and the nice estate was doing fifty at my door.",
#:   "V1 intended to turn across the path of oncoming traffic. V2, a truck, was approaching and reduced speed from 28 to 14 mph, which V1's operator took for a courtesy. V2 did not stop. Its speed rose again to 30 mph and it proceeded through the intersection as V1 was starting its turn.",
#:   "I read bumpers for a living, as a crossing guard. That coach's bumper said please. It sank, like they do when somebody's being let go, and the little electric car that wanted to turn began to nose out. Then it said thank you and goodnight: it rose, the engine roared, and the coach came on over.",
#:   "You've got to remember that a slowing car isn't a stopped car. I had a pupil at the turn, oncoming hatchback brakes hard enough to see its lights reflected in the puddle behind. \"He's giving it to me.\" He wasn't giving anybody anything: he had it down to fifteen and then booted it.",
#:   "Left-turn assist fails again. Oncoming actor's speed drops by half over twenty metres, the intention classifier flips to \"yield\" with 0.93. At the junction mouth the actor goes wide open and drives straight over. We had two wheels past the line. Suggest: yield only after speed stays under walking pace.",
#:   "How was I to know he was only changing down? I was waiting to get across with the shopping in the boot, and the oncoming lorry lost so much way that I thought, what a gentleman. It turns out that he wanted a lower gear for pulling harder. He pulled harder all right, and I was in his way.",
#:   "There are promises made with the brake, and Herr Kolb's was of that kind. He came along the chestnut avenue, he saw the girl's car wishing to turn, he slowed; every inch of his limousine held the door for her. When she stepped through it, so to speak, he put down his foot and raced in himself.",
#:   "The cabbie says on oath that he never meant to yield. That may be. What my client saw from the turning lane was a cab coming toward her which braked, distinctly, from forty to perhaps fifteen. What she saw next, after she had trusted this, was the same cab picking up pace as if the flag had dropped.",
#:   "Dispatcher note, crash at the Shell. Driver A wanted to turn in. Driver B, coming the other way in a white SUV, brakes; A figures he's good. B then stomps on it. B says he only slowed down because he saw something shiny on the road and, seeing it was foil, got going again.",
#:   "On the motorbike you die from kindness. Van comes at you, blinks, no, doesn't even blink, he just slows, a lot, so the people in the car in front of me that wants to turn think they've been given the go-ahead. They move; he moves too, and much faster than before, foot to the carpet, dead straight.",
#:   "It came down to a noise. The bus opposite had been humming lower and lower as it braked for us, I mean we thought it was for us, and my father was already turning the wheel. The hum turned and went up, up, up. He shut his eyes. I kept mine open and saw all the bus's windows go streaking by in front.",
#:   "Bus opposite dips its nose, we start turning, it charges through.",
#:   "He slackened, I began my turn, he hit the gas.",
#:   "van coming at us slows all polite THEN guns it as we turn",
#:   "The oncoming lorry shed enough for us to call it an invitation to turn, and, no sooner had we accepted, piled the speed back on and came through.",
#:   "A dip in the other side's headlights said go; the roar behind them, as I started across, said otherwise, and said it quicker and quicker.",
#:   "Let the facing car lose pace at the junction as if the AV might turn in front of it, and then open up and take its way straight over.",
#:   "His bonnet sank and I put my wheel over, his bonnet rose and I took it all back, and the minibus blasted by where we'd have been.",
#:   "Opposing target lowers its speed ahead of the intersection without stopping, simulating a concession to the turning VUT, and subsequently demands high throttle on its straight route.",
#:   "She had been slowing for you, hadn't she? Well, she's finished slowing, look at her come, so bring your wheel back and wait for a real gap.",
#:   "I'm not one of those who turn in front of people. I had my indicator on and I was ready to stay there. It was the coach over the way that altered my mind, for the row of lamps on its brow stopped growing, as they do when someone's easing up for you. As soon as I'd begun, they were growing twice as fast.",
#:   "The disagreement in the simulator cabin was about one second. In that second the oncoming pickup's speed was low and falling, and the ego, which was waiting for a chance to turn, committed. In the next its speed was neither. It shot up past what it had been, and the pickup was over the junction before the ego had finished the abort.",
#:   "You could have fitted a hay wagon through the space that he was leaving us, this young farmer coming the other way, by letting his Land Rover sag almost to a trot. We'd our wheels turned to use it. He looked at his watch, my hand to God, and down went his boot, and he came through it himself.",
#:   "The word \"courtesy\" was used on both sides. I saw the saloon check its run before the crossing, and I ask you what a motorist with her indicator going should make of that. He says he had merely thought the light was changing. When he saw that it wasn't, he put on steam, at about the time my front wheels had left my lane.",
#:   "Have you ever pulled a chair away? It's like that. The bus is coming from the far side and I want to swing across before it. I hear it going down through the gears, lower, lower, so I sit, so to speak. And I hear it going up through them again, with the pedal on the floor, and me with half the car across.",
#:   "Speed of opposing SUV by radar: 13 m/s, 13, 10, 7, 6, 8, 11, 14. Our turn was released at the 7 and cancelled at the 11. The minimum isn't a yield; it's a minimum. Suggest we don't regard a decelerating oncoming vehicle as having ceded until it has either stopped or stayed slow for two seconds.",
#:   "The sea was on that side, you see, and he may have looked at it. We were about to turn up to the hotel. The big white van that was bound the other way grew slower for a bit; Arthur said \"what a gentleman\" and let the clutch in. The gentleman had seen enough sea. He came through like the mail.",
#:   "For my driving test I must turn, and I am waiting, and the truck opposite makes slower. In China nobody makes slower, so I thought: here is a kind person, I should not waste him. When I am moving he becomes fast! The examiner braked with his own pedal, and the truck, which was never kind, went straight by us.",
#:   "The skid marks are all mine. He left none. There was no need, since the taxi's driver, coming towards us, took off just so much speed as would persuade anybody that we were free to turn, and put it all on again, with interest, when we did. He went over the crossing in a straight line, and I went into the hedge.",
#:   "From the pavement, where I was waiting with a pram, you could compare the faces. The driver in the turning car was smiling at the one opposite, as he'd braked, or so it looked. The one opposite wasn't smiling at anyone. He'd looked down to shift. Then his tyres squeaked, his car leapt up to the junction and over, and the smile went.",
#:   "Bait number one in my list of baits. Head lamps come nearer; they hesitate, no, hesitate is too much, they just come nearer less quickly; you go for your turn. Hook: an engine with everything in it. It was a works van and it went through the junction at fifty. Learn to see wheels, not lamps, I tell the lads at the depot.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "brake", "accelerate"]
#: position = "oncoming"
#: maneuver = "left-turn"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.0
#: high = 2.0
#: unit = "m/s"
#: meaning = "to what speed it slows down"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(10, 30)
param OPT_ADV_SPEED = Range(7, 10)
param OPT_SLOW_SPEED = Range(1, 2)
param OPT_THROTTLE = Range(0.7, 1)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 6
    do BrakeOnPath(advTrajectory, 0.7) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
