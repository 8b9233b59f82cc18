"""Stories: events of a scenario of OpenSCENARIO XML (see `chatscene.world.story`)."""

from chatscene.world.story.player import StoryAction, storyOf

behavior PlayStory(names, acts, stop=None, variables=()):
    """Let a story happen (see `chatscene.world.story`) to all who are in it, and end the drive when it is over.

    The ego is left alone where it has no behavior, since something else drives it then.
    """
    story = storyOf(simulation(), names, acts, stop, variables)
    while not story.over:
        take StoryAction()
    terminate

behavior TakePart():
    """Be moved by the story of the drive, which another plays."""
    while True:
        wait
