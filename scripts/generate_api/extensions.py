"""src/api/extensions.inc: what glGetString(GL_EXTENSIONS) may name.

A row of src/api/extensions.json is named when every command of the extension is ours and built, and so is
all that it "needs" beyond its commands. With "driver" its commands are the driver's, as far as they are
not ours, and it is named on a driver that names it.
"""

import json
import xml.etree.ElementTree as ElementTree

from tables import GENERATED


def text(path, registry_path, api, built):
    root = ElementTree.parse(registry_path).getroot()
    aliases = {c.find("proto/name").text: c.find("alias").get("name") for c in root.find("commands").iter("command")
               if c.find("alias") is not None}
    commands = {e.get("name"): [c.get("name") for r in e.iter("require") for c in r.iter("command")
                                if r.get("api", "gl") == "gl"]
                for e in root.iter("extension")}

    def ours(name):
        while name[2:] not in api.commands and name in aliases:
            name = aliases[name]
        return name[2:] if name[2:] in api.commands else None

    rows = GENERATED
    for extension in json.loads(path.read_text()):
        name, driver = extension["name"], extension.get("driver", False)
        wanted = [ours(command) for command in commands[name]]
        if not driver and None in wanted:
            continue
        needed = {command for command in wanted if command} | set(extension.get("needs", []))
        if needed <= built:
            rows += f"LEGACY_GL_EXTENSION({name}, {'true' if driver else 'false'})\n"
    return rows
