package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class OpenCommandTest {
  private static final DesktopServices NO_DESKTOP =
      new DesktopServices(Optional::empty, Optional::empty);

  private static String refusal(String... words) {
    OpenCommand command = new OpenCommand(NO_DESKTOP);
    Console console = new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream());
    return assertThrows(
            UsageException.class,
            () -> command.run(Arguments.parse(command.options(), List.of(words)), console))
        .getMessage();
  }

  @Test
  void refusesAnAddressWithoutPorts() {
    assertEquals(
        "--host is only for open ports, with --ports", refusal("--host", "127.0.0.1", "a.script"));
  }

  @Test
  void refusesAnOffsetThatLeavesNoRoom() {
    assertEquals(
        "--port-offset is 11215, must be a number from 0 to 11214",
        refusal("--ports", "--port-offset", "11215"));
  }

  @Test
  void refusesAFolderThatIsNotThere() {
    assertTrue(
        refusal("--ports", "--programs", "no/such/folder").endsWith("folder, must be a folder"));
  }

  @Test
  void itsOptionsAreUnderstoodWithoutItsName() {
    assertTrue(OpenCommand.understands("--ports"));
    assertTrue(OpenCommand.understands("--host=127.0.0.1"));
    assertFalse(OpenCommand.understands("--robot"));
    assertFalse(OpenCommand.understands("open"));
  }

  @Test
  void saysThatThereIsNoDesktop() {
    ByteArrayOutputStream errors = new ByteArrayOutputStream();

    ExitCode code =
        new Pendant(new Console(new ByteArrayOutputStream(), errors), NO_DESKTOP)
            .run(List.of("open", "a.script"));

    assertEquals(ExitCode.WRONG_USAGE, code);
    assertEquals(
        """
        pendant: the desktop cannot be opened: it is not on the class path
        Programs run without a display too: pendant run FILE...; pendant --help lists more
        """,
        errors.toString(StandardCharsets.UTF_8));
  }
}
