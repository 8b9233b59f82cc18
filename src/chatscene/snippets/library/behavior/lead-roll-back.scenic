#: description = "The car ahead stops gently and then rolls backwards toward the ego."
#: rephrasings = [
#:   "The one in front stops and starts rolling back at us like somebody forgot the handbrake.",
#:   "Vehicle 2 halted without hard braking and subsequently rolled rearward.",
#:   "Lead stands, rolls back slowly, no reversing lights.",
#:   "The target comes to standstill softly and then moves backward at low speed toward the VUT.",
#:   "The truck before us is standing and then it goes back by itself on the hill.",
#:   "A heavy bus ahead eases to rest and slides back on the slope.",
#:   "The van's clutch slips and down it comes, tail first, onto our bonnet.",
#:   "The leader loses its hold on the incline and trickles toward us in reverse.",
#:   "car in front pulled up all gently and then started rolling back at me, must've forgot his handbrake",
#:   "The box truck preceding V1 came to a smooth stop and subsequently rolled rearward in the direction of V1.",
#:   "Bus ahead: soft stop, then drifts backwards twd us.",
#:   "After a mild stop of the lead vehicle, it travels rearwards at low speed towards the stationary VUT.",
#:   "The car before me stops slowly, and after that comes back to me, like on a hill without brake.",
#:   "Lead halts comfortably, then takes on slight negative velocity so the gap to the SUT closes from the front.",
#:   "The van had settled to a standstill, and then, barely to be noticed at first, it slid back towards their radiator.",
#:   "He's stopped nicely, but watch it, he's not holding it on the clutch, he's coming back at you!",
#:   "car in front stopped and now its rolling BACK into us help",
#:   "A coach drew up softly and then, to the horror of the driver following, slipped backwards at her",
#:   "Having come to rest, the vehicle before you began to travel in reverse, towards you?",
#:   "The lorry ahead stopped, and then it is coming back back back onto us, no handbrake or what",
#:   "He pulls up all gentle, then he starts drifting back at me, oi, handbrake, mate",
#:   "Rearward motion of lead vehicle after gentle standstill; shrinking front gap",
#:   "Truck in front starts rolling BACKWARDS at me",
#:   "The van ahead settled, then slithered back at our nose.",
#:   "Bus in front eases to rest, then begins slipping back at us.",
#:   "Gentle halt by the van ahead, followed by a backward drift.",
#:   "Lead lorry settles softly to zero, then trickles tail-first toward VUT.",
#:   "Have the car in front stop mildly and roll back on us.",
#:   "He stopped so nice, and then he came down the hill backwards.",
#:   "The ambulance we were behind slowed without fuss, stood for a breath, and then its rear step began to come nearer, although our own wheels were still.",
#:   "Nothing sudden: the pickup ahead sheds its speed, comes to rest, and after a short wait creeps the wrong way, down the incline to our bumper.",
#:   "Is his handbrake on? He pulled up smoothly enough at the top of this rise, but the gap's shrinking, he's running back into you, sound the horn!",
#:   "The motorist before me finished his halt with much softness and then, the slope being steep, his car descended again in my direction.",
#:   "I want the lead truck to decelerate comfortably to a stop and, some seconds later, to lose its hold and travel slowly in reverse at the ego.",
#:   "Claimant's bonnet was dented by the towbar of a taxi that had coasted to a stop ahead of her and thereafter ran backward on the gradient.",
#:   "Log review, lap nine. Lead vehicle comes to rest at a mild rate, waits briefly, then shows about minus one metre per second toward the ego. Our stack assumed that a stopped lead can only stay or move off forwards. Please add a horn request and check the gap logic.",
#:   "We were behind a removals lorry on Castle Hill. It came to a stand quite tenderly, as these fellows do with a full load, and for a while all was well; then the letters on its tailboard grew larger and larger, and I realised it was travelling back down toward my radiator.",
#:   "On the recording the patrol car preceding the subject vehicle slows with no more than a light touch of brake and stops. Some two seconds afterward its brake lamps go out. It then moves rearward, with gathering pace, in the direction of the subject vehicle, which had no room to retreat.",
#:   "My instructor had told me to keep back from old cars on hills and now I know why. The banger in front rolled gently up to nothing, sat there, and then came sliding back towards my nose, its driver looking at her phone with both feet off the pedals.",
#:   "Honestly the slowest crash in the world. Bus ahead of me brings itself to a lovely smooth stop, I stop behind it. Then it starts coming back. Like, backwards. At me. Two miles an hour, and I'm leaning on the horn the entire time lol",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: backing up; own code"
#: [slots]
#: actions = ["slow", "stop", "reverse"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 35.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.14
#: high = 0.22
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.5
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_BACK_SPEED"
#: low = 0.8
#: high = 2.4
#: unit = "m/s"
#: meaning = "how fast it rolls back"

param OPT_ADV_DISTANCE = Range(10, 35)
param OPT_BRAKE = Range(0.14, 0.22)
param OPT_STOP_TIME = Range(0.5, 1.5)
param OPT_ADV_BACK_SPEED = Range(0.8, 2.4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK_SPEED) for 6 seconds
    do Halt()
