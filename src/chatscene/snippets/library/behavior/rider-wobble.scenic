#: description = "The rider ahead rides slowly and wobbles from side to side."
#: rephrasings = [
#:   "The old boy on the bike in front is wobbling all over the shop at walking pace.",
#:   "The bicyclist traveled slowly ahead of Vehicle 1 on an unsteady path.",
#:   "slow bike ahead, wobbling",
#:   "The bicyclist target moves at low speed ahead of the VUT with lateral oscillations.",
#:   "The cyclist before us is slow and goes left and right.",
#:   "A child learning to ride teeters along in our lane.",
#:   "A rider with shopping on the handlebars cannot keep a straight line.",
#:   "The scooter in front dawdles in wavy lines as if looking for an address.",
#:   "The cyclist in front was tottering along all over the place, hardly moving.",
#:   "The bicyclist ahead was riding unsteadily at low speed, drifting left and right.",
#:   "Bike ahead slow + unsteady, L-R-L. Keeps going.",
#:   "The leading cyclist target proceeds at low speed with continuous lateral oscillation.",
#:   "The bicycle in front is slow and shakes left and right.",
#:   "Slow leader VRU with lateral wander; no stop or turn, just unstable.",
#:   "She was new to the thing, and went along before him at a crawl, her front wheel hunting this way and that.",
#:   "Give him a wide berth, he's a shaky rider, slow as you like and swaying about in front of you.",
#:   "this old guy on a bike in front is so slow and so wobbly im scared for him",
#:   "An elderly cyclist teetered along at a modest pace, holding no line, witnesses said.",
#:   "The rider ahead was slow, and he could not keep a straight course; he swayed, did he not?",
#:   "Front cycle uncle going very slow and shaking this side that side, cannot pass.",
#:   "Pedalling through treacle in front of me and swaying like a washing line.",
#:   "Slow leading two-wheeler with pronounced lateral instability.",
#:   "WOBBLIEST CYCLIST IN TOWN",
#:   "The rider ahead joggled slowly left and right.",
#:   "Cyclist in front, doing about nothing, tacking like a boat.",
#:   "Have a feeble scooter ahead of us that totters left, right, left.",
#:   "Bike ahead: jelly-legged, tortoise speed, all over its bit of lane.",
#:   "Davanti a me one bicycle, piano piano, dancing left and right.",
#:   "Boy on bike's so slow he keeps tipping one way then the other",
#:   "My neighbour, ninety next week, was ahead of the taxi on her bicycle, proceeding at a dawdle and swerving a little this way and a little that.",
#:   "Leading powered two-wheeler to be ridden at 7 km/h with a periodic weave of ±0.5 m for the whole run, upright and under way throughout.",
#:   "A man balancing a ladder on his bicycle crept along the lane in front, and the ladder swung to and fro with each unsteady stroke of his pedals.",
#:   "You can't sensibly pass a moped that's waggling about like that, so we'll sit back here at its five miles an hour and be patient, shall we?",
#:   "At so low a speed no bicycle will run true, and the one ahead of the robotaxi rolled its front wheel continually leftward and rightward to keep from falling.",
#:   "The reason I held up the traffic, officer, was a biker before me, hardly moving, whose machine lurched now to the kerb side and now to the other.",
#:   "I got stuck going up Gallows Hill. There was a chap on a tourer in front of me with four panniers and no gears left, and he was grinding upwards slower than I could walk, with the bike squirming from one side to the other every time he pushed down on a pedal.",
#:   "The planner's lateral-gap check flip-flops here. A cyclist ahead in our lane is riding at eight km/h, and because of the low speed their track oscillates, half a metre left, half a metre right, for the whole length of the log. They never come off, never turn away, never stop.",
#:   "When you teach your daughter to ride on the road, pick a quieter one. Dad jogs alongside, and there she is, directly ahead of our car, at the speed of a toddler's tricycle, the handlebars twitching one way and then the other as she fights to keep the thing pointing forwards.",
#:   "Newspaper letters page: Sir, must learner motorcyclists practise at rush hour? For a mile on Tuesday I was behind one who travelled at little more than a trot and whose machine swung across the lane in a kind of slow pendulum, to left and to right, with the rest of us strung out at the back.",
#:   "Madam, the old uncle ahead was having two big milk cans hanging on his cycle. So he was going very slowly, and with the weight the cycle was rocking on both sides, once to the left, once to the right, like an elephant only, and I was going behind him fully careful.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "weave"]
#: position = "ahead"
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.4
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 1.3
#: high = 1.7
#: unit = "m"
#: meaning = "how far it wobbles to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.6
#: high = 4.6
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(2.4, 3.2)
param OPT_ADV_AMPLITUDE = Range(1.3, 1.7)
param OPT_ADV_PERIOD = Range(3.6, 4.6)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
