"""The simulator `native`: plans and egos by rule, in batches of scenes, with the embedded simulator's numbers."""
