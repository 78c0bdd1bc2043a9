"""The exceptions of Nacre. Their texts are those that the command line prints."""


class Error(RuntimeError):
    """Something failed while running; the base of all that Nacre raises on purpose."""


class DomainError(Error, ValueError):
    """An argument is outside its valid range."""


class SettingError(DomainError):
    """A setting is out of range, or does not fit the paint that it is for."""

    setting: str = ""
    """The name of the setting, as Python spells it."""

    def __init__(self, *args: object, setting: str = "") -> None:
        super().__init__(*args)
        self.setting = setting


class InputError(Error, ValueError):
    """A file, or a text, is wrong: names file, line, key, value and the allowed range."""


class Stopped(Error):
    """The work was stopped in its middle by its progress callback."""
