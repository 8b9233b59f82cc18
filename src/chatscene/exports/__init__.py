"""After the method: scenes of a run as files that other tools read."""
