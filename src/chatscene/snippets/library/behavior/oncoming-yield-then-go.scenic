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
