"""clangd, asked as an editor asks it: over its standard input and output."""

import json
import subprocess


class LanguageServer:
    """Runs clangd for one project. ask() and diagnostics() read until what they wait for has come, and drop all that comes before."""

    def __init__(self, clangd, build, log):
        self.log = log.open("w", encoding="utf-8")
        self.process = subprocess.Popen([clangd, f"--compile-commands-dir={build}", "--background-index=false", "--log=info"],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.log)
        self.last = 0
        self.ask("initialize", processId=None, rootUri=None, capabilities={
            "textDocument": {"hover": {"contentFormat": ["plaintext"]}}})
        self.send(method="initialized", params={})

    def end(self):
        self.ask("shutdown")
        self.send(method="exit")
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()
        self.log.close()

    def diagnostics(self, file, text=None):
        """Opens a file, as if it held `text` where that is given. Returns clangd's diagnostics: pairs of a line, counted from 1, and
        a message."""
        self.send(method="textDocument/didOpen", params={"textDocument": {
            "uri": file.as_uri(), "languageId": "cpp", "version": 1, "text": text or file.read_text(encoding="utf-8")}})
        while True:
            message = self.receive()
            if message.get("method") == "textDocument/publishDiagnostics" and message["params"]["uri"] == file.as_uri():
                return [(found["range"]["start"]["line"] + 1, found["message"]) for found in message["params"]["diagnostics"]]

    def close(self, file):
        self.send(method="textDocument/didClose", params={"textDocument": {"uri": file.as_uri()}})

    def hover(self, file, word):
        """Returns what an editor shows where the word stands first in an open file."""
        before = file.read_text(encoding="utf-8").partition(word)[0]
        position = {"line": before.count("\n"), "character": len(before) - before.rfind("\n") - 1}
        answer = self.ask("textDocument/hover", textDocument={"uri": file.as_uri()}, position=position)
        return answer["contents"]["value"] if answer else ""

    def ask(self, method, **params):
        self.last += 1
        self.send(id=self.last, method=method, params=params)
        while True:
            message = self.receive()
            if message.get("id") == self.last and "method" not in message:
                assert "error" not in message, message
                return message["result"]

    def send(self, **message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(f"Content-Length: {len(body)}\r\n\r\n".encode() + body)
        self.process.stdin.flush()

    def receive(self):
        length = None
        while line := self.process.stdout.readline().strip():
            name, _, value = line.decode().partition(": ")
            length = int(value) if name == "Content-Length" else length
        assert length is not None, f"clangd ended; see {self.log.name}"
        return json.loads(self.process.stdout.read(length))
