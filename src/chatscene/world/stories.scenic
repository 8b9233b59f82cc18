"""Stories: events of a scenario of OpenSCENARIO XML (see `chatscene.world.story`)."""

from chatscene.world.story.player import StoryAction, storyOf

behavior PlayStory(names, acts, stop=None, variables=()):
    """Let a story happen (see `chatscene.world.story`), take part in it, and end the drive when it is over."""
    story = storyOf(simulation(), names, acts, stop, variables)
    while not story.over:
        take StoryAction()
    terminate

behavior TakePart():
    """Do what the story of the drive, which another begins, tells somebody."""
    while True:
        take StoryAction()
