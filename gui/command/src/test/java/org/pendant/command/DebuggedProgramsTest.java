package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.RunResult;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.text.Language;

class DebuggedProgramsTest {
  @TempDir private Path folder;

  private String script() throws Exception {
    Path file = folder.resolve("a.script");
    Files.writeString(file, "textmsg(1)\n");
    return file.toString();
  }

  private static String refusal(String program, String... options) {
    return refusal(Language.ENGLISH, program, options);
  }

  private static String refusal(Language language, String program, String... options) {
    return assertThrows(
            TargetRefusal.class,
            () -> new DebuggedPrograms().target(program, List.of(options), language))
        .getMessage();
  }

  @Test
  void whatIsDebuggedHasTheOptionsOfRun() throws Exception {
    DebugTarget target =
        new DebuggedPrograms()
            .target(script(), List.of("--robot=ur3e", "--seed", "4"), Language.ENGLISH);
    target.outside().run();
    assertEquals("ur3e", target.options().arm().id());
    assertFalse(target.generated());
  }

  @Test
  void whatMakesNoSenseIsRefusedInTheWordsOfTheCommandLine() throws Exception {
    assertEquals("nowhere.script: there is no such file", refusal("nowhere.script"));
    assertEquals("unknown option --sped, did you mean --speed?", refusal(script(), "--sped=1"));
    assertEquals("args has extra, which is no option", refusal(script(), "extra"));
  }

  @Test
  void whatMakesNoSenseIsRefusedInTheLanguageOfTheEditor() throws Exception {
    assertEquals(
        "args enthält extra, das ist keine Option", refusal(Language.GERMAN, script(), "extra"));
    assertEquals("args has extra, which is no option", refusal(script(), "extra"));
  }

  @Test
  void aTestIsPreparedByItsName() throws Exception {
    Path file = folder.resolve("a_test.script");
    Files.writeString(
        file,
        """
        # @case 2, 4
        # @case 3, 6
        def test_twice(given, expected):
          assert_equal(2 * given, expected)
        end
        """);
    DebuggedPrograms programs = new DebuggedPrograms();
    DebugTarget target =
        programs.test(
            file.toString(), "test_twice[3, 6]", List.of("--robot=ur3e"), Language.ENGLISH);
    assertEquals("ur3e", target.options().arm().id());
    assertTrue(target.test().isPresent());
    assertEquals(file.toString(), target.source().orElseThrow().name());
    assertEquals(
        "there is no test test_half in " + file,
        assertThrows(
                TargetRefusal.class,
                () -> programs.test(file.toString(), "test_half", List.of(), Language.ENGLISH))
            .getMessage());
  }

  @Test
  void endsWithTheExitCodesOfRun() {
    assertEquals(ExitCode.DONE.number(), RunResult.DONE);
    assertEquals(ExitCode.PROGRAM_FAILED.number(), RunResult.PROGRAM_FAILED);
    assertEquals(ExitCode.INTERNAL_ERROR.number(), RunResult.INTERNAL_ERROR);
  }
}
