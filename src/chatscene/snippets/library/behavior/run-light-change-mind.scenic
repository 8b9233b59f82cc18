#: description = "The crossing car brakes for the red light at the last moment, then changes its mind and accelerates through."
#: rephrasings = [
#:   "looks like he's stopping for the red, then he floors it after all",
#:   "Vehicle 2 braked for the red signal but then accelerated into the intersection.",
#:   "brakes at red, reconsiders, full throttle through",
#:   "The target decelerates at the stop line as if to comply with the red signal and then accelerates across the VUT's path.",
#:   "The motorcycle first is braking because of the red, but suddenly it gives gas and passes.",
#:   "A driver slams the brakes on for the lights and a heartbeat later guns it over the crossing.",
#:   "The rider checks his speed at the signal, thinks better of it, and blasts off on red.",
#:   "It slows sharply for the red, only to speed up and run it.",
#:   "he stood on the brakes for the red, then thought sod it and booted it through",
#:   "The driver braked late for the red signal, then reconsidered and sped up through the intersection.",
#:   "MC: brakes for red at last sec, then nope, full gas over.",
#:   "The crossing target brakes late at the red signal, aborts the stop and accelerates across the junction.",
#:   "The car has red, he brakes in last moment, but then he thinks other and goes with full gas.",
#:   "Red-light NPC with aborted stop: late decel, then release and throttle up across the box before reaching v=0.",
#:   "The biker had dipped his front wheel as if to obey the light, but the temptation got him and he roared over.",
#:   "He's stopping for the red... no he isn't! Dabbed the brakes, had second thoughts and gone for it.",
#:   "he was braking for the red n then was like nah and gunned it",
#:   "A motorist who looked set to obey the red signal reconsidered and shot over",
#:   "You had begun to brake for the signal, belatedly I grant, and then you resolved to defy it at full power?",
#:   "Red light he brake already, then suddenly don't want to stop, press oil and dash across",
#:   "Nose goes down, good lad, he's stopping for the red... no he ain't, foot down and through",
#:   "Revoked stopping decision at red signal: late braking, then acceleration through",
#:   "Biker brakes for the red light, then CHANGES HIS MIND",
#:   "The coupe balked at the red, then bolted over it.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "brake", "accelerate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(18, 50)
param OPT_ADV_SPEED = Range(6, 10)
param OPT_BRAKE = Range(0.5, 1)
param OPT_THROTTLE = Range(0.6, 1)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 2
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 2
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
