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
#:   "Bus in front halts, bides its time, hangs a left off the road.",
#:   "Leader stationary in lane a while, then away left into a driveway.",
#:   "Up front the van's at a stand; by and by it's off the road, leftwards.",
#:   "Have the cab up front stop, hold, and exit left.",
#:   "Biker we follow waits at a standstill before veering left off the road.",
#:   "The tractor unit ahead came to rest in our lane, sat there with its indicator going, and eventually rolled off left into the depot.",
#:   "When the police car in front had stopped and kept all of us waiting some seconds, he left the road to the left hand.",
#:   "V1's lane was occupied by a stopped hatchback, which after a delay of several seconds departed leftward into a shopping-centre entrance.",
#:   "She's pulled up in front, so you stop behind her; she's in no rush, and now she's off the road to the left, carry on.",
#:   "How long must we sit behind this pickup, which has simply halted in the lane, before it makes its blessed left into the farm?",
#:   "With the preceding target at standstill for the defined stop time, a subsequent left turn shall take it off the carriageway.",
#:   "The ambulance ahead of us drew to a stop with its crew peering about for the right house. After a good long look they found it, and the thing rolled away leftward up a gravel path, and we could go on.",
#:   "I had stopped behind the coach because it had stopped too, in the running lane, no explanation. We sat. Then the driver must have seen his opening, as he swung it ponderously left and disappeared into the hotel car park.",
#:   "Scene request: one motorcycle rides in front of the AV and comes to a halt. It stands there for as long as a person needs to make up his mind, after which it goes off left, out of the roadway.",
#:   "Papa, the car in front is not moving! It was just standing there and we were just standing too, and then it went round to the side where the sweet shop is, on the left, and off the street.",
#:   "The learner who led our little procession stalled her courage rather than her engine. She stopped, she considered the gateway at her left for what seemed a whole afternoon, and at last she steered in and set the rest of us free.",
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
