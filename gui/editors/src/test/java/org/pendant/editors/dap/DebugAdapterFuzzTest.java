package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.pendant.editors.wire.BytePipe;
import org.pendant.editors.wire.ProtocolLog;

/**
 * A client without manners: requests in any order, about things that do not exist, malformed and
 * cut, of programs that wait, compute for ever and fail. {@code -Dtest.cases=100} makes it long.
 */
@Isolated("the threads of the whole JVM are looked at")
final class DebugAdapterFuzzTest {
  private static final int SESSIONS = 12 * Integer.getInteger("test.cases", 1);
  private static final int MESSAGES = 60;

  private static final List<String> PROGRAMS =
      List.of(
          "x = 0\nwhile True:\n  x = x + 1\nend\n",
          """
          def p():
            thread t():
              while True:
                sync()
              end
            end
            h = run t()
            a = [1, 2, 3]
            sleep(0.1)
            textmsg("a", a)
            kill h
          end
          """,
          "movej([0, -1.2, 0, -1.57, 0, 0])\nb = struct(c=p[0, 0, 0, 0, 0, 0])\nx = [1][5]\n",
          "y = 1\nz = 2\n",
          "slep(1)\n");

  private static final List<String> COMMANDS =
      List.of(
          "setBreakpoints",
          "setBreakpoints",
          "breakpointLocations",
          "setFunctionBreakpoints",
          "setExceptionBreakpoints",
          "dataBreakpointInfo",
          "setDataBreakpoints",
          "configurationDone",
          "configurationDone",
          "threads",
          "stackTrace",
          "stackTrace",
          "scopes",
          "variables",
          "variables",
          "setVariable",
          "setExpression",
          "evaluate",
          "completions",
          "continue",
          "continue",
          "next",
          "next",
          "stepIn",
          "stepOut",
          "stepBack",
          "reverseContinue",
          "pause",
          "pause",
          "goto",
          "gotoTargets",
          "restart",
          "restartFrame",
          "terminateThreads",
          "source",
          "loadedSources",
          "exceptionInfo",
          "modules",
          "cancel",
          "nonsense");

  private static final List<String> EXPRESSIONS =
      List.of("x", "a[1]", "b.c", "1+", "\\\"", "sleep(1)", "get_actual_tcp_pose()", "x = 4", "");

  private static final List<String> DATA =
      List.of("value:x", "value:a[1]", "signal:digital_out[0]", "signal:", "value:", "x", ":");

  private final Random random = new Random(Long.getLong("test.seed", 1));
  private final Map<Integer, String> asked = new TreeMap<>();
  private int nextId;
  private Path program;

  @TempDir Path folder;

  @Test
  void noClientEndsOrHangsTheAdapter() throws Exception {
    List<String> log = new CopyOnWriteArrayList<>();
    try (ProtocolLog _ = new ProtocolLog(log::add)) {
      for (int i = 0; i < SESSIONS; i++) {
        program = folder.resolve(i % 5 + ".script");
        Files.writeString(program, PROGRAMS.get(i % PROGRAMS.size()));
        session(i);
      }
      assertEquals(List.of(), robots());
    }
  }

  /** The threads of robots that are still there. */
  private static List<String> robots() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.equals("debugged robot"))
        .toList();
  }

  private void session(int number) throws Exception {
    List<Throwable> faults = new CopyOnWriteArrayList<>();
    BytePipe toServer = new BytePipe();
    BytePipe toClient = new BytePipe();
    CompletableFuture<Boolean> served = new CompletableFuture<>();
    Thread.ofPlatform()
        .daemon()
        .start(
            () -> {
              try {
                DebugAdapterConnection.serve(
                    new FilesOnDisk(),
                    Optional.empty(),
                    toServer.input(),
                    toClient.output(),
                    faults::add,
                    complaint -> {});
                toClient.output().close();
                served.complete(true);
              } catch (Throwable e) {
                served.completeExceptionally(e);
              }
            });
    CompletableFuture<Set<Integer>> answered = new CompletableFuture<>();
    Thread.ofPlatform().daemon().start(() -> read(toClient.input(), answered));
    asked.clear();
    nextId = 1;
    if (number % 4 > 0) {
      request(toServer.output(), "initialize", "{\"adapterID\":\"pendant\"}");
      launch(toServer.output());
    }
    for (int i = 0; i < MESSAGES; i++) {
      anything(toServer.output());
    }
    if (number % 3 > 0) {
      request(toServer.output(), "disconnect", "{\"terminateDebuggee\":true}");
    }
    toServer.output().flush();
    if (number % 3 == 0) {
      toServer.output().close();
    }
    assertTrue(served.get());
    assertEquals(List.of(), faults, () -> "session " + number);
    if (number % 3 > 0) {
      Map<Integer, String> missing = new TreeMap<>(asked);
      missing.keySet().removeAll(answered.get());
      assertEquals(Map.of(), missing, () -> "unanswered in session " + number);
    }
  }

  private void launch(OutputStream out) throws IOException {
    JsonObject arguments = new JsonObject();
    arguments.addProperty("program", program.toString());
    arguments.addProperty("stopOnEntry", random.nextBoolean());
    request(out, "launch", arguments.toString());
  }

  private void anything(OutputStream out) throws IOException {
    switch (random.nextInt(14)) {
      case 0 -> raw(out, malformed());
      case 1 -> {
        if (random.nextInt(6) == 0) {
          launch(out);
        }
      }
      case 2 -> request(out, "configurationDone", "{}");
      default -> request(out, COMMANDS.get(random.nextInt(COMMANDS.size())), arguments());
    }
  }

  private String malformed() {
    return switch (random.nextInt(4)) {
      case 0 -> "Content-Length: 4\r\n\r\n{\"a\"";
      case 1 -> "Content-Length: x\r\n\r\n";
      case 2 -> "Content-Length: 2\r\n\r\n[]";
      default -> "\r\n\r\n";
    };
  }

  private int number() {
    return random.nextInt(10) == 0 ? random.nextInt() : random.nextInt(6);
  }

  /** What any of the requests may ask for; each takes what it knows. */
  private String arguments() {
    JsonObject source = new JsonObject();
    source.addProperty("path", program.toString());
    JsonObject breakpoint = new JsonObject();
    breakpoint.addProperty("line", number());
    if (random.nextInt(3) == 0) {
      breakpoint.addProperty("condition", "x > 3");
    }
    if (random.nextInt(3) > 0) {
      breakpoint.addProperty("name", random.nextBoolean() ? "p" : "none");
      breakpoint.addProperty("dataId", DATA.get(random.nextInt(DATA.size())));
    }
    if (random.nextInt(5) == 0) {
      breakpoint.addProperty("hitCondition", ">2");
    }
    JsonObject all = new JsonObject();
    all.add("source", source);
    all.add("breakpoints", JsonParser.parseString("[" + breakpoint + "]"));
    all.add("filters", JsonParser.parseString("[\"error\"]"));
    all.addProperty("threadId", number());
    all.addProperty("frameId", number());
    all.addProperty("variablesReference", number());
    all.addProperty("start", number());
    all.addProperty("count", number());
    all.addProperty("startFrame", number());
    all.addProperty("levels", number());
    all.addProperty("line", number());
    all.addProperty("column", number());
    all.addProperty("targetId", number());
    all.addProperty("sourceReference", number());
    all.addProperty("requestId", random.nextInt(Math.max(1, nextId)));
    String expression = EXPRESSIONS.get(random.nextInt(EXPRESSIONS.size()));
    all.addProperty("expression", expression);
    all.addProperty("name", "x");
    all.addProperty("value", expression);
    all.addProperty("text", expression);
    all.addProperty("context", random.nextBoolean() ? "repl" : "watch");
    all.add("threadIds", JsonParser.parseString("[" + number() + "]"));
    return all.toString();
  }

  private void request(OutputStream out, String command, String arguments) throws IOException {
    int id = nextId++;
    asked.put(id, command);
    byte[] body =
        ("{\"seq\":"
                + id
                + ",\"type\":\"request\",\"command\":\""
                + command
                + "\",\"arguments\":"
                + arguments
                + "}")
            .getBytes(StandardCharsets.UTF_8);
    raw(out, "Content-Length: " + body.length + "\r\n\r\n");
    out.write(body);
    out.flush();
  }

  private static void raw(OutputStream out, String bytes) throws IOException {
    out.write(bytes.getBytes(StandardCharsets.ISO_8859_1));
    out.flush();
  }

  /** Reads to the end which requests are answered. */
  private static void read(InputStream in, CompletableFuture<Set<Integer>> answered) {
    Set<Integer> all = new HashSet<>();
    try {
      for (JsonObject message = message(in); message != null; message = message(in)) {
        if (message.get("type").equals(new JsonPrimitive("response"))) {
          all.add(message.get("request_seq").getAsInt());
        }
      }
      answered.complete(all);
    } catch (IOException | RuntimeException e) {
      answered.completeExceptionally(e);
    }
  }

  private static JsonObject message(InputStream in) throws IOException {
    int length = 0;
    for (String line = line(in); !line.isEmpty(); line = line(in)) {
      if (line.equals("end")) {
        return null;
      }
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
        return "end";
      }
      line.write(next);
    }
    return line.toString(StandardCharsets.US_ASCII).strip();
  }
}
