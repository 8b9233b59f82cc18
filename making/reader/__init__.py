"""The learned reader: what it learns from, its network, and the file that it is written to."""
