#: description = "The car behind tailgates the ego, weaving from side to side to get past."
#: rephrasings = [
#:   "The hothead behind sits on our bumper and swings left and right looking for a way by.",
#:   "Vehicle 2 followed closely while swerving repeatedly within the lane.",
#:   "Tailgater, snaking, trying to pass.",
#:   "The target follows the VUT at short distance with lateral oscillations.",
#:   "He is near behind us and goes left, right, left, he wants to pass.",
#:   "A motorbike sways in our mirror, now this side, now that.",
#:   "A van dances on our tail, peering round one flank and then the other.",
#:   "Impatient, the taxi to our rear wags to and fro at our bumper.",
#:   "This nutter in a BMW was right up my chuff, dodging left and right looking for a way by.",
#:   "Vehicle 2 was observed following closely and moving repeatedly from one edge of the lane to the other in an attempt to pass.",
#:   "Car at rear, bumper to bumper, zigzagging, wants past.",
#:   "The following vehicle keeps minimal distance and oscillates laterally within the lane, seeking an opportunity to overtake.",
#:   "The motorbike behind me goes left, right, left, very close, because he wants to go before me.",
#:   "Chaser in rear snakes about at tiny headway, peeking out both sides but never actually gets by.",
#:   "She saw its headlights swing from one mirror to the other; it would not settle, it hung on her bumper and hunted for a gap.",
#:   "Chap behind is getting impatient, see him ducking out one side then the other, practically in your boot.",
#:   "this guy behind me is literally slaloming trying to get by, like chill",
#:   "A car rode close behind the family and darted from one side to the other in its hunt for a way through.",
#:   "The defendant, by his own account, hung at the rear of the vehicle and swung out repeatedly, first to one side and then to the other.",
#:   "One bike is behind me only, sometimes left, sometimes right, he is having so much of hurry.",
#:   "Muppet's filling both my mirrors in turn, left one, right one, like he's doing a flipping waltz back there.",
#:   "Close-following vehicle with alternating lateral displacement in search of a passing opportunity",
#:   "IMPATIENT BIKER CAN'T PICK A SIDE, dances behind me for miles",
#:   "The car at our tail jinks to and fro.",
#:   "Idiot glued to my boot, poking out left, then right, won't settle",
#:   "Make the follower crowd the AV and slalom restlessly, itching to overtake.",
#:   "Traffic 51, you've a hatchback on your bumper, wandering side to side, wants by.",
#:   "Close-up in rear stop swaying stop driver evidently seeks to overtake stop",
#:   "Mummy, that car's nearly touching us and it keeps wiggling!",
#:   "I want a scene where a saloon rides inches off the ego's rear and swings back and forth, eager to slip by.",
#:   "For about half a mile the motorcycle kept almost no distance from my tailgate, showing up first in the offside mirror and then in the nearside one.",
#:   "V2 was trailing V1 at less than one car length and made repeated lateral excursions in both directions, apparently searching for an opportunity to go around.",
#:   "An ambulance sits on the robotaxi's heels, grille filling the rear camera, edging out to either side by turns because it can't squeeze through.",
#:   "Don't be rattled by the chap at your back who's nearly in your boot; he's bobbing from one side to the other hoping for a gap, just hold your line.",
#:   "The auto behind is sticking on me and drives in snake lines, always pushing, he searches the hole for overtaking.",
#:   "I was doing a steady fifty when a black coupé came right up to my number plate. It never fell back; it just kept lurching toward the verge and then toward the centre line, the driver craning his neck to see a way round me.",
#:   "My client felt hounded. The other driver hung so near that his headlamps vanished beneath her rear window, and all the while he tacked left and right like a man trying to see past a tall hat at the theatre.",
#:   "Ticket 4471: rear-chaser scenario. Agent locks on at a very small gap, holds it for some seconds, then starts a sinusoidal motion behind us as if probing both flanks for a pass. It stays to our rear throughout; our planner must not panic-brake.",
#:   "At my age you don't like being hurried. This young man on a motorcycle was so near that I could hear his engine over my wireless, and he kept drifting out one side and then the other, fidgeting to go by.",
#:   "The clip shows what pushing looks like: the SUV is practically on the tow bar, and its nose appears on the left, ducks in, appears on the right, ducks in again. You can tell how desperately he wants in front.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: place = "road"
#: actions = ["tailgate", "weave"]
#: leader = false
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = 0.6
#: high = 3.0
#: unit = "m"
#: meaning = "how much room it leaves between its bumper and the ego's"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.8
#: high = 7.6
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.2
#: unit = "m"
#: meaning = "how far it swings to either side"

param OPT_ADV_GAP = Range(0.6, 3)
param OPT_ADV_SPEED = Range(6.8, 7.6)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.2)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12) for 3 seconds
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 2.6) until headway(advTrajectory, self, ego) < (ego.length + self.length) / 2 + 0.3
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
