#: description = "The car ahead stops in the lane, waits and then turns left off the road."
#: rephrasings = [
#:   "The car in front of us stops in the middle to wait and then swings left across the road.",
#:   "Vehicle 2 was stopped in the lane waiting to make a left turn into a drive and then turned.",
#:   "Lead stops, waits, left turn off road.",
#:   "The target stands ahead of the VUT, dwells and then leaves the road to the left.",
#:   "It stays before us to let the others go and then is turning to left in a parking.",
#:   "The truck we follow halts to let somebody by, then lumbers left into a yard.",
#:   "The bus ahead pulls up mid-lane, pauses and heaves itself left off the street.",
#:   "A biker ahead holds up everybody until he can cut left to the café.",
#:   "the car ahead stopped in the lane, hung about waiting for his moment and then peeled off left off the road",
#:   "V2, directly ahead, stopped in the travel lane, waited, and then completed a left turn off the roadway.",
#:   "Truck ahead halts in lane, waits, then L off rd.",
#:   "The lead vehicle stops in lane, remains stationary for a waiting period and then departs the road by a left turn.",
#:   "The bus in front stands some seconds in the lane, and after this it goes left, away from the street.",
#:   "Lead stop with dwell time, then left exit off the carriageway; the SUT has to queue behind it.",
#:   "It had pulled up before them and bided its time, and when it judged the moment right it swung left and was gone from the road.",
#:   "He's holding you up because he's wanting to go left off the road there. Patience... he's waiting... and off he goes.",
#:   "car in front stopped in the road forever then finally turned left",
#:   "Traffic was held up while a lorry stood in the road biding its time before leaving it to the left",
#:   "You remained stationary in the lane for some while and eventually departed to the left?",
#:   "Bus in front stop there wait wait wait, then only go left side",
#:   "He sits there in the middle of the lane having a think, and when he's good and ready off he goes left",
#:   "Standing lead vehicle awaiting left turn off the road; delayed clearance",
#:   "Car ahead waits FOREVER in the lane before turning left",
#:   "The van ahead lingered, then sidled off leftward.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "turn-left"]
#: place = "road"
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.2
#: high = 0.6
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 1.0
#: high = 2.5
#: unit = "s"
#: meaning = "how long it stands"

param OPT_ADV_DISTANCE = Range(5, 28)
param OPT_BRAKE = Range(0.2, 0.6)
param OPT_STOP_TIME = Range(1, 2.5)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do TurnOff(1.4, 3)
    do MoveAhead(3) for 4 seconds
    do Halt()
