"""The one exception type of the library."""
from ._core import ErrorCode


class Error(ValueError):
    """What the library refuses, as one sentence.

    Attributes:
        code: what is wrong, an ErrorCode, which is also its word: ``error.code == "not-finite"``.
        culprits: the numbers of the points, faces, vertices, edges or lines that are at fault; see ErrorCode.
    """

    __module__ = "quadloom"
    code: ErrorCode
    culprits: list[int]

    def __init__(self, sentence: str, code: ErrorCode = ErrorCode.BAD_OPTION, culprits=()):
        super().__init__(sentence)
        self.code = code
        self.culprits = list(culprits)

    def __reduce__(self):
        return type(self), (str(self), self.code, self.culprits)
