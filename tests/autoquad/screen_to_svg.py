"""Draws a screen of tmux (`capture-pane -e -p`) as SVG: standard input to standard output.

usage: screen_to_svg.py COLUMNS
"""

import re
import sys
from xml.sax.saxutils import escape

WIDTH, HEIGHT, MARGIN, SIZE = 8.4, 18, 14, 14
"""Of a character, around all of them, and of the font, in pixels."""

PAPER, INK = "#1c1f26", "#d7dae0"

COLOURS = {1: "#f0616d", 2: "#8cc265", 3: "#e0b050", 4: "#4aa5f0", 6: "#42b3c2", 8: "#8b93a3"}
"""Of the terminal, by their numbers; all others are that of the ink."""

ESCAPE = re.compile(r"\x1b\[([0-9;]*)m")
INDEXED = re.compile(r"38;5;(\d+)")


class Screen:
    """The lines of a screen; what a line selects stays for the next ones."""

    def __init__(self):
        self.colour, self.bold = INK, False

    def runs(self, line):
        """Pieces of a line with their column, colour and weight."""
        column, place = 0, 0
        for match in [*ESCAPE.finditer(line), None]:
            text = line[place : match.start() if match else len(line)]
            if text.strip():
                yield column, self.colour, self.bold, text
            column += len(text)
            if match:
                place = match.end()
                self.select(match[1])

    def select(self, codes):
        indexed = INDEXED.search(codes)
        if indexed:
            self.colour = COLOURS.get(int(indexed[1]), INK)
            return
        for code in (int(code or 0) for code in codes.split(";")):
            if code in (0, 39):
                self.colour = INK
            if code in (0, 22):
                self.bold = False
            self.bold = self.bold or code == 1


def main():
    columns, lines = int(sys.argv[1]), sys.stdin.read().rstrip("\n").split("\n")
    width, height = columns * WIDTH + 2 * MARGIN, len(lines) * HEIGHT + 2 * MARGIN
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height}" width="{width:.0f}" height="{height}">')
    print(f'<rect width="100%" height="100%" rx="8" fill="{PAPER}"/>')
    print(f'<g font-family="DejaVu Sans Mono, Menlo, Consolas, monospace" font-size="{SIZE}" xml:space="preserve">')
    screen = Screen()
    for row, line in enumerate(lines):
        y = MARGIN + row * HEIGHT + SIZE
        for column, colour, bold, text in screen.runs(line):
            stripped = text.lstrip(" ")
            x = MARGIN + (column + len(text) - len(stripped)) * WIDTH
            text = stripped.rstrip(" ")
            weight = ' font-weight="bold"' if bold else ""
            length = f'textLength="{len(text) * WIDTH:.1f}" lengthAdjust="spacingAndGlyphs"'
            print(f'<text x="{x:.1f}" y="{y}" fill="{colour}"{weight} {length}>{escape(text)}</text>')
    print("</g>\n</svg>")


if __name__ == "__main__":
    main()
