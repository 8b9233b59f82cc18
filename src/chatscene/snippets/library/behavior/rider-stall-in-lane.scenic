#: description = "The rider rolls slowly out of the roadside into the ego's lane, stalls and stands across it."
#: rephrasings = [
#:   "A learner on a scooter creeps out, stalls and is stuck broadside before us.",
#:   "The motorcycle entered the travel lane at low speed, stalled, and blocked the lane.",
#:   "moto creeps out, stalls across lane",
#:   "The powered two-wheeler moves slowly onto the VUT's path and comes to rest perpendicular to it.",
#:   "The moped comes slowly and then the motor dies, it stays across on the lane.",
#:   "A rider loses his chain as he rolls off the pavement and stands there helpless.",
#:   "The e-bike gives up the ghost just as it noses into our way.",
#:   "A heavily laden cargo bike edges out and gets stuck sideways.",
#:   "an old boy on a moped trundled out off the roadside, cut out and was left standing sideways over my lane",
#:   "The motorcyclist rolled slowly from the roadside into the lane, stalled the engine, and remained across it.",
#:   "MC creeps out from side, engine dies, crosswise in lane.",
#:   "The PTW enters the lane at low speed from the roadside, loses drive and stands transverse to the VUT.",
#:   "The motorbike rolls slow from the side in my lane, then motor is off, and it stands cross.",
#:   "Rider emerges at walking pace from the shoulder, drops to v=0 by itself and stays at 90° to our heading.",
#:   "The scooter came trickling out of the verge, coughed and died, and there its rider sat, blocking the way with its length.",
#:   "She's rolled out too slow and she's stalled it, bike's lying across your bows now and she can't get it going.",
#:   "scooter rolled out rly slowly, died and is now sideways in our lane",
#:   "A trainee motorcyclist trickled into the road, lost his engine and was marooned broadside in the lane",
#:   "At a crawl you left the verge, your engine cut out, and the machine was left lying across the lane's width, upright?",
#:   "Bike slowly slowly came out from side, engine off, now standing crosswise blocking us",
#:   "Dribbles out off the side, conks out, and there he is side-on in front of me kicking the starter",
#:   "Slow roadside entry of two-wheeler with stall and transverse blockage",
#:   "Motorbike creeps out, STALLS sideways in my lane",
#:   "The moped seeped into our lane and conked out crossways.",
#:   "Pizza moped limps off the pavement, cuts out, bars our lane.",
#:   "E-bike crawls into our lane sideways and dies on the spot.",
#:   "Broadside and lifeless: the motorbike that had just dawdled off the verge.",
#:   "Make a scooter ease from the roadside into our path and conk out.",
#:   "Slow entry of bicycle, chain off, standing square across the lane.",
#:   "The pupil let the clutch up far too gently, trickled off the grass strip into the lane, felt the engine quit and sat there with the bike at right angles to us.",
#:   "A powered two-wheeler enters from beside the carriageway at 1.5 m/s, loses propulsion on the VUT's path and remains there, its longitudinal axis perpendicular to the lane.",
#:   "I had to stop because an old lady on a tricycle had rolled out of the hedge gap at a snail's pace, got stuck in my lane and couldn't move it.",
#:   "Please simulate a moped that comes off the side at hardly any speed, has its motor give out in the ego's lane and blocks it lengthwise, rider still astride.",
#:   "La moto go out very slowly from the border of the road, in my lane the engine he dies, and she remains there standing crossed.",
#:   "Careful, that scooter's inching out from the lay-by, she hasn't got the revs, and there, it's gone quiet, she's stranded sideways right where we want to go.",
#:   "I only wanted to get over to the petrol station. I let my old Honda roll gently out of the gateway, and with the front wheel about on the dotted line she coughed and gave up. There I was, side-on across the lane, kicking away like mad with a driverless car waiting.",
#:   "Vehicle 2, a 49 cc motor scooter, departed the shoulder at very low speed on a path perpendicular to the lane of Vehicle 1. Its engine ceased to run while it was in that lane, and it was standing upright and crosswise there when struck.",
#:   "It is a helpless sort of obstacle. First you see a cyclist with a loaded trailer pushing off laboriously from the roadside, hardly moving; then, in the middle of your lane, the legs give out, and bike and trailer are stuck athwart your way like a gate.",
#:   "Message to all cars, Station Road, be aware of a motorcycle obstructing. Rider came off the footway dead slow, engine failed as he got into the lane, and he's now stationary at right angles to the traffic. He can't restart and he hasn't pushed it clear.",
#:   "Did it come at you quickly, Mr Rao? No sir, very very slowly, from the mud side of the road. Then the motor went dut-dut and was finished, and the fellow was sitting on it there, handlebar to one side, back wheel to other side, my whole lane shut.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "slow", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.4
#: high = 2.6
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 30.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.1
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1.4, 2.6)
param OPT_ADV_DISTANCE = Range(30, 50)
param OPT_STOP_DISTANCE = Range(0, 1.1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
