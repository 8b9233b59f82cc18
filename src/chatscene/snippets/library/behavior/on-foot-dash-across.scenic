#: description = "The oncoming pedestrian breaks into a sprint and dashes straight across the ego's lane."
#: rephrasings = [
#:   "A walker coming our way takes off like a shot and streaks over in front of us.",
#:   "A pedestrian walking against traffic suddenly ran across the roadway ahead of Vehicle 1.",
#:   "oncoming ped, sudden sprint across lane",
#:   "The target approaches at walking pace and then crosses at running speed.",
#:   "The boy comes slowly to us, then very fast he runs over the lane.",
#:   "Having spied a friend over the road, somebody who meets us tears across.",
#:   "The stroller ahead, facing us, hurtles over to the opposite pavement.",
#:   "A tourist we are about to pass rushes to the other side for a bus.",
#:   "A jogger coming towards me suddenly put on a spurt and legged it right over my lane.",
#:   "The pedestrian, walking toward Unit 1, suddenly sprinted laterally across its lane.",
#:   "Ped facing ego, walks up, then bolts straight over lane.",
#:   "The pedestrian target approaches the VUT head-on and then runs perpendicularly across its lane.",
#:   "A man walks in my direction against me, suddenly he runs fast over my lane.",
#:   "Oncoming ped on foot goes from walk to sprint and cuts our lane at a right angle.",
#:   "He'd been coming along to meet her at a stroll; all at once he took to his heels and shot across her front.",
#:   "Fellow walking up towards you, careful, he's broken into a run, he's going straight over in front!",
#:   "guy was walking towards us all chill then just BOOKED it across our lane",
#:   "A walker heading toward the car abruptly took to his heels across its lane.",
#:   "He was facing my client as he came, and then he ran, without warning, to the far side?",
#:   "One lady walking opposite to me suddenly started running and crossed in front.",
#:   "Comes strolling up to meet me, then someone fires the starting pistol and he's over my lane.",
#:   "Sudden sprint across ego lane by pedestrian approaching head-on.",
#:   "PEDESTRIAN WALKS TOWARD CAR THEN SUDDENLY SPRINTS ACROSS",
#:   "The approaching walker exploded into a run over our lane.",
#:   "Jogger facing us flips to full sprint, straight over our lane.",
#:   "Lady strolling to meet the van suddenly pelts over in front of it.",
#:   "Make a walker who's coming at us bolt directly through our lane.",
#:   "Man on foot, coming your way, off like a hare across you",
#:   "The boy walks against us, plötzlich he runs like hell over the lane.",
#:   "An old man had been ambling up the road towards me when, at the sight of his bus, he took to running and went right over my lane.",
#:   "V1's operator observed a pedestrian approaching on foot, face on; without warning that pedestrian changed to a run and traversed V1's lane at a right angle.",
#:   "She'd looked me in the eye through the windscreen, this girl walking my way, and then she just turned on the afterburners and raced across before my bonnet.",
#:   "The VRU target initially moves opposite to the travel direction of the VUT at 5 km/h, then turns by 90 degrees and clears its lane at 15 km/h.",
#:   "Who was to know that the lad dawdling up the verge to meet us would, within a few yards of our bumper, hare off to the other side?",
#:   "That fellow there, coming along facing you, keep an eye on him. What did I say? He's legging it, straight over in front, cover your brake.",
#:   "I was cycling home behind one of those robot cars. There was a woman in running gear trotting along the edge of the road towards it, quite relaxed, and for some reason she wheeled round sideways and ripped across the lane as though the pavement had caught fire behind her.",
#:   "The accused came on foot along the roadside in a direction opposed to that of the police vehicle. On recognising it, he did not turn on his heel; he took off at the run, directly over the lane in front of it, and vanished between the houses on the other side.",
#:   "Please give me someone walking towards the ego at an ordinary pace, the sort of person no one would think twice about. When we are near, that person must start sprinting and go square across our lane in one burst, without stopping in it or hesitating.",
#:   "I'm eighty-four and I still drive to the shops. A postman was coming up the road in my direction, sorting his letters as he walked. Then a dog barked somewhere, and off he shot like a man half his age, right over my side of the road, letters and all.",
#:   "Namaste, I share my near miss. One college fellow was walking from opposite side facing my car, talking in phone. When I came close only, he got some urgency and rushed at full speed through my lane to the other end, and not even once he checked for me.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "cross", "fast"]
#: position = "oncoming"
#: place = "road"
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.9
#: high = 1.8
#: unit = "m/s"
#: meaning = "how fast it walks at first"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.0
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it sprints"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 17.0
#: unit = "m"
#: meaning = "distance to the ego at which it sprints across"

param OPT_ADV_SPEED = Range(0.9, 1.8)
param OPT_ADV_SPRINT = Range(4, 6.5)
param OPT_ADV_DISTANCE = Range(5, 17)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 1 seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 1.5 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, 1.57)
