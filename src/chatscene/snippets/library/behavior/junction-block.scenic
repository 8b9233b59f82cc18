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
#:   "Ambulance from the side wedged itself in the box. Not shifting.",
#:   "In drives a bendy bus from the side, and there it roosts.",
#:   "Crossroads corked: one skip lorry, mid-box, engine running, no intention.",
#:   "Traffic from the left had an artic at its head, which pulled out onto the hatching, drew up there and simply never went.",
#:   "Please let the crossing van get as far as the centre of the crossroads, bring itself to rest and leave the ego with no way over.",
#:   "The lorry has come from the right hand into the middle, there he made stop, and till evening I think he is there like a temple elephant.",
#:   "How long were you stationary in the middle of that intersection, having entered it from Mill Street? Until after the officers arrived, my lord.",
#:   "Obstruction scenario B2: crossing vehicle enters the conflict zone under power, halts over the ego's path by normal braking, zero speed until end of run.",
#:   "Our green came and went three times while that moped sat plumb in the box, where it had ridden in from the side and pulled up.",
#:   "I have been a crossing warden for years and you learn the faces. The man in the removal van looked down the side road's exit, saw it was full, and came on out anyhow. He drew up with his wheels on the yellow criss-cross, folded his newspaper, and nobody went over that junction until he'd read it.",
#:   "Our light had turned green and there was nothing to stop us but a wall of blue metal with windows in it. The number 9 had come across from the station side and run out of space. Its brakes hissed, its doors stayed closed, and for as long as we were there it did not turn a wheel.",
#:   "The planner times out in this run. A crossing SUV enters the box ahead of us, comes to a controlled stop on our path and is still there at the end of the log, ninety seconds on. Expected outcome is that the ego holds short of the junction and doesn't go looking for a hole.",
#:   "According to the signal controller both detector loops in the centre of the intersection were occupied from 17:02 onwards. V2, a semitrailer, had advanced onto them from the side street and been braked to a stop by its operator. It was still covering V1's lane at 17:09 when police arrived and directed it away.",
#:   "You could get a cigarette paper between that coach and the far kerb, but not a forty-tonner. He'd pulled out of the side road onto the crossroads, see, and dropped anchor, and wouldn't go on and couldn't go back. I switched off, got my flask out and rang the yard.",
#:   "Look past the car in front of you. There's a taxi coming into the junction from the left, and I'd expect him to carry on over and be done. He's braking, though, he's stopped right in the centre, and by the look of it he's stopping for good; so don't you go in after him.",
#:   "The party was waiting for us and we could not come through. From the other street a bus has driven in the crossroad, it has put its brakes and has remained there, long as a snake. All people made noise with the horn but this did not help, the bus stayed in its place.",
#:   "The town council has again been urged to act after a fire engine on a false alarm drew up in the heart of the Albert Street crossing and was left there. It had driven in from the eastern arm. Motorists on the High Street found their way shut for twenty-five minutes.",
#:   "The silence struck him first, that odd hush when a junction has stopped being one. A brewery dray had rolled in from the cross street, been reined to a stand by its driver exactly where the two ways met, and taken root. Beyond its barrels he could see the road he wanted, and it might have been in China.",
#:   "We counted four changes of the lights. In all that time the view from our windscreen was the same: a motorcyclist who had ridden in from the left, put down both feet on the spot we needed, and stood astride his machine gazing at his telephone. I'm eighty and I've never been so cross.",
#:   "So that's why you can't see the far side. The white van that was coming across has got its nose up to the middle, gone down on its springs, and now it's part of the scenery. Whatever you were planning to do here, wait, because the box is shut and he shows no sign of opening it.",
#:   "Cab in the crossroads. Not crossing it. Just in it.",
#:   "Tram lines, yellow grid, and on top of both, one immovable minibus",
#:   "Centre of the box taken up by a crossing HGV, for keeps.",
#:   "Where the far side of the junction ought to have been we could see only a removal firm's telephone number, and it never budged.",
#:   "The motorcyclist rode out from the left on to the hatched area, let the engine idle there and made a home of it.",
#:   "Three greens wasted, since the artic from the side street that had rolled on to our crossing point showed no sign of rolling off it.",
#:   "It is stuck in the middle like a fishbone, that bus; it came out of the other street and there was no more place to go.",
#:   "Can the ambulance please drive as far as the conflict point, from the cross road, and thereafter simply be furniture until the simulation ends?",
#:   "Result of run 12: the van entered from the right, attained the midpoint, braked to nil, and was still there when the ego timed out.",
#:   "We'd a clear view of the post office, and it got clipped off from the left, letter by letter, as a skip lorry came over from the side. P, O, S, T. At the second F the clipping stopped. That's where his bumper was and that's where his bumper is, and we can't any of us go through.",
#:   "I ate both of my sandwiches there. A double-decker had put itself athwart the crossing, having come from the hospital road and found no room on the other side, and whenever our light turned green its wheels were precisely where they'd been at the last green. I started on my wife's sandwich after that.",
#:   "The rule's simple: don't go in unless you can come out. Here's a gentleman from the right who hasn't read it. He's in, brakes on, in the dead centre, and he can't come out, and so you can't either. You may as well put the handbrake on and tell me about your holidays.",
#:   "Motorists hooted, a man on a balcony shouted advice, and a warden knocked on the glass. The red fire engine from Mill Street heeded none of them. It had pulled forward to the very navel of the crossroads and there it intended to remain, its crew gazing straight in front of them like guardsmen.",
#:   "Occupancy of the conflict zone begins at 4.1 s, when the crossing pickup decelerates from 7 m/s to standstill in it. Occupancy doesn't end. The subject vehicle, which had planned its passage for 6.0 s, revises the plan to 8, to 12, to 20 and then gives up. No steering, no rearward motion, no second start was recorded for the pickup.",
#:   "Ma'am, I know the light is green. If I go I'll be in the side of that coach, the one that came nosing over out of Third and went to sleep on the crosswalk lines. It's got its hazards on. Nope, he isn't going to let us by, there's not enough of the road left over for a skateboard.",
#:   "It was the shadow I stopped for. Low sun from the right, long shadow over the junction, and I waited for that to travel on along with whatever was casting it. It didn't travel. A bin lorry had driven in out of the side street up to the middle and hit the brakes, and the sun set behind it.",
#:   "What they found odd was the order of things. Usually one hears a crash first and afterwards finds a truck standing in the crossroads. Here there'd been no crash. The truck had simply come in from the east, slowed down till it didn't move, and left everyone else to think of another way home.",
#:   "Claim for late delivery, 400 tulips. The driver was prevented from traversing the intersection by a third-party vehicle, namely a taxi, that had entered it at right angles, stopped upon the lane he required and failed to vacate it. He waited, as instructed, and was not able to leave before the tulips had.",
#:   "You can ride a pushbike round most things, and I did ride round this one, but the car behind me couldn't. Scooter, big one, topbox. She'd trundled out of the lane on the left up to where the two roads meet and parked it, feet down, looking for her phone. I looked back from the park and she still was.",
#:   "Nothing was coming any more from the side street, that is how we knew that it was jammed. The last thing which had come was a crane on eight wheels, and it filled up the crossing from corner to corner. The foreman got out, lit a pipe, and looked at our bonnet as if we were the ones in the way.",
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

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
