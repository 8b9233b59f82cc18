#: description = "The crossing car brakes for the stop line without quite stopping, and speeds up across."
#: rephrasings = [
#:   "classic rolling stop, he barely slows for the sign and then goes for it",
#:   "Vehicle 2 failed to come to a complete stop at the stop sign and accelerated into the intersection.",
#:   "rolling stop, doesn't halt, speeds up",
#:   "The target reduces its speed at the stop line without reaching a standstill and then accelerates across the path of the VUT.",
#:   "The driver brakes a bit at the STOP but he doesn't really stop, then he goes faster.",
#:   "A lorry does a California stop and pulls across.",
#:   "The biker brushes the brakes at the give-way line and nips over.",
#:   "It slows sharply, rolls past the sign, and picks up speed in front of the ego.",
#:   "He made a half-hearted dab at the stop line, never actually stopped, then gunned it over.",
#:   "The driver made a rolling stop at the stop sign and accelerated across the intersection.",
#:   "Rolling stop, then hard gas across. Wheels never at 0.",
#:   "The crossing target decelerates towards the stop line without reaching standstill and accelerates through the junction.",
#:   "The car brakes at the stop, but not to zero, and then goes quick over.",
#:   "California stop: actor dips to ~2 m/s at the line, then floors it through the conflict zone.",
#:   "He made a show of slowing at the sign, but the wheels never stood still, and off he leapt across.",
#:   "See that? He didn't stop at the sign, only rolled it, and now he's booting it over.",
#:   "he like almost stopped at the stop sign and then sped across instead",
#:   "The driver slowed for the line without ever coming to rest, then hurried over.",
#:   "You slowed, I grant, but your wheels never ceased to turn before you quickened across; yes?",
#:   "At the stop line he slowed little bit only, never fully stop, then went fast across.",
#:   "Stop means stop, doesn't it? Not to him, bit of brake, then foot down and over.",
#:   "Incomplete stop at stop line with accelerated crossing.",
#:   "CALIFORNIA STOP THEN GUNS IT ACROSS",
#:   "The crossing motorbike curtsied at the stop line and scooted over.",
#:   "Crossing cab dips its speed at the line, never halts, zips over.",
#:   "Side-road van: token braking at STOP, then a spurt across.",
#:   "Let the lorry nearly stop at its line, then hurry over.",
#:   "He only made slow at the sign, then whoosh across, cheeky!",
#:   "Biker scrubs off speed for the stop line, foot never down, blasts across.",
#:   "We watched the saloon in the side road come down to a crawl at its line, but it never quite stood, and then it sprinted over.",
#:   "The crossing target brakes towards its stop line to a residual speed above zero and then accelerates strongly so as to traverse the junction ahead of the VUT.",
#:   "A stop is when the wheels don't turn. His turned. He slowed for the line, kept it rolling, and now he's given it the beans to get across.",
#:   "The bus of the other street has braked at the line but not until the end, and afterwards he gave gas and came over quickly.",
#:   "Accident was caused as motorbike fellow did half-braking only at the stop line, did not come to halt at all, and took pickup to cross.",
#:   "Where the sign says stop, the pickup on the cross street did about three-quarters of a stop, and the missing quarter it turned into a dash over.",
#:   "I always sit on the bench by that corner, and I can tell you that nobody stops. This one, a lady in a big estate, did touch the brake by the line so that the front dipped, but she was still moving when she put her foot down and flew over the crossroads.",
#:   "Vehicle 2 was required to stop before entering the intersection from the minor road. Camera footage shows its speed falling to approximately 8 km/h at the line, at no time reaching zero, and then rising to 40 km/h as it went across in front of Vehicle 1, whose driver had taken the braking for compliance.",
#:   "Ticket: NPC on the crossing arm brakes for the stop line and we classify it as stopping. Minimum speed is around 2 m/s. Then it picks up again, more strongly than it had slowed, and clears through the junction. Planner released its own brake too early; wait for true standstill next time.",
#:   "The tipper had the decency to lower its gears for the line, so that for a second the AV's passengers believed in it. Its wheels went round slowly, then slower, but never not at all; and with that it had done its duty, growled, gathered itself and came charging over.",
#:   "From where I was on my bicycle he and I made eye contact, and that's the annoying bit. He braked, the little van nearly stood at the line, I relaxed, the woman in the robotaxi relaxed. Still rolling, he checked nobody had a badge on and shot across before the lot of us.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "accelerate"]
#: position = "crossing"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 45.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.2
#: high = 2.4
#: unit = "m/s"
#: meaning = "to what speed it slows down at the line"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it becomes"

param OPT_ADV_DISTANCE = Range(15, 45)
param OPT_ADV_SPEED = Range(6, 9)
param OPT_SLOW_SPEED = Range(1.2, 2.4)
param OPT_ADV_SPRINT = Range(6, 10)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5
    do BrakeOnPath(advTrajectory, 0.6) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT)
