package org.pendant.command;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;

/** Training editor: what an editor says that opens a program, asks about it and debugs it. */
final class TrainingEditor {
  private static final String URI = "file:///training.script";

  private static final List<String> QUESTIONS =
      List.of(
          "completion",
          "hover",
          "signatureHelp",
          "documentSymbol",
          "foldingRange",
          "semanticTokens/full",
          "codeAction",
          "codeLens",
          "inlayHint",
          "documentHighlight",
          "formatting",
          "diagnostic");

  /** Behind the program, so that edits leave something as it is. */
  private static final String DEFINITION =
      "\ndef trained(x):\n  local y = [x, 1]\n  while x > 1:\n    textmsg(y[0])\n  end\nend\n";

  /** What is asked after each edit. */
  private static final List<String> QUESTIONS_OF_EDITS = List.of("completion", "diagnostic");

  private static final int EDITS = 3;

  /** What any of the questions may ask for. */
  private static final String ANYWHERE =
      "{\"textDocument\":{\"uri\":\""
          + URI
          + "\"},\"position\":{\"line\":1,\"character\":3},\"range\":{\"start\":{\"line\":0,"
          + "\"character\":0},\"end\":{\"line\":99,\"character\":0}},\"context\":{\"diagnostics\":"
          + "[]},\"options\":{\"tabSize\":2,\"insertSpaces\":true}}";

  private static final String TERMINATED = "\"terminated\"";

  private final ByteArrayOutputStream messages = new ByteArrayOutputStream();
  private final CountDownLatch terminated = new CountDownLatch(1);

  /** A session of the language server: {@code text} is opened, asked about, and typed in. */
  InputStream questions(String text) {
    say("\"id\":1,\"method\":\"initialize\",\"params\":{\"capabilities\":{}}");
    say("\"method\":\"initialized\",\"params\":{}");
    say(
        "\"method\":\"textDocument/didOpen\",\"params\":{\"textDocument\":{\"uri\":\""
            + URI
            + "\",\"languageId\":\"urscript\",\"version\":1,\"text\":"
            + quoted(text + DEFINITION)
            + "}}");
    int id = 2;
    for (String method : QUESTIONS) {
      ask(id++, method);
    }
    for (int edit = 0; edit < EDITS; edit++) {
      say(
          "\"method\":\"textDocument/didChange\",\"params\":{\"textDocument\":{\"uri\":\""
              + URI
              + "\",\"version\":"
              + (edit + 2)
              + "},\"contentChanges\":[{\"range\":{\"start\":{\"line\":1,\"character\":0},\"end\":"
              + "{\"line\":1,\"character\":0}},\"text\":\"sleep(1)\\n\"}]}");
      for (String method : QUESTIONS_OF_EDITS) {
        ask(id++, method);
      }
    }
    say("\"id\":" + id + ",\"method\":\"shutdown\"");
    say("\"method\":\"exit\"");
    return said();
  }

  private void ask(int id, String method) {
    say("\"id\":" + id + ",\"method\":\"textDocument/" + method + "\",\"params\":" + ANYWHERE);
  }

  /**
   * A session of the debug adapter: {@code program} runs, and when it has ended the editor leaves.
   */
  InputStream debugging(Path program) {
    request(1, "initialize", "{\"adapterID\":\"pendant\"}");
    request(2, "launch", "{\"program\":" + quoted(program.toString()) + "}");
    request(3, "configurationDone", "{}");
    InputStream first = said();
    request(4, "disconnect", "{}");
    InputStream last = said();
    return new SequenceInputStream(first, new Awaited(last));
  }

  /** Takes the answers of the debug adapter. */
  OutputStream answers() {
    return new OutputStream() {
      @Override
      public void write(int each) {}

      @Override
      public void write(byte[] bytes, int offset, int length) {
        if (new String(bytes, offset, length, StandardCharsets.UTF_8).contains(TERMINATED)) {
          terminated.countDown();
        }
      }
    };
  }

  private void request(int number, String command, String arguments) {
    say(
        "\"seq\":"
            + number
            + ",\"type\":\"request\",\"command\":\""
            + command
            + "\",\"arguments\":"
            + arguments);
  }

  private void say(String members) {
    byte[] body = ("{\"jsonrpc\":\"2.0\"," + members + "}").getBytes(StandardCharsets.UTF_8);
    String head = "Content-Length: " + body.length + "\r\n\r\n";
    messages.writeBytes(head.getBytes(StandardCharsets.US_ASCII));
    messages.writeBytes(body);
  }

  private InputStream said() {
    InputStream said = new ByteArrayInputStream(messages.toByteArray());
    messages.reset();
    return said;
  }

  private static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    text.chars()
        .forEach(
            each -> {
              if (each < 0x20 || each == '"' || each == '\\' || each >= 0x7F) {
                quoted.append(String.format("\\u%04x", each));
              } else {
                quoted.append((char) each);
              }
            });
    return quoted.append('"').toString();
  }

  /** Bytes that come when the program has ended. */
  private final class Awaited extends InputStream {
    private final InputStream bytes;

    Awaited(InputStream bytes) {
      this.bytes = bytes;
    }

    @Override
    public int read() throws IOException {
      await();
      return bytes.read();
    }

    @Override
    public int read(byte[] target, int offset, int length) throws IOException {
      await();
      return bytes.read(target, offset, length);
    }

    private void await() throws IOException {
      try {
        terminated.await();
      } catch (InterruptedException e) {
        throw new IOException("interrupted", e);
      }
    }
  }
}
