#: description = "The oncoming car weaves from side to side as it approaches."
#: rephrasings = [
#:   "A vehicle from ahead swings about its lane toward the ego.",
#:   "The opposing driver slaloms over the centre line and back.",
#:   "The adversary comes on in a wavering course.",
#:   "The approaching motorbike snakes to and fro.",
#:   "Opposing traffic sways erratically and keeps coming.",
#:   "the one coming toward us is swaying all over the road",
#:   "Vehicle 2 approached from the opposite direction on a weaving course.",
#:   "opposing veh, zigzag about its lane",
#:   "There was someone coming the other way snaking all over the place.",
#:   "The approaching vehicle was weaving left and right as it neared Unit 1.",
#:   "Opp. veh zigzag, L-R-L, closing.",
#:   "The oncoming target approaches with repeated alternating lateral deviations.",
#:   "The motorbike comes against me and makes zig-zag all the time.",
#:   "Opposite-direction actor with oscillating path; continuous, doesn't settle; lateral prediction jitters.",
#:   "He came tacking down the road to meet her, first one side, then the other, like a dinghy in a squall.",
#:   "See the headlights coming swinging about? He can't hold a line, keep well over to the edge.",
#:   "the car coming at us was going all squiggly",
#:   "An approaching van wound along the road from edge to edge, alarming drivers.",
#:   "The vehicle bearing toward you swung to one side, then the other, and so on until it reached you?",
#:   "Opposite bus was coming left-right, left-right, I don't know where to go.",
#:   "One's coming at me like he's dodging bullets, this side, that side, take your pick.",
#:   "Oscillating lateral path of approaching opposing vehicle.",
#:   "ONCOMING CAR ALL OVER THE ROAD",
#:   "The oncoming motorcycle slithered from side to side.",
#:   "Oncoming HGV snaking left and right as it nears, exercise caution.",
#:   "Moped from ahead, tipsy-looking, swaying one way then the other.",
#:   "Generate an approaching bus which keeps wandering left and right.",
#:   "El camión comes to me doing \"eses\", all time left, right, left.",
#:   "That car coming at us is wiggling like a worm, Mum!",
#:   "The lorry coming the other way couldn't hold a straight course for two seconds together; it lolled to one edge, then to the other, the whole way up to us.",
#:   "Was he drunk, asleep, or wrestling a wasp, the motorist whom we met swinging his saloon alternately towards the verge and towards the line as he came on?",
#:   "The opposing target follows a sinusoidal path with an amplitude of 0.8 m and a period of 4 s while closing on the subject vehicle.",
#:   "Several motorists phoned in about a coach making its way towards them in a series of lazy curves, first rightward, then leftward, mile after mile.",
#:   "Keep left and keep slow, because the motorbike up there that's heading for us is slaloming, and you can't tell which side he'll be on when we meet.",
#:   "By the time the van had passed me I'd watched it drift over, correct, drift back and correct again so often that I was feeling seasick.",
#:   "Driving home from the nativity play, we noticed the lights of a vehicle in the distance that seemed to be dancing. It turned out to be a pickup coming our way, meandering to the right, then to the left, then to the right again, never once settling, until it had gone by.",
#:   "The opposing actor must not keep to a line. It should come towards the ego while swinging to and fro across its lane in a regular rhythm, at an ordinary speed, and go on doing so all the way. No stopping, please, and no sudden single swerve at us.",
#:   "For the record: I had Vehicle 2 in view for around two hundred metres. During that whole time it was heading in my direction on an undulating line, now near its kerb, now near the centre, and I counted no fewer than five such swings before it drew level with my cab.",
#:   "I'd been on the motorway for nine hours, so at first I blamed my eyes. But no, the artic on the opposite side really was waltzing, its trailer going one way as the cab went the other, and back again, and again, and it waltzed its way right up to me.",
#:   "Comment under the clip: that's not avoiding potholes, that's a fella who's glued to his phone. See how the oncoming car drifts to the line, jerks back, drifts to the kerb, jerks back? He does it on repeat from the moment he's on camera till he goes past the cammer.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.4
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.5
#: high = 4.5
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.4)
param OPT_ADV_PERIOD = Range(2.5, 4.5)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
