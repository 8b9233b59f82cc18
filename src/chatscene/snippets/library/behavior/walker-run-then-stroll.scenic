#: description = "The pedestrian runs out into the road and then slows to a stroll in the ego's lane."
#: rephrasings = [
#:   "She legs it as far as our lane, then dawdles the rest as though the danger were over.",
#:   "The pedestrian ran into the roadway and then slowed to a leisurely walk in the lane of travel.",
#:   "ped runs out, then slow walk in lane",
#:   "The target's speed drops from running to 1 m/s within the VUT's lane.",
#:   "First he runs, then in our lane he goes very slow.",
#:   "A youth sprints off the kerb and swaggers through the lane provocatively.",
#:   "The jogger runs out of puff mid-road and drags himself over.",
#:   "After a brisk start somebody takes it easy exactly in our way.",
#:   "this teenager pelted out into the road and then slowed right down and sauntered over in front of me, cocky so-and-so",
#:   "The pedestrian ran into the street and then reduced his pace to a leisurely walk in V1's lane.",
#:   "Ped dashes out, then dawdles in our lane.",
#:   "The pedestrian target enters at running speed and decreases to slow walking speed within the VUT's lane.",
#:   "The woman runs in the street, but in front of me she walks very relaxed.",
#:   "Crosser with negative speed step: fast entry, then slow amble inside our lane; keeps moving, doesn't halt.",
#:   "He had burst out running, and then, right before them, let himself fall into an idle walk as though in a park.",
#:   "He's bolted out, you'd think he'd keep at it, but no, now he's in your lane he's having a leisurely wander.",
#:   "he sprinted into the road then just started walking all slow in front of us like bruh",
#:   "A youth raced off the pavement and then sauntered through the lane as cars waited",
#:   "You ran into the road, and having got in front of the car you chose to amble?",
#:   "He came running on road and then in front of our car walking like in a park, full hero",
#:   "Bolts out like he's late for a bus, then takes his time in front of me like he's missed it",
#:   "Running road entry of pedestrian with pace collapse to slow walk in lane",
#:   "Guy sprints out then STROLLS in front of my car",
#:   "The lad dashed out and then moseyed through our lane.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.2
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it runs at first"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.9
#: high = 1.9
#: unit = "m"
#: meaning = "how far from the ego's line it slows down"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 0.6
#: high = 1.2
#: unit = "m/s"
#: meaning = "how fast it strolls"

param OPT_ADV_SPEED = Range(3.2, 6)
param OPT_ADV_DISTANCE = Range(4, 24)
param OPT_ADV_REACH = Range(0.9, 1.9)
param OPT_SLOW_SPEED = Range(0.6, 1.2)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_SLOW_SPEED)
