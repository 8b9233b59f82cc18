#: description = "The pedestrian reels across the road slowly, swaying from side to side."
#: rephrasings = [
#:   "Someone the worse for drink lurches over at a snail's pace, all over the place.",
#:   "The intoxicated pedestrian staggered slowly across the roadway.",
#:   "drunk ped, slow, swaying over",
#:   "The target follows a sinuous crossing path at 1 m/s.",
#:   "The man has drunken too much and goes slowly left and right over the street.",
#:   "A dizzy old gentleman totters across, drifting this way and that.",
#:   "He wavers over the tarmac step by unsteady step.",
#:   "A toddler waddles over with many a detour.",
#:   "some drunk was swaying his way over the road at a snail's pace, left a bit, right a bit",
#:   "The intoxicated subject slowly made his way over the street, swaying from side to side.",
#:   "Ped, drunk?, slow, lurching L/R while X-ing.",
#:   "The pedestrian target crosses at low speed with a superimposed lateral oscillation.",
#:   "A drunk man comes slow over the street, he moves like a ship, here and there.",
#:   "Slow crosser with sinusoidal path, v around 0.7 m/s, rocking to the sides all the way over.",
#:   "He rolled like a sailor as he came over, a little this way, a little that, and it took him an age.",
#:   "He's had a skinful, that one, he's rocking about and getting nowhere fast, give him time to get over.",
#:   "some wasted dude swaying across the road in slow motion",
#:   "A reveller rolled from side to side as he made a very slow passage over the street",
#:   "He swayed, he drifted, and he took an age to get over, is that what you saw?",
#:   "One drunkard crossing very slowly, this side that side, legs not listening to him",
#:   "Skinful on board, this one, two steps left, one step right, and all at the pace of a glacier",
#:   "Slow pedestrian crossing with pronounced lateral sway",
#:   "Drunk guy takes FOREVER swaying across the street",
#:   "The tippler wallowed sluggishly over.",
#:   "Unsteady man crosses at a creep, tilting left, then right.",
#:   "Slow reeler on foot, over the road in lurches from side to side.",
#:   "He traverse very slowly and balance himself to left, to right, always.",
#:   "Crossing pedestrian, low speed, rolling gait, no straight line, ego waits.",
#:   "Wobbly old woman, ever so slowly over our road, lurching sideways.",
#:   "A man with a bottle took the best part of a minute to get over in front of the taxi, listing to one side and then the other.",
#:   "Could you have somebody cross before the AV at a tottering pace, never in a straight line but lurching now to the left, now to the right?",
#:   "She was making her way over the street in slow motion and, being ill as it turned out, kept swinging from one side to the other.",
#:   "The pedestrian's crossing velocity did not exceed 0.7 m/s; the path exhibited alternating deviations to the left and to the right of the perpendicular.",
#:   "Mind the gentleman who's come out of the pub: he's on his way over, bit by bit, tacking like a dinghy, so hang back until he's landed.",
#:   "Slowly, terribly slowly, like a mast in a swell leaning to port and to starboard, the figure in the raincoat came over the road before us.",
#:   "Officer, I'd have hooted, only it wouldn't have helped. The fellow was crossing as though the ground were a ship's deck, over to this side, over to that side, and he moved forward so little with each step that I turned my engine off and waited.",
#:   "V1 approached an uncontrolled location. A pedestrian with a blood alcohol level of 0.21 was walking across V1's lane at a rate well below normal. The pedestrian swayed from left to right repeatedly, so that the driver of V1 was unable to judge on which side to pass.",
#:   "Our dog walks straighter than that man did. Daddy stopped the car and we all watched him come over. He went a bit this way and a bit that way, like when you've been spinning, and he was so slow that I could count to forty.",
#:   "Four in the morning, last load, and there's a lass in heels trying to get to the other pavement. She's weaving like a bee over a flower bed, left, right, left, and she's not getting there any faster than my wagon would on foot. I just sat and waited.",
#:   "We classify such persons as slow lateral oscillators: they traverse the carriageway at far below the usual walking speed, and superimposed on this is a body sway which carries the track alternately to either side. A constant-velocity model predicts neither the duration of the crossing nor its course.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "weave", "slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.95
#: high = 1.35
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 0.9
#: unit = "rad"
#: meaning = "how far each leg slants"

param OPT_ADV_SPEED = Range(0.95, 1.35)
param OPT_ADV_DISTANCE = Range(6, 34)
param OPT_ADV_ANGLE = Range(0.6, 0.9)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) for 0.6 seconds
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED, -2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
        do MoveAhead(globalParameters.OPT_ADV_SPEED, 2 * globalParameters.OPT_ADV_ANGLE) for 1.2 seconds
