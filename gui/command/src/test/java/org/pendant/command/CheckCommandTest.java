package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class CheckCommandTest {
  private static final String LIBRARY = "def twice(a):\n  return 2 * a\nend\ndef use(a):\n";

  private static final String SAYS =
      "lib is a library: it holds 2 functions and no program; a program is a last def without"
          + " parameters";

  @TempDir private Path folder;
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @Test
  void aLibraryIsCheckedAsOne() throws IOException {
    assertEquals(0, pendant("check", LIBRARY + "  return twice(a)\nend\n"));
    assertEquals(List.of("lib.script: note: " + SAYS), complaints());
  }

  @Test
  void aFileOfTestsMayCallTheFunctionsOfTestsAndThoseThatItImports() throws IOException {
    Files.writeString(folder.resolve("pick.script"), "def pick():\n  def open():\n  end\nend\n");
    Path file = folder.resolve("pick_test.script");
    Files.writeString(
        file,
        """
        import_script("pick.script")
        def test_open():
          open()
          eventually(get_standard_digital_out(0), within=1)
          if False:
            textmsg(nothing)
          end
        end
        """);
    assertEquals(0, pendant("check", file));
    assertEquals(
        List.of("pick_test.script:6:13: warning: variable nothing is never assigned"),
        complaints());

    Files.writeString(file, "def test_open():\n  mock_by(\"a\", b)\nend\n");
    assertEquals(3, pendant("check", file));
    assertEquals(
        List.of("pick_test.script:2:3: error: mock_by needs the names of two functions in quotes"),
        complaints());
  }

  @Test
  void mistakesInALibraryAreFound() throws IOException {
    assertEquals(3, pendant("check", LIBRARY + "  return twice(a, 1)\nend\n"));
    assertEquals(
        List.of(
            "lib.script:5:19: error: twice has 2 arguments, expected twice(a)",
            "  return twice(a, 1)",
            "                  ^",
            "lib.script: note: " + SAYS),
        complaints());
  }

  @Test
  void aCallThatLacksAnArgumentIsAWarningAsItMayNeverRun() throws IOException {
    assertEquals(0, pendant("check", LIBRARY + "  return twice()\nend\n"));
    assertEquals(
        "lib.script:5:10: warning: twice is called without a; expected twice(a)",
        complaints().getFirst());
  }

  @Test
  void aNameThatALibraryLacksIsAWarningAsItsProgramMayHaveIt() throws IOException {
    assertEquals(0, pendant("check", LIBRARY + "  return twise(a)\nend\n"));
    assertEquals(
        List.of(
            "lib.script:5:10: warning: function twise is not defined in this library; did you mean"
                + " twice?",
            "  return twise(a)",
            "         ^~~~~",
            "lib.script: note: " + SAYS),
        complaints());
  }

  @Test
  void aMissingNameIsToldOnce() throws IOException {
    assertEquals(3, pendant("check", "def p():\n  a()\n  a()\nend\n"));
    assertEquals(
        List.of(
            "lib.script:2:3: error: function a is not defined (and in another place: line 3)",
            "  a()",
            "  ^"),
        complaints());
  }

  @Test
  void aLibraryIsNotRun() throws IOException {
    assertEquals(3, pendant("run", LIBRARY + "  return twice(a)\nend\n"));
    assertEquals(List.of("lib.script:4:5: error: " + SAYS, "def use(a):", "    ^~~"), complaints());
  }

  private int pendant(String command, String text) throws IOException {
    Path file = Files.writeString(folder.resolve("lib.script"), text);
    return pendant(command, file);
  }

  private int pendant(String command, Path file) {
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    errors.reset();
    return new Pendant(new Console(output, errors)).run(List.of(command, file.toString())).number();
  }

  /** Complaints without the folder of the test. */
  private List<String> complaints() {
    return errors.toString(StandardCharsets.UTF_8).replace(folder + "/", "").lines().toList();
  }
}
