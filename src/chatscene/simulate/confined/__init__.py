"""Where a stranger's Scenic runs: an allow-list in front, and behind it a process that can do nothing but compute."""
