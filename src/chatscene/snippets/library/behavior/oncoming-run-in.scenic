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
    do MoveAhead(globalParameters.OPT_ADV_SPRINT, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
