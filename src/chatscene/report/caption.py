"""What stands above and below a moving picture, so that it is understood alone: the sentence, who is who, a scale."""

from __future__ import annotations

from PIL import Image, ImageDraw, ImageFont

from chatscene.maps.picture import GROUND, INK, OVERSAMPLE, PAINT, ROLES, WIDTH, Camera
from chatscene.report.tracks import called
from chatscene.terms.actors import noun_of
from chatscene.terms.episode import Episode, Role
from chatscene.terms.scene import CAR

FONT, LINE, EDGE = 13, 18, 10  # [px]
LINES = 3  # of the sentence, at most
SCALES = (5, 10, 20, 50)  # [m]
WIDEST_SCALE = WIDTH / 5  # [px]


def above(said: str) -> Image.Image:
    """A band with the sentence, as much of it as has room."""
    lines = _wrapped(" ".join(said.split()))
    band = Image.new("RGB", (WIDTH, len(lines) * LINE + EDGE), PAINT)
    ImageDraw.Draw(band).multiline_text((EDGE, EDGE / 2), "\n".join(lines), fill=INK, font=_font(), spacing=LINE - FONT)
    return band


def below(episode: Episode, camera: Camera, ego: str) -> Image.Image:
    """A band with who is who and how long some metres are."""
    band = Image.new("RGB", (WIDTH, LINE + EDGE), PAINT)
    brush, font = ImageDraw.Draw(band), _font()
    left = float(EDGE)
    for role, name in _who(episode, ego):
        brush.rectangle((left, EDGE / 2 + 4, left + 12, EDGE / 2 + 14), fill=ROLES[role])
        brush.text((left + 18, EDGE / 2), name, fill=INK, font=font)
        left += 18 + font.getlength(name) + 2 * EDGE
    metres = max((m for m in SCALES if m * camera.scale / OVERSAMPLE <= WIDEST_SCALE), default=SCALES[0])
    length, right, low = metres * camera.scale / OVERSAMPLE, WIDTH - EDGE, LINE + EDGE / 2 - 6
    text = f"{metres} m"
    brush.rectangle((right - length - font.getlength(text) - 4 * EDGE, 0, WIDTH, LINE + EDGE), fill=PAINT)
    brush.text((right - length - font.getlength(text) - EDGE, EDGE / 2), text, fill=INK, font=font)
    ends = [(right - length, low - 5), (right - length, low), (right, low), (right, low - 5)]
    brush.line(ends, fill=INK, width=2)
    return band


def between(top: Image.Image, frame: Image.Image, bottom: Image.Image) -> Image.Image:
    """A frame with the bands above and below it."""
    whole = Image.new("RGB", (WIDTH, top.height + frame.height + bottom.height), GROUND)
    for part, y in ((top, 0), (frame, top.height), (bottom, top.height + frame.height)):
        whole.paste(part, (0, y))
    return whole


def _who(episode: Episode, ego: str) -> list[tuple[Role, str]]:
    kinds = dict.fromkeys(
        (track.role, called(track.role, track.kind)) for track in episode.tracks if track.role is not Role.EGO
    )
    own = episode.ego_track.kind
    what = "ego" if own == CAR else f"ego ({noun_of(own)})"
    return [(Role.EGO, f"{what}: {ego}" if ego else what), *kinds]


def _wrapped(said: str) -> list[str]:
    """Lines that fit; the last one ends with an ellipsis if there is more."""
    font, lines = _font(), [""]
    for word in said.split():
        longer = f"{lines[-1]} {word}".strip()
        if font.getlength(f"{longer} …") <= WIDTH - 2 * EDGE or not lines[-1]:
            lines[-1] = longer
        elif len(lines) < LINES:
            lines.append(word)
        else:
            lines[-1] += " …"
            break
    return lines


def _font() -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(FONT)
