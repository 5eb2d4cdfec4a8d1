"""Reads the parts of an effect (.fx) file that an application uses: parameters, techniques, passes.

Function bodies are skipped; the compiler reads those.
"""

import re
from dataclasses import dataclass, field

TOKEN = re.compile(
    r'"(?:[^"\\]|\\.)*"|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[fFhH]?|[A-Za-z_]\w*|\S')
NUMBER = re.compile(r"[\d.]")
MODIFIERS = {"static", "const", "uniform", "extern", "shared", "row_major", "column_major",
             "inline"}
BRACKETS = {"{": "}", "(": ")", "[": "]", "<": ">"}


class FxError(Exception):
    """The file is not an effect that this reader supports."""


@dataclass
class Annotation:
    """One `type name = value;` between < and >."""
    type: str
    name: str
    value: object  # text, a number, or a list of numbers


@dataclass
class Parameter:
    """A global variable that the application sets."""
    type: str
    name: str
    semantic: str = ""
    annotations: list = field(default_factory=list)
    initial: list = field(default_factory=list)  # tokens after the equals sign

    def value(self, name, otherwise=None):
        """The value of an annotation; names are case-insensitive."""
        found = [a.value for a in self.annotations if a.name.lower() == name.lower()]
        return found[0] if found else otherwise


@dataclass
class Pass:
    """A pass: its annotations, and its states as {name: tokens}."""
    name: str
    annotations: list
    states: dict


@dataclass
class Technique:
    """A technique and its passes."""
    name: str
    annotations: list
    passes: list


@dataclass
class Effect:
    """The top-level declarations of a file."""
    parameters: list = field(default_factory=list)
    techniques: list = field(default_factory=list)


def numbers_in(tokens):
    """The numbers of an initialiser: `1.0f`, `{1, -2}` or `float2(1, -2)`."""
    found, sign = [], 1.0
    for token in tokens:
        if NUMBER.match(token) and token != ".":
            found.append(sign * float(token.rstrip("fFhH")))
        sign = -1.0 if token == "-" else 1.0
    return found


class Tokens:
    """The words of a file, read from left to right."""

    def __init__(self, text):
        text = re.sub(r'("(?:[^"\\\n]|\\.)*")|//[^\n]*|/\*.*?\*/|^[ \t]*#[^\n]*',
                      lambda match: match[1] or " ", text, flags=re.DOTALL | re.MULTILINE)
        self.words, self.next = TOKEN.findall(text), 0

    def peek(self):
        """The next word, or an empty text at the end."""
        return self.words[self.next] if self.next < len(self.words) else ""

    def take(self, expected=None):
        """Consumes and returns the next word."""
        word = self.peek()
        if not word or expected not in (None, word):
            near = " ".join(self.words[max(self.next - 5, 0):self.next])
            raise FxError(f"expected {expected or 'more'}, got {word or 'the end'}, after: {near}")
        self.next += 1
        return word

    def take_if(self, word):
        """Whether the next word is this one; if so it is consumed."""
        found = self.peek() == word
        self.next += found
        return found

    def until(self, last):
        """The words before `last`, brackets of every kind except < > kept whole; consumes `last`."""
        words, open_brackets = [], []
        while open_brackets or self.peek() != last:
            word = self.take()
            words.append(word)
            if word in "{([":
                open_brackets.append(BRACKETS[word])
            elif open_brackets and word == open_brackets[-1]:
                open_brackets.pop()
        self.take(last)
        return words


def read_effect(text):
    """The Effect in a file's text; FxError if it can't be read."""
    tokens, effect = Tokens(text), Effect()
    while tokens.peek():
        if tokens.take_if("technique"):
            effect.techniques.append(read_technique(tokens))
        elif tokens.take_if("struct"):
            tokens.until("{")
            tokens.until("}")
            tokens.take(";")
        else:
            effect.parameters += read_global(tokens)
    return effect


def read_global(tokens):
    """A global variable, as a list; an empty one for a function or a static."""
    modifiers = set()
    while tokens.peek() in MODIFIERS:
        modifiers.add(tokens.take())
    parameter = Parameter(tokens.take(), tokens.take())
    if tokens.take_if("("):
        tokens.until(")")
        tokens.until("{")
        tokens.until("}")
        return []
    if tokens.take_if("["):
        tokens.until("]")
    if tokens.take_if(":"):
        parameter.semantic = tokens.take()
    parameter.annotations = read_annotations(tokens)
    if tokens.take_if("="):
        parameter.initial = tokens.until(";")
    else:
        tokens.take(";")
    return [] if "static" in modifiers else [parameter]


def read_annotations(tokens):
    """The annotations that come next, if any."""
    found = []
    if tokens.take_if("<"):
        while not tokens.take_if(">"):
            kind, name = tokens.take(), tokens.take()
            tokens.take("=")
            words = tokens.until(";")
            numbers = numbers_in(words)
            value = numbers[0] if len(numbers) == 1 else numbers
            found.append(Annotation(kind, name, words[0][1:-1] if kind == "string" else value))
    return found


def read_technique(tokens):
    """A technique, its first word already consumed."""
    technique = Technique(tokens.take(), read_annotations(tokens), [])
    tokens.take("{")
    while not tokens.take_if("}"):
        tokens.take("pass")
        one = Pass(tokens.take(), read_annotations(tokens), {})
        tokens.take("{")
        while not tokens.take_if("}"):
            state = tokens.take()
            tokens.take("=")
            one.states[state] = tokens.until(";")
        technique.passes.append(one)
    return technique
