#: description = "The car crosses the intersection in small jerks, stopping again and again."
#: rephrasings = [
#:   "goes a bit, stops, goes a bit, stops, all the way over",
#:   "Vehicle 2 proceeded through the intersection in a stop-and-go manner.",
#:   "kangaroos across: roll, halt, roll, halt",
#:   "The target traverses the junction slowly with repeated standstills.",
#:   "A beginner is crossing, his car stops every metre and starts again.",
#:   "A learner bunny-hops over the crossroads.",
#:   "The lorry shunts forward a little at a time, pausing between each move.",
#:   "Stuttering along at low speed, the bus needs several goes to get across.",
#:   "He kangarooed all the way over the crossroads, kept stopping and rolling on and stopping again.",
#:   "Vehicle 2 moved through the intersection in a series of short advances with repeated full stops.",
#:   "Truck hops thru jct: go-stop-go-stop-go.",
#:   "The target crosses the junction intermittently, with several successive halts.",
#:   "The car goes one meter, stops, goes one meter, stops, so over the whole crossing.",
#:   "Repeated stop/go cycles inside the intersection (3+ halts), not one hesitation and not a steady crawl.",
#:   "It lurched, and stood, and lurched again, and so by fits and starts it got itself across.",
#:   "Learner in the junction, he's bunny-hopping, stopping every couple of yards, give him plenty of space.",
#:   "this truck was stop go stop go stop go the whole way over the intersection im dying",
#:   "The van hiccuped over the crossroads, halting four or five times on the way.",
#:   "It did not halt once but repeatedly, moving a yard or two between each halt, until it was over the junction?",
#:   "Crossing the junction he go a bit, stop, go a bit, stop, very jerky driver.",
#:   "Like he's learning the clutch, hop, stop, hop, stop, right over the crossroads.",
#:   "Intermittent intersection transit with multiple successive halts.",
#:   "LEARNER BUNNY HOPS ACROSS THE ENTIRE INTERSECTION",
#:   "The bus hiccuped over the junction yard by yard.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it creeps"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.0
#: high = 2.0
#: unit = "s"
#: meaning = "how long it rolls each time"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.6
#: high = 1.0
#: unit = "s"
#: meaning = "how long it stands in between"

param OPT_ADV_DISTANCE = Range(5, 25)
param OPT_SLOW_SPEED = Range(2, 3.5)
param OPT_ADV_PERIOD = Range(1, 2)
param OPT_STOP_TIME = Range(0.6, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advMeeting) < 10 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    while True:
        do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) for globalParameters.OPT_ADV_PERIOD seconds
        do BrakeOnPath(advTrajectory) for globalParameters.OPT_STOP_TIME seconds
