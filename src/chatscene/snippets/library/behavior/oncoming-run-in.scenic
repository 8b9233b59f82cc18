#: description = "The oncoming pedestrian suddenly runs into the lane toward the ego."
#: rephrasings = [
#:   "A person coming the other way breaks into a run and enters the ego's path.",
#:   "The pedestrian heads for the ego on foot and speeds up into its lane.",
#:   "Someone jogging against the traffic swerves in front of the vehicle at a sprint.",
#:   "The walker from ahead accelerates slantwise into the carriageway.",
#:   "Facing the ego, a runner rushes into the roadway.",
#:   "this guy's jogging toward us and then he bolts into the road",
#:   "A pedestrian facing traffic ran into the travel lane.",
#:   "runner against traffic, sprints into lane",
#:   "this lad walking towards us on the roadside all of a sudden legged it straight out into the lane at me",
#:   "A male on foot, approaching V1, suddenly ran into the travel lane in V1's direction.",
#:   "Ped coming our way, bolts into lane twd us.",
#:   "The pedestrian approaching the VUT head-on suddenly enters the lane at running speed.",
#:   "A woman comes from the front on foot, and she runs suddenly in my lane to my car.",
#:   "Walker, opposite direction, walk -> sprint on trigger, lateral move into the lane ahead, closing on the SUT.",
#:   "The stranger had been strolling to meet them, and then he broke into a run, off the edge and into the lane, right at their bonnet.",
#:   "He's walking towards you, nothing odd... hang on, he's pelting out into your lane, he's coming right at you!",
#:   "guy walking at us suddenly RAN into the road at the car",
#:   "A man on foot who had been approaching at the roadside broke into a run and threw himself into traffic's way",
#:   "He had been coming towards you on foot, and of a sudden he was running in your very lane?",
#:   "That person walking opposite direction all of a sudden came running inside towards our car only",
#:   "He's strolling along facing me, next thing he's haring down my lane at the bonnet",
#:   "Sudden running entry of opposing pedestrian into own lane, head-on",
#:   "Man sprints INTO THE ROAD straight at my car",
#:   "The walker facing us stampeded into the lane.",
#:   "lad walking up to meet us suddenly charges into are lane head on",
#:   "Approaching ped goes from stroll to full pelt, straight at V1.",
#:   "Have a jogger coming the other way sprint into the ego's lane.",
#:   "The lady was walking to us and then zoom, in our road!",
#:   "Foot traveller, opposite heading, abruptly runs in front of vehicle, closing.",
#:   "He was ambling along the verge with his face to us; then he was tearing down the middle of our lane as though to embrace the bonnet.",
#:   "From an initial walk against the direction of the VUT, the pedestrian target changes to running speed and enters the lane on a shallow, closing angle.",
#:   "You see a boy coming your way on the pavement, harmless, and all at once he's hurtling toward you on the tarmac. What will you do?",
#:   "She was in front of me at the border, walking to my side, then on a sudden she took the race in my lane, direction my car.",
#:   "I never expected that the man who was strolling to meet my lorry would bolt off the edge and come full tilt at the radiator.",
#:   "Caller's shaking. A female on foot was heading toward her at the side of the road, then flung herself into a run and into her lane, facing her.",
#:   "Vehicle 1 was travelling at 45 km/h when its driver noticed a pedestrian approaching at the road's edge at a normal walk. At a distance of some twenty metres the pedestrian burst into a run, came obliquely into the travel lane and continued to run toward Vehicle 1.",
#:   "It's the change of gear that gets me in this clip. For five seconds there's a hooded figure walking our way beside the parked cars, hands in pockets. Then something goes off in him and he's flying at the camera, right in the lane, knees up, and we're all shouting.",
#:   "He might have been anybody's uncle, taking the air along the lane and drawing nearer. Afterwards Ruth could only say that his walk had broken open. He was running, he had left the grass, and he filled her windscreen, arms wide, coming on and on in her own half of the road.",
#:   "For the scenario set we need an opposing walker who triggers on distance. Up to the trigger: ordinary pace, clear of the lane, facing us. After it: a sprint that slants into our lane so that he closes on the ego from the front. He is not on his way to the far side.",
#:   "i'm a courier so i was right behind the robotaxi. dude is walking towards it next to the bike racks, totally chill, then he just launches himself, like an actual sprint, into its lane and at its face. it braked so hard i nearly ate the back window",
#:   "Dog walker ambles our way, then suddenly races into our lane at us.",
#:   "Make the oncoming stroller break into a sprint, into the ego's lane, facing it.",
#:   "calm, calm, calm, CHARGE: man runs down my lane at the camera",
#:   "He was walking up along the ditch to meet us, peaceable as a cow, and out of nowhere he came galloping onto our half of the road, straight toward us.",
#:   "An opposing pedestrian at walking pace beside the lane shall, at the trigger gap, change to a sprint and enter the VUT's lane on a heading toward the VUT.",
#:   "The lady was coming walking from the front side of road; all of a sudden she started full running, inside my lane, face to face with my vehicle.",
#:   "You had been sauntering along the verge in the direction of the oncoming lorry, had you not, when you broke into a gallop and into its lane?",
#:   "Don't look at the phone, look at him! He's stopped strolling, he's legging it, he's in your lane and he's heading for your windscreen!",
#:   "Male walking toward traffic at the roadside, appeared calm, per the caller; he then took off like a sprinter and ended up running in her lane, at her.",
#:   "I noticed his bag first, a blue sports bag, swinging in time with his steps as he came along the pavement in our direction. The bag stopped swinging and started to fly. He had launched himself off the kerb and was pelting up our lane with it, getting bigger at a rate I didn't care for.",
#:   "V1 was eastbound. The pedestrian was westbound on the south shoulder at a walk. With approximately sixty feet between them he accelerated to a run, angled into the eastbound lane and went on toward V1, hands raised. V1's operator came to a stop about an arm's length from him.",
#:   "It was the shoes. In the dashcam you hear nothing, but I had the window down, and it was clack, clack, clack, a woman in heels walking our way next to the hedge. Then clackclackclackclack, and she was off the edge and in front of us, hurtling at the bonnet, shouting about her husband.",
#:   "Here's one from the psychiatric liaison officer. The person is walking along the edge of the road and toward the patrol car. There is no sign of agitation. At twenty or so metres the person begins to run at top speed, obliquely into the lane of the patrol car, and keeps facing it. Can the AV deal with that?",
#:   "Coming the other way by the football ground there were scarves everywhere, so what was one more? I gave him the same width as all the rest who were walking to meet us. He put on a burst, left the others standing, and was sprinting in my lane with his arms up as if I were the goalkeeper.",
#:   "Between one lamp-post and the next he had been a pedestrian, somebody approaching along the wall with his collar up. Between that lamp-post and the third he was a projectile. His coat stood out behind; he had swung into their lane; he was running, my God, at them, and Lena tore the wheel round.",
#:   "I'm a lorry driver and I've had deer do it, never a human being. The lad's plodding towards me on the grass, hood up. You'd think he'd plod on by. He goes off like a hare, bends in onto the tarmac, and he's belting up my lane with his eyes on my badge.",
#:   "Pupil's reflection sheet. \"There was a man walking towards us. I thought he is on the side, he is slow, he's no hazard. Then he ran very suddenly, into our lane, and he was still facing us and came to us very quickly. I braked but my instructor braked earlier. I must watch feet.\"",
#:   "It was my birthday and they'd all come out to welcome me, you see, so little Finn was walking down the road to meet the car. That was quite all right. But he recognised me behind the wheel, and off he shot, out of the grass, into the lane, running as fast as his legs would go right for the front of the car.",
#:   "My colleague from Beijing asks for this: \"pedestrian come from front, by side of lane, speed one point four. When our car is near, speed go up to four very fast, and he go slantly into our lane, toward our car. He do not want to go across. Our car must brake full.\"",
#:   "What did the gap do? At the start it was closing at the pace of one car and one walker, since he was coming up the roadside toward us. Then his half of the sum trebled. He had set off at a dead run and, what's worse, he was running in our lane by then and not beside it.",
#:   "He was strolling up to meet us; now he's sprinting, in our lane.",
#:   "Oncoming walker goes from amble to headlong, into lane, at bumper.",
#:   "mum walking our way then BOOM shes running at the car",
#:   "From his face coming toward me at a walker's bounce there was one blink to his face coming at me at a hurdler's, and now with my bonnet under it.",
#:   "The test person advances beside the lane against the VUT; at the given gap the gait switches to sprint and the heading tilts into the lane, range closing.",
#:   "Those flip-flops that had been slapping along the gutter in my direction suddenly slapped three times as fast, and on the tarmac before my headlamps.",
#:   "She'd her arms wide and her eyes on our taxi, and the quiet few yards of walking up to meet us were over: she was pelting down the middle of our lane.",
#:   "Put a schoolboy by the roadside, sauntering the AV's way; when the two are near, have him tear off into the lane and head for the headlights.",
#:   "He's only walking, you'll say, and he's on the side. Aye, and there he goes at full stretch into our path with his nose to our windscreen.",
#:   "I've replayed my own thoughts more than the video. A man facing me on the cycle strip, plodding nearer: no concern. Then his knees. You never see a pedestrian's knees come that high. By the time I'd thought \"why the knees\" he was in front of the coach, in the lane, still facing it, and we had about a bus length to share.",
#:   "Closing speed is a sum of two numbers. Ours was constant. In the record the sum rises by four metres per second within a single step, and simultaneously the bearing of the person, which had been drifting off to the side as you'd expect of someone you will pass, goes to zero and stays there. He had come to us, at a run.",
#:   "We were rolling up to our own front gate, and Grandma was coming down the road to it, from the other end, along the hedge. She had her stick. She saw the twins in the back; the stick went into the hedge. I wouldn't have believed it of her knees. All I saw in the windscreen was Grandma getting bigger.",
#:   "It was to be an ordinary interview with an ordinary postman. He walks beside the kerb, he faces the van, he's sorting letters. \"And then,\" he says, \"I smelt the bees.\" What the van's driver has is the postman's bag, in the air, and the postman under it, having left the kerb for the lane, galloping at his grille.",
#:   "Pupil's question: could I have known? Well, he was oncoming, he was on foot, he was young, and he'd a ball under his arm. As long as he kept to his three miles an hour on the edge you could've passed. But the ball dropped and he went after it with all he had, down on to your lane, in the direction of your number plate.",
#:   "They asked if he meant to get over the road. No sir. A chap who wants to get over the road goes for the other pavement. This one's aim was the ambulance. He came up the verge at us like anyone, hands in his jacket, then took off as though a gun had gone, slantwise on to our bit, and ended before our radiator.",
#:   "On the heat camera he's a white comma, left margin, growing by a pixel or so with every frame. Between frames 211 and 212 it's as if someone had changed the film. The comma has legs now, they're scissoring, it has left the margin for the centre, and it's growing by ten. At 230 it's the whole picture. We had stopped.",
#:   "A robber has no friends, they say in Naples, so he takes any car. He was coming in our sense on foot, tranquil, like one with nothing in his bag. And behind him somebody has cried. Mamma mia! He made himself into a horse, he threw himself on our lane, and with all the legs he came against us.",
#:   "There'd been forty feet of wet leaves between the jogger, no, he wasn't yet a jogger, the gentleman, and my front bumper. He was approaching at a walk, outside the white edge line. Why he should have begun to run at that instant, and inside the line, and at me, only his doctor knows. I used up some of the forty feet; he used up the others.",
#:   "My lorry has a bell for the blind side and a camera for the rear, and nothing for madness. Round the bend comes a lass on foot, face to me, well in on the grass. I lift my fingers, she lifts hers. Then she's charging. Not over the road. Down it, my lane, arms going, straight at the Mercedes star.",
#:   "From a hill one sees it as a diagram. Dot one, a car, proceeding up the road. Dot two, on foot, proceeding down along its edge, slowly, so that they would pass at an arm's length. Dot two then trebles its rate and bends its line on to that of dot one. I shut my eyes, though the brakes sounded good.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "accelerate"]
#: blocker = false
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.0
#: unit = "m/s"
#: meaning = "how fast it goes at first"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 28.0
#: unit = "m"
#: meaning = "distance to the ego at which it runs"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.3
#: high = 0.9
#: unit = "rad"
#: meaning = "how sharply it turns into the lane"

param OPT_ADV_SPEED = Range(0.8, 2)
param OPT_ADV_SPRINT = Range(4, 7)
param OPT_ADV_DISTANCE = Range(10, 28)
param OPT_ADV_ANGLE = Range(0.3, 0.9)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < 2 * globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    side = 1 if offsetFrom(egoRoute, self) > 0 else -1
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, side * globalParameters.OPT_ADV_ANGLE) until side * offsetFrom(egoRoute, self) < -1
    do Halt()
