package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.service.Completion;
import org.pendant.language.source.Source;

final class ConditionCheckTest {
  private static final Source PROGRAM =
      Source.of(
          "test.script",
          "def prog():\n  count = 0\n  while count < 3:\n    count = count + 1\n  end\nend\n");

  private final List<Runnable> later = new ArrayList<>();
  private final ConditionCheck check =
      new ConditionCheck(
          (delayMs, work) -> later.add(work),
          Runnable::run,
          StandardBuiltins.create(),
          () -> PROGRAM);

  private void workOff() {
    List.copyOf(later).forEach(Runnable::run);
    later.clear();
  }

  @Test
  void saysWhatIsWrongOnceNobodyTypes() {
    List<String> refusals = new ArrayList<>();
    check.check(4, "coun", refusals::add);
    check.check(4, "count > 2", refusals::add);
    workOff();
    assertEquals(List.of(""), refusals, "only what was typed last counts");
    check.check(4, "coun > 2", refusals::add);
    workOff();
    assertTrue(refusals.getLast().contains("coun"), refusals.getLast());
  }

  @Test
  void whoeverCannotWaitIsAnsweredAtOnce() {
    assertEquals("", check.now(4, "count == 2"));
    assertEquals("", check.now(4, "  "));
    assertTrue(!check.now(4, "count = 2").isEmpty());
    assertEquals(List.of(), later);
  }

  @Test
  void completesNamesOfTheLine() {
    List<String> offered = new ArrayList<>();
    check.complete(
        4, "cou", 3, found -> found.stream().map(Completion::label).forEach(offered::add));
    workOff();
    assertEquals("count", offered.getFirst());
  }

  @Test
  void ofAMessageOnlyWhatStandsInBracesIsRead() {
    ConditionCheck messages = check.forMessages();
    assertEquals("", messages.now(4, "turn {count} of {2 * count}: {"));
    assertTrue(messages.now(4, "turn {coun}").contains("coun"));
  }

  @Test
  void namesAreCompletedInTheBracesOfAMessage() {
    ConditionCheck messages = check.forMessages();
    List<String> offered = new ArrayList<>();
    messages.complete(
        4, "cou", 3, found -> found.stream().map(Completion::label).forEach(offered::add));
    workOff();
    assertEquals(List.of(), offered);
    messages.complete(
        4, "at {cou", 7, found -> found.stream().map(Completion::label).forEach(offered::add));
    workOff();
    assertEquals("count", offered.getFirst());
  }
}
