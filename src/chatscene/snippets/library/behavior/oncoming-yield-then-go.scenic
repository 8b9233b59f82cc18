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
