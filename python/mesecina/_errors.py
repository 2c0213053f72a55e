# SPDX-License-Identifier: GPL-3.0-or-later
"""The exceptions of the module that Python does not have."""


class InputError(ValueError):
    """A file or data that cannot be read.

    Its text is one line with the place, as in ``shape.poff:3:7: a number is expected``.
    """

    def __init__(self, text, file="", line=0, column=0):
        super().__init__(text)
        self.file = file  #: as it was given; empty for data in memory
        self.line = line  #: from 1; 0: unknown
        self.column = column  #: in bytes, from 1; 0: unknown

    def __reduce__(self):
        return type(self), (str(self), self.file, self.line, self.column)


class ComputationFailed(RuntimeError):
    """A structure that could not be computed, or one that depends on it."""

    def __init__(self, text, structure="", witnesses=()):
        super().__init__(text)
        self.structure = structure  #: id of the structure that failed
        self.witnesses = [int(one) for one in witnesses]  #: ids of the samples that it blames; often empty

    def __reduce__(self):
        return type(self), (str(self), self.structure, self.witnesses)


class ProgramError(RuntimeError):
    """The program ``mesecina`` ended with an error that is neither of usage nor of input.

    Its text is the message of the program.
    """

    def __init__(self, text, status=1):
        super().__init__(text)
        self.status = status  #: exit status of the program

    def __reduce__(self):
        return type(self), (str(self), self.status)
