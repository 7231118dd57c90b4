package org.pendant.editors.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.pendant.editors.wire.BytePipe;
import org.pendant.editors.wire.ProtocolLog;

/**
 * A client without manners: random edits and requests, at places that do not exist, cancelled,
 * malformed and cut. {@code -Dtest.cases=160} makes 9,600 sequences of it.
 */
final class LanguageServerFuzzTest {
  private static final int SEQUENCES = 60 * Integer.getInteger("test.cases", 1);
  private static final int MESSAGES = 25;

  /** Sequences after which another client takes over. */
  private static final int SEQUENCES_EACH = 200;

  private static final List<String> PIECES =
      List.of(
          "def f(x, y=1):\n",
          "end\n",
          "if True:\n",
          "else:\n",
          "while x < 3:\n",
          "movej([0,-1.57,0,-1.57,0,0], a=1.4)\n",
          "x = p[0.1, -0.2, 0.3, 0, 3.14, 0]\n",
          "thread t():\n",
          "run t()\n",
          "# ä 🤖\n",
          "textmsg(\"a",
          "[",
          ")",
          "\r\n",
          "\r",
          "global z = struct(a=1)\n",
          "z.a",
          "\u0000",
          "x.append(1)\n");

  private static final List<String> METHODS =
      List.of(
          "completion",
          "hover",
          "signatureHelp",
          "definition",
          "references",
          "documentHighlight",
          "prepareRename",
          "rename",
          "documentSymbol",
          "foldingRange",
          "selectionRange",
          "formatting",
          "rangeFormatting",
          "onTypeFormatting",
          "semanticTokens/full",
          "semanticTokens/full/delta",
          "semanticTokens/range",
          "codeAction",
          "inlayHint",
          "codeLens",
          "prepareCallHierarchy",
          "diagnostic",
          "moniker",
          "nonsense");

  private final Random random = new Random(Long.getLong("test.seed", 1));
  private final Set<Integer> asked = new HashSet<>();
  private int nextId;

  @Test
  void noClientEndsTheServer() throws Exception {
    List<String> complaints = new CopyOnWriteArrayList<>();
    try (ProtocolLog _ = new ProtocolLog(complaints::add)) {
      for (int done = 0; done < SEQUENCES; done += SEQUENCES_EACH) {
        session(Math.min(SEQUENCES_EACH, SEQUENCES - done));
      }
    }
  }

  private void session(int sequences) throws Exception {
    List<Throwable> faults = new CopyOnWriteArrayList<>();
    BytePipe toServer = new BytePipe();
    BytePipe toClient = new BytePipe();
    CompletableFuture<Boolean> served = new CompletableFuture<>();
    Thread.ofPlatform()
        .daemon()
        .start(
            () -> {
              try {
                served.complete(
                    LanguageServerConnection.serve(
                        "test", toServer.input(), toClient.output(), faults::add, complaint -> {}));
              } catch (Throwable e) {
                served.completeExceptionally(e);
              }
            });
    asked.clear();
    nextId = 0;
    request(
        toServer.output(),
        "initialize",
        "{\"capabilities\":{},\"initializationOptions\":{\"dryRun\":\"off\"}}");
    for (int i = 0; i < sequences; i++) {
      String uri = "file:///" + random.nextInt(3) + ".script";
      open(toServer.output(), uri);
      for (int message = 0; message < MESSAGES; message++) {
        anything(toServer.output(), uri);
      }
      // Every request that could be read is answered, the last one as well.
      int last = request(toServer.output(), "textDocument/hover", params(uri));
      answers(toClient.input(), last);
      assertEquals(List.of(), faults, () -> "sequence after " + nextId + " requests");
      assertTrue(!served.isDone());
    }
    request(toServer.output(), "shutdown", "null");
    notify(toServer.output(), "exit", "null");
    assertEquals(true, served.get());
  }

  private void anything(OutputStream out, String uri) throws IOException {
    switch (random.nextInt(12)) {
      case 0 -> open(out, uri);
      case 1, 2, 3, 4 -> change(out, uri);
      case 5 ->
          notify(out, "textDocument/didClose", "{\"textDocument\":{\"uri\":\"" + uri + "\"}}");
      case 6 -> {
        int id = request(out, "textDocument/codeAction", params(uri));
        notify(out, "$/cancelRequest", "{\"id\":" + id + "}");
      }
      case 7 -> raw(out, malformed());
      default ->
          request(out, "textDocument/" + METHODS.get(random.nextInt(METHODS.size())), params(uri));
    }
  }

  private String malformed() {
    return switch (random.nextInt(6)) {
      case 0 -> "Content-Length: 4\r\n\r\n{\"a\"";
      case 1 -> "Content-Length: x\r\n\r\n";
      case 2 -> "Content-Length: 2\r\n\r\n[]";
      case 3 -> "Content-Length: 15\r\n\r\n{\"jsonrpc\":1.0}";
      case 4 -> "Content-Length: 40\r\n\r\n" + "[".repeat(40);
      default -> "\r\n\r\n";
    };
  }

  private String position() {
    int line = random.nextInt(12) == 0 ? random.nextInt() : random.nextInt(8);
    int character = random.nextInt(12) == 0 ? random.nextInt() : random.nextInt(30);
    return "{\"line\":" + line + ",\"character\":" + character + "}";
  }

  private String range() {
    return "{\"start\":" + position() + ",\"end\":" + position() + "}";
  }

  /** What any of the requests may ask for; each takes what it knows. */
  private String params(String uri) {
    return "{\"textDocument\":{\"uri\":\""
        + uri
        + "\"},\"position\":"
        + position()
        + ",\"positions\":["
        + position()
        + "],\"range\":"
        + range()
        + ",\"newName\":\"n"
        + random.nextInt(9)
        + "\",\"ch\":\"d\",\"previousResultId\":\""
        + random.nextInt(30)
        + "\",\"options\":{\"tabSize\":"
        + random.nextInt(-2, 20)
        + ",\"insertSpaces\":true},\"context\":{\"includeDeclaration\":true,\"diagnostics\":[]}}";
  }

  private void open(OutputStream out, String uri) throws IOException {
    StringBuilder text = new StringBuilder();
    for (int i = random.nextInt(12); i > 0; i--) {
      text.append(piece());
    }
    JsonObject document = new JsonObject();
    document.addProperty("uri", uri);
    document.addProperty("languageId", "urscript");
    document.addProperty("version", 1);
    document.addProperty("text", text.toString());
    JsonObject params = new JsonObject();
    params.add("textDocument", document);
    notify(out, "textDocument/didOpen", params.toString());
  }

  private void change(OutputStream out, String uri) throws IOException {
    JsonArray changes = new JsonArray();
    for (int i = random.nextInt(3); i >= 0; i--) {
      JsonObject change = new JsonObject();
      if (random.nextInt(10) > 0) {
        change.add("range", JsonParser.parseString(range()));
      }
      change.addProperty("text", random.nextBoolean() ? piece() : "");
      changes.add(change);
    }
    JsonObject document = new JsonObject();
    document.addProperty("uri", uri);
    document.addProperty("version", random.nextInt(100));
    JsonObject params = new JsonObject();
    params.add("textDocument", document);
    params.add("contentChanges", changes);
    notify(out, "textDocument/didChange", params.toString());
  }

  private String piece() {
    return PIECES.get(random.nextInt(PIECES.size()));
  }

  private int request(OutputStream out, String method, String params) throws IOException {
    int id = nextId++;
    asked.add(id);
    send(
        out,
        "{\"jsonrpc\":\"2.0\",\"id\":"
            + id
            + ",\"method\":\""
            + method
            + "\",\"params\":"
            + params
            + "}");
    return id;
  }

  private static void notify(OutputStream out, String method, String params) throws IOException {
    send(out, "{\"jsonrpc\":\"2.0\",\"method\":\"" + method + "\",\"params\":" + params + "}");
  }

  private static void send(OutputStream out, String body) throws IOException {
    byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
    out.write(("Content-Length: " + bytes.length + "\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
    out.write(bytes);
    out.flush();
  }

  private static void raw(OutputStream out, String bytes) throws IOException {
    out.write(bytes.getBytes(StandardCharsets.ISO_8859_1));
    out.flush();
  }

  /** Reads answers until all that was asked is answered, each once. */
  private void answers(InputStream in, int last) throws IOException {
    while (!asked.isEmpty()) {
      JsonObject message = message(in);
      JsonElement id = message.get("id");
      if (id != null && id.isJsonPrimitive() && !message.has("method")) {
        assertTrue(asked.remove(id.getAsInt()), () -> id + " is answered twice, of " + last);
      }
    }
  }

  private static JsonObject message(InputStream in) throws IOException {
    int length = 0;
    for (String line = line(in); !line.isEmpty(); line = line(in)) {
      if (line.startsWith("Content-Length: ")) {
        length = Integer.parseInt(line.substring("Content-Length: ".length()));
      }
    }
    return JsonParser.parseString(new String(in.readNBytes(length), StandardCharsets.UTF_8))
        .getAsJsonObject();
  }

  private static String line(InputStream in) throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (int next = in.read(); next != '\n'; next = in.read()) {
      if (next < 0) {
        throw new IOException("the server has closed its stream");
      }
      line.write(next);
    }
    return line.toString(StandardCharsets.US_ASCII).strip();
  }
}
