"""What a snippet may use: classes, behaviors, places."""
