package org.pendant.command;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.pendant.editors.lsp.LanguageServerConnection;

/**
 * Training run: does in one process what the commands that should start fast do: the launcher has
 * the JVM note the classes that are loaded for it.
 */
public final class Training {
  private static final String URI = "file:///training.script";

  private static final List<String> REQUESTS =
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
          "formatting");

  private final ByteArrayOutputStream messages = new ByteArrayOutputStream();
  private int requests;

  private Training() {}

  /** Runs the program that {@code words} name, and has an editor ask about it. */
  public static void main(String[] words) throws IOException, InterruptedException {
    ExitCode code = new Pendant(Console.ofProcess()).run(List.of("run", words[0]));
    byte[] text = Files.readAllBytes(Path.of(words[0]));
    LanguageServerConnection.serve(
        "training",
        new Training().session(new String(text, StandardCharsets.UTF_8)),
        OutputStream.nullOutputStream(),
        Throwable::printStackTrace,
        complaint -> {});
    System.exit(code.number());
  }

  /** What an editor says that opens {@code text}. */
  private InputStream session(String text) {
    request("initialize", "{\"capabilities\":{}}");
    message("{\"jsonrpc\":\"2.0\",\"method\":\"initialized\",\"params\":{}}");
    message(
        "{\"jsonrpc\":\"2.0\",\"method\":\"textDocument/didOpen\",\"params\":{\"textDocument\":{\"uri\":\""
            + URI
            + "\",\"languageId\":\"urscript\",\"version\":1,\"text\":"
            + quoted(text)
            + "}}}");
    for (String method : REQUESTS) {
      request("textDocument/" + method, PARAMS);
    }
    request("shutdown", "null");
    message("{\"jsonrpc\":\"2.0\",\"method\":\"exit\"}");
    return new ByteArrayInputStream(messages.toByteArray());
  }

  private static final String PARAMS =
      "{\"textDocument\":{\"uri\":\""
          + URI
          + "\"},\"position\":{\"line\":1,\"character\":3},\"range\":{\"start\":{\"line\":0,"
          + "\"character\":0},\"end\":{\"line\":99,\"character\":0}},\"context\":{\"diagnostics\":[]},"
          + "\"options\":{\"tabSize\":2,\"insertSpaces\":true}}";

  private void request(String method, String params) {
    message(
        "{\"jsonrpc\":\"2.0\",\"id\":"
            + requests++
            + ",\"method\":\""
            + method
            + "\",\"params\":"
            + params
            + "}");
  }

  private void message(String body) {
    byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
    messages.writeBytes(
        ("Content-Length: " + bytes.length + "\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
    messages.writeBytes(bytes);
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
}
