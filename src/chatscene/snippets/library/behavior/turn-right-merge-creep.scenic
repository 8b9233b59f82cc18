#: description = "The car turns right into the ego's lane and crawls along in front of it."
#: rephrasings = [
#:   "pulls out of the side road in front of us and then just dawdles",
#:   "Vehicle 2 turned right onto the roadway ahead of Vehicle 1 and travelled at low speed.",
#:   "right turn into our lane, crawls",
#:   "The target turns right into the lane of the VUT and continues at less than 14 km/h.",
#:   "A bus comes from the right street before the ego and it drives very slowly.",
#:   "A cyclist rounds the corner to the right and pedals leisurely ahead of the ego.",
#:   "The tractor-trailer swings right and lumbers along, holding us up.",
#:   "A moped potters out to the right without giving way, and never gets going.",
#:   "He turned right out of the side road in front of me and then pootled along at walking pace.",
#:   "Unit 2 made a right turn into Unit 1's lane and continued at an unusually low speed.",
#:   "Tractor-trailer R turn into our lane, then crawls.",
#:   "The target vehicle joins the lane of the test vehicle by a right turn and proceeds at walking speed.",
#:   "A bus turns right into my lane and drives so slow before me.",
#:   "Cross traffic merges right into our lane, v stays ~5 km/h, doesn't stop or speed up.",
#:   "It came round the corner into her lane and there, when it ought to have got going, it merely ambled.",
#:   "Cyclist is turning right, out in front of you, and he's just dawdling now, so you'll have to slow.",
#:   "pulled out right in front of me turning right and then just... crawled",
#:   "A lorry came in from the side with a right-hand turn and held up the car behind with its sluggish pace.",
#:   "You turned right into the lane before my client, and having got there you scarcely moved along it.",
#:   "Lorry from side road turned right in front of me and then going like ant.",
#:   "Can't wait to turn out ahead of me, oh no, and then can't find second gear.",
#:   "Right-turn entry of crossing vehicle ahead of own vehicle with persistent crawl speed",
#:   "COULDN'T WAIT TO PULL OUT... THEN DOES 3 MPH",
#:   "The bus slips right into our lane and plods before us.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-right", "slow"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.8
#: high = 3.9
#: unit = "m/s"
#: meaning = "how fast it turns and goes on"

param OPT_ADV_DISTANCE = Range(2, 20)
param OPT_SLOW_SPEED = Range(2.8, 3.9)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until abs(offsetFrom(egoRoute, self)) < 6
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
