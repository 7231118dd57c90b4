package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/** {@code pendant run}: streams, options and exit codes. */
@Tag("slow")
final class RunTest {
  @TempDir Path folder;

  private String script(String name, String... lines) {
    return Launcher.script(folder, name, String.join("\n", lines) + "\n");
  }

  @Test
  void messagesGoToStandardOutputByteForByteAndAllElseToStandardError() {
    script(
        "talk.script",
        "def talk():",
        "  textmsg(\"plain\")",
        "  popup(\"look here\", title=\"Notice\", blocking=True)",
        "  textmsg(\"bytes \u00ff\u0000\u00c3\u00bc\")",
        "  textmsg(\"value=\", 3)",
        "  textmsg(\"\")",
        "end");

    Result result = Launcher.pendant(folder, "run", "talk.script");

    assertAll(
        () -> assertEquals(0, result.exitCode()),
        () -> assertEquals("plain\nbytes \u00ff\u0000\u00c3\u00bc\nvalue=3\n\n", result.output()),
        () -> assertTrue(result.errors().contains("look here"), result.errors()));
  }

  @Test
  void runtimeErrorShowsPlaceSourceAndCallStackAndExitsWithOne() {
    script(
        "fails.script",
        "def fails():",
        "  def pick(values, index):",
        "    return values[index]",
        "  end",
        "  textmsg(\"before\")",
        "  pick([1, 2, 3], 7)",
        "  textmsg(\"after\")",
        "end");

    Result result = Launcher.pendant(folder, "run", "fails.script");

    List<String> errors = result.errors().lines().toList();
    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("before\n", result.output()),
        () -> assertTrue(errors.getFirst().startsWith("fails.script:3:"), result.errors()),
        () -> assertTrue(errors.getFirst().contains(": error: "), result.errors()),
        () -> assertTrue(errors.getFirst().contains("7"), result.errors()),
        () -> assertTrue(errors.get(1).contains("return values[index]"), result.errors()),
        () -> assertEquals("^", errors.get(2).strip().substring(0, 1), result.errors()),
        () -> assertTrue(result.errors().contains("in pick, line 3"), result.errors()),
        () -> assertTrue(result.errors().contains("in fails, line 6"), result.errors()));
  }

  @Test
  void everyFileRunsAndTheFirstCodeThatIsNotZeroCounts() {
    script("fine.script", "def fine():", "  textmsg(\"fine\")", "end");
    script("typo.script", "def typo():", "  textmgs(\"x\")", "  other_typo()", "end");
    script("zero.script", "def zero():", "  n = 0", "  textmsg(1 / n)", "end");
    script("last.script", "def last():", "  textmsg(\"last\")", "end");

    Result result =
        Launcher.pendant(folder, "run", "fine.script", "typo.script", "zero.script", "last.script");

    assertAll(
        () -> assertEquals(3, result.exitCode()),
        () -> assertEquals("fine\nlast\n", result.output()),
        () -> assertTrue(result.errors().contains("typo.script:2:3: error: "), result.errors()),
        () -> assertTrue(result.errors().contains("textmsg"), result.errors()),
        () -> assertTrue(result.errors().contains("typo.script:3:3: error: "), result.errors()),
        () -> assertTrue(result.errors().contains("zero.script:3:"), result.errors()));
  }

  @Test
  void questionsAreAnsweredByTextOrInOrderForEachFileAnew() {
    script(
        "ask.script",
        "n = request_integer_from_primary_client(\"How many = ?\")",
        "b = request_boolean_from_primary_client(\"Mark them?\")",
        "textmsg(n, b)");

    Result result =
        Launcher.pendant(
            folder,
            "run",
            "--answer",
            "=yes",
            "--answer",
            "How many = ?=3",
            "ask.script",
            "ask.script");

    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals("3True\n3True\n", result.output()),
        () ->
            assertTrue(
                result.errors().contains("note: \"Mark them?\" is answered: True"),
                result.errors()));
  }

  @Test
  void questionWithoutAnAnswerFailsAndIsQuoted() {
    script("ask.script", "textmsg(\"before\")", "request_string_from_primary_client(\"Who?\")");

    Result result = Launcher.pendant(folder, "run", "ask.script");

    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("before\n", result.output()),
        () -> assertTrue(result.errors().startsWith("ask.script:2:"), result.errors()),
        () -> assertTrue(result.errors().contains("\"Who?\""), result.errors()),
        () -> assertTrue(result.errors().contains("--answer"), result.errors()));
  }

  @Test
  void eachFileHasAControllerOfItsOwn() {
    script("one.script", "set_standard_digital_out(0, True)", "global left_over = 1");
    script("two.script", "textmsg(get_standard_digital_out(0))", "textmsg(random())");

    Result result = Launcher.pendant(folder, "run", "one.script", "two.script", "two.script");

    List<String> lines = result.outputLines();
    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals(4, lines.size(), result.output()),
        () -> assertEquals("False", lines.getFirst()),
        () -> assertEquals(lines.subList(0, 2), lines.subList(2, 4)));
  }

  @Test
  void timeLimitCountsRobotTimeAndExitsWithFour() {
    script(
        "long.script",
        "def long():",
        "  textmsg(\"begin\")",
        "  sleep(9.9)",
        "  textmsg(\"almost\")",
        "  while True:",
        "    sync()",
        "  end",
        "end");

    Result result = Launcher.pendant(folder, "run", "--timeout", "10", "long.script");

    assertAll(
        () -> assertEquals(4, result.exitCode()),
        () -> assertEquals("begin\nalmost\n", result.output()),
        () -> assertTrue(result.errors().contains("10"), result.errors()));
  }

  @Test
  void eachProgramEndsWhenItsTimeOnTheWallIsOver() {
    script("endless.script", "def endless():", "  while True:", "    sync()", "  end", "end");

    Result result =
        Launcher.pendant(
            folder, "run", "--wall-timeout", "0.2", "endless.script", "endless.script");

    String once = "endless.script: error: stopped after 0.2 s on the wall, its time limit there\n";
    assertAll(
        () -> assertEquals(4, result.exitCode()), () -> assertEquals(once + once, result.errors()));
  }

  @Test
  void aProgramThatNeedsMoreMemoryThanItMayHaveFails() {
    script("large.script", "def large():", "  a = make_list(100000, 0, 100000)", "  b = a", "end");

    Result fails = Launcher.pendant(folder, "run", "--memory", "1MB", "large.script");
    Result runs = Launcher.pendant(folder, "run", "--memory", "4MB", "large.script");

    assertAll(
        () -> assertEquals(1, fails.exitCode()),
        () -> assertTrue(fails.errors().contains("large.script:3:"), fails.errors()),
        () -> assertTrue(fails.errors().contains("1 MB"), fails.errors()),
        () -> assertEquals(0, runs.exitCode(), runs::errors));
  }

  @Test
  void optionsReachTheController() {
    script(
        "options.script",
        "def options():",
        "  textmsg(get_standard_digital_in(2))",
        "  textmsg(get_standard_digital_in(3))",
        "  sleep(0.1)",
        "end");

    Result result =
        Launcher.pendant(
            folder,
            "run",
            "--robot=ur5e",
            "--speed",
            "20",
            "--seed",
            "5",
            "--input",
            "digital_in[2]=true",
            "--input=digital_in[3]=false",
            "options.script");

    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals("True\nFalse\n", result.output()));
  }

  @Test
  void waveformsChangeInputsByTheTimeOfTheProgram() {
    script(
        "waits.script",
        "while not get_standard_digital_in(0):",
        "  sync()",
        "end",
        "textmsg(get_steptime())",
        "while get_standard_digital_in(0):",
        "  sync()",
        "end",
        "textmsg(\"gone\")");
    script("inputs.csv", "time,signal,value", "0.5,digital_in[0],true", "1.5,digital_in[0],false");
    Result result =
        Launcher.pendant(folder, "run", "--waveforms=inputs.csv", "--timeout=2", "waits.script");
    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals("0.002\ngone\n", result.output()));
    script("inputs.csv", "time,signal,value", "0.5,digital_in[8],true");
    assertEquals(
        "pendant run: inputs.csv:2:5: digital_in: index is 8, must be 0 to 7",
        Launcher.pendant(folder, "run", "--waveforms=inputs.csv", "waits.script")
            .errors()
            .lines()
            .findFirst()
            .orElse(""));
  }

  @Test
  void inputsOfAllKindsReachTheProgram() {
    script(
        "inputs.script",
        "textmsg(get_standard_analog_in(0))",
        "textmsg(get_tool_analog_in(1))",
        "textmsg(read_input_integer_register(3))",
        "textmsg(read_input_float_register(47))",
        "textmsg(read_input_boolean_register(64))",
        "textmsg(read_port_register(128))");

    Result result =
        Launcher.pendant(
            folder,
            "run",
            "--input=analog_in[0]=7.5V",
            "--input=tool_analog_in[1]=12mA",
            "--input=input_integer_register[3]=-7",
            "--input=input_float_register[47]=0.25",
            "--input=input_boolean_register[64]=true",
            "--input=port_register[128]=65535",
            "inputs.script");

    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals("7.5\n0.012\n-7\n0.25\nTrue\n-1\n", result.output()));
  }

  @Test
  void aBeltTurnsAnEncoder() {
    script(
        "belt.script",
        "before = encoder_get_tick_count(1, \"raw\")",
        "sleep(0.5)",
        "textmsg(encoder_get_tick_count(1, \"raw\") - before)",
        "textmsg(encoder_get_tick_count(0))");

    Result result = Launcher.pendant(folder, "run", "--encoder", "1=-2000", "belt.script");
    Result third = Launcher.pendant(folder, "run", "--encoder", "2=5", "belt.script");
    Result word = Launcher.pendant(folder, "run", "--encoder", "0=fast", "belt.script");
    Result fast = Launcher.pendant(folder, "run", "--encoder", "0=1e7", "belt.script");

    assertAll(
        () -> assertEquals(0, result.exitCode(), result.errors()),
        () -> assertEquals("-1000\n0\n", result.output()),
        () -> assertEquals(2, third.exitCode()),
        () -> assertTrue(third.errors().contains("encoder is 2, must be 0 or 1"), third.errors()),
        () ->
            assertTrue(
                word.errors()
                    .contains("--encoder 0 is fast, must be -1000000 to 1000000 ticks a second"),
                word.errors()),
        () ->
            assertTrue(
                fast.errors().contains("is 1e7, must be -1000000 to 1000000"), fast.errors()));
  }

  @Test
  void seedDecidesWhatRandomAnswers() {
    script("random.script", "textmsg(random())");

    String five = Launcher.pendant(folder, "run", "--seed", "5", "random.script").output();
    String again = Launcher.pendant(folder, "run", "--seed", "5", "random.script").output();
    String six = Launcher.pendant(folder, "run", "--seed", "6", "random.script").output();

    assertAll(() -> assertEquals(five, again), () -> assertFalse(five.equals(six)));
  }

  @Test
  void readerThatGoesAwayEndsTheRunWithoutNoise() {
    script(
        "chatty.script",
        "def chatty():",
        "  while True:",
        "    textmsg(\"0123456789012345678901234567890123456789012345678901234567890123456789\")",
        "    sync()",
        "  end",
        "end");

    Result result =
        Launcher.shell(
            folder, "{ \"$PENDANT\" run chatty.script; echo $? >code; } | head -n 1; cat code");

    assertAll(
        () -> assertEquals("", result.errors()),
        () -> assertEquals("141", result.outputLines().getLast()),
        () -> assertEquals(2, result.outputLines().size()));
  }

  @Test
  void pauseGoesOnAndSecondaryProgramsRun() {
    script("pauses.script", "def pauses():", "  pause", "  textmsg(\"on\")", "end");
    script("aside.script", "sec aside():", "  textmsg(\"aside\")", "end");
    script(
        "heavy.script",
        "sec heavy():",
        "  i = 0",
        "  while i < 90000000:",
        "    i = i + 1",
        "  end",
        "end");

    Result result =
        Launcher.pendant(folder, "run", "pauses.script", "aside.script", "heavy.script");

    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("on\naside\n", result.output()),
        () -> assertTrue(result.errors().contains("paused in line 2"), result.errors()),
        () -> assertTrue(result.errors().contains("heavy.script:3: error: "), result.errors()),
        () -> assertTrue(result.errors().contains("Runtime is too much behind"), result.errors()));
  }

  @Test
  void warningsNameTheLineThatTheProgramWasAt() {
    script(
        "blends.script",
        "def blends():",
        "  movej([0, -1.57, -1.57, -1.57, 1.57, 0])",
        "  movej([0.01, -1.57, -1.57, -1.57, 1.57, 0], r=0.5)",
        "  movej([0.02, -1.57, -1.57, -1.57, 1.57, 0], r=0.5)",
        "  movej([0.03, -1.57, -1.57, -1.57, 1.57, 0])",
        "end");

    Result result = Launcher.pendant(folder, "run", "blends.script");

    assertAll(
        () -> assertEquals(0, result.exitCode()),
        () ->
            assertTrue(
                result.errors().contains("blends.script:4: warning: Overlapping Blends"),
                result.errors()));
  }

  @Test
  void haltIsAnOrdinaryEnd() {
    script("halts.script", "def halts():", "  textmsg(\"x\")", "  halt", "end");

    Result result = Launcher.pendant(folder, "run", "halts.script");

    assertAll(
        () -> assertEquals(0, result.exitCode()),
        () -> assertEquals("x\n", result.output()),
        () -> assertEquals("", result.errors()));
  }

  @Test
  void standardErrorQuotesScriptsInTheirOwnBytes() {
    Launcher.script(
        folder, "words.script", "def words():\n  textmsg(\"\u00c3\u00bc\", missing())\nend\n");

    Result result = Launcher.pendant(folder, "run", "words.script");

    assertAll(
        () -> assertEquals(3, result.exitCode()),
        () -> assertTrue(result.errors().contains("textmsg(\"ü\", missing())"), result.errors()));
  }
}
