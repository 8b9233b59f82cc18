"""Write an OpenDRIVE file: streets and junctions of a plan, what stands on them, and their reference lines."""
