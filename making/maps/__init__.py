"""The packaged maps: their plans, and the OpenDRIVE that is written of a plan."""
