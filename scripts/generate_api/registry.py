"""Reads the commands and enums of OpenGL 1.0 to 1.5 from the Khronos registry."""

import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

VERSIONS = ["1.0", "1.1", "1.2", "1.3", "1.4", "1.5"]


@dataclass
class Parameter:
    type: str  # "const GLfloat *"
    name: str
    group: str = ""  # of enums
    length: str = ""  # of what a pointer points to: "4", "n", "COMPSIZE(pname)"


@dataclass
class Command:
    name: str  # without the gl prefix
    version: str
    result: str
    parameters: list

    def declaration(self):
        return ", ".join(f"{p.type}{'' if p.type.endswith('*') else ' '}{p.name}" for p in self.parameters) or "void"

    def names(self):
        return ", ".join(p.name for p in self.parameters)


@dataclass
class Api:
    commands: dict = field(default_factory=dict)  # name -> Command, in the registry's order
    enums: dict = field(default_factory=dict)  # version -> [(name, value)]
    enum_groups: dict = field(default_factory=dict)  # group -> [(name, value)], of every version and extension


def _type_of(element):
    text = "".join(element.itertext())
    name = element.find("name").text
    text = text[: text.rindex(name)].strip()
    return " ".join(text.replace("*", " *").split()).replace("* *", "**")


def read(path):
    root = ElementTree.parse(path).getroot()
    values = {}
    for enum in root.iter("enum"):
        if "value" in enum.attrib and enum.get("api", "gl") == "gl":
            values.setdefault(enum.get("name"), enum.get("value"))
    commands = {}
    for command in root.find("commands").iter("command"):
        proto = command.find("proto")
        commands[proto.find("name").text] = command

    api = Api()
    for enum in root.iter("enum"):
        if "value" in enum.attrib and enum.get("api", "gl") == "gl":
            for group in filter(None, enum.get("group", "").split(",")):
                api.enum_groups.setdefault(group, []).append((enum.get("name"), enum.get("value")))
    seen = set()
    for feature in root.iter("feature"):
        version = feature.get("number")
        if feature.get("api") != "gl" or version not in VERSIONS:
            continue
        api.enums[version] = []
        for require in feature.iter("require"):
            for enum in require.iter("enum"):
                if enum.get("name") not in seen:
                    seen.add(enum.get("name"))
                    api.enums[version].append((enum.get("name"), values[enum.get("name")]))
            for reference in require.iter("command"):
                name = reference.get("name")
                command = commands[name]
                parameters = [Parameter(_type_of(p), p.find("name").text, p.get("group", ""), p.get("len", ""))
                              for p in command.findall("param")]
                api.commands[name[2:]] = Command(name[2:], version, _type_of(command.find("proto")), parameters)
    return api
