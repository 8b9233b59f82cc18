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
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "accelerate"]
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
