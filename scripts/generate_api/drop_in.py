"""The names that we answer for, src/api/gl_names.inc, and the other exported names of the drop-in libGL.so.1,
src/platform/exported_*.inc.

Ours are the entry points of OpenGL 1.0 to 1.5 and their aliases with ARB and EXT endings. Every other
command of OpenGL, of ARB and EXT extensions and of GLX passes to the driver's library.
"""

import re
import xml.etree.ElementTree as ElementTree

from registry import Command, Parameter, _type_of
from tables import GENERATED

# Types that no header of Debian's Mesa declares without more headers.
UNDECLARED = re.compile(r"struct _cl|GLXHyperpipe|GLXVideo|DMparams|VLServer|VLPath|VLNode|DMbuffer|GLXPbufferClobber|_cl_")

# Written by hand in src/platform/exported_framebuffer_objects.cpp.
GL_BY_HAND = {
    "glFramebufferTexture1D", "glFramebufferTexture2D", "glFramebufferTexture3D", "glFramebufferTextureLayer",
    "glGenerateMipmap", "glCheckFramebufferStatus", "glGetFramebufferAttachmentParameteriv",
    "glBindFramebufferEXT", "glBindRenderbufferEXT", "glBlitFramebufferEXT",
    "glCheckFramebufferStatusEXT", "glDeleteFramebuffersEXT", "glDeleteRenderbuffersEXT",
    "glFramebufferRenderbufferEXT", "glFramebufferTexture1DEXT", "glFramebufferTexture2DEXT",
    "glFramebufferTexture3DEXT", "glGenFramebuffersEXT", "glGenRenderbuffersEXT",
    "glGenerateMipmapEXT", "glGetFramebufferAttachmentParameterivEXT", "glGetRenderbufferParameterivEXT",
    "glIsFramebufferEXT", "glIsRenderbufferEXT", "glRenderbufferStorageEXT",
    "glRenderbufferStorageMultisampleEXT",
}

# Written by hand in src/platform/glx*.cpp.
GLX_BY_HAND = {
    "glXCreateContext", "glXCreateNewContext", "glXCreateContextAttribsARB", "glXCreateContextWithConfigSGIX",
    "glXDestroyContext", "glXMakeCurrent", "glXMakeContextCurrent", "glXMakeCurrentReadSGI", "glXSwapBuffers",
    "glXGetProcAddress", "glXGetProcAddressARB", "glXUseXFont", "glXCopyContext", "glXWaitGL",
}


def _commands(path):
    root = ElementTree.parse(path).getroot()
    commands, aliases = {}, {}
    for element in root.find("commands").iter("command"):
        name = element.find("proto/name").text
        parameters = [Parameter(_type_of(p), p.find("name").text) for p in element.findall("param")]
        commands[name] = Command(name, "", _type_of(element.find("proto")), parameters)
        alias = element.find("alias")
        if alias is not None:
            aliases[name] = alias.get("name")
    return root, commands, aliases


def _names(root, api, extensions):
    names = []
    for feature in root.iter("feature"):
        if feature.get("api") == api:
            names += [c.get("name") for r in feature.iter("require") for c in r.iter("command")]
    for extension in root.iter("extension"):
        supported = extension.get("supported").split("|")
        if re.match(extensions, extension.get("name")) and (api in supported or api + "core" in supported):
            names += [c.get("name") for r in extension.iter("require") for c in r.iter("command")]
    return list(dict.fromkeys(names))


def _declared(command):
    texts = [command.result] + [p.type for p in command.parameters]
    return not any(UNDECLARED.search(text) for text in texts)


def _function(macro, command, *more):
    fields = [command.result, command.name, f"({command.declaration()})", f"({command.names()})", *more]
    return f"{macro}({', '.join(fields)})\n"


def gl(path, api):
    """(ours, the driver's)."""
    root, commands, aliases = _commands(path)
    ours, others = [], GENERATED
    for name in _names(root, "gl", r"GL_(ARB|EXT)_"):
        command = commands[name]
        target = name
        while target[2:] not in api.commands and target in aliases:
            target = aliases[target]
        if target[2:] in api.commands:
            ours.append(_function("LEGACY_GL_NAME", command, "l" + target))
        elif name not in GL_BY_HAND and _declared(command):
            others += _function("LEGACY_GL_PASSED", command)
    rows = sorted(ours, key=lambda row: row.split(", ")[1])
    return GENERATED + "// Sorted by name, for binary search.\n" + "".join(rows), others


def glx(path):
    root, commands, _ = _commands(path)
    text = GENERATED
    for name in _names(root, "glx", r"GLX_(ARB|EXT|SGI|SGIX|MESA|OML)_"):
        if name not in GLX_BY_HAND and _declared(commands[name]):
            text += _function("LEGACY_GL_PASSED", commands[name])
    return text


def egl(header):
    """EGL has no registry in package khronos-api: its prototypes are in its header."""
    text = GENERATED
    by_hand = {"eglCreateContext", "eglDestroyContext", "eglMakeCurrent", "eglSwapBuffers", "eglGetProcAddress",
               "eglReleaseThread", "eglCopyBuffers", "eglWaitGL", "eglWaitClient"}
    for result, name, parameters in re.findall(r"^EGLAPI (.+?) ?EGLAPIENTRY (egl\w+) \((.*)\);$", header, re.M):
        if name in by_hand:
            continue
        names = [] if parameters == "void" else [re.search(r"(\w+)$", p).group(1) for p in parameters.split(",")]
        text += f"LEGACY_GL_PASSED({result}, {name}, ({parameters}), ({', '.join(names)}))\n"
    return text
