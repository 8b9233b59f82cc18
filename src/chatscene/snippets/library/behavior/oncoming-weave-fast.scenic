#: description = "The oncoming car comes at high speed, weaving from side to side."
#: rephrasings = [
#:   "he's flying towards us and snaking all over the road",
#:   "Vehicle 2 approached at high speed on an erratic course.",
#:   "opposing veh, fast, swaying left-right",
#:   "The oncoming target travels at 43 km/h or more on a sinuous path about its lane.",
#:   "A motorcycle comes with big speed making zigzag.",
#:   "A biker barrels along with a violent tank-slapper.",
#:   "A speeding hatchback fishtails toward us.",
#:   "Far too quick and out of control, it sways this way and that as it comes.",
#:   "Some headcase came the other way flat out, snaking all over the place.",
#:   "Opposing vehicle approached at a high rate of speed, swaying from edge to edge.",
#:   "Bike oncoming, v. fast, zigzag.",
#:   "The opposing vehicle approaches at elevated speed with sinusoidal lateral oscillation.",
#:   "The car from the front is very fast and goes left right left right.",
#:   "Opp. traffic: high v plus slalom around its own lane, unlike the slow weaver that sits in ours.",
#:   "It tore down upon them, slithering from side to side like something hunted.",
#:   "Fast one coming at you, he can't hold a line at that speed, he's fishtailing.",
#:   "some maniac flew towards me swerving side to side at like 100",
#:   "A car hurtled toward oncoming traffic, swinging from left to right as it came.",
#:   "It approached at a breakneck rate, your Honour, and never for two seconds on the same line.",
#:   "Opposite bike coming zig-zag in full speed, like video game.",
#:   "Coming at me flat to the boards and wagging like a dog's tail.",
#:   "High-speed approach of opposing vehicle with alternating lateral deviations",
#:   "ONCOMING LUNATIC SLALOMS AT FULL SPEED",
#:   "The oncoming motorcycle slithers toward us at tremendous speed.",
#:   "Hatchback hurtling at us, tail swinging like a pendulum.",
#:   "Opposing bike: way over the limit and all over the shop.",
#:   "Send a speeding oncoming saloon whose path wobbles left, right, left, right.",
#:   "omg here he comes doing like a hundred swerving side to side",
#:   "Oncoming motorcycle at great velocity, never on a straight line.",
#:   "The sports car approaching us was going far beyond the limit and couldn't be kept straight, lurching to the verge, then to the middle, then to the verge again.",
#:   "Opposing target: speed not less than 60 km/h, lateral motion periodic with 0.8 m amplitude about the lane centre for the whole approach to the VUT.",
#:   "I want an oncoming motorbike to charge in our direction at full tilt while it sways from one edge of its lane to the other and back.",
#:   "Claimant noticed the third party from afar because it was approaching much too quickly and rolling this way and that like a ship in heavy seas.",
#:   "Control, be advised, stolen Astra heading towards you on the old road at high speed, he's all over his carriageway, left and right, drunk by the looks of it.",
#:   "Una moto came from the front as a rocket, and with this velocity it was also dancing from one side to the other side.",
#:   "What frightened me wasn't only the speed, although he must have been doing ninety. It was that the car would not run true. It leaned over to the left, then over to the right, then left again, and all the while it was getting bigger in my windscreen.",
#:   "According to three residents, Vehicle 2 came down the grade toward Vehicle 1 at an estimated seventy miles per hour in a thirty-five zone. Its rear end was swinging to alternate sides, and the tire marks on its side of the road form a long S.",
#:   "Have a look at this one. Country lane, I'm pootling along, and out of the distance comes a lad on a superbike giving it everything, and the whole bike is swaying, left, right, left, right, handlebars flapping, and he shoots past me like that.",
#:   "Grandpa pulled right up to the hedge because he'd seen the big silver car in front coming so terribly fast. It was wiggling too, first to the grass and then to the white line and then to the grass, and the wind of it shook us when it passed.",
#:   "For the paper we recreated the worst class of opposing traffic, that is, an actor which couples excessive approach speed with a continuous side-to-side oscillation of its path, so that neither its time of arrival nor its lateral position can be trusted by the ego.",
#:   "Hurtling our way, slewing left and right: one red coupe.",
#:   "Opposing motorcycle, tremendous pace, snaking without a break.",
#:   "He's bombing towards us and swinging from line to verge and back.",
#:   "Make an oncoming hot hatch approach far above the limit while its course keeps swaying, first to one edge of the lane, then to the other.",
#:   "At a speed estimated as double that permitted, V2 bore down upon V1 on a serpentine line, its sides leaning alternately inward and outward.",
#:   "Bike from front is coming like bullet train, and not straight also, this side that side this side that side, my heart stopped.",
#:   "Warning to traffic on the coast road: a white saloon is heading north at very high speed and cannot keep a straight course.",
#:   "As if the speed weren't enough, the approaching Audi waggled, nose to the hedge, nose to the centre line, over and over until it had gone by.",
#:   "What I ask for is a fast opponent, seventeen metres a second or thereabouts, coming from the front in a continuous slalom about its lane's middle.",
#:   "The dust told us first. It stood over the lane in a long plume, and the plume wasn't straight but wavy like hair. At the head of it was a car, coming at us at rally speed, and each time it came out of a wave its flank was on another side. We got as far into the nettles as we could.",
#:   "Since he was going to meet me I had him in my lamps all the way, the lunatic on the Kawasaki. He must have had a shake in the front end. His light was a figure of eight lying on its side, and it went from a spark to a sun in about four seconds, so work the speed out yourself.",
#:   "In view of the excessive closing speed, the insured brought her car to a stop on the verge. The third party's vehicle passed her a moment later; in its approach it had been observed to run in a sinuous manner between the edge and the middle of its half, and at no moment was that speed lessened.",
#:   "Take your foot off, now. That's someone coming down the hill much too quick. And look at his wheels, he's no longer in charge, he's over to his left, he's over to his right, he's back to the left. Don't guess where he'll be when he meets us, get in that gateway and let him by.",
#:   "Two things are varied in this series, namely how quick the opposing vehicle is and how much it sways. Condition D has both at the maximum. The vehicle tears towards the ego at 65 km/h, and its lateral position is at every moment changing, out and in, out and in, with a two-second period.",
#:   "Once in the war my father saw a plane come in like it, he told me. It was far too fast and it rolled from one wing to the other. What was coming towards our Morris this time was only a sports car, but it had the same rush in it, and it rocked from side to side all the way as it came.",
#:   "Seen the clip with the lad on the pit bike? He is on the other side, coming at the camera flat out with his chin on the tank. And the thing's going like a fish under him, left right left right left right, all over his lane. The uploader brakes to zero and you hear him praying.",
#:   "Perception log, opp. vehicle 12. Speed 19 m/s constant, heading towards us. Its y-coordinate is a nice sine wave, half a metre in, half a metre out, and this is why the predicted path flickered between \"own lane\" and \"collision\" at two hertz until it had passed us. The robotaxi braked eleven times.",
#:   "There are drunks who crawl and drunks who fly. This was one of the second kind, your worship. He flew at my client's car down the straight, and did so as a bat flies, that is, never two moments on the same line, tacking to the one side and to the other and still with his foot hard down.",
#:   "When the tyre of my motorbike went soft I was at hundred and ten, and I should have slowed, but I was late for my sister's wedding. So it swam under me, to the right, to the left, to the right, and towards me came a little car with nobody at its steering wheel, and I didn't brake for that one either.",
#:   "Like a shuttle in a loom it flew up the valley, never ceasing to pass from one side of its lane to the other, and with every pass it was nearer by fifty yards. She had time for one thought, which was that nobody can steer at such a speed, and the proof of it was coming straight, or not straight, at her.",
#:   "Coming at us like the clappers, weaving like a drunk wasp.",
#:   "Opposing sports bike: triple the limit, never one straight yard.",
#:   "Let an oncoming saloon rush us, swaying edge to edge.",
#:   "The speck on the straight became an Audi in about three breaths, and in each of those breaths it had hung over the verge and then over the centre line.",
#:   "His headlamp doubled in size every second, and the whole time it was swinging, hedge, line, hedge, line, like a lantern on a ship.",
#:   "Had he been slow I'd have laughed at his swaying, had he been straight I'd have cursed his speed, but the oncoming biker managed both.",
#:   "Opposing target: seventeen metres per second, lateral offset alternating about its lane centre with a two-second period, sustained until it has passed the VUT.",
#:   "Get into the gateway, that's a very quick one coming down, and look how its tail keeps going out, left, right, left.",
#:   "From opposite a Pulsar is coming so fast that the horn comes after him, and he's drawing snakes on the road, my left, my right.",
#:   "Hold a pencil between two fingers and wag it, that's what its bonnet was doing. I saw it over my handlebars, on the far side, at the top of the long hill, and I hadn't done wagging my own head when it was down at the bottom and past. The draught laid me in the bracken.",
#:   "We had worked out a rule with the kids for the long straights: shout \"car\" when you see one and count until it has gone by. Usually you get to twelve. For the white one they got to four. And the baby, who can't count, was turning her face from the one side to the other, in time with it.",
#:   "The tyre marks run for a hundred and sixty metres along V2's lane, now up to the gravel, now up to the paint, six waves in all. From the lean of the marks the institute derives a speed of some 130 km/h. V1, which was coming up the same road in the other direction, took to the shoulder as it came.",
#:   "I drive an artic, I don't scare. I was scared. There's this motorbike coming the other way and I can hear it over my own diesel, so he's on the stop. And the front end's having a fit. He goes from the kerb to the white line and back as if he was sewing it up, and closing on me at that speed.",
#:   "Predicted position error of the oncoming object, in metres: 0.2 to the left, 1.1 to the right, 1.3 to the left, and so on. Predicted arrival: far too late every time. It was simply swinging to and fro about its lane like a metronome arm, and doing so at a velocity for which our lookup table has no row.",
#:   "\"Is that one all right?\" she asked, of a car still small between the poplars. He'd no time to say that it wasn't. The poplars went by it like a stick along railings, and it kept showing them now its one flank, now its other. Then there was a bang of air, and the wing mirror, thank God only the mirror, folded in.",
#:   "The wet had got into his brakes, he told us, and into his tyres, and, I'd add, into his head. He'd come over the brow at the other end with the throttle pinned. You never saw the same side of him twice. Nearside, offside, nearside, every couple of seconds and fifty yards closer, till he'd gone by our car howling.",
#:   "Emergency call transcript. \"There's a red car on the coast road heading to you, north, and he'll be there before I've said it. Ninety? More. No, he isn't in my lane, he's in his, but he's using all of it, like, he's at the rocks, he's at the line, he's at the rocks. I was going south and I just stopped.\"",
#:   "For the instructor's handbook. An approaching vehicle can be hard to read by its pace or by its path. Here it's both. It'll be with you in no time, since it's going at twice what is sane. Where it'll be then can't be told, for it swings over to one side of its lane and over to the other, again and again.",
#:   "It came on as the swallows do before rain, low, and much too quick, and tilting first this wing and then that. In the robotaxi they'd put their newspapers down. A grey coupe, someone said later; all that the rest had seen was a thing that grew while it swung, and swung while it grew, over there in the oncoming lane.",
#:   "Wie ein Skifahrer, a ski racer in the gates, so this car came against us on his side. The driver wanted surely to be straight but the tempo did not let him. Left gate, right gate, left gate. I said to my wife, hold the dog. Before she held the dog the racer was already by us through.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "weave", "fast"]
#: place = "road"
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 2.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swings"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 3.0
#: high = 4.0
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(12, 15)
param OPT_ADV_AMPLITUDE = Range(2, 3)
param OPT_ADV_PERIOD = Range(3, 4)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
