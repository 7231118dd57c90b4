package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

final class LspCommandTest {
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  private ExitCode run(String input, String... words) throws UsageException {
    LspCommand command =
        new LspCommand(new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8)), output);
    Console console = new Console(new ByteArrayOutputStream(), errors);
    return command.run(Arguments.parse(command.options(), List.of(words)), console);
  }

  private static String frame(String body) {
    return "Content-Length: " + body.length() + "\r\n\r\n" + body;
  }

  private static String request(int id, String method, String params) {
    return frame(
        "{\"jsonrpc\":\"2.0\",\"id\":"
            + id
            + ",\"method\":\""
            + method
            + "\",\"params\":"
            + params
            + "}");
  }

  @Test
  void anEditorThatShutsDownIsAnsweredToTheEnd() throws Exception {
    String session =
        request(1, "initialize", "{\"capabilities\":{}}")
            + request(2, "shutdown", "null")
            + frame("{\"jsonrpc\":\"2.0\",\"method\":\"exit\"}");
    assertEquals(ExitCode.DONE, run(session));
    String answers = output.toString(StandardCharsets.UTF_8);
    assertTrue(answers.startsWith("Content-Length: "), answers);
    assertTrue(answers.contains("\"serverInfo\":{\"name\":\"Pendant\""), answers);
    assertTrue(answers.contains("{\"jsonrpc\":\"2.0\",\"id\":2,\"result\":null}"), answers);
    assertEquals("", errors.toString(StandardCharsets.UTF_8));
  }

  @Test
  void anEditorThatGoesAwayWithoutAWordIsAFailure() throws Exception {
    assertEquals(ExitCode.PROGRAM_FAILED, run(request(1, "initialize", "{\"capabilities\":{}}")));
  }

  @Test
  void whatCannotBeReadIsOneLineOnStandardError() throws Exception {
    run(frame("{x}"));
    List<String> lines = errors.toString(StandardCharsets.UTF_8).lines().toList();
    assertEquals(1, lines.size(), lines.toString());
    assertTrue(lines.getFirst().startsWith("pendant lsp: "), lines.getFirst());
  }

  @Test
  void aPortThatIsTakenIsSaid() throws IOException {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      UsageException refused =
          assertThrows(UsageException.class, () -> run("", "--port", "" + taken.getLocalPort()));
      assertTrue(
          refused.getMessage().startsWith("port " + taken.getLocalPort() + " cannot be opened: "),
          refused.getMessage());
    }
  }

  @Test
  void itTakesNoFile() {
    UsageException refused = assertThrows(UsageException.class, () -> run("", "cell.script"));
    assertEquals("takes no file, it was given cell.script", refused.getMessage());
  }
}
