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
