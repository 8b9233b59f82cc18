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
#:   "starts stoping for the red then reconsiders and zooms over the crossing",
#:   "Crossing biker brakes late at red, then rushes the junction.",
#:   "Cross traffic: red, hard brake, change of heart, full power.",
#:   "HE WAS STOPPING! ...then he floors it through the red",
#:   "Have the crossing coupe brake on red and then go for it.",
#:   "The van coming from the side had its nose right down for the red light, but before it stood still he let go and shot over the intersection.",
#:   "Against a red signal the crossing target applies its brake shortly ahead of the stop line, releases it prior to standstill and accelerates through the junction.",
#:   "Late on the brakes for his red, and nearly stopped, the motorcyclist must have decided that stopping was for others, and he tore over in front of us.",
#:   "I believed he will respect his red light because he braked, finally, at the last metre; but no, he put the gas again and crossed.",
#:   "The grey estate on the side road was obliged by the red to wait, and for one second looked as if it would, before it leapt across.",
#:   "Caller reports a taxi that was slowing for the red from the cross street, decided against it at the line and belted straight over the junction.",
#:   "My light was green, so his was red. I watched the SUV on my right dip under braking as it reached the line, rather late, and I relaxed. Then its nose came up, the engine howled, and it flew across the intersection just in front of me.",
#:   "According to the data recorder of V2, which faced a red signal, the brake was applied 1.6 seconds before the junction and released at a speed of 7 km/h. The accelerator was then fully depressed and V2 entered the intersection at increasing speed from V1's left.",
#:   "This actor should look obedient and then betray us. It comes along the cross street to a red light, gets on its brakes at the very last moment as if to stop, and while still rolling abandons that idea and powers through the junction.",
#:   "Never go by the first thing you see. The motorbike in the side road is braking for his red, yes, he's nearly at walking pace, you think he's done; and look, he can't be bothered to wait after all, he's opened it up and he's through.",
#:   "I know the type from forty years on the road. Comes belting up to the lights from the side, they're against him, so he stamps on the brake, front end goes down. Then you can see him think, ah, the hell with it, and he boots it over.",
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
