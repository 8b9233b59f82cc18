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
#:   "She from there to here, we from here to there, at once.",
#:   "Motorbike dives out of our goal lane into our former one.",
#:   "No going back: the Mini over there has just taken our lane.",
#:   "The moment we began going left, the hatchback which was on the left came right, and took the very strip of road we'd got up from.",
#:   "Adversary drives in the lane the ego wants; when the ego sets off for it, he quits that lane and enters the one the ego is leaving.",
#:   "Like two people in a corridor: I step to your side, the biker steps to mine, and neither of us can step back.",
#:   "As the AV gave up the slow lane for the fast one, the minicab in the fast one gave that up for the slow.",
#:   "I was changing on the second lane and, at the same time, the Ford of the second lane throws itself on the first, exactly where I was leaving.",
#:   "Driver of the estate, previously established in lane two, transferred into lane one behind the lorry, the lane the claimant was in the act of vacating.",
#:   "There had been a milk tanker in front of me since Crewe, so I'd decided to get out from behind it. I checked the outside lane: a Honda, well forward, no trouble. No trouble until I was on the line, that is, when the Honda shot across from that lane into mine and sat itself down behind the tanker.",
#:   "In the debrief we put two toy cars on the table. This is you, leaving lane one for lane two. This red one is the coupé in lane two. Now, as you slide out, watch the red one, it slides the other way, and without a signal, in behind the dustcart. Where would you have gone if you'd had to abort?",
#:   "The subject vehicle's fallback in a lane change is, by design, the lane from which it started. This scenario removes the fallback. A motorcycle which has been travelling in the destination lane abruptly changes to the start lane and settles behind the slow leader, at the same time as the subject vehicle moves out.",
#:   "Half of me was over the dashes when I wished I'd stayed. Not because of where I was going, that was now lovely and clear. It was clear since the biker who'd been there had darted in front of me to the lane I was coming from, and I missed his rear wheel by the width of a newspaper.",
#:   "\"We'd exchanged lanes, that was all,\" the young man protested. That wasn't all, and the sergeant said so. The lady had indicated for four seconds and was going over. He, from the lane towards which she was going, had swung without warning to the lane she'd come out of, so close in front that she'd had to stand on everything.",
#:   "When the scrape came I thought I'd hit something in the lane I was joining. Wrong. There wasn't anything left in it. The saloon that used to be there had decided, just then, that it wanted to be behind the gritter, so it had cut over into my own lane while my back end was still there.",
#:   "The ego's intention is displayed in green: out from behind the tractor, one lane over. The intention of the other actor, a sports car which is already one lane over, is displayed in red: in behind the tractor. The two arrows cross. Both are carried out at once, and the red one comes without a turn signal.",
#:   "It was like that dance at weddings where everyone swaps partners. I left the nearside lane and its smelly old skip lorry to somebody else, and somebody else was quick to take them: a chap on a Vespa, who'd been in the lane I was making for, and who nipped across to the nearside as if I'd called him.",
#:   "Kindly note that I have given indicator. I was behind one slow tractor, so I went to the right lane. In right lane one Swift car was going. That fellow, without seeing anything, came to left lane, behind same tractor, where I was one second before. If I had to come back, full accident was there.",
#:   "After the near miss V1's driver moved to the shoulder and called in. He stated that he'd been leaving the right lane and that V2, a pickup in the left lane, had moved abruptly to the right lane in the same moment. The bed of V2 passed his front bumper \"by a hand\". V2 went on behind a slow camper.",
#:   "i get that you want the exit mate but so close?? im pulling out from behind this caravan into lane 2, your in lane 2, and right as i move you swerve over into lane 1 like im not even there. now your tailing the caravan in my old spot and ive got no way back if lane 2 goes wrong",
#:   "me and the audi swapped lanes, neither of us asking",
#:   "The biker whose lane we wanted wanted ours: over he came.",
#:   "Our old lane, behind the slow truck: taken by next lane's saloon.",
#:   "I signalled for his lane, he didn't signal for mine, and before I'd left it he had slotted himself in behind the tractor.",
#:   "While the ego goes from its lane to the neighbouring one, send the taxi out of the neighbouring one and into that which the ego's leaving.",
#:   "No sooner had the bus in front persuaded us to pull out than a motorcycle from the lane we were pulling into dived in behind that bus.",
#:   "The exchange was simultaneous: subject vehicle outward, target from the outer lane inward, ending directly astern of the leading vehicle.",
#:   "You want out from behind that caravan, but did you notice the hatchback over there wants in, and is already on its way?",
#:   "He was in the lane I go to, and when I go, he comes in the lane I come from, so sudden, behind the slow lorry.",
#:   "It's the going back that was the trouble. I'd moved half out, saw a coach coming up in the mirror, and thought, no, I'll stay behind the digger where I was. But where I was, there was by then a blue Clio, who'd come the opposite way out of the lane I'd been going into, and she hadn't even looked.",
#:   "Picture a revolving door. I step out of the slow lane, and the person who's in the fast lane, a motorcyclist in a yellow vest, uses the same moment and the same doorway to step into the slow one. He had no need to. There was just the one space behind that cement mixer and, until then, it had been me who filled it.",
#:   "The AV's reserve plan was to stay in lane, and it had to be thrown away at 14:08:31. Reason: object 12, which had till then been established in the lane the AV was about to enter, turned up between the AV and the leading van. The target lane was, therefore, free; the lane that we'd hoped to fall back on wasn't.",
#:   "A tyre mark doesn't lie. Mine starts in the right-hand lane and slants left. The sedan's starts in the left-hand lane and slants right. They form a neat X, about a car's length apart, and the right-hand arm of hers ends behind the milk tanker, at the very spot I'd just got out of. I'm told I cut her up!",
#:   "I'd been looking so hard at where I wanted to go, Officer. There was a moped in that lane, some way on, I meant to go in after him. And then my wing was nearly on his number plate, not over there but right here, on my own side, squeezed in between me and the lorry that I'd wanted to be rid of.",
#:   "What was supposed to be free was full and what was supposed to be full was free. Behind the slow camper, where we'd just been and where we still had our back wheels: a Toyota. In the lane alongside, where the Toyota had been a moment ago: not a soul. He had crossed over just as we did, the other way.",
#:   "Mei's first lesson. She wants change to left lane, I say good, signal, go slowly. Left lane has one white car. She moves, white car also moves, to the right, no light, very quick, to be behind old bus in the lane we leave. If I don't hold the wheel, our right corner kisses his left corner.",
#:   "Musical chairs on the M6, lads. I get sick of this wagon doing fifty, I pull out. The fella in the Beemer who's out there already must have an exit to catch, for he slings it across in front of me as I'm coming over, into the hole between me and the wagon. So he's got my chair. I've got his.",
#:   "Prior to the event the target keeps station in the lane to which the subject vehicle will change, and a slower vehicle leads in the subject's initial lane. As the change begins, the target performs one of its own in the contrary sense, completing it between leader and subject. It follows the leader thereafter. It doesn't return.",
#:   "\"I was thinking of you,\" the old motorcyclist assured me, \"I saw you wanted my lane and I made room.\" He'd made room, it's true. He had made it by flitting across my bows to the very strip of road that I was in process of giving up, and tucking himself in behind the hay cart.",
#:   "Closing the door behind you is polite; having it closed for you, on your heel, by a man in an Alfa, isn't. I was merging out. He'd been sailing along in the lane I was after, and out of the blue he was sailing no longer there, but in mine, my ex-lane I should say, up the chuff of the slow van.",
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
