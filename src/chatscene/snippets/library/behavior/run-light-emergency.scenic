#: description = "The emergency vehicle accelerates hard through the red light with lights and siren on."
#: rephrasings = [
#:   "an ambulance comes screaming through the red with the blue lights on",
#:   "A fire apparatus responding to a call entered the intersection on red at increasing speed.",
#:   "emergency veh, siren, red light, accelerating hard",
#:   "An emergency vehicle on duty passes the red signal under strong acceleration across the path of the VUT.",
#:   "The police car with siren goes faster and faster and passes in red.",
#:   "A fire engine tears across against the signal, gathering speed.",
#:   "The ambulance bombs over the crossing on red, siren wailing.",
#:   "Racing to an accident, a police van speeds up through the lights.",
#:   "An ambulance came belting through the red with the blues and twos going.",
#:   "Emergency unit, with lights and siren activated, proceeded against the red signal while accelerating.",
#:   "Fire truck thru red, siren on, full gas.",
#:   "The priority vehicle with active warning devices passes the red signal under strong acceleration.",
#:   "The police drives through red very fast with blue light and tatütata.",
#:   "EV pre-empts junction: ignores signal, positive accel, siren audio on.",
#:   "It wailed up to the crossroads, paid the red no heed, and put on speed.",
#:   "Engine 4 is going through against the red, code three, and he is not slowing down, so stop.",
#:   "fire truck blasted thru the red w sirens and everything",
#:   "A fire engine sounding its siren surged through the red signal on its way to a call.",
#:   "The ambulance, its lamps and siren in operation, went against the red with gathering speed.",
#:   "Ambulance siren on, red light also he never stop, press more somemore.",
#:   "Woo-woo-woo and through the red he goes, pedal to the carpet, ours not to reason why.",
#:   "Red-signal passage of warning-active priority vehicle under strong acceleration",
#:   "SIREN! Fire engine STORMS the red",
#:   "The wailing police car surges over the red.",
#:   "Siren yelping, fire engine storms the red, still piling on speed.",
#:   "Ambulance, blues on, takes the red with its throttle wide open.",
#:   "Against red, siren active, priority vehicle crosses, speed rising.",
#:   "The police car went nee-naw through the red and got faster and faster!",
#:   "Who floors a fire truck through a stop light, siren or no siren?",
#:   "Let an ambulance with its lamps flashing and horn blaring put on speed, ignore the red that faces it, and burst through the junction.",
#:   "Our light was green; theirs was red, and all the same the patrol car, lit up like Christmas and wailing, powered on across.",
#:   "The ambulance was, on its crew's own evidence, sounding its siren, passing a red aspect, and under full acceleration as it entered the junction.",
#:   "With tatü and blue lamps comes the Feuerwehr, has red, does not care and gives still more gas over the crossing.",
#:   "Don't go on green if you can hear one: there, a police van, siren going, foot hard down, straight over his red.",
#:   "Rescue 7 will be coming across your front with everything lit, disregarding the signal, and he's picking up speed, not losing it.",
#:   "Usually they creep up to a red and peep. This ambulance driver did none of that. You heard the siren, you heard the diesel straining as he gave it everything he'd got, and there it was, flying over the crossroads in front of us with the red light shining down on it.",
#:   "The emergency vehicle, with optical and acoustic warning devices switched on, waits out of the ego's sight. On the trigger, while the signal for its approach shows red, it accelerates at the configured throttle up to a high speed and cuts the path of the subject vehicle.",
#:   "What I can swear to is the noise: two-tones, air horn, and underneath it an engine being thrashed. The fire engine came at the junction on red, nobody lifted, if anything she surged, and she'd gone over and away before our lights had even changed.",
#:   "They'd had the call for a child not breathing, so nobody at the inquest blamed the crew. Blue lights, siren, signal against them, and the foot of the driver pressed to the boards, so that the ambulance was still gathering pace when it passed in front of the tram.",
#:   "dashcam caught the feds coming out of nowhere, siren blaring, and you can literally hear the V8 winding up as they cross the line with there light red. they werent slowing at all they were launching, thing must of hit 60 in the middle of the intersection",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "accelerate", "fast"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 60.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it becomes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(25, 60)
param OPT_ADV_SPEED = Range(12, 17)
param OPT_THROTTLE = Range(0.7, 1)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, globalParameters.OPT_ADV_SPEED)
