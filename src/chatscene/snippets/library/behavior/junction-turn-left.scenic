#: description = "The car turns left across the ego's way without yielding."
#: rephrasings = [
#:   "A vehicle swings left through the junction in front of the ego.",
#:   "The adversary makes a left turn and takes the ego's priority.",
#:   "The other driver turns to the left, cutting the ego's path.",
#:   "A left-turning car crosses before the ego.",
#:   "The motorcyclist sweeps left over the crossroads ahead of the ego.",
#:   "he hangs a left right across us",
#:   "Vehicle 2 turned left and failed to yield the right of way.",
#:   "The target turns left across the path of the VUT at constant speed.",
#:   "He hung a left right across my bows without so much as a by-your-leave.",
#:   "Unit 2 failed to yield while making a left turn and crossed the path of Unit 1.",
#:   "Truck left turn at x-ing, no give way, cuts us off.",
#:   "The target vehicle executes a left turn across the path of the test vehicle, disregarding priority.",
#:   "The bus goes to the left before me, but I have priority.",
#:   "LTAP: actor ignores our right of way and turns left at normal speed.",
#:   "She had the right of way, but the cyclist simply leaned to the left and took it from her.",
#:   "He's going left, he hasn't looked, he's not going to give way to you, brake.",
#:   "she turned left right in front of me like i didnt exist, my turn btw",
#:   "A bus turned left through the path of a motorist who had the right to go first.",
#:   "You were bound to let my client pass; instead you took your left turn before him.",
#:   "He has taken the left turn across me, giving way is not in his dictionary.",
#:   "Lefty there reckons he owns the crossing, round he goes over my front, manners of a goat.",
#:   "Priority violation by left-turning vehicle across own path",
#:   "DIDN'T YIELD! Left turner cuts right across",
#:   "The cyclist turns left and snatches our priority.",
#:   "Priority was ours; the cab took its left regardless.",
#:   "Cyclist goes round to his left straight over our path, no yield.",
#:   "Let a lorry turn left through my way at the crossing.",
#:   "She should have waited, but she swung it left before us.",
#:   "Failure to give way by a motorbike making a left at the junction.",
#:   "At the crossroads the milk float, which ought to have let us pass, bore round to its left over our half of the road.",
#:   "The driver of V2 stated he believed he could make his left turn ahead of V1, and did not yield as required.",
#:   "In this test case the other vehicle doesn't grant the ego its right of way and at normal pace turns leftward through its path.",
#:   "Why is this bus making his left now, when it is my go, and passing his whole length before my eyes?",
#:   "That bike's signalled left and he's not waiting for anybody, he's sweeping round in front of you at the crossing, cover the brake.",
#:   "he had the give way sign i didnt and he still chucked a left across me, unbelievable some people",
#:   "I came up to the junction at my usual thirty. The gentleman in the estate car looked me in the eye and took his left-hander over my path all the same, neither fast nor slow, as if I had not been there.",
#:   "We had a scooter at the four-way that owed us the right of way. It curved off to the left in front of the shuttle anyway, at an ordinary speed and without a stop, and the shuttle braked at minus five.",
#:   "The crossing by the church is marked clearly and my road goes first. The camion did not respect this; he has turned to his left and cut my route, and me I had to brake very strongly.",
#:   "It was the bus driver's opinion that size decides who goes first. He hauled the great wheel round and took his passengers leftward through the junction, under the nose of a little blue car which had every right to be there.",
#:   "Think of the junction as a clock. The pickup comes in, peels off leftward and passes over our line before we get to the middle, although his was the road with the yield triangle; he simply presumed we'd brake.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["acrossMeeting", "advMeeting", "advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["turn-left"]
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -4.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(-4, 26)
param OPT_ADV_SPEED = Range(4, 10)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, acrossMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
