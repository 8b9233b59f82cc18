#: description = "The oncoming car drifts over the centre line and comes back."
#: rephrasings = [
#:   "he's on his phone, wanders over the middle line and then notices",
#:   "Vehicle 2 gradually crossed the centreline and returned to its own lane.",
#:   "opposing veh drifts over the line, corrects",
#:   "The oncoming target slowly departs its lane toward the VUT and returns.",
#:   "The truck comes little by little on our side and later goes again to his side.",
#:   "A dozy lorry driver strays across the line before he pulls it straight.",
#:   "The biker coming the other way takes a wide arc over the dividing line.",
#:   "Sliding gently over onto our half, it eases away again.",
#:   "Someone coming the other way dozed off over the white line and then pulled himself back to his side.",
#:   "The opposing vehicle gradually went left of center and then returned to its lane.",
#:   "Opp. truck sags over CL, corrects back.",
#:   "The oncoming target departs its lane gradually across the centre line and subsequently recovers its lane.",
#:   "The bus against me comes slowly over the middle line and goes back to his side.",
#:   "Opposite actor: slow lateral drift over the centre line with recovery; encroachment is temporary.",
#:   "He must have nodded off, for he slid gently over onto her half, woke with a start, and slid back again.",
#:   "He's wandering over the middle, this one coming, probably on his phone; there, he's corrected himself.",
#:   "oncoming car was slowly floating into our side then went back, prob texting",
#:   "The driver of an approaching lorry nodded off, slipped over the middle of the road and recovered in time.",
#:   "By degrees you left your side, crossed the line dividing the traffic, and by degrees returned?",
#:   "The opposite bus came slowly into my side, must be sleeping, then he went back to his own side.",
#:   "Wanders over the middle at me, eyes on his phone no doubt, then wanders home again.",
#:   "Gradual centreline encroachment by opposing vehicle with self-recovery.",
#:   "ONCOMING DRIVER FALLS ASLEEP, WAKES UP JUST IN TIME",
#:   "The oncoming car leaked over the centre line and ebbed back.",
#:   "Oncoming van floats across the middle, then floats home.",
#:   "Lorry from the front leans gradually over the line, then recovers.",
#:   "Approaching biker eases wide over the dividing paint and returns.",
#:   "Have the oncoming coach stray slowly over centre, then resume its lane.",
#:   "He crept over the white line toward us and crept back.",
#:   "Bit by bit the saloon coming up the hill slid onto our half, and bit by bit it found its own again.",
#:   "A gradual excursion of the opposing vehicle beyond the centre marking is followed by an equally smooth return to its lane.",
#:   "You'll often meet this: the fellow opposite looks at his sat-nav, sags across the line, notices, and steers gently onto his own side.",
#:   "The bus came from the other direction, and slowly, like a boat without captain, it went over the line before it found back.",
#:   "By the time our robotaxi had braked, the pickup approaching it was on its proper side again after wandering half a metre over the centre.",
#:   "Did you notice that oncoming tipper sort of melt over the middle of the road and then put itself right?",
#:   "She was coming round the long bend in a little hatchback, fiddling with something on the seat. I watched the car bleed over the lines inch by inch, hugged the verge, and then watched it ease itself where it belonged.",
#:   "V2, approaching from the opposite direction, was seen to encroach upon V1's lane over a distance of roughly forty feet. The encroachment was progressive, no sharp steering was noted, and V2 regained its lane prior to the vehicles meeting.",
#:   "It was a night of long straight roads and the trucker opposite had surely been awake since Poland. His lights moved over, over, until they were half in front of me; then he stirred, and they slipped away to the right place.",
#:   "I'm asking for an oncoming motorcyclist with a lazy line. He runs a bit wide past the centre stripe, not jerking, just carried out there, spends a second or two on our side, then curves back into his lane.",
#:   "Every evening this coach comes the other direction and the driver is eating. So the coach also is coming little over the centre, little over, then he sees me and little little he takes it to his side.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: opposite direction, no manoeuvre; own code"
#: [slots]
#: actions = ["oncoming", "turn-back"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 28.0
#: high = 60.0
#: unit = "m"
#: meaning = "distance to the ego at which it starts to drift"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.5
#: high = 3.0
#: unit = "m"
#: meaning = "how far it drifts"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 5.0
#: high = 8.0
#: unit = "s"
#: meaning = "twice as long as it is off its line"

param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_DISTANCE = Range(28, 60)
param OPT_ADV_AMPLITUDE = Range(1.5, 3)
param OPT_ADV_PERIOD = Range(5, 8)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD) for 0.5 * globalParameters.OPT_ADV_PERIOD seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
