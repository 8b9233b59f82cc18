#: description = "The car drives along its lane at a steady speed."
#: rephrasings = [
#:   "A vehicle keeps to its lane and its pace.",
#:   "The adversary simply goes on straight ahead.",
#:   "The car follows the road without changing anything.",
#:   "The driver cruises on, neither faster nor slower.",
#:   "The truck stays in lane at constant speed.",
#:   "He just tootles along in his lane, nothing special.",
#:   "Vehicle 2 proceeded in its lane at a constant speed.",
#:   "Target: constant velocity, no lateral motion.",
#:   "Nothing fancy, there was just a car pootling along in its lane minding its own business.",
#:   "Vehicle 2 was traveling within its lane at a constant speed, no evasive or unusual maneuver noted.",
#:   "Bus in own lane, const v, no manoeuvre.",
#:   "The target maintains lane position and constant velocity throughout the test.",
#:   "A car goes normal in his lane, always the same speed.",
#:   "Background actor only: lane keep, cruise at set speed, no events.",
#:   "It rolled on down its lane, neither faster nor slower, as though it had all the time in the world.",
#:   "That lorry's just cruising along, holding his lane nice and even, nothing to worry about.",
#:   "literally just a car driving in its lane nothing happened",
#:   "The bus travelled along its lane at an even pace, according to passengers.",
#:   "And the lorry, so far as you saw, simply kept to its lane and its speed?",
#:   "He was going in his own lane nicely only, same speed, no problem.",
#:   "Bloke in his lane, steady as a clock. Makes a change, I tell you.",
#:   "Lane-keeping traffic participant at uniform speed.",
#:   "JUST A CYCLIST RIDING IN ITS LANE AT A NORMAL PACE",
#:   "The motorcycle hummed along its lane.",
#:   "Coach just keeps rolling in lane at an unchanging 50.",
#:   "Let a lorry proceed down its lane, speed fixed.",
#:   "dull one hatchback sticks to its lane n pace throughout",
#:   "The moped neither sped up nor slowed nor wandered.",
#:   "Simple cruise, own lane, constant speedometer, that's the bus.",
#:   "All the cyclist does in this run is pedal along his lane with an even cadence, and there is nothing for our car to react to.",
#:   "Vehicle 2, a tractor-trailer, was occupying its lane normally and the recorder shows no change of speed in the thirty seconds before the event.",
#:   "I'd like a bit of ordinary traffic please: a pickup that holds whatever lane it has at the same velocity from start to finish.",
#:   "The lady in the Honda was driving as one should, officer, sticking to her lane, forty on the clock the whole time, no funny business whatsoever.",
#:   "Baseline trajectory for the surrounding vehicle: follow the lane centre with zero lateral offset and no acceleration until the end of the simulation.",
#:   "Notice how that motorbike is riding: tidy, in the middle of his lane, not speeding up, not backing off, and that's how I want you to ride too.",
#:   "There is really not much to tell. The other car, a grey estate, went along in its lane at what I'd call a normal speed and it was still doing so when I lost sight of it. It didn't brake, it didn't drift, it did nothing.",
#:   "For the control group we need an actor without any event. The bus runs along its lane, as given by the map, at a preset speed which it keeps to the last frame, and the ego gets no surprise from it.",
#:   "Cruise control set at fifty-six, elbow on the window, radio on. I stayed in my lane with the trailer dead straight behind me and never touched a pedal for eleven miles, and what that robot car was doing is its own affair.",
#:   "Grandad drives his old Mercedes like a tram. He goes in his lane and he goes at one speed, and he doesn't hurry up and he doesn't slow down, even when people wave at him, and I like it because I don't feel sick.",
#:   "The truck was travelling with regular speed in the lane where it belongs. I have observed it well because nothing was happening: always straight following of the road, always same tempo, no manoeuvre of any kind until we arrived there.",
#:   "Bus trundles on in lane one, needle glued to thirty.",
#:   "Give me one dull milk tanker, own lane, unvarying pace.",
#:   "Moped, same lane, same speed, mile after mile.",
#:   "The other party's estate car was going along within its own markings at an unvarying forty-five, and neither camera shows a brake lamp or an indicator.",
#:   "No deviation in lateral position and no change of velocity shall be commanded for the surrounding truck from release until end of run.",
#:   "She asked me what the pickup had been up to, and I had to say nothing, it was simply driving in its lane at one speed.",
#:   "Here comes the boring part of the stream, folks: that coach stays where it is in the lane and just keeps on at the rate it was going.",
#:   "Always the same velocity has had this cyclist, always in the middle from his lane, so I could plan my day around him.",
#:   "The lorry may not surprise anybody: let it occupy its lane and carry on there as evenly as a train on rails.",
#:   "You could have stood a full cup of tea on the dashboard of that van. I was watching it from the bridge for my survey, and between the first lamp post and the last it didn't gain or lose a yard on my stopwatch schedule, nor did its wheels come anywhere near either line.",
#:   "Our accident had nothing to do with the motorcycle, I'd like that in the report. He was riding properly in his own lane and at the same pace all through. My husband only mentioned him because it was the only thing on the road that afternoon which behaved.",
#:   "I have driven the number 61 for nineteen years and the trick is to be furniture. You choose your lane, you choose your thirty, and you let both be. That's how I was going when the driverless thing got itself in a muddle, and I dare say I never figured in its sums.",
#:   "Mara had expected it to dart, or to slow, or to come over, since everything else that day had. It did not. The black saloon went down its lane as the moon goes down the sky, and she grew almost angry with it for giving her so little to tell.",
#:   "The radar trace of object 7 is a flat line, speed 13.9 throughout. So is its lateral trace, zero give or take ten centimetres. We keep the truck in the set because the stack has once braked for a vehicle that does nothing but this, and it ought not to.",
#:   "Ambient traffic, one piece, please. A hatchback that obeys the road, which is to say it goes round the bends the lane goes round, runs straight where the lane is straight, and holds its thirty-two all the time, whatever our car is up to. No braking, no shifting.",
#:   "Dispatch, further to the tanker. I've been sitting on its tail since the services and there's nothing for me here. It's keeping inside its lines, it's doing fifty-two, it was doing fifty-two ten minutes back, and if he's drunk then so am I. Breaking off.",
#:   "When we play the bus game I count the seconds between lamp posts. For the big yellow bus it was four, and four, and four again, all down the road. It didn't go over the white stripes once and it never went faster or slower, so I won.",
#:   "Per the event data recorder, V3 did not take part in the collision. In the twenty seconds preserved, its vehicle speed reads 38 mph at every sample, steering angle is within two degrees, and both brake switch and turn signal remain off. Its operator stated he was \"just driving home.\"",
#:   "What I liked about the cyclist was his rhythm. Left, right, left, right, like a sewing machine, and the wheel running down the lane as if a thread were pulling it. From my window on the third floor I followed him the whole length of the boulevard, and there was not one beat more or less.",
#:   "In my country nobody is driving so. This lady, she has put her small car in one lane and she is remaining there, she has chosen one speed and with this she is also remaining. After two kilometre I was relaxed like in my sofa, because I knew what she does next: the same.",
#:   "That bus? In lane, on thirty, all the way, full stop.",
#:   "Motorbike minds its own business, between the lines, needle dead still.",
#:   "Let a van roll along its lane and do nothing else.",
#:   "I looked for a brake lamp, a blinker, a wheel on the paint, and all I got from that lorry was mile upon mile of the same.",
#:   "For all it changed, the saloon might have been drawn on the road: the same place in the lane, the same forty-two.",
#:   "The surrounding truck shall be commanded with a constant set speed and the lane centre as its reference line, these being its only inputs.",
#:   "Nothing was asked of the learner but to see how the milk tanker went: straight where the lane was straight, bending where it bent, never quicker, never slower.",
#:   "Between Exeter and Honiton, the witness said, the coach had not once given him cause to look up from his crossword.",
#:   "We'd braced for a surprise from the cyclist and none came, he merely kept his cadence and his place in the lane until the session was over.",
#:   "The tachograph disc is the most boring I have had in my hands. It's a circle. Whoever drove that lorry chose eighty at the slip road and left it there, and the lane camera has him thirty centimetres from each line throughout. Whatever frightened your robot, it wasn't anything that he did.",
#:   "I followed him because I was lost. He had a trailer with a boat, and I thought, sailors know the way. It was restful. I never had to change gear, never had to brake, never had to turn the wheel except as the lane itself turned, and when we parted my speedometer was where it'd been at the beginning.",
#:   "Grandson showed me on the tablet what the robot car sees. Ours is the blue box. There was an orange box, that was a bus, in its lane. I asked what happens now. Nothing, he said. The orange box crept on between its two lines by so much every second, and by the same every second after.",
#:   "Could the motorcyclist have been swaying, counsel asked, or speeding up, or about to turn off? The witness had been a bandmaster. He'd listened to that engine for a good five minutes, he replied, and it had held an A flat from first to last, and the lamp had come along the lane as if it ran on a wire.",
#:   "To prove that the tracker has no drift, one wants a target that has none. Take a hatchback, put it anywhere on the map, have it follow its lane. Its speed at the first frame and its speed at the last are to be one and the same number, and so are all the numbers between.",
#:   "On the scales of the day it didn't weigh much. Some dog had run off, a child had been sick, and then there was the robotaxi which braked for a van that, I swear, had done nothing. I was painting the fence. The van was doing what vans do, humming along on its side at one speed.",
#:   "Radio check from the bridge, nothing to report. I've the coach in sight, inside lane. No, no weaving. No, brake lights have been off since I've had him. He passed marker nine and marker ten at precisely the same pace, seventy-two seconds a mile each. You might tell them to look for another coach.",
#:   "My pupils think a good driver is one who does clever things. Then I point at somebody like the woman in that estate car. What has she done since we came on this road? She has picked a lane, she's picked a speed, and you've stopped noticing her. That is the finest thing I can say of anybody.",
#:   "A pot of soup stood on the passenger seat, and I live at the other end of the valley. So there I went, in my pickup, at fifty on the straight and fifty through the bends, in the dead middle of my lane. I touched neither pedal. Not a drop was lost, whatever became of those others behind me.",
#:   "All the while that they quarrelled, the taxi's lamp was there in the corner of her eye. It neither gained nor lost. Where the road curved, the lamp curved; where the road ran straight, it ran straight; and it seemed to her the one thing on earth that night which had decided on something and was keeping to it.",
#:   "Trucker uncle is a legend in our chat group. Song number one, lane number one, sixty. Song number fifteen, lane number one, sixty. Somebody wrote, bhai does the brake of his lorry work? Nobody can say, since nobody has seen it used, nor the steering also, except as the road itself was bending.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["follow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(4, 9)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
