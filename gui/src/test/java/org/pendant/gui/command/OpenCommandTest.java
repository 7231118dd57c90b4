package org.pendant.gui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.List;
import org.junit.jupiter.api.Test;

final class OpenCommandTest {

  private static String refusal(String... words) {
    OpenCommand command = new OpenCommand();
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
}
