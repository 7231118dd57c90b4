package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class RpcCommandTest {
  private static final String BEGIN = "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"";

  private static List<String> answers(String... requests) throws UsageException {
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    String lines = String.join("\n", requests);
    Console console = new Console(output, errors);
    ExitCode code =
        new RpcCommand(new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)))
            .run(Arguments.parse(List.of(), List.of()), console);
    console.flush();
    assertEquals(ExitCode.DONE, code);
    assertEquals("", errors.toString(StandardCharsets.UTF_8));
    return output.toString(StandardCharsets.UTF_8).lines().toList();
  }

  private static String request(String method, String params) {
    return BEGIN + method + "\",\"params\":" + params.replace('\'', '"') + "}";
  }

  @Test
  void robotHasTheOptionsOfRunWithoutTheirDashes() throws Exception {
    String made =
        answers(
                request(
                    "robot.create",
                    "{'robot':'UR3e','arm':'ideal','start_ramp':'off','seed':4,"
                        + "'input':{'digital_in[1]':true,'analog_in[0]':2.5}}"))
            .getLast();
    assertTrue(made.contains("\"robot\":\"ur3e\""), made);
    assertTrue(made.contains("\"digital_in\":[false,true,"), made);
    assertTrue(made.contains("\"analog_in\":[2.5,"), made);
  }

  @Test
  void optionThatMakesNoSenseIsAWrongParameter() throws Exception {
    assertEquals(
        List.of(
            "{\"jsonrpc\":\"2.0\",\"id\":1,\"error\":{\"code\":-32602,\"message\":\"unknown option"
                + " armm, did you mean arm?\"}}",
            "{\"jsonrpc\":\"2.0\",\"id\":1,\"error\":{\"code\":-32602,\"message\":\"arm is soft,"
                + " must be dynamic or ideal\"}}"),
        answers(
            request("robot.create", "{'armm':'ideal'}"),
            request("robot.create", "{'arm':'soft'}")));
  }

  @Test
  void programIsReadFromItsFile(@TempDir Path folder) throws Exception {
    Path file = Files.writeString(folder.resolve("a.script"), "def a():\n global n = 4\nend\n");
    List<String> answers =
        answers(
            request("robot.create", "{'arm':'ideal'}"),
            request("program.load", "{'file':'" + file + "'}"),
            request("program.start", "{}"),
            request("advance", "{'until':'ended'}"),
            request("variables", "{}"),
            request("program.load", "{'file':'" + folder + "'}"));
    assertTrue(answers.get(4).endsWith("{\"n\":4}}"), answers.get(4));
    assertTrue(answers.get(5).contains("\"code\":-32003"), answers.get(5));
  }

  @Test
  void fileOnTheCommandLineIsRefused() {
    RpcCommand command = new RpcCommand(new ByteArrayInputStream(new byte[0]));
    Console console = new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream());
    assertThrows(
        UsageException.class,
        () -> command.run(Arguments.parse(List.of(), List.of("a.script")), console));
  }
}
