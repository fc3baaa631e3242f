"""Each topic's place in the graph of topics, drawn from CMake's declarations."""

import html
import json
import re
import subprocess

from docs.markdown import RAW_HTML


class TopicMap:
    """The graph of topics, and the part of it that each topic belongs to."""

    def __init__(self, tree, declarations):
        self._tree = tree
        self._files = {path: tag for path, tag in declarations["files"].items() if path.startswith("common/")}
        topics = [topic for topic in declarations["topics"] if any(tag["topic"] == topic for tag in self._files.values())]
        self._uses = {topic: [used for used in declarations["topics"][topic] if used in topics] for topic in topics}

    def graph(self):
        """All of it as an SVG: an arrow leads from a topic to those that may use it; a topic leads to its headers."""
        return framed(draw(dot_source(reduced(self._uses), "#topic-{}")), "The graph of topics")

    def places(self):
        """A section for each topic: where it stands between those that it uses and those that use it."""
        return "\n".join(self._place(topic) for topic in self._uses)

    def _place(self, topic):
        below = [other for other in self._uses if reaches(self._uses, topic, other)]
        above = [other for other in self._uses if reaches(self._uses, other, topic)]
        near = {other: [used for used in self._uses[other] if used in {*below, topic, *above}]
                for other in [*below, topic, *above]}
        chapters = sorted({tag["chapter"] for tag in self._files.values() if tag["topic"] == topic})
        lines = [f"\n## {topic} {{#place-{topic}}}\n",
                 framed(draw(dot_source(reduced(near), "#place-{}", topic)), f"What {topic} uses, and what uses it"),
                 f"\nUses {self._links(below) or 'nothing of ours'}.",
                 f"Used by {self._links(above) or 'chapters alone'}.",
                 f"Brought by chapter {', '.join(self._chapter(number) for number in chapters)}.",
                 f'<a href="architecture.html#topic-{topic}">Its headers</a>.\n']
        return "\n".join(lines)

    @staticmethod
    def _links(topics):
        return ", ".join(f'<a href="#place-{topic}">{topic}</a>' for topic in topics)

    def _chapter(self, number):
        page = next((page for page in self._tree.chapters() if int(self._tree.chapter_of(page)[:2]) == number), None)
        return f'<a href="{page.url}">{number:02}</a>' if page else f"{number:02}"


def reaches(uses, start, goal):
    return goal in uses[start] or any(reaches(uses, used, goal) for used in uses[start])


def reduced(uses):
    """The same graph without the arrows that follow from others."""
    return {topic: [used for used in direct if not any(reaches(uses, other, used) for other in direct if other != used)]
            for topic, direct in uses.items()}


def dot_source(uses, link, chosen=None):
    """Graphviz's source of a graph; `link` says where a topic leads to, and `chosen` is drawn to be seen."""
    lines = ["digraph topics {", "rankdir=LR; nodesep=0.25; ranksep=0.6; bgcolor=transparent;",
             'node [shape=box, style=rounded, fontname="DejaVu Sans", fontsize=12, height=0.4, margin="0.18,0.06"];',
             "edge [arrowsize=0.7];"]
    for topic in sorted(uses):
        mark = ', class="chosen"' if topic == chosen else ""
        lines.append(f'"{topic}" [URL="{link.format(topic)}", tooltip={json.dumps(topic)}{mark}];')
        lines += [f'"{used}" -> "{topic}";' for used in sorted(uses[topic])]
    return "\n".join(lines + ["}"])


def draw(source):
    """Graphviz's SVG of a graph, as an element to put into a page."""
    svg = subprocess.run(["dot", "-Tsvg"], input=source, stdout=subprocess.PIPE, check=True, text=True).stdout
    svg = re.sub(r"<!--.*?-->\n?", "", svg, flags=re.DOTALL)
    # A page has many graphs, and an id is one element's alone.
    svg = re.sub(r'<(g|a|svg)([^>]*?) id="[^"]*"', r"<\1\2", svg)
    return svg[svg.index("<svg"):].strip()


def framed(svg, label):
    """A graph that can be scrolled, by keyboard too, where it is wider than the page."""
    named = svg.replace("<svg", f'<svg role="img" aria-label="{html.escape(label)}"', 1)
    return RAW_HTML.format(f'<div class="topics" tabindex="0">{named}</div>')
