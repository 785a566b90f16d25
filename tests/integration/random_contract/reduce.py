"""Makes a header that fails smaller for as long as it fails in the same way."""


def reduced(header, fails):
    """Returns the smallest header that was found for which fails(header) is true; it is for the one that is given."""
    tried = set()
    while True:
        for smaller in header.smaller():
            text = smaller.header()
            if text not in tried:
                tried.add(text)
                if fails(smaller):
                    header = smaller
                    break
        else:
            return header
