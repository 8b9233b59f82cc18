#: description = "The car behind sticks to the ego's rear bumper."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: following too closely; own code"
#: [slots]
#: actions = ["tailgate"]
#: position = "behind"

param OPT_ADV_GAP = Range(-0.6, 2.5)  #: [m] how much room it means to leave; below 0 it will touch

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
