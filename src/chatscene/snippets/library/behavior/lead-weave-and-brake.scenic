#: description = "The car ahead weaves in its lane like a drunk and suddenly brakes."
#: rephrasings = [
#:   "The drunk in front of us wobbles left and right and then stamps on the brake.",
#:   "Vehicle 2 was swerving within its lane before it abruptly decelerated and stopped.",
#:   "Lead snaking in lane, then hard stop.",
#:   "The target oscillates laterally in front of the VUT and finishes with emergency braking.",
#:   "The driver ahead goes zigzag, maybe he sleeps, and then he brakes much.",
#:   "The lorry before us sways to and fro, wakes up and jams everything on.",
#:   "A motorcyclist ahead snakes about and then hauls the machine to a stop.",
#:   "Our leader meanders on his phone, looks up, panics, halts.",
#:   "The bloke in front was all over the shop, must've been plastered, then out of nowhere he hit the brakes.",
#:   "The lead vehicle was observed drifting from side to side within its lane, consistent with impairment, and then braked suddenly.",
#:   "Lead wandering L/R like DUI, then abrupt brake to stop.",
#:   "The lead target exhibits lateral oscillation within the lane, followed by unannounced braking.",
#:   "The car in front drives like drunk man, left right, and suddenly he brakes.",
#:   "Drunk-driver lead: swerving sinusoid first, then unprovoked hard brake to standstill.",
#:   "He rolled about before her like a sailor on shore leave, and then without rhyme or reason he jammed it to a stop.",
#:   "He's had a skinful, that one, look at him swaying, and now he's slammed on, hang back!",
#:   "car ahead was swerving side to side like wasted and then just braked",
#:   "A suspected drink-driver lolled about his lane ahead of other traffic and then pulled up without cause.",
#:   "Your vehicle would not keep a straight course, my lady's witness says, and then, quite suddenly, you braked?",
#:   "Front car was going zig zag in his lane like drunkard, after that sudden brake.",
#:   "Pickled, he must be, rolling about the lane in front like a ferry, then on go the brakes.",
#:   "Erratic lateral lane wandering of lead vehicle culminating in sudden stop.",
#:   "DRUNK DRIVER AHEAD SWAYS THEN BRAKES",
#:   "The motorbike ahead reeled in its lane, then clawed to a stop.",
#:   "car ahead sways about in its lane n then breaks hard",
#:   "Lorry in front wriggles left and right, then an emergency stop.",
#:   "Lead moto: serpentine within lane, abrupt braking to rest.",
#:   "Sleepy bus driver ahead wanders, wakes, slams everything on.",
#:   "TIPSY? Driver in front wobbles along then SLAMS ON",
#:   "Get the van in front of the AV to drift from one lane edge to the other a few times, and then, with no warning, stop hard.",
#:   "First came the wobbling, this side, that side, never leaving his lane; then came the brake lights, and I very nearly ended in his boot.",
#:   "The fire engine we were behind rocked from line to line as though the wheel were loose, and out of the blue it stamped to a standstill.",
#:   "The lead vehicle shows a lane-internal sinusoidal course ahead of the test vehicle; at the trigger it decelerates strongly until at rest.",
#:   "Drunk driver report: pickup ahead of caller can't hold a straight line in his lane, and just now he braked to a dead stop for nothing.",
#:   "The front car is dancing in his lane, now near to right line, now near to left line, and at last he does a full braking.",
#:   "I noticed him first because his wheels kept touching the white line on one side and then the other. I dropped back a little, thinking he was drunk or texting. A good job I did, for all of a sudden he went for the brake and stopped.",
#:   "The driver of V2 had a blood alcohol level of 1.9. Before the impact his car, leading V1 by about twenty metres, moved to and fro inside its lane in several swings, and then it was braked heavily, without cause, until it no longer moved.",
#:   "My dad says never stay behind somebody who drives like a snake. The motorbike in front of us was wiggling all along its lane, and then it went screech and it stood still, and my dad had to screech as well.",
#:   "A good one for the perception people: the truck ahead snakes gently between its lane markings for some seconds, which already looks fishy, and when the ego gets close it adds a vicious brake application down to zero. The combination is what trips the planner.",
#:   "It was past midnight when the taxi before us took to reeling, from kerb side to centre line and over to the kerb side again, like a man feeling along a corridor for the light. Then it stopped, so violently that its tail lifted.",
#:   "Sozzled-looking pickup ahead: line to line, then all anchors out.",
#:   "Biker in front waltzed inside his lane until he abruptly stood.",
#:   "Swaying leader, no line held; next thing, dead stop.",
#:   "The police car we were behind kept drifting over and correcting, drifting over and correcting, and then braked as if for a cliff.",
#:   "Preceding vehicle exhibited within-lane meandering of roughly two-second half periods and concluded with a maximum-effort stop that no traffic situation called for.",
#:   "Is he asleep in there, this way, that way, brushing one line and then the other, and now, Lord help us, a full-blown stop!",
#:   "Please have the lead lorry lurch about between its lane lines like a punch-drunk boxer and finally brake to nothing without rhyme or reason.",
#:   "The fellow before me is dancing on the road inside his one lane only, and after dancing he is giving such a brake, I nearly died.",
#:   "For half a mile the scooter ahead wrote squiggles between the markings, and the full stop at the end of them was what nearly did for me.",
#:   "I ought to have rung the police sooner. From the moment he got in front of me the man in the Volvo was polishing first the left-hand line and then the right, over and over, never quite leaving the lane. By the church he hit the brakes for no reason and there he stood.",
#:   "The officer asked whether the brake lights were the first sign of trouble. They were not. Before them there had been a good deal of lolling about from one margin of the lane to the other, the way a boat does at anchor, and I'd backed off. When they came on the coach stopped in its own length.",
#:   "Lead truck behaviour for the impairment suite has two parts. In part one it tracks a slow serpentine of moderate amplitude, both wheel paths staying inside its own lane. In part two, on reaching the trigger and back near the lane centre, it brakes hard and remains at rest.",
#:   "Here's how you spot them at night, kids: watch the tail lights. These two reds here slide left, slide right, slide left, and they never slide out of the lane, so it's not a lane change, it's drink or a phone. And when three reds come up, he's stopping, right now, for nothing at all.",
#:   "We left the pub road at eleven and were behind a motorbike. At first I thought the wind was taking him, for he leant towards the ditch, then towards the middle, then towards the ditch, though there wasn't any wind. He suddenly grabbed everything and pulled up. My wife went into the dashboard.",
#:   "The lateral trace of V2 over the last nine seconds shows four excursions, none crossing a lane boundary. The longitudinal trace is flat until the ninth second and falls to zero within the next two. The driver, who led V1, tested positive and could account for neither.",
#:   "She was following a bus which seemed unable to make up its mind about the middle of its lane. It leaned to one edge and regretted it, leaned to the other and regretted that. She smiled at it, rather. She was still smiling when its great square back rose up in front of her, stock-still, hissing.",
#:   "Stopped, just like that, in the live lane, and I'm in a loaded wagon behind him. Mind you I'd had my doubts about that taxi since the services. He'd been snaking along in front of me from rumble strip to cat's eyes like he was steering with his knees.",
#:   "It is a known sign of the tiredness. The ambulance before my car goes not straight, it goes in small curves, near the right border and near the left border, always in the same lane. I hold distance. And truly, from one second to the other it brakes fully and is standing.",
#:   "The children were counting out loud how often it touched the lines. Left was winning with seven, right had six, and the old camper van ahead of us never once went over either. There was no eight. There was a squeal, and the camper stood, and so in the end did we, a hand's breadth off.",
#:   "Unit at the rear reports that her lead vehicle, a fire tender returning to station, appears to have a steering fault or a dozy driver. It has been wallowing about between the markings since the bridge. Correction, it's just jammed on and come to a complete halt in lane one.",
#:   "Line, line, line, line, STOP: the pickup ahead of us, Saturday night",
#:   "Coach in front wags its tail, gutter to centreline, then anchors.",
#:   "Lead scooter: lateral swings inside the lane, then standing still.",
#:   "The dog on the parcel shelf slid left, slid right, slid left again, and then forwards out of sight as the estate ahead stopped dead.",
#:   "I was too busy guessing which edge of the lane he would lick next, and so his emergency stop found me with my foot in the wrong place.",
#:   "Prior to its abrupt standstill the leading ambulance had visited both margins of its lane four times, according to the lane camera of the test car.",
#:   "That fellow in front is having full bottle inside him, you see, going this border that border, and then one brake like anything, finished, standing.",
#:   "I need an impaired leader: it should wander rhythmically between its lane markings before us and, without any cause, terminate in full braking to zero.",
#:   "Nobody who swings about in his own lane like a censer in church ought to be followed so near, I thought, and there he was, stationary.",
#:   "There were ruts in the slush. They belonged to the lorry in front and they looked like a plait, two strands crossing and crossing but never leaving the lane. I was following the plait with some amusement. Where it ended, with no warning at all, were the lorry's wheels, at a stand, and smoke coming off them.",
#:   "First you feel pity, because he seems ill. He floats over to the line, the tyres rumble on it, he wakes up and floats over to the other line, it rumbles as well, and so forth, rumble left, rumble right. Then you feel other things, because the bus is suddenly not floating, it's parked, and you have forty metres. Thirty.",
#:   "My friend behind the microphone will recall the horse box. We'd sat after it since the races, in our lane, in its lane, in a manner of speaking, since it used every inch from kerb to paint. Then the horses' ears went forward. All of them at once, like that, and I had the ramp in my lap.",
#:   "If there had been an arrow on his roof it would have pointed at ten o'clock, two o'clock, ten o'clock, two o'clock. You'd never have said the fire engine was leaving its lane, just that it wasn't on good terms with the middle. The clock stopped at noon. It had come back to the centre and all its wheels had locked.",
#:   "Data from the following vehicle: lead lateral deviation sinusoidal, amplitude 0.8 m, period 3.4 s, no boundary exceeded, duration nine seconds. Next sample, deviation nil, lead deceleration 8 m/s squared. Final sample, lead at rest. The operator of the lead motorcycle, when asked to walk a line, couldn't.",
#:   "Two facts made me phone you. One's that I have just seen a minicab shimmy the length of Dock Road, right up against the cats' eyes, right up against the kerb, over and over, with me behind. Two's that he then did a stop that put my tools through the bulkhead. He is still there. He's asleep, I think.",
#:   "You remember what I told you about the swimmer? That's what I call them, when the car in front goes breast-stroking from one side of its lane to the other. Never get near a swimmer, because they get a fright. There, that's him getting it. All on, nose in the road, not moving. And you had the room, well done.",
#:   "We were singing and trying to sway along with the caravan in front, everyone to the left, everyone to the right, Dad too. It really swayed a lot but it didn't come out of our lane. On \"merrily\" it had its lights on and it stood, and we all went to the front instead. Dad said a word.",
#:   "The driver's statement, that he \"always drives like that\", I don't doubt. It accounts for the first half mile, in the course of which his van described a wavy line between the lane markings ahead of my client's. It does not account for the end of the half mile, where with nothing before him he braked as hard as the van was able and stopped.",
#:   "A cat's cradle of rubber on the road at the end would have pleased me better; there was merely one short black pair. All the swinging had been done on rolling wheels, from the one white line to the other and again back, quite in its lane, quite gently. The short black pair was where the truck ahead had decided enough.",
#:   "She'd got a carton of milk between her knees and both thumbs on the phone, we found out later. From behind you saw only the Fiesta nibbling at the right edge of the lane, then nibbling at the left one. I'd dropped back a bit. Good thing too, for she looked up, saw God knows what, and nailed it to the floor.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "brake", "stop"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -25.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.5
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.7
#: high = 1.2
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-25, 5)
param OPT_ADV_SPEED = Range(5.5, 7.5)
param OPT_ADV_AMPLITUDE = Range(0.7, 1.2)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) for 2 seconds
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, 3.4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and abs(offsetFrom(advTrajectory, self)) < 0.7
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
