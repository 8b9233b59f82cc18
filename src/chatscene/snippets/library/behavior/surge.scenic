#: description = "The car speeds up and slows down by turns."
#: rephrasings = [
#:   "A vehicle alternates between throttle and brake.",
#:   "The adversary's pace rises and falls erratically.",
#:   "The driver accelerates, brakes, and accelerates once more without reason.",
#:   "The car next to the ego keeps changing its speed unpredictably.",
#:   "The motorbike lunges forward and checks itself again and again.",
#:   "On the gas, off the gas, on the gas: the guy drives like a yo-yo.",
#:   "Vehicle 2 was accelerating and decelerating repeatedly.",
#:   "The target follows a sawtooth speed profile.",
#:   "the bloke couldn't keep a steady speed to save his life, fast, slow, fast, slow, all the way along",
#:   "The driver repeatedly increased and decreased speed for no apparent reason.",
#:   "Truck speed up/down/up/down, yo-yo.",
#:   "The target's longitudinal speed alternates cyclically between acceleration and deceleration phases.",
#:   "The bus makes faster, slower, again faster, again slower, all the time.",
#:   "Oscillating velocity profile, several periods; no lateral motion, no full stop.",
#:   "The car ran on and hung back, ran on and hung back, like a dog on a walk.",
#:   "He's got a foot like a yo-yo, that biker: on the gas, off the gas, on again, off again. Makes you seasick.",
#:   "this car keeps going fast slow fast slow its making me ill",
#:   "A bus whose pace rose and fell like the tide perplexed those about it",
#:   "Your speed climbed, it fell, it climbed anew, and so it went on, did it not?",
#:   "This driver one time fast one time slow, one time fast again, cannot predict",
#:   "On the gas, off it, on it, off it, like he's pumping up a lilo",
#:   "Cyclic speed fluctuation of neighbouring traffic",
#:   "Motorbike can't hold a speed: fast, slow, FAST, SLOW",
#:   "The truck pulsed along.",
#:   "keeps darting ahead and braking off agian and again and again",
#:   "Its speed goes up, drops, goes up, drops, endlessly.",
#:   "Bus driver can't hold one pace: spurt, check, spurt, check.",
#:   "MAKE UP YOUR MIND! Car hurries, dawdles, hurries, dawdles",
#:   "Vary the lorry's pace: throttle phase, braking phase, repeat.",
#:   "The motorbike hurried for a few seconds and then held itself back for a few, and this game it played the whole length of the road.",
#:   "The target vehicle's speed shall rise under throttle and fall under braking in regular alternation, its lateral position in the lane being unaffected and no standstill occurring.",
#:   "One minute the van's pulling like a train, next it's braking, then it's off again, then it's braking again, and I've no idea what he's playing at.",
#:   "The taxi makes all the time gas and brake, gas and brake, my stomach was not happy only from looking to it.",
#:   "First it went whoosh and then it went slow, and then whoosh and slow again, and it would not stop doing that, said the little boy.",
#:   "A coach whose driver was alternately on the accelerator and on the brake pedal, without any pattern of traffic to explain it, was reported by three motorists.",
#:   "There was a hatchback near us on the way home whose driver, I can only suppose, was learning. She would put on a burst of speed, brake, put on another burst, brake once more, and so it went for as long as we had her in sight.",
#:   "Examination of V2's telematics shows a speed trace resembling the teeth of a saw: acceleration for about three seconds, braking for about two, acceleration again, and so on for the whole approach. At no time did the vehicle stop or depart from its lane.",
#:   "For this test the actor never travels at a constant speed. It presses on, it slackens by braking, it presses on anew, in cycles of a few seconds, so that any prediction which extrapolates the present speed will be wrong a moment later.",
#:   "When you drive a truck you want to know what the other fellow's doing. This pickup had me guessing: up he'd go to fifty, brake lights, down to thirty-five, up to fifty again, brake lights. Ten, twelve times he did that, I swear.",
#:   "It was as though two men were quarrelling over the pedals. The motorcycle sprang forward, shrank back on its brakes, sprang forward once more and shrank back once more, over and over, and nobody near it could tell which of the two would have the last word.",
#:   "Spurts, brakes, spurts, brakes; that lorry never once settles.",
#:   "Concertina car: gaining, braking, gaining, braking, no end to it.",
#:   "The moped's pace: up with a burst, down with a brake, repeat.",
#:   "I tried matching speeds with the coach and gave up, for it would race ahead, brake itself back, race ahead and brake itself back.",
#:   "Adversary longitudinal profile: alternating full-throttle and braking intervals of fixed period, minimum speed above zero, repeated to the end of the run.",
#:   "Is there something the matter with that driver, that he must stamp on the gas and then on the brake, turn and turn about?",
#:   "The lorry is giving race, then brake, again race, again brake, whole road like this, I thought maybe he is checking his new brake shoes.",
#:   "Please let the SUV never find its speed: some seconds of hard acceleration, some of braking, and so on round and round.",
#:   "brake lights on, off and vroom, on, off and vroom, that van was like a disco all the way to the ring rd",
#:   "If you had put a marble on his dashboard it would have rolled to and fro the whole afternoon. He'd be on the throttle, a hatchback with a mission; a few seconds later he'd be on the brake; and so through all of the valley, though no car and no bend obliged him.",
#:   "The adaptive cruise system in the subject vehicle chose a new speed eleven times in a minute. The reason was a motorcycle whose rider opened up and braked, opened up and braked, at intervals of about three seconds. At no point did he come to a stop, and he stayed in his lane.",
#:   "Could be a learner, could be a row with the wife, could be a sticky pedal. What I can tell you for certain is that the pickup won't hold a speed. He's off like a hare, there's his brake lights, he's off like a hare again, there they are again. So leave him plenty of room.",
#:   "You could hear the bus before it came into sight, and what you heard was a kind of breathing. The engine would swell for a bit, and then came the sigh of the air brakes; another swell, another sigh. So it went by, now quicker, now slower, and so it was still going in the distance.",
#:   "The passenger in V2 told investigators that her husband had been experimenting with the regenerative brake. She described being pressed into the seat and thrown into the belt by turns for upwards of a mile. Data confirm a regular succession of acceleration and deceleration phases with the speed lying between 24 and 57 km/h.",
#:   "Of all our actors this is the most tiresome to predict. One hypothesis says that it's leaving, as it is accelerating; before that has been confirmed it's braking, so it is yielding; and before that has been confirmed it's accelerating anew. The cycle has no end. Its path is the plain lane centre.",
#:   "When the big boys drive Papa's van they play a game. They go faster and faster until everyone shouts, and then they brake until everyone shouts, and then faster again and then brake again. They never stop for real. We were in the other car and could see the heads going nod, nod.",
#:   "I have the honour to report a saloon, driven by a gentleman in a cap, that travelled as a pump works. On the down stroke it leapt forward with a great effort; on the up stroke its brake lamps shone and it lost all that it had won. I counted fourteen strokes before it was lost to view.",
#:   "It made me sea-ill, I must say. The taxi pulls, brakes, pulls, brakes, the whole Kurfürstenstraße long, and there was before him nothing. My foot was only busy to go on the gas and off the gas, since the space to him became long, became short, became long, became short.",
#:   "By the third time we'd stopped believing any of it. Each spurt of that motorbike looked like the one with which it would be gone for good, and each time the red lamp came up and the spurt was taken back. It can have gained no more than a furlong by them in all.",
#:   "See those humps in the headway plot? That's the truck in its lane, full boot for three seconds, brakes for two, full boot for three, brakes for two, as regular as a heartbeat. Our controller chases every hump and the passengers are turning green. I want a smoother response by Friday.",
#:   "Pickup: quick, slow, quick, slow; no cruise in him.",
#:   "SPEED 60, 35, 60, 35... is this taxi driver OK??",
#:   "Revs swell, brake lamps glow, revs swell: that's the bus, nonstop.",
#:   "If you plotted that lorry's pace along the road you'd get the outline of the Alps, peak after valley after peak, on to the horizon.",
#:   "It was gas, brake, gas, brake with the minicab the whole way to the airport, and everyone aboard nodded like pigeons.",
#:   "The motorcycle bears forward under throttle, hangs back under brake, and bears forward anew; this alternation is continuous and doesn't lead to a stop.",
#:   "He is pressing and leaving, pressing and leaving, that van, one time it is like a rocket and next time like a bullock cart.",
#:   "Could the hatchback be made to pant, as it were: a few seconds of hard throttle, a few of braking, and on like that?",
#:   "Neither fast nor slow is the complaint, m'lud, but both, by turns, mile upon mile, the coach never once having held a steady pace.",
#:   "I tried to count sheep and counted brake lights. On, four seconds off, on, four seconds off. In every off the saloon put on such a spurt that I thought it'd be over the hill, and in every on it fell back as if it were on elastic. I had got to sixty-one when my wife said it was our exit.",
#:   "Our convoy leader radioed that he was getting sick. We could see why. The people carrier in the neighbouring lane would lurch forward till all its passengers' heads were pinned to the rests; then all of them bowed; then they were pinned again. It had gone on since the border and at no time did anyone see that car stand still.",
#:   "That's not a following distance, that's a concertina. With a pickup like his you get a metre to spare one second and sixty the next, as he's either chasing something or running from it. There he goes, foot down. There he goes, brakes. Foot down. So we don't play; we hold our thirty and let him do his squeezing and pulling.",
#:   "The fuel computer will have something to say to that gentleman. Uphill or down it was all one to him. His exhaust barked, and the bike leapt; his brake lamp glared, and the bike sank back; bark, glare, bark, glare, while my own needle stood on fifty as though painted. I never worked out what he wanted.",
#:   "From the pavement it sounded as if two lorries were going by, a fast and a slow one, that kept changing places. There was only the one. It'd rev up and come on at a great rate, then it would hiss and drop to half that. It did it past the school and it did it past the church and was doing it by the dairy.",
#:   "Where the adversary will be in two seconds depends on which half of its cycle you catch it in. In the throttle half it's gaining three metres per second each second; in the brake half it loses them again. It has no third half. Lane and heading don't change. Set the ego beside or behind it and see whether it oscillates too.",
#:   "Bertha said it was hiccups, and I said that buses can't have hiccups. But it did go hic, and hop forward really fast, and then its red lights came on and it got slow, and hic, it hopped again. It hopped all along the sea. Nobody got on or off as it never stopped, it only got slower and hopped.",
#:   "We've all got a cousin who drives on the pedals instead of with them. Mine has a van now. I had the misfortune of being in the next lane to her today. She'd surge up until her bumper was at my door, think, stamp, sink away till I'd lost sight of her, and up she'd come once more. From Slough to Reading.",
#:   "The accelerometer of the tanker shows a remarkable regularity. Positive for 3.0 s, negative for 1.8 s, positive for 3.0 s, negative for 1.8 s, with the trace never touching zero speed. It's the liquid, the haulier says. The officer who was driving behind it says that, liquid or not, he had to speed up and slow down eleven times.",
#:   "Beside her rode a stranger who did not know his own wish. Now the motorcycle strained ahead, and all its voice was in it; now it remembered itself and checked, and its lamp blushed. It strained again. She held to her pace, as one walks on beside a child that runs and dawdles, runs and dawdles, and is never quite lost nor caught.",
#:   "For a while I blamed my own foot. The gap to the taxi was big, it was small, it was big, and I thought, I'm nodding off. So I put the cruise on, seventy, and watched. Seventy I did, on the nose. It was him: flat out for a bit, brakes for a bit, flat out for a bit, like somebody blowing up an airbed.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["accelerate", "brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.35
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.2
#: high = 2.2
#: unit = "s"
#: meaning = "how long each phase lasts"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_THROTTLE = Range(0.6, 1)
param OPT_BRAKE = Range(0.35, 1)
param OPT_ADV_PERIOD = Range(1.2, 2.2)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for 0.6 * globalParameters.OPT_ADV_PERIOD seconds
        do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_ADV_PERIOD seconds
