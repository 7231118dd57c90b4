package org.pendant.language.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

@Tag("slow")
class NestingLimitTest {

  @Test
  void refusesTenThousandBrackets() {
    assertTooDeep("x = " + "(".repeat(10_000) + "1" + ")".repeat(10_000));
    assertTooDeep("x = " + "[".repeat(10_000));
    assertTooDeep("x = " + "f(".repeat(10_000));
    assertTooDeep("x = " + "a[".repeat(10_000) + "0" + "]".repeat(10_000));
  }

  @Test
  void refusesTenThousandBlocks() {
    assertTooDeep("if a:\n".repeat(10_000) + "end\n".repeat(10_000));
    assertTooDeep("def f():\n".repeat(10_000));
  }

  @Test
  void refusesEndlessChains() {
    assertTooDeep("x = " + "not ".repeat(100_000) + "a");
    assertTooDeep("x = " + "1 + ".repeat(100_000) + "1");
    assertTooDeep("x = " + "1 + not ".repeat(100_000) + "a");
    assertTooDeep("x = " + "1 - - ".repeat(100_000) + "1");
    assertTooDeep("x = a" + ".b".repeat(100_000));
    assertTooDeep("x = a" + "[0]".repeat(100_000));
    assertTooDeep("x = a" + ".f()".repeat(100_000));
  }

  @Test
  void acceptsWhatGeneratorsWrite() {
    assertFine("x = " + "(".repeat(150) + "1" + ")".repeat(150));
    assertFine("x = " + "1 + ".repeat(900) + "1");
    assertFine("if a:\n".repeat(90) + "end\n".repeat(90));
    assertFine("if a:\n" + "elif b:\n".repeat(10_000) + "end");
    assertFine("x = [" + "1, ".repeat(50_000) + "1]");
    assertFine("x = 1 ".repeat(50_000));
  }

  @Test
  void refusesTextThatIsTooLarge() {
    ParseResult result =
        ScriptParser.parseProgram(Source.of("big.script", "x = 1\n".repeat(1_700_000)));
    assertEquals("source-too-large", result.diagnostics().getFirst().code());
    assertEquals(1, result.diagnostics().size());
  }

  @Test
  void givesUpOnBinaryGarbageWithFewErrors() {
    byte[] garbage = new byte[1_000_000];
    new Random(1).nextBytes(garbage);
    ParseResult result = ScriptParser.parseProgram(Source.of("garbage", garbage));
    assertTrue(result.diagnostics().size() <= 51);
    assertEquals("too-many-errors", result.diagnostics().getLast().code());
  }

  @Test
  void saysOfWhatThereIsTooMuch() {
    assertTooDeep(
        "nested too deeply: more than 200 brackets inside each other", "x = " + "(".repeat(1000));
    assertTooDeep(
        "nested too deeply: more than 100 blocks inside each other", "if a:\n".repeat(1000));
    assertTooDeep(
        "nested too deeply: more than 100 prefix operators inside each other",
        "x = " + "not ".repeat(10_000) + "a");
  }

  private static void assertTooDeep(String message, String text) {
    ParseResult result = ScriptParser.parseProgram(Source.of("deep", text));
    assertEquals(message, result.diagnostics().getFirst().message());
  }

  private static void assertTooDeep(String text) {
    ParseResult result = ScriptParser.parseProgram(Source.of("deep", text));
    assertEquals("nested-too-deeply", result.diagnostics().getFirst().code());
    assertTrue(result.diagnostics().getFirst().message().startsWith("nested too deeply"));
  }

  private static void assertFine(String text) {
    ParseResult result = ScriptParser.parseProgram(Source.of("fine", text));
    assertTrue(result.ok(), () -> result.diagnostics().toString());
  }
}
