package org.pendant.desktop.testwriter;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

final class TestFileNameTest {
  private static final Path PROGRAM = Path.of("cell", "pick.up.pendant");

  @Test
  void aTestStandsBesideItsProgramUnderANameThatIsFree() {
    Path first = Path.of("cell", "pick.up_test.script");
    Path second = Path.of("cell", "pick.up_2_test.script");

    assertEquals(first, TestFileName.free(PROGRAM, _ -> false));
    assertEquals(
        Path.of("cell", "pick.up_3_test.script"),
        TestFileName.free(PROGRAM, Set.of(first, second)::contains));
  }

  @Test
  void aNameThatNoTestHasGetsTheEndingOfOne() {
    assertEquals(Path.of("a", "b_test.script"), TestFileName.named(Path.of("a", "b_test.script")));
    assertEquals(Path.of("a", "b_test.script"), TestFileName.named(Path.of("a", "b.script")));
    assertEquals(Path.of("a", "b_test.script"), TestFileName.named(Path.of("a", "b")));
    assertEquals("b", TestFileName.word(Path.of("a", "b_test.script")));
  }

  @Test
  void theProgramIsNamedFromTheFolderOfTheTestOn() {
    assertEquals(
        Optional.of("pick.up.pendant"),
        TestFileName.program(PROGRAM, Path.of("cell", "x_test.script")));
    assertEquals(
        Optional.of("../pick.up.pendant"),
        TestFileName.program(PROGRAM, Path.of("cell", "tests", "x_test.script")));
  }
}
