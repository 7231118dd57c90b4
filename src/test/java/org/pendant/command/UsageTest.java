package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.command.Launcher.Result;

/** Wrong and right ways to call {@code pendant}. */
@Tag("slow")
final class UsageTest {
  @TempDir Path folder;

  static Stream<Arguments> wrongCalls() {
    return Stream.of(
        Arguments.of("rum x.script", "did you mean run?"),
        Arguments.of("run", "no file"),
        Arguments.of("run --sped max good.script", "did you mean --speed?"),
        Arguments.of("run --speed", "--speed needs a value"),
        Arguments.of("run --speed fast good.script", "fast"),
        Arguments.of("run --robot ur99 good.script", "ur99"),
        Arguments.of("run --input digital_in[9]=true good.script", "digital_in[9]"),
        Arguments.of("run --input digital_in[0]=perhaps good.script", "perhaps"),
        Arguments.of("run --input analog_in[0]=5 good.script", "such as 5V or 12mA"),
        Arguments.of("run --input analog_in[0]=11V good.script", "must be 0.0 to 10.0 V"),
        Arguments.of("run --input digital_out[0]=1 good.script", "safeguard_stop"),
        Arguments.of("run --timeout -1 good.script", "-1"),
        Arguments.of("run --wall-timeout 0 good.script", "--wall-timeout is 0"),
        Arguments.of("run --memory lots good.script", "such as 256MB"),
        Arguments.of("run --external-control pc:0 good.script", "the port is 0, must be 1 to"),
        Arguments.of("run --record missing/out.csv good.script", "missing/out.csv"),
        Arguments.of(
            "run --force good.script",
            "--force goes with --record or --profile, which are missing"),
        Arguments.of("run missing.script", "missing.script: there is no such file"),
        Arguments.of("run .", "is a directory"),
        Arguments.of("check good.script missing.script", "missing.script: there is no such file"),
        Arguments.of("serve --host=", "--host is empty, must be an address of this machine"),
        Arguments.of("serve --logs=good.script/x", "good.script/x, which cannot be made a folder"),
        Arguments.of("functions movje", "did you mean movej?"));
  }

  @Test
  void aLanguageThatIsAskedForIsSpokenByHelpButNotByWhatIsGenerated() {
    Result german = Launcher.shell(folder, "PENDANT_LANGUAGE=de \"$PENDANT\" run --help");
    assertTrue(german.output().startsWith("Aufruf: pendant run [Optionen] FILE...\n"));
    Result completion = Launcher.shell(folder, "PENDANT_LANGUAGE=de \"$PENDANT\" completion fish");
    assertTrue(completion.output().contains("'run programs headless, in virtual time'"));
  }

  @Test
  void whyACommandIsRefusedIsSaidInTheLanguageThatIsAskedFor() {
    Result german = Launcher.shell(folder, "PENDANT_LANGUAGE=de \"$PENDANT\" run missing.script");
    assertEquals(
        "pendant run: missing.script: es gibt keine solche Datei\n"
            + "pendant run --help erkl\u00e4rt den Aufruf\n",
        german.errors());
    Result chinese = Launcher.shell(folder, "PENDANT_LANGUAGE=zh \"$PENDANT\" rum");
    assertTrue(chinese.errors().contains("rum\uff0c"), chinese.errors());
  }

  @Test
  void resultsOfTestsAreToldInTheLanguageThatIsAskedForAndReportedInEnglish() throws IOException {
    Files.writeString(
        folder.resolve("grip_test.script"),
        """
        def test_grip():
          assert_near(0.05, 0.04, 0.001)
        end
        """);
    Result german =
        Launcher.shell(folder, "PENDANT_LANGUAGE=de \"$PENDANT\" test --junit tests.xml .");
    assertTrue(german.output().contains("1 fehlgeschlagen in "), german.output());
    assertTrue(german.output().contains(" nach der Wanduhr"), german.output());
    String junit = Files.readString(folder.resolve("tests.xml"));
    assertTrue(junit.contains(": error: "), junit);
    Result chinese = Launcher.shell(folder, "PENDANT_LANGUAGE=zh \"$PENDANT\" test .");
    String output =
        new String(chinese.output().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    assertTrue(output.contains("1 个失败"), output);
  }

  @Test
  void outcomesOfASweepAreToldInTheLanguageThatIsAskedForAndWrittenInEnglish() throws IOException {
    Files.writeString(folder.resolve("wait.script"), "T = 0.1\nsleep(T)\n");
    Files.writeString(
        folder.resolve("wait.toml"),
        """
        program = "wait.script"
        [[parameter]]
        name = "T"
        set = "variable T"
        values = [0.1, 0.2]
        """);
    Result german =
        Launcher.shell(folder, "PENDANT_LANGUAGE=de \"$PENDANT\" sweep --out out wait.toml");
    assertTrue(german.output().startsWith("Ausgang"), german.output() + german.errors());
    assertTrue(german.output().contains("\nbeendet      2\n"), german.output());
    String rows = Files.readString(folder.resolve("out/results.csv"));
    assertTrue(rows.contains(",finished,"), rows);
  }

  @Test
  void robotsAreListedUnderHeadingsInTheLanguageThatIsAskedFor() {
    Result german = Launcher.shell(folder, "PENDANT_LANGUAGE=de \"$PENDANT\" robots");
    assertTrue(german.output().startsWith("Kennung "), german.output());
    assertTrue(german.output().contains("Gelenkgeschwindigkeiten, Grad/s"), german.output());
  }

  @Test
  void commandsSpeakEnglishOnAComputerThatSpeaksGerman() {
    Result result =
        Launcher.shell(
            folder,
            "env -u DISPLAY PENDANT_JAVA_OPTIONS=\"$PENDANT_JAVA_OPTIONS -Duser.language=de\""
                + " \"$PENDANT\" doctor");
    assertTrue(result.output().contains("note    Display       there is none"), result.output());
  }

  @Test
  void aLanguageThatIsNotSpokenIsRefusedBeforeAnythingElse() {
    Result result = Launcher.shell(folder, "PENDANT_LANGUAGE=fr \"$PENDANT\" --version");

    assertEquals(2, result.exitCode());
    assertEquals("", result.output());
    assertEquals("pendant: PENDANT_LANGUAGE is fr, must be one of en, de, zh\n", result.errors());
  }

  @Test
  void theDesktopWithoutADisplayIsExplainedAndExitsWithTwo() {
    Result result = Launcher.shell(folder, "env -u DISPLAY \"$PENDANT\"");

    assertAll(
        () -> assertEquals(2, result.exitCode()),
        () -> assertEquals("", result.output()),
        () -> assertTrue(result.errors().contains("cannot be opened"), result.errors()),
        () -> assertTrue(result.errors().contains("pendant run FILE"), result.errors()));
  }

  @ParameterizedTest
  @MethodSource("wrongCalls")
  void wrongUsageIsExplainedAndExitsWithTwo(String words, String explanation) {
    Launcher.script(folder, "good.script", "def good():\n  textmsg(\"ran\")\nend\n");

    Result result = Launcher.pendant(folder, words.split(" ", -1));

    assertAll(
        () -> assertEquals(2, result.exitCode()),
        () -> assertEquals("", result.output()),
        () -> assertTrue(result.errors().contains(explanation), result.errors()));
  }

  @Test
  void unreadableFileIsNamed() {
    Launcher.script(folder, "secret.script", "textmsg(1)\n");
    assumeTrue(folder.resolve("secret.script").toFile().setReadable(false));
    assumeFalse(Files.isReadable(folder.resolve("secret.script")), "root reads everything");

    Result result = Launcher.pendant(folder, "run", "secret.script");

    assertAll(
        () -> assertEquals(2, result.exitCode()),
        () ->
            assertTrue(result.errors().contains("secret.script: no permission"), result.errors()));
  }

  @Test
  void whatIsNoFileIsNamed() {
    Result folderResult = Launcher.pendant(folder, "run", ".");
    Result endless = Launcher.pendant(folder, "run", "/dev/zero");

    assertAll(
        () -> assertEquals(2, folderResult.exitCode()),
        () -> assertTrue(folderResult.errors().contains("is a directory"), folderResult.errors()),
        () -> assertEquals(2, endless.exitCode()),
        () -> assertTrue(endless.errors().contains("has more than"), endless.errors()));
  }

  @Test
  void helpAndVersionArePrinted() {
    Result help = Launcher.pendant(folder, "--help");
    Result runHelp = Launcher.pendant(folder, "run", "--help");
    Result version = Launcher.pendant(folder, "--version");

    assertAll(
        () -> assertEquals(0, help.exitCode()),
        () -> assertTrue(help.output().contains("functions [NAME]"), help.output()),
        () -> assertEquals(0, runHelp.exitCode()),
        () -> assertTrue(runHelp.output().contains("--speed max|1|N"), runHelp.output()),
        () -> assertEquals(0, version.exitCode()),
        () -> assertTrue(version.output().startsWith("pendant "), version.output()),
        () -> assertEquals("", help.errors() + runHelp.errors() + version.errors()));
  }

  @Test
  void checkReportsOnEveryFile() {
    Launcher.script(folder, "good.script", "def good():\n  textmsg(\"ran\")\nend\n");
    Launcher.script(folder, "bad.script", "def bad():\n  nonsense()\nend\n");
    Launcher.script(folder, "worse.script", "def worse(:\nend\n");

    Result good = Launcher.pendant(folder, "check", "good.script");
    Result all = Launcher.pendant(folder, "check", "worse.script", "good.script", "bad.script");

    assertAll(
        () -> assertEquals(0, good.exitCode()),
        () -> assertEquals("", good.output() + good.errors()),
        () -> assertEquals(3, all.exitCode()),
        () -> assertEquals("", all.output()),
        () -> assertTrue(all.errors().contains("worse.script:1:"), all.errors()),
        () -> assertTrue(all.errors().contains("bad.script:2:3: error: "), all.errors()));
  }

  @Test
  void functionsListsAllAndExplainsOne() {
    Result all = Launcher.pendant(folder, "functions");
    Result one = Launcher.pendant(folder, "functions", "movej");

    assertAll(
        () -> assertEquals(0, all.exitCode()),
        () -> assertTrue(all.output().contains("Module urmath"), all.output()),
        () -> assertTrue(all.output().contains("  sleep(t) "), all.output()),
        () -> assertEquals(0, one.exitCode()),
        () ->
            assertTrue(one.output().startsWith("movej(q, a=1.4, v=1.05, t=0, r=0)"), one.output()),
        () ->
            assertTrue(
                one.output().contains("rad/s²") || one.output().contains("rad/s\u00c2\u00b2"),
                one.output()),
        () -> assertTrue(one.output().contains("section 15.29"), one.output()));
  }
}
