"""Whether what somebody else wrote or recorded shows what was said: a verdict on each fact, from tracks."""
