"""Prints slots, samples and Eigen's fixed types in gdb as a person reads them: (gdb) source .../suture_printers.py"""

import gdb
import gdb.printing


def text_of(numbers):
    return "[" + ", ".join(str(number) for number in numbers) + "]"


def matrix_text(rows, columns, at):
    """A vector in one pair of brackets, a matrix in one for each row."""
    if columns == 1:
        return text_of(at(row, 0) for row in range(rows))
    return f"{rows}x{columns} " + text_of(text_of(at(row, column) for column in range(columns)) for row in range(rows))


def field_names(value):
    return {field.name for field in value.type.fields()}


def behind(pointer):
    """What a std::unique_ptr points to; None if that is nothing."""
    raw = gdb.default_visualizer(pointer)
    found = list(raw.children()) if raw is not None else []
    return found[0][1] if found else None


def elements(value):
    """The elements of a BoundedList, whose memory may be its own or elsewhere."""
    data = value["data"]
    start = data if data.type.strip_typedefs().code == gdb.TYPE_CODE_ARRAY else behind(data)
    return [start[i] for i in range(int(value["size"]))] if start is not None else []


class List:
    def __init__(self, value):
        self.value = value
        self.capacity = int(value.type.template_argument(1))
        element = value.type.template_argument(0).strip_typedefs()
        self.is_text = element.code == gdb.TYPE_CODE_INT and element.name == "char"

    def to_string(self):
        found = elements(self.value)
        if self.is_text:
            return bytes(int(one) % 256 for one in found).decode("utf-8", "replace")
        return f"{len(found)} of " + (f"at most {self.capacity}" if self.capacity else "any number")

    def children(self):
        return [] if self.is_text else [(f"[{i}]", one) for i, one in enumerate(elements(self.value))]

    def display_hint(self):
        return "string" if self.is_text else "array"


class Matrix:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        rows, columns, data = int(self.value["rows"]), int(self.value["columns"]), self.value["data"]
        found = elements(data) if data.type.strip_typedefs().code == gdb.TYPE_CODE_STRUCT else data
        return matrix_text(rows, columns, lambda row, column: found[column * rows + row])


class Optional:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        return "some" if int(self.value["present"]) else "nothing"

    def children(self):
        if not int(self.value["present"]):
            return []
        inner = self.value["value"]
        owned = "unique_ptr" in str(inner.type.strip_typedefs())
        return [("value", behind(inner).dereference() if owned else inner)]


def tuple_parts(value):
    while True:
        yield value["head"]
        if "tail" not in field_names(value):
            return
        value = value["tail"]


class Tuple:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        return None

    def children(self):
        return [(f"[{i}]", part) for i, part in enumerate(tuple_parts(self.value))]


class Variant:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        return f"alternative {int(self.value['index'])}"

    def children(self):
        index = int(self.value["index"])
        if "all" in field_names(self.value):
            return [("value", list(tuple_parts(self.value["all"]))[index])]
        alternative = self.value.type.template_argument(index)
        return [("value", self.value["data"].address.cast(alternative.pointer()).dereference())]


def nanoseconds(stamp):
    return int(stamp["__d"]["__r"])


class Sample:
    def __init__(self, value):
        self.value = value
        self.answer = value["answer_"] if "answer_" in field_names(value) else value

    def to_string(self):
        stamp, error = nanoseconds(self.answer["stamp_"]), self.answer["error_"]
        said = [] if bool(self.answer["usable_"]) else ["not to be acted on"]
        said += [str(error)] if int(error) != 0 else []
        said += [f"stamp {stamp / 1e9:.9f} s" if stamp else "never produced"]
        return ", ".join(said)

    def children(self):
        carries = "value_" in field_names(self.value) and nanoseconds(self.answer["stamp_"]) != 0
        return [("value", self.value["value_"])] if carries else []


class EigenMatrix:
    """With fixed numbers of rows and columns."""

    def __init__(self, value):
        self.rows, self.columns = (int(value.type.template_argument(i)) for i in (1, 2))
        self.by_row = int(value.type.template_argument(3)) & 1
        self.data = value["m_storage"]["m_data"]["array"]

    def to_string(self):
        def at(row, column):
            return self.data[row * self.columns + column if self.by_row else column * self.rows + row]
        return matrix_text(self.rows, self.columns, at)


def eigen_matrix(value):
    """None, and so gdb's own form, where a number of rows or columns is known at run time only."""
    is_fixed = all(int(value.type.template_argument(i)) >= 0 for i in (1, 2))
    return EigenMatrix(value) if is_fixed else None


class EigenQuaternion:
    def __init__(self, value):
        self.data = value["m_coeffs"]["m_storage"]["m_data"]["array"]

    def to_string(self):
        return ", ".join(f"{name} {self.data[i]}" for i, name in ((3, "w"), (0, "x"), (1, "y"), (2, "z")))


class EigenTransform:
    def __init__(self, value):
        self.matrix = value["m_matrix"]

    def to_string(self):
        return EigenMatrix(self.matrix).to_string()


def printers():
    collection = gdb.printing.RegexpCollectionPrettyPrinter("suture")
    for name, pattern, printer in (
            ("list", "^suture::BoundedList<.*>$", List),
            ("matrix", "^suture::BoundedMatrix<.*>$", Matrix),
            ("optional", "^suture::(Slot|Open)Optional<.*>$", Optional),
            ("tuple", "^suture::SlotTuple<.*>$", Tuple),
            ("variant", "^suture::SlotVariant<.*>$", Variant),
            ("sample", "^suture::Sample<.*>$", Sample),
            ("eigen matrix", "^Eigen::Matrix<.*>$", eigen_matrix),
            ("eigen quaternion", "^Eigen::Quaternion<.*>$", EigenQuaternion),
            ("eigen transform", "^Eigen::Transform<.*>$", EigenTransform)):
        collection.add_printer(name, pattern, printer)
    return collection


gdb.printing.register_pretty_printer(None, printers(), replace=True)
