#: description = "The car brakes suddenly and then drives off again."
#: rephrasings = [
#:   "A vehicle decelerates hard for a moment and afterwards picks up speed.",
#:   "The adversary brake-checks the ego and accelerates away.",
#:   "The car next to the ego slows sharply, then resumes its pace.",
#:   "The driver stamps on the brake and shortly after on the gas.",
#:   "The motorbike dabs the brakes violently and pulls away once more.",
#:   "He brake-tests us once and takes off again.",
#:   "Vehicle 2 decelerated abruptly, then resumed its travel speed.",
#:   "Hard brake pulse, then acceleration to prior speed.",
#:   "Chap jumped on the brakes for no reason and then off he went again.",
#:   "Vehicle 2 braked abruptly without cause, then resumed its speed.",
#:   "Car: hard brake, brief, then away again. No full block.",
#:   "The target applies sudden braking and, after a short interval, accelerates back to speed.",
#:   "The bus brakes suddenly and then goes on again.",
#:   "One brake event then recovery: decel spike, then throttle back up, keeps its lane.",
#:   "He stamped on the pedal out of the blue, seemed to come to his senses, and got going again.",
#:   "He's thrown the brakes on, wait, no, he's pulling away again, carry on.",
#:   "he braked outta nowhere and then just drove off like nothing happened",
#:   "For no evident cause the driver checked his car violently, then picked up his pace once more, a resident said.",
#:   "You braked with violence, released, and resumed your journey, all within a couple of seconds?",
#:   "Car suddenly put brake, then again started going, I don't know what for.",
#:   "Whacks his brakes on, thinks better of it, picks up again. Like driving behind a yo-yo.",
#:   "Unexpected short braking event with subsequent recovery of speed.",
#:   "RANDOM BRAKING THEN DRIVES OFF LIKE NOTHING HAPPENED",
#:   "The bus choked its speed and then revived.",
#:   "Coach drops anchor for a second, weighs it, and off again.",
#:   "Put in a scooter that brakes out of nowhere, then gets a move on.",
#:   "Brake lights! Oh. Never mind, the truck's picking its feet up again.",
#:   "Er bremst like for a ghost, then gives gas like before.",
#:   "car did a massive brake for a pigeon then just carried on",
#:   "The driver of the estate must have imagined something in the road, since he threw out the anchors and a second later was bowling along as before.",
#:   "Test 9b: the target applies 0.7 g for 1.2 s without visible cause, releases, and re-accelerates to its initial travelling speed in the same lane.",
#:   "It was soon rolling along at full speed again, that bus, but a moment earlier its nose had dipped so sharply that every strap-hanger aboard had lurched.",
#:   "Is he stopping? He's braked hard enough... no, he's let it off and he's gathering way again, so we just keep our distance and follow on.",
#:   "According to the motorcyclist's own statement he snatched at the lever when a wasp got into his helmet, then opened the throttle and continued on his way.",
#:   "The lorry stopped being a lorry and became a wall for a heartbeat; then it sighed, let go of its brakes and resumed its way down the road.",
#:   "I'm a courier, so I spend my days looking at other people's rear ends. The van today went from fifty to about twenty in no time at all, brake lights blazing, nothing in front of it whatsoever, and then the driver seemed to wake up and put his foot back on the accelerator.",
#:   "V1 was in steady traffic when V2 slowed with considerable force, for reasons its operator could not afterwards explain. The slowing lasted under two seconds. V2 then increased its speed once more and left the scene without its occupants having noticed that V1 had gone into the verge.",
#:   "Dear insurers, I enclose my sketch. The silver car suddenly slackened its pace so violently that my dog ended up in the footwell, and while I was still gathering him up it had already got back up to speed and was disappearing along the road as though nothing had occurred.",
#:   "Phantom-braking scenario wanted: the other vehicle, itself probably an assisted one, tracks its lane, fires a short, strong deceleration for no reason, and recovers. Afterwards it must be seen speeding back up and driving on, because the recovery is what our tracker keeps missing.",
#:   "My husband always says trucks cannot stop quickly, but this one did nearly. All of a sudden its wheels were smoking and its tail was in the air, then the smoke was gone and it trundled off with rising speed, leaving the two of us to remember how to breathe.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["brake", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE_TIME"
#: low = 0.7
#: high = 1.6
#: unit = "s"
#: meaning = "for how long"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it drives afterwards"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.4, 1)
param OPT_BRAKE_TIME = Range(0.7, 1.6)
param OPT_ADV_SPEED = Range(7, 12)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
