#: description = "The car cuts in, stops in front of the ego and backs up into it."
#: rephrasings = [
#:   "A crash-for-cash scammer cuts us up, stops and comes back at us in reverse.",
#:   "Vehicle 2 merged ahead of vehicle 1, halted and then backed toward it.",
#:   "Cut-in, stop, reverses at us.",
#:   "The target cuts in before the VUT, comes to standstill and moves rearward.",
#:   "He drives before us, he stands, and then makes back gear until it touches.",
#:   "The van pulls across, halts and backs up to a loading bay.",
#:   "A taxi grabs our lane, overshoots its fare and reverses without looking.",
#:   "The bus moves in from beside, pulls up and shunts backwards.",
#:   "nutter carved me up, pulled up dead and then stuck it in reverse and came back at my bonnet",
#:   "The operator of the Ford cut off V1, halted, then intentionally backed into the front of V1.",
#:   "Truck: swoops in, full stop, R gear -> into our front.",
#:   "The target cuts in, decelerates to standstill and then travels rearwards towards the VUT until impact.",
#:   "The car comes before me, he stops, and then he goes backward against my car!",
#:   "Crash-for-cash actor: lane change ahead, v=0, then negative v until it hits the SUT's nose.",
#:   "It barged in before her and halted; then the white lights came on, and it rolled back until metal met metal.",
#:   "Caller says an ambulance pulled across in front of her, stopped, and then backed up into her bumper. Insurance scam if you ask me.",
#:   "he cut us off, stopped, and REVERSED INTO US im not even joking",
#:   "Driver accused of insurance plot after barring the way, halting and slamming his van backwards into a nurse's hatchback",
#:   "You moved in ahead, you stopped, and you then engaged reverse gear and struck my client, yes or no?",
#:   "Fellow overtakes the lane, stops in front and takes reverse directly on our bonnet, full fraud case",
#:   "Carves in, sticks it on the spot, then shoves it in reverse and comes for my radiator, that's a claim job if ever I saw one",
#:   "Lane intrusion, standstill and rearward motion toward own vehicle; staged-collision scenario",
#:   "INSURANCE SCAM: truck blocks me then backs into my car",
#:   "The sedan butted in, planted itself and rammed backwards.",
#:   "Barges in ahead, pulls up, then comes backwards into us.",
#:   "Lane change in front of VUT, standstill, rearward travel into VUT.",
#:   "Van: in front, dead stop, reversing lights, crunch.",
#:   "The bus got in our way and stopped and came at us bottom first.",
#:   "Who swerves in front of you, halts, then rams you in reverse gear?",
#:   "Let the ambulance slip over from the next lane, come to rest with its back doors at our bumper, and then drive rearwards at us.",
#:   "The front damage arose when the insured's adversary, having changed into her lane and brought his lorry to a stand, set it moving backwards.",
#:   "Reversing alarm beeping, the dustcart rolled back onto the AV, which it had moments before boxed in by changing lanes and halting.",
#:   "He enters my lane with force, he puts the car at zero, and then with marcha atrás he comes to hit my front.",
#:   "Be advised, caller reports a grey SUV pulled across her, stood there, and has now backed at her deliberately, possible staged accident.",
#:   "Three steps for the adversary: take the ego's lane from the side, brake down to nothing just ahead, then roll tail-first at the ego.",
#:   "I know what a swoop-and-squat is, I've driven a cab since 1988, but this was new. Passat whips over in front of me and anchors up, fine, I stop in time, no bump, so what does he do? Finds reverse and gives me one on the radiator.",
#:   "According to the narrative, V2 entered V1's lane from the left, slowed until it was no longer moving, and after a brief pause accelerated rearward. V1's driver sounded the horn to no effect, and the tow bar of V2 penetrated the grille of V1.",
#:   "It seems the coach driver had spotted his stop too late. He veered in from the lane beside the robotaxi, brought that great thing to a stand, and then, without so much as a glance in his mirrors, shunted it backwards with the robotaxi right behind him.",
#:   "Court heard how the defendant would select lone drivers, steer his hatchback into their lane a few metres ahead, halt it completely, and then throw it into reverse so that it looked as if they had hit him from behind.",
#:   "What I felt first was annoyance, because the police car had taken my lane and then come to a stop for no reason. The annoyance turned to fear when its white lamps came on and the boot began to grow in my windscreen.",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "stop", "reverse"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 6.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 0.6
#: high = 1.8
#: unit = "m/s"
#: meaning = "how fast it backs up"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(6, 15)
param OPT_BRAKE = Range(0.4, 0.9)
param OPT_ADV_BACK_SPEED = Range(0.6, 1.8)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 4
    do DrivePath(egoRoute, 7) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 4 seconds
    do Halt()
