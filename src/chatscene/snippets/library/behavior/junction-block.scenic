#: description = "The car drives into the intersection and stays there, blocking the box."
#: rephrasings = [
#:   "he pulls in and just sits there in the box so nobody gets through",
#:   "Vehicle 2 entered the intersection and remained stationary, obstructing the travel lane.",
#:   "stands in the box, blocks the way",
#:   "The target comes to rest on the path of the VUT inside the junction and stays there.",
#:   "A truck enters in the crossing and stays there, the way of the ego is closed.",
#:   "A long bus gets stuck across the junction and shuts it off.",
#:   "The lorry ends up parked across the crossroads, long before the ego gets there.",
#:   "Gridlock: a van stands crosswise and there's no way past.",
#:   "The lorry trundled into the middle of the box and sat there like a lemon, no way through.",
#:   "Unit 2 entered the intersection and failed to clear it, obstructing cross traffic.",
#:   "Bus stands in mid junction, gridlock, not moving.",
#:   "The target vehicle occupies the conflict area and remains stationary there, obstructing the path of the test vehicle.",
#:   "Car goes in the crossing and stays in it, nobody can pass.",
#:   "Cross traffic actor parks in the box indefinitely, no reverse, no restart.",
#:   "It had rolled out into the crossroads and there it remained, plugging it like a cork.",
#:   "Fire engine's sat right across the yellow box, we're not going anywhere until he shifts.",
#:   "theres a bus just sitting in the middle of the intersection nobody can move",
#:   "A lorry came to rest amid the crossing and held up all comers.",
#:   "The defendant's vehicle lay athwart the intersection and there he let it lie.",
#:   "He has put his lorry in the middle of the junction and standing only, whole traffic jammed.",
#:   "Parks his backside in the middle of the crossroads and stays there, and I'm on a meter!",
#:   "Persistent obstruction of conflict area by stationary crossing vehicle",
#:   "ENTITLED DRIVER CLOGS THE WHOLE INTERSECTION",
#:   "The coach dams up the crossroads.",
#:   "An artic enters the crossroads, halts and simply won't clear.",
#:   "Crossing bus comes to a stand mid-box; route obstructed.",
#:   "Crossing motorbike rides into the junction and plants itself there for good.",
#:   "Have a van occupy the middle of the intersection and remain.",
#:   "YELLOW BOX? What yellow box? Cab stops on it and stays",
#:   "A fire engine came out of the side road as far as the centre of the crossing and that's where it stood, in everybody's way.",
#:   "theres no getting over the crossroads cos the lorry from the right drove in behind the queue and is now stood plumb in the middle",
#:   "The crossing vehicle shall proceed into the conflict zone, brake to rest there and stay, so that the path of the VUT is occupied.",
#:   "He could see full well his exit was choked, but in he went regardless, and now he's planted on the hatching and nobody can cross.",
#:   "The bus from left has gone inside the junction and is not coming out, it is only standing there like a wall before our car.",
#:   "Mum, the big truck drove to the middle where the roads meet and it isn't going anywhere, so how do we get through?",
#:   "It was at the lights by the station. A delivery van coming from the side street pulled forward onto the junction, braked, and then it did not budge again, neither forwards nor back, although half the town was sounding its horn at him.",
#:   "The collision risk arises because V2, a crossing tractor-trailer, advanced into the intersection when there was no space beyond it. It came to a halt athwart the through lanes and remained stationary for the rest of the recording, with its trailer closing off V1's path.",
#:   "Ticket 3312: planner doesn't know what to do with a blocked junction. Repro: a cross-traffic SUV drives up to the meeting point of the two paths, stops on it and keeps standing for ever. No creeping on, no backing out. Ego should wait.",
#:   "You mustn't enter till you can leave, that's the rule of the box. That coach there has broken it: he's come in from the side, he's had to stop in the centre, and there he stays, so we can't go anywhere until he's shifted.",
#:   "The old crossroads had seen many things, but seldom an ambulance come in at a fair lick from the mill road, pull up in the very heart of it and stand. The crew stayed in their seats, and the traffic on our side piled up before its flank.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["stop"]
#: maneuver = "straight"
#: position = "crossing"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 10.0
#: high = 13.0
#: unit = "m/s"
#: meaning = "how fast it drives in"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 0.8
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -1.0
#: high = 2.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_SPEED = Range(10, 13)
param OPT_BRAKE = Range(0.5, 0.8)
param OPT_STOP_DISTANCE = Range(-1, 2)

advTurn = "straight"

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
