#: description = "The car slaloms across both lanes in front of the ego."
#: rephrasings = [
#:   "A lunatic ahead of us swings from lane to lane like a slalom skier.",
#:   "Vehicle 2 repeatedly moved back and forth between both lanes ahead of vehicle 1.",
#:   "Veh in next lane crossing in and out of ours, repeatedly.",
#:   "The target oscillates over two lane widths in front of the VUT.",
#:   "He goes our lane, his lane, our lane, his lane, without end.",
#:   "A stunt rider carves big esses over the whole carriageway.",
#:   "The van snakes over into us and out again, over and over.",
#:   "Using both lanes as his playground, the driver sweeps across us and back.",
#:   "boy racer in front of me was treating both lanes like a ski run, left right left right",
#:   "Suspect motorcycle repeatedly changed lanes without signal, zigzagging over both lanes ahead of complainant's car.",
#:   "Car lane-hops to & fro in front of us, L-R-L-R, uses both lanes.",
#:   "The target performs successive alternating lane changes ahead of the VUT, covering two lanes.",
#:   "One car goes to my lane, to the other lane, again to my lane, like snake, in front of me.",
#:   "Actor does a full-width S-curve over two lanes in front of the AV; it keeps entering and leaving our lane.",
#:   "The police car had swung over before her, then away, then over once more, sewing the two lanes together like a needle.",
#:   "Traffic unit to control: biker's swooping from one lane to the other and back, right under the nose of the car behind him, can't pick one.",
#:   "bro thinks its mario kart, hes swapping lanes nonstop in front of us",
#:   "A motorcyclist was seen criss-crossing both lanes ahead of commuters in what one called a circus act",
#:   "He crossed into my client's lane and out again, and in again, how many times, Mr Dent? At least four, sir.",
#:   "That fellow changing lane like nobody's business, this lane that lane this lane, right in front of us",
#:   "Can't settle on a lane, this one, he's had mine, then his, then mine again, like he's lacing a shoe",
#:   "Repeated two-lane oscillation of a vehicle ahead; recurrent re-entry into own lane",
#:   "Cop car zigzagging across BOTH lanes in front of me?!",
#:   "The hot hatch braided the two lanes together ahead of us.",
#:   "ahead of us he keeps swaping lanes ours next ours next",
#:   "Police bike zigzags the full width of both lanes before the AV.",
#:   "Make the hatchback switch lanes back and forth in front of us.",
#:   "Target slaloms over ego lane and neighbouring lane, several cycles.",
#:   "WATCH this muppet use two lanes like cones on a training ground",
#:   "The red car went in our lane and then in the other one and then in ours again, it was drawing wiggly lines, daddy said.",
#:   "From the lane beside the vehicle under test, the adversary moves over ahead of it, returns, and repeats the pattern in long sweeps across both lanes.",
#:   "The witness recalls an ambulance in front of him drifting from one lane clean into the other and back more times than he could count.",
#:   "Imagine a waiter dodging tables: that is how the motorcyclist before us took the two lanes, tilting over to one, tilting over to the other.",
#:   "Please can somebody tell the taxi in front that he may only have one of the two lanes, he is wandering across both of them end to end.",
#:   "In front of the robotaxi this cabriolet is making curves from the right lane to the left lane and again to the right lane, without a stop.",
#:   "I saw him from the cab a long way off, a little sports thing sweeping out of his own lane, right through mine, then out again and in again. It wasn't one lane change, it was ten of them, one after the other, ahead of my bonnet.",
#:   "Unit 2, initially in the lane adjacent to Unit 1, entered the lane ahead of Unit 1 and left it again at least four times. Its path was described by two independent witnesses as a series of wide bends reaching from one lane edge to the far one.",
#:   "To test the prediction module we need an actor that never settles: it crosses the dividing line toward us, swings back, crosses once more, and so forth, always a few car lengths in front. Call it a slalom with the two lanes as the piste.",
#:   "Now, I would not try to get by that motorcycle yet. You see him lean over into our lane, then over into the next, then to us again? As long as he's carving those big waves in front of you, neither lane is free.",
#:   "Honestly I thought he was warming up his tyres like they do behind the safety car. Big lazy swerves, all the way over to my side of the line, all the way back to the other, for half a mile, and me right behind watching.",
#:   "Biker ahead stitching both lanes together, across and back and across.",
#:   "His lane, ours, his, ours: the coupe wouldn't pick one.",
#:   "Both lanes swept by one wandering patrol car ahead of the ego.",
#:   "Ahead of our car, an SUV slid over into our lane, went back to its own, slid over again, and kept up this pendulum.",
#:   "The lead object's lane ID toggles 1-2-1-2-1 at five-second intervals while it remains fifteen metres in front of the subject vehicle.",
#:   "He is eating the two lanes, señor, he comes before my car, he goes to his lane, he comes again, all the time like a dancer.",
#:   "How am I meant to follow anybody who spends half his time in front of me and the other half in the lane next door, to and fro?",
#:   "Let the sports car start off next to the AV and then carve wide bends over both lanes before it, into its lane and out, repeatedly.",
#:   "What the drone footage shows is a moped drawing a wave over the tarmac, each crest in our lane and each trough in the neighbouring one.",
#:   "I had the cruise control on and it went mad. Every few seconds it found a car in front and braked, then lost it and pulled away, found it, lost it. Of course it did: the Audi up there was swinging clean across from the left-hand lane to mine and back the entire time.",
#:   "PC Lowe followed for a mile. The rider began in the lane alongside, leaned into the one we occupied, leaned out of it, and went on tacking from one to the other a short way ahead of our bonnet. There were no cones, no potholes and no other traffic to account for it.",
#:   "Mummy says it was a police car and that policemen ought to know better. It was on the side first and then it came in front of us. Then it went to the side and then it came in front of us, and it did that lots and lots, like skating.",
#:   "The dotted line between the lanes might have been a skipping rope for all he cared. A black hatchback, twenty yards ahead of our nose, hopped over it towards us, hopped back, hopped towards us, hopped back. We hung behind at forty with our hearts in our mouths because there was no telling where he'd be next.",
#:   "Request: an actor that starts in the lane beside us, gets slightly ahead, and then snakes at large amplitude so that it alternately occupies our lane and the other. It should not settle, and it should not stop. Purpose is to see whether the ego gives up on passing.",
#:   "Our insured was unable to pass at any time. A motorcyclist in front, having come from the neighbouring lane, would cover the insured's lane for a moment, withdraw to the next, and be back again before any gap could be used. This went on until the retail park.",
#:   "Being from Shenzhen I have seen many strange driving, but this one is new. The car not want lane one, not want lane two, it want both. It cross the white line to my front, cross back, cross again, many many times, big S shape, and I only can slow down and look.",
#:   "You could have plotted a sine curve from his tail lamps. They'd be dead ahead of us, then well off to one side over the next lane, then dead ahead, then off again, with the indicator dark throughout. My sister, who gets carsick, said she felt ill just watching it.",
#:   "They had been told the stuntman would warm up, so nobody on the crew worried when the ambulance alongside drew ahead and began to swing. It took in the whole width of both lanes with every swing, sliding over before the camera car and off again. On the fifth the director called cut.",
#:   "Dispatch, we've got a likely drunk on the dual carriageway, silver people carrier. He's in front of us using up lane one and lane two, drifts right across our nose, drifts off, straight back over again. We're keeping back, there's no safe side to go by him.",
#:   "Neither lane was ours, that is the best way I can put it. When we moved our eyes to the left the moped had just been there; it was back in front of our wheel, and before one could blink it had tilted off leftward anew. For a good half mile it laid its loops across the pair of them.",
#:   "Police bike ahead pendulums: neighbouring lane, ours, neighbouring lane, ours.",
#:   "That coupe's embroidering both lanes in front of us!",
#:   "Lane-line crossings by leading taxi: nine. Settled: never.",
#:   "Between us and the horizon there was one hatchback, and it wrote a very long letter S, again and again, over the pair of lanes.",
#:   "whoever's in the silver thing up front, brother, you gotta pick a lane, you've come across my nose six times and gone away six times",
#:   "Its shadow kept sliding on to our tarmac and off it; the ambulance casting that shadow was treating the two lanes as one wide dance floor before us.",
#:   "Would the honourable member care to know how it is to drive behind a man who is now in one's lane, now beside it, now in it?",
#:   "The front camera alternately shows a full rear view and an empty lane, at a period of six seconds, as the adversary sweeps over from next door and returns.",
#:   "I request one fire car: starts at side, comes somewhat forward, then makes the big wave through my lane and the other lane, many times over.",
#:   "My foot was going like a sewing machine. On the brake, since there's an SUV in front of me; off it, since the SUV's gone back over the white dashes to the lane it came from; on again, since here it is once more. The lad beside me counted eleven of those before our exit came.",
#:   "You'd think he was following a trail of something, a dog with a scent. The scent led him from the left lane athwart our headlights to the right-hand edge, then led him athwart them once more the opposite way, and so on, over and over, up the whole of that empty boulevard, always a little in front.",
#:   "V1's operator described attempting to get by on the left, finding the motorcycle there; attempting the right, finding it there; and giving up. The motorcycle had at first been abreast. Tyre traces on the damp surface form an unbroken wave that spans both lanes with seven crests, all of them forward of V1.",
#:   "Here is why I told you to hang back and stay out of it. Left lane's free, you say? Count to two. Now it isn't. Right lane's free? Count to two. That patrol car out in front is mopping the floor with both of them, side to side, to hold everyone up, and it'll be doing it a while yet.",
#:   "The thing with the cones was last year; this year, no cones, just a stag party. Their hired people carrier got a nose in front of us from the inside lane, and from there on it was tacking like a dinghy, our lane, theirs, ours, theirs, with somebody's arm out of each window in time to the music.",
#:   "Grandpa told us to watch the rear number plate and shout when we could read it. We could read it, then we couldn't as it was far over on the other lane, then we could again because it was straight in front. We shouted nineteen times. Grandpa said the lady was either dancing or unwell.",
#:   "Something was sweeping the road ahead of them with two red brooms. Over to the right they went, before the van's very lamps, and hung there; back to the left, clean into the lane beyond; over to the right. It was the doctor's motor, and the doctor, they afterwards heard, had not slept since Sunday.",
#:   "Fault: target selection flips. Lead vehicle detected, lost, detected, lost, twelve toggles in half a minute. Cause: no fault of ours. The taxi that had been alongside took up a position slightly ahead and keeps swinging between lane 1 and lane 2 with full lateral travel. It doesn't leave, and it doesn't choose.",
#:   "Rider here, and yes that was me, I'm sorry. I'd come up next to the robotaxi, slipped a few lengths in front and the road was so smooth and so empty that I started carving. Its lane, my lane, its lane, my lane. I forgot there were people in it. I hear that it followed me at twenty.",
#:   "What struck the inspector was how even it was. No lurching, no correcting, only those broad arcs that began in the outside lane, ran through the lane of the test car some fifteen metres before its bumper, and bent outward once more. He had watched ice skaters do as much. The difference was that the car behind could not pass.",
#:   "Sir, kindly note that I had no chance to go around. Whichever side I was thinking, that side the Innova was arriving. From the side lane he was coming before me, then returning, then again coming before me, just like the cloth of a man who is polishing a table, full two lanes wide.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["weave", "cut-in", "change-lane"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 6.0
#: high = 12.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.5
#: high = 6.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 3.2
#: high = 3.8
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 4.5
#: high = 6.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_AHEAD = Range(6, 12)
param OPT_ADV_SPEED = Range(4.5, 6.5)
param OPT_ADV_AMPLITUDE = Range(3.2, 3.8)
param OPT_ADV_PERIOD = Range(4.5, 6)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) for 2 seconds
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
