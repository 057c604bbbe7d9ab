"""Errors for what a user can get wrong. Each message is one clear sentence."""


class SceneError(ValueError):
    """A scene or a scene file is not valid. The message names the field and what is allowed."""


class SettingError(ValueError):
    """A setting (a slider's name and value) is not valid for the scene."""


class InputError(ValueError):
    """A call or an input log asks for something that the simulation cannot do."""
