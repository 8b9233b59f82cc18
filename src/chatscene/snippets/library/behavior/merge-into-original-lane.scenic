#: description = "The car in the target lane suddenly merges into the ego's original lane."
#: rephrasings = [
#:   "A vehicle from beside cuts over into the lane the ego is leaving.",
#:   "The adversary moves in behind the slow leader, where the ego came from, and blocks its return.",
#:   "The neighbouring car swaps lanes and slots in ahead of the ego behind the slow one.",
#:   "While the ego moves out, the other driver moves in to the place it left.",
#:   "The car next to the ego switches abruptly to the ego's initial lane.",
#:   "As we swing out, the other guy dives into the slot we've just left.",
#:   "Vehicle 2 moved into the lane that vehicle 1 was vacating.",
#:   "He goes in our old lane behind the slow one, so we cannot come back.",
#:   "just as I was leaving my lane, the bike from the one I was going into swapped straight over to where I'd come from",
#:   "While V1 was changing lanes, V2 left the destination lane and moved into the lane V1 had been occupying.",
#:   "Car swaps lanes w/ us: from new lane -> our old lane.",
#:   "The vehicle in the target lane makes an abrupt lane change into the lane that the VUT is departing from.",
#:   "I go to the other lane, and the car from there comes suddenly to my first lane.",
#:   "Lane swap conflict: NPC in the goal lane merges towards the SUT's starting lane while the SUT is moving out.",
#:   "They were about to change places, as it were: she slid out of her lane and the motorcycle, without warning, slid into it.",
#:   "You're going over there, and he, in that lane, has decided he wants the one you've been in all along. Careful, don't trade paint.",
#:   "i moved over to the next lane and the car there swapped right into the lane i just left",
#:   "A hatchback crossed, with no notice, from the lane a driver was aiming for to the very lane she came from",
#:   "The motorcycle quit the lane you were bound for and thrust itself into that in which you had begun?",
#:   "I want to go his lane, he suddenly come to my old lane, exchange ah",
#:   "I'm after his lane and blow me if he doesn't hop over to mine at the same moment",
#:   "Abrupt merge of destination-lane traffic into the own vehicle's initial lane",
#:   "Biker from the other lane suddenly swaps INTO MINE",
#:   "The hatchback hopped across from the target lane to our old one.",
#:   "As we leave for his lane, the sedan claims ours.",
#:   "Trading places: biker over there grabs the lane I'm giving up.",
#:   "Target-lane hatchback shifts into ego's departure lane, behind slow leader.",
#:   "He came into my lane exactly as I was getting out of it!",
#:   "Bike in new lane nips over to where you've just been.",
#:   "Let the convertible from the lane the ego is heading for change, at the same time, to the one that the ego has only just begun to leave.",
#:   "I wanted his side and he wanted mine; so the taxi drove over, no warning, and took my spot behind the tractor.",
#:   "While V1 was moving to the left lane, V2 in the left lane moved right, and came to occupy the lane where V1 had started.",
#:   "I make the change to the fast lane, and the motorbike that was there throws himself to the slow lane which was mine before.",
#:   "Don't count on going back, for the estate in the next lane has just slid across into the lane that you're pulling out of.",
#:   "Your old place is gone: the saloon which was running in the lane you picked has hopped over and parked itself behind the slow lorry.",
#:   "Funny dance we did there on the motorway. I got fed up with a caravan and started across; a white Golf in the lane I was crossing to must have wanted the exit, because it came the opposite way, into the very lane I'd been in.",
#:   "The manoeuvre puts pressure on the abort strategy. As the subject vehicle commits itself to the neighbouring lane, the motorcycle travelling there gives that lane up, heads across, and takes the space behind the slow leader to which the subject vehicle could otherwise have withdrawn.",
#:   "My instructor had only just said \"right, over you go\" and I'd started going over, when the Mini that was up ahead in that lane swerved over to ours. So we were swopping, and now I couldn't change my mind, because my own lane was taken.",
#:   "Counsel has suggested that my client blocked the claimant's return. He did nothing of the kind on purpose. He was riding in the overtaking lane, he shifted into the inside lane, and he could not have known that the claimant was at that moment moving out of it.",
#:   "The robotaxi had signalled and its wheels were turning. In the lane it was after there was a black cab, and the cabbie, having seen a fare on the pavement, cut across into the robotaxi's old lane and tucked himself in astern of the dawdling bin lorry.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["LeadingAgent", "advLane", "egoRoute", "leaderWay"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "change-lane"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives at most"
#: [[parameters]]
#: name = "OPT_ADV_BEHIND"
#: low = 8.0
#: high = 12.0
#: unit = "m"
#: meaning = "how far behind the leading vehicle it stays"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_ADV_SPEED = Range(6, 10)
param OPT_ADV_BEHIND = Range(8, 12)

behavior AdvBehavior():
    # At the latest where there is just room left behind the leading vehicle.
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE or headway(leaderWay, self, LeadingAgent) < globalParameters.OPT_ADV_BEHIND + 1
    do PaceOnPath(leaderWay, LeadingAgent, -globalParameters.OPT_ADV_BEHIND, globalParameters.OPT_ADV_SPEED)
