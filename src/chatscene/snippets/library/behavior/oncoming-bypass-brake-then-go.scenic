#: description = "The oncoming car brakes as if to let the ego around the obstacle, then accelerates."
#: rephrasings = [
#:   "he brakes like he's letting us through and then guns it",
#:   "Vehicle 2 decelerated as if yielding, then accelerated toward Vehicle 1 in the opposing lane.",
#:   "opposing veh brakes, then full gas, gap gone",
#:   "The oncoming target decelerates before the narrow place and then accelerates toward the VUT.",
#:   "The truck brakes, we think that we can pass, but it gives gas again.",
#:   "A biker checks his speed at the bottleneck, then opens up.",
#:   "The lorry opposite seems to give way but has second thoughts and surges on.",
#:   "A bus slows sharply for us, only to pick up speed a moment later.",
#:   "he slowed down like he was letting me round the skip, then the cheeky sod put his foot down",
#:   "The oncoming driver slowed, apparently yielding for V1 to go around the obstruction, then sped up.",
#:   "Oncoming van brakes (= go ahead?), then guns it while we pass obstacle.",
#:   "The oncoming target decelerates, suggesting priority to the VUT at the obstruction, and then increases its speed.",
#:   "The car from the front brakes, I think he gives me the way beside the blocked lane, but then he drives fast.",
#:   "Fake-yield at the bottleneck: oncoming actor drops its speed, waits for the SUT to commit, then goes full throttle.",
#:   "The lorry checked its pace as though to offer them the narrow way, and no sooner had they taken up the offer than it surged on.",
#:   "He's slowed to let you round that parked van... no, he hasn't, he's changed his tune, he's charging. False courtesy, that.",
#:   "he slowed down like \"you go\" and then sped up at us when we went around??",
#:   "An approaching lorry seemed to grant passage past the blockage, then surged ahead when the offer was taken up",
#:   "You braked, inviting my client to pass the obstruction, and then withdrew that invitation by accelerating?",
#:   "He slow down like giving way for us to pass the parked car, then suddenly press oil, cheater sia",
#:   "He eases up, I take it as \"after you\", I'm halfway round the skip and he only goes and floors it",
#:   "False yielding cue from opposing traffic during obstacle bypass; deceleration then renewed acceleration",
#:   "Oncoming bus PRETENDS to let me round, then charges",
#:   "The biker facing us made way with a brake, then revoked it with a roar.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "brake", "accelerate"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 28.0
#: high = 60.0
#: unit = "m"
#: meaning = "distance to the ego at which it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_SPEED = Range(7, 10)
param OPT_ADV_DISTANCE = Range(28, 60)
param OPT_BRAKE = Range(0.5, 0.9)
param OPT_THROTTLE = Range(0.7, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 1.5
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 10)
